// Probe tool: evaluates the equation at a pixel that is clicked.
#include "viewer/panels/probe.hpp"
#include "core/error.hpp"
#include "core/math.hpp"
#include "render/probe.hpp"
#include "viewer/tools/tool.hpp"

#include <algorithm>
#include <chrono>
#include <fmt/format.h>
#include <utility>

namespace sr::viewer {
namespace {

constexpr int first_samples = 4; // of numbers that are there at once, and are refined then

} // namespace

class Probe : public Tool {
public:
    using Tool::Tool;

    std::optional<Changes> handle(const Event& event) override;
    Changes update(double seconds) override;
    void notice(Changes changes) override;
    Changes draw(const Overlay& overlay) override;
    Activity activity() const override {
        if (probing_) return Activity::exclusive;
        return ws_.wanted_probe ? Activity::active : Activity::idle;
    }

private:
    Changes request(vec2 at);
    void stop();
    void take_steps();
    void finish();
    std::optional<Lobe> lobe_of(const render::PixelTerms& terms, const render::RenderOptions& options,
                                int column, int row) const;

    ProbePanel panel_{ws_.probed};
    std::optional<render::Probing> probing_;   // of the pixel that panel_.result names
    std::optional<render::Probing> reference_; // of an assignment, afterwards
    render::RenderOptions options_;            // of both
    scene::Camera camera_;                     // of both
};

std::optional<Changes> Probe::handle(const Event& event) {
    if (const auto* click = std::get_if<ClickEvent>(&event)) return request(click->at);
    const auto command = command_in(event);
    if (command == Command::probe_pixel) return request(ws_.input.pointer());
    if (command != Command::cancel || !panel_.result) return std::nullopt;
    if (probing_) ws_.messages.notify("Probe cancelled.");
    stop();
    return Change::redraw;
}

void Probe::stop() {
    probing_.reset();
    reference_.reset();
    panel_.result.reset();
}

/// The terms of one pixel take as long as a small picture, so that their samples are limited. They are taken
/// between frames.
Changes Probe::request(vec2 at) {
    constexpr int max_samples = 64;
    stop();
    if (!ws_.shown_area().contains(at)) {
        ws_.messages.notify("Point at the picture to probe a pixel.");
        return Change::redraw;
    }
    if (const KeptPicture* const shown = ws_.shown_picture()) {
        ws_.messages.notify(
            fmt::format("Picture {} is shown, and a probe is of the render. {} goes back to it.",
                        shown->letter, ws_.keys.text(Command::cancel)));
        return Change::redraw;
    }
    ws_.show_panels(); // for the table
    const vec2 place = ws_.place_in_picture(at);
    const auto pixel = [](float part, int size) {
        return std::clamp(static_cast<int>(part * static_cast<float>(size)), 0, size - 1);
    };
    const int column = pixel(place.x, ws_.width), row = pixel(place.y, ws_.height);
    ws_.playback.is_playing = false;
    options_ = ws_.render_options();
    options_.samples = std::min(options_.samples, max_samples);
    options_.estimates_error = false;
    camera_ = ws_.camera->camera();
    const render::GpuScene& gpu = ws_.scene->gpu();
    probing_.emplace(gpu, camera_, options_, column, row, first_samples);
    if (!ws_.options.submission.empty() && !ws_.options.shows_reference) {
        render::RenderOptions theirs = options_;
        theirs.shader_path = ws_.options.reference_path;
        reference_.emplace(gpu, camera_, theirs, column, row);
    }
    panel_.result = ProbeResult{{}, {}, {}, column, row, ws_.height, 0};
    panel_.result->is_complete = false;
    ws_.messages.notify("Probing the pixel. Esc cancels.");
    return Change::redraw;
}

Changes Probe::update(double /*seconds*/) {
    if (const auto wanted = std::exchange(ws_.wanted_probe, std::nullopt)) return request(*wanted);
    if (!probing_) return {};
    try {
        take_steps();
    } catch (const Error& error) {
        stop();
        ws_.messages.fail("Cannot probe this pixel.", error.what());
    }
    return Change::redraw;
}

/// Takes as many steps as a frame has time for, one at least.
void Probe::take_steps() {
    constexpr auto budget = std::chrono::milliseconds(30);
    const auto end = std::chrono::steady_clock::now() + budget;
    const auto run = [end](render::Probing& probing) {
        while (!probing.is_done() && std::chrono::steady_clock::now() < end) probing.step();
        return probing.is_done();
    };
    const bool has_begun = panel_.result->samples > 0;
    const bool is_done = run(*probing_) && (!reference_ || run(*reference_));
    ProbeResult& result = *panel_.result;
    result.terms = probing_->terms();
    result.samples =
        probing_->is_first_round() ? std::min(first_samples, options_.samples) : options_.samples;
    for (std::size_t kind = 0; kind < result.has.size(); ++kind)
        result.has[kind] = probing_->has(static_cast<render::Probing::Kind>(kind));
    if (!has_begun) ws_.messages.log("The first numbers of the probe are there.");
    if (is_done) finish();
}

void Probe::finish() {
    ProbeResult& result = *panel_.result;
    if (reference_) result.reference = reference_->terms();
    result.lobe = lobe_of(result.terms, options_, result.column, result.row);
    result.is_complete = true;
    probing_.reset();
    reference_.reset();
    ws_.messages.notify(fmt::format("Probed pixel {},{}.", result.column, result.row));
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
    const auto brdf = render::evaluate_brdf(ws_.scene->gpu(), camera_, options, column, row, directions);
    if (!brdf) return std::nullopt;
    lobe.is_mirror = brdf->is_mirror;
    for (std::size_t i = 0; i < directions.size(); ++i)
        (i < lobe.wi.size() ? lobe.f_r : lobe.light_f_r).push_back(luminance(brdf->f_r[i]));
    return lobe;
}

/// A result holds for the lights and the materials that it was computed with.
void Probe::notice(Changes changes) {
    if (changes.has(Change::lights) || changes.has(Change::shadows) || changes.has(Change::materials)) stop();
}

Changes Probe::draw(const Overlay& overlay) {
    const scene::RenderScene& stage = ws_.scene->stage();
    panel_.draw_directions(stage, overlay.projection, overlay.scale);
    if (!ws_.is_explained || (ws_.probed && !ws_.probed->is_complete))
        panel_.draw(stage, ws_.scene->lights(), ws_.selected, ws_.layout, ws_.ui);
    if (probing_ && !panel_.result) stop(); // the panel was closed
    return {};
}

std::unique_ptr<Tool> make_probe(Workspace& workspace) { return std::make_unique<Probe>(workspace); }

} // namespace sr::viewer
