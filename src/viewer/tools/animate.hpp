#pragma once
// Animation tool: plays and scrubs animations, switches material variants.
#include "viewer/panels/animation.hpp"
#include "viewer/tools/tool.hpp"

namespace sr::viewer {

class Animate : public Tool {
public:
    using Tool::Tool;

    std::optional<Changes> handle(const Event& event) override;
    Changes update(double seconds) override;
    Changes draw(const Overlay& overlay) override;
    Changes draw_section() override;
    Activity activity() const override { return ws_.playback.is_playing ? Activity::active : Activity::idle; }

private:
    std::optional<Command> command_of_key(const KeyEvent& event) const;
    std::optional<Changes> execute(Command command);
    Changes step(Command command);
    Changes show_time();
    Changes choose_variant(const std::string& name);
    Changes next_variant();

    bool bar_has_pointer_ = false;
};

} // namespace sr::viewer
