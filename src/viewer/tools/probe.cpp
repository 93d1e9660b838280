// Probe tool: evaluates the equation at a pixel that is clicked.
#include "viewer/panels/probe.hpp"
#include "core/math.hpp"
#include "render/probe.hpp"
#include "viewer/tools/tool.hpp"

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>
#include <algorithm>
#include <fmt/format.h>
#include <utility>

namespace sr::viewer {
class Probe : public Tool {
public:
    using Tool::Tool;

    std::optional<Changes> handle(const Event& event) override;
    Changes update(double seconds) override;
    void notice(Changes changes) override;
    Changes draw(const Overlay& overlay) override;
    Activity activity() const override {
        return requested_ || ws_.wanted_probe ? Activity::active : Activity::idle;
    }

private:
    Changes request(vec2 at);
    void probe(int column, int row);
    std::optional<Lobe> lobe_of(const render::PixelTerms& terms, const render::RenderOptions& options,
                                int column, int row) const;

    ProbePanel panel_;
    std::optional<vec2> requested_; // a place in the window
};

std::optional<Changes> Probe::handle(const Event& event) {
    if (const auto* click = std::get_if<ClickEvent>(&event)) return request(click->at);
    const auto command = command_in(event);
    if (command == Command::probe_pixel) return request(ws_.input.pointer());
    if (command != Command::cancel) return std::nullopt;
    panel_.result.reset();
    return Change::redraw;
}

/// The next update() probes, so that a frame with the message comes first.
Changes Probe::request(vec2 at) {
    requested_ = at;
    ws_.playback.is_playing = false;
    ws_.messages.notify("Probing the pixel. Esc cancels.");
    return Change::redraw;
}

Changes Probe::update(double /*seconds*/) {
    if (ws_.wanted_probe) requested_ = std::exchange(ws_.wanted_probe, std::nullopt);
    if (!requested_) return {};
    const vec2 place = *std::exchange(requested_, std::nullopt) / ws_.window_size();
    const auto pixel = [](float part, int size) {
        return std::clamp(static_cast<int>(part * static_cast<float>(size)), 0, size - 1);
    };
    probe(pixel(place.x, ws_.width), pixel(place.y, ws_.height));
    return Change::redraw;
}

/// Takes a while, in which only Esc and closing the window are handled.
void Probe::probe(int column, int row) {
    constexpr int max_samples = 64; // the terms of one pixel take as long as a small picture
    render::RenderOptions options = ws_.render_options();
    options.samples = std::min(options.samples, max_samples);
    options.estimates_error = false;
    std::stop_source stop;
    const auto take_events = [&] {
        glfwPollEvents();
        if (ws_.input.has_cancel()) stop.request_stop();
    };
    const render::GpuScene& gpu = ws_.scene->gpu();
    const scene::Camera& camera = ws_.camera->camera();
    auto terms = render::probe(gpu, camera, options, column, row, stop.get_token(), take_events);
    if (!terms) return ws_.messages.notify("Probe cancelled.");
    panel_.result = ProbeResult{*std::move(terms), {}, {}, column, row, ws_.height, options.samples};
    if (!ws_.options.submission.empty() && !ws_.options.shows_reference) {
        render::RenderOptions reference = options;
        reference.shader_path = ws_.options.reference_path;
        panel_.result->reference =
            render::probe(gpu, camera, reference, column, row, stop.get_token(), take_events);
    }
    panel_.result->lobe = lobe_of(panel_.result->terms, options, column, row);
    ws_.messages.notify(fmt::format("Probed pixel {},{}.", column, row));
}

/// f_r over the hemisphere and toward each light; absent where no surface is visible.
std::optional<Lobe> Probe::lobe_of(const render::PixelTerms& terms, const render::RenderOptions& options,
                                   int column, int row) const {
    if (terms.n == vec3(0.0f) || terms.wo == vec3(0.0f)) return std::nullopt;
    Lobe lobe;
    lobe.n = glm::normalize(terms.n);
    lobe.wo = glm::normalize(terms.wo);
    lobe.wi = lobe_directions(lobe.n, lobe.wo);
    std::vector<vec3> directions = lobe.wi;
    for (const render::LightTerms& light : terms.lights) {
        lobe.light_wi.push_back(light.wi == vec3(0.0f) ? vec3(0.0f) : glm::normalize(light.wi));
        directions.push_back(light.wi == vec3(0.0f) ? lobe.n : lobe.light_wi.back());
    }
    const auto brdf =
        render::brdf_at(ws_.scene->gpu(), ws_.camera->camera(), options, column, row, directions);
    if (!brdf) return std::nullopt;
    lobe.is_mirror = brdf->is_mirror;
    for (std::size_t i = 0; i < directions.size(); ++i)
        (i < lobe.wi.size() ? lobe.f_r : lobe.light_f_r).push_back(luminance(brdf->f_r[i]));
    return lobe;
}

/// A result holds for the lights and the materials that it was computed with.
void Probe::notice(Changes changes) {
    if (changes.has(Change::lights) || changes.has(Change::shadows) || changes.has(Change::materials))
        panel_.result.reset();
}

Changes Probe::draw(const Overlay& overlay) {
    const scene::RenderScene& stage = ws_.scene->stage();
    panel_.draw_directions(stage, overlay.projection, overlay.scale);
    panel_.draw(stage, ws_.scene->lights(), ws_.selected, "Assignment", overlay.scale);
    return {};
}

std::unique_ptr<Tool> make_probe(Workspace& workspace) { return std::make_unique<Probe>(workspace); }

} // namespace sr::viewer
