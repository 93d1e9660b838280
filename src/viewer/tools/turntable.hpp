#pragma once
// Turntable tool: writes a PNG of the converged render at each step of a turn around the pivot.
#include "viewer/tools/tool.hpp"

namespace sr::viewer {

class Turntable : public Tool {
public:
    using Tool::Tool;

    std::optional<Changes> handle(const Event& event) override;
    Changes update(double seconds) override;
    Activity activity() const override { return folder_.empty() ? Activity::idle : Activity::active; }

private:
    Changes begin();

    std::string folder_; // that is written to; empty: none
    int step_ = 0;
};

} // namespace sr::viewer
