#pragma once
// Light editing tool: selects, enables, adds and removes lights, sets quantities, undoes.
#include "viewer/panels/lights.hpp"
#include "viewer/tools/tool.hpp"

namespace sr::viewer {

class EditLights : public Tool {
public:
    using Tool::Tool;

    std::optional<Changes> handle(const Event& event) override;
    Changes draw(const Overlay& overlay) override;
    Changes draw_section() override;

private:
    std::optional<Changes> select_at(vec2 pointer);
    std::optional<Changes> execute(Command command);
    Changes step(bool is_undo);
    Changes edit_selected(Command command);
    Changes select(std::size_t entry);

    LightsPanel panel_;
};

} // namespace sr::viewer
