#pragma once
// Probe tool: evaluates the equation at a pixel that is clicked.
#include "viewer/panels/probe.hpp"
#include "viewer/tools/tool.hpp"

namespace sr::viewer {

class Probe : public Tool {
public:
    using Tool::Tool;

    std::optional<Changes> handle(const Event& event) override;
    Changes update(double seconds) override;
    void notice(Changes changes) override;
    Changes draw(const Overlay& overlay) override;
    Activity activity() const override { return requested_ ? Activity::active : Activity::idle; }

private:
    Changes request(vec2 at);
    void probe(int column, int row);
    std::optional<Lobe> lobe_of(const render::PixelTerms& terms, const render::RenderOptions& options,
                                int column, int row) const;

    ProbePanel panel_;
    std::optional<vec2> requested_; // a place in the window
};

} // namespace sr::viewer
