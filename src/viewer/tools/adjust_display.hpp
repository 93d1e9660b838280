#pragma once
// Display tool: exposure, tone curve, false colour.
#include "viewer/tools/tool.hpp"

namespace sr::viewer {

class AdjustDisplay : public Tool {
public:
    using Tool::Tool;

    std::optional<Changes> handle(const Event& event) override;
    Changes draw_section() override;
};

} // namespace sr::viewer
