// Comparison tool: a wipe, a difference or a ꟻLIP map between the render and a reference, which is a kept
// render or a file.
#include "compare/compare.hpp"
#include "compare/flip.hpp"
#include "compare/planes.hpp"
#include "core/error.hpp"
#include "image/file.hpp"
#include "settings/render_settings.hpp"
#include "viewer/fields.hpp"
#include "viewer/panels/file_dialog.hpp"
#include "viewer/tools/tool.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <chrono>
#include <filesystem>
#include <fmt/format.h>
#include <imgui.h>
#include <utility>

namespace sr::viewer {

/// ꟻLIP error of each pixel, in the red channel, 0 to 1, and its mean.
struct FlipMap {
    image::Image film;
    double mean = 0.0;
};

namespace {

/// In the order of ComparisonMode.
constexpr std::array modes{"render alone", "wipe", "difference", "FLIP map"};

constexpr const char* other_camera = " The reference is of another camera.";
constexpr const char* how_to_compare = "Press B to cycle comparisons.";

/// An image with one or two channels as RGB.
image::Image with_colors(image::Image film) {
    if (film.channels >= 3) return film;
    image::Image rgb(film.width, film.height, 3);
    for (std::size_t i = 0; i < rgb.pixels.size(); ++i)
        rgb.pixels[i] = film.pixels[i / 3 * static_cast<std::size_t>(film.channels)];
    return rgb;
}

bool is_picture(const std::string& file) {
    constexpr std::array extensions{".exr", ".hdr", ".png", ".jpg", ".jpeg"};
    std::string extension = std::filesystem::path(file).extension().string();
    std::ranges::transform(extension, extension.begin(), [](unsigned char c) { return std::tolower(c); });
    return std::ranges::find(extensions, extension) != extensions.end();
}

/// Reads radiance from EXR and HDR, the light of a screen from PNG and JPEG. @throws Error
Reference read_reference(const std::string& file) {
    const bool is_display_referred = !image::is_scene_referred(file);
    image::Image film = with_colors(image::read(file));
    if (is_display_referred)
        for (float& value : film.pixels) value = compare::srgb_decoded(value);
    return {std::filesystem::path(file).filename().string(), std::move(film), {}, is_display_referred};
}

/// HDR-ꟻLIP of two films, or ꟻLIP of what a screen shows of `film` and a display-referred reference.
/// @throws Error if their sizes differ
FlipMap flip_map(const image::Image& film, const DisplaySettings& display, const image::Image& reference,
                 bool is_display_referred) {
    if (film.width != reference.width || film.height != reference.height)
        throw Error(fmt::format("the pictures have {}x{} and {}x{} pixels", film.width, film.height,
                                reference.width, reference.height),
                    "give the window the size of the reference: --size");
    const float pixels_per_degree = compare::CompareOptions{}.pixels_per_degree;
    compare::Plane plane;
    if (is_display_referred) {
        image::Image shown = image::displayed(film, display.ev100, *display.curve);
        for (float& value : shown.pixels) value = compare::srgb_decoded(value);
        plane = compare::flip(shown, reference, pixels_per_degree);
    } else {
        plane = compare::hdr_flip(film, reference, compare::exposures_for(reference), pixels_per_degree);
    }
    FlipMap map{image::Image(film.width, film.height, 1), compare::mean(plane)};
    std::copy(plane.values.begin(), plane.values.end(), map.film.pixels.begin());
    map.film = with_colors(std::move(map.film));
    return map;
}

/// Combo box of named values. @return the value that was chosen
template<class Value, std::size_t count>
std::optional<Value> choice(const char* label, const char* meaning, Value now,
                            const std::array<std::pair<const char*, Value>, count>& all) {
    std::optional<Value> chosen;
    const char* name = "";
    for (const auto& [text, value] : all)
        if (value == now) name = text;
    const bool is_open = ImGui::BeginCombo(make_room(label, name, ImGui::GetFrameHeight()).c_str(), name);
    tooltip(meaning);
    if (!is_open) return chosen;
    for (const auto& [text, value] : all)
        if (ImGui::Selectable(text, value == now) && value != now) chosen = value;
    ImGui::EndCombo();
    return chosen;
}

} // namespace

class Compare : public Tool {
public:
    using Tool::Tool;

    std::optional<Changes> handle(const Event& event) override;
    Changes update(double seconds) override;
    Changes draw(const Overlay& overlay) override;
    Changes draw_section() override;
    void notice(Changes changes) override;
    FilmSum reference_film() const override;
    bool holds_keyboard() const override { return dialog_.is_open(); }
    Activity activity() const override { return flipping_ ? Activity::waiting : Activity::idle; }

private:
    Changes keep_render();
    Changes load(const std::string& file);
    Changes next_mode();
    bool has_other_camera() const;
    void begin_flip();
    Changes draw_methods();
    Changes draw_modes();
    Changes set_estimator(render::Estimator estimator);
    Changes set_visibility(render::Visibility visibility);

    FileDialog dialog_;
    std::optional<Reference> flip_; // the map, as a film
    std::optional<std::future<FlipMap>> flipping_;
    std::string flip_result_;
    bool had_other_camera_ = false;
};

std::optional<Changes> Compare::handle(const Event& event) {
    if (const auto* dropped = std::get_if<FileEvent>(&event))
        return is_picture(dropped->file) ? std::optional(load(dropped->file)) : std::nullopt;
    const auto command = command_in(event);
    if (command == Command::compare) return next_mode();
    if (command != Command::cancel) return std::nullopt;
    if (dialog_.is_open()) {
        dialog_.close();
        return Change::redraw;
    }
    if (ws_.display.comparison == ComparisonMode::none) return std::nullopt;
    ws_.display.comparison = ComparisonMode::none;
    return Change::display;
}

Changes Compare::keep_render() {
    const ProgressiveRender& render = ws_.scene->render();
    if (render.sample_count() == 0) return {};
    ws_.reference.emplace(fmt::format("{} samples, {}, {}", render.sample_count(),
                                      name_in(settings::estimators, ws_.options.rendering.estimator),
                                      ws_.camera->argument()),
                          render.read_film(), ws_.camera->argument());
    if (ws_.display.comparison == ComparisonMode::none) ws_.display.comparison = ComparisonMode::wipe;
    ws_.messages.notify(fmt::format("Reference kept. {}", how_to_compare));
    return Change::display;
}

Changes Compare::load(const std::string& file) {
    try {
        ws_.reference = read_reference(file);
        if (ws_.display.comparison == ComparisonMode::none) ws_.display.comparison = ComparisonMode::wipe;
        ws_.messages.clear_error();
        ws_.messages.notify(fmt::format("Comparing with {}. {}", ws_.reference->name(), how_to_compare));
        dialog_.close();
    } catch (const Error& error) {
        ws_.messages.fail("Cannot compare with this file.", error.what());
        dialog_.retry();
    }
    return Change::display;
}

Changes Compare::next_mode() {
    const bool is_kept = ws_.reference && !ws_.is_term_left_out;
    if (!is_kept && !ws_.is_term_left_out && ws_.options.submission.empty()) return keep_render();
    // There is no FLIP map against a picture that still gathers samples.
    const std::size_t count = is_kept ? modes.size() : modes.size() - 1;
    const std::size_t next = (static_cast<std::size_t>(ws_.display.comparison) + 1) % count;
    ws_.display.comparison = static_cast<ComparisonMode>(next);
    if (ws_.display.comparison == ComparisonMode::flip) begin_flip();
    ws_.messages.notify(
        fmt::format("Comparison: {}.{}", modes[next], next != 0 && has_other_camera() ? other_camera : ""));
    return Change::display;
}

bool Compare::has_other_camera() const {
    return ws_.reference && !ws_.reference->camera().empty()
           && ws_.reference->camera() != ws_.camera->argument();
}

/// Says so when a comparison becomes one of two views.
void Compare::notice(Changes changes) {
    if (!changes.has(Change::camera)) return;
    const bool is_other = ws_.display.comparison != ComparisonMode::none && has_other_camera();
    if (is_other && !std::exchange(had_other_camera_, true))
        ws_.messages.notify(fmt::format("The view has moved.{}", other_camera));
    had_other_camera_ = is_other;
}

/// Runs on a thread: a large picture takes seconds.
void Compare::begin_flip() {
    if (flipping_ || !ws_.reference || ws_.scene->render().sample_count() == 0) return;
    flip_result_ = "computing ...";
    flipping_ = std::async(std::launch::async, flip_map, ws_.scene->render().read_film(), ws_.display,
                           ws_.reference->film(), ws_.reference->is_display_referred());
}

Changes Compare::update(double /*seconds*/) {
    if (!flipping_ || flipping_->wait_for(std::chrono::seconds(0)) != std::future_status::ready) return {};
    auto flipping = std::exchange(flipping_, std::nullopt);
    try {
        FlipMap map = flipping->get();
        flip_result_ = fmt::format("mean FLIP {:.4f}", map.mean);
        flip_.emplace("FLIP", std::move(map.film));
    } catch (const Error& error) {
        flip_result_ = error.what();
    }
    ws_.messages.notify(flip_result_);
    return Change::display;
}

FilmSum Compare::reference_film() const {
    if (ws_.is_term_left_out) return {};
    if (ws_.display.comparison == ComparisonMode::flip) return flip_ ? flip_->sum() : FilmSum{};
    return ws_.reference ? ws_.reference->sum() : FilmSum{};
}

Changes Compare::draw(const Overlay& /*overlay*/) {
    const auto file = dialog_.draw();
    return file ? load(*file) : dialog_.wants_focus() ? Changes(Change::redraw) : Changes();
}

Changes Compare::draw_section() {
    const bool is_unfolded = ImGui::CollapsingHeader("Compare");
    tooltip("the render beside a kept one or a picture, and methods to compare");
    if (!is_unfolded) return {};
    Changes changes = draw_methods();
    if (ImGui::Button("keep this render")) changes |= keep_render();
    tooltip(ws_.keys.hint("as the reference that later pictures are compared with", Command::compare));
    ImGui::SameLine();
    if (ImGui::Button("load a picture")) dialog_.show(FileDialog::Purpose::compare, ws_.scene->loaded().file);
    tooltip("as the reference: EXR or HDR as radiance, PNG or JPEG as what a screen shows");
    return ws_.reference ? changes | draw_modes() : changes;
}

Changes Compare::draw_methods() {
    using render::Estimator;
    using render::Visibility;
    Changes changes;
    constexpr std::array<std::pair<const char*, Estimator>, 2> estimators{
        {{"sampled", Estimator::sampled}, {"analytic", Estimator::analytic}}};
    constexpr std::array<std::pair<const char*, Visibility>, 5> visibilities{
        {{"ray", Visibility::ray},
         {"ray-cpu", Visibility::ray_on_cpu},
         {"ray-glsl", Visibility::ray_in_glsl},
         {"map", Visibility::map},
         {"none", Visibility::none}}};
    if (const auto chosen =
            choice("estimator",
                   "sampled: points on the lights, which converge; analytic: closed forms with few points",
                   ws_.options.rendering.estimator, estimators))
        changes |= set_estimator(*chosen);
    if (const auto chosen = choice(
            "visibility", "how V is found: shadow rays on the CPU or in GLSL, depth maps, or not at all",
            ws_.options.visibility, visibilities))
        changes |= set_visibility(*chosen);
    return changes;
}

Changes Compare::draw_modes() {
    Changes changes;
    ImGui::TextDisabled("reference: %s", ws_.reference->name().c_str());
    if (has_other_camera()) ImGui::TextWrapped("%s", other_camera + 1);
    int mode = static_cast<int>(ws_.display.comparison);
    if (ImGui::Combo("show", &mode, modes.data(), static_cast<int>(modes.size()))) {
        ws_.display.comparison = static_cast<ComparisonMode>(mode);
        if (ws_.display.comparison == ComparisonMode::flip) begin_flip();
        changes |= Change::display;
    }
    tooltip(ws_.keys.hint("the render alone, or with the reference", Command::compare));
    if (ws_.display.comparison == ComparisonMode::wipe) {
        number_field("wipe", ws_.display.wipe, {0.0f, 1.0f, "%.2f"});
        tooltip("share of the picture's width that shows the render; the reference has the rest");
    }
    if (ws_.display.comparison == ComparisonMode::difference)
        ImGui::TextWrapped("Blue: darker than the reference. Orange: brighter. Saturated at half of it.");
    if (ws_.display.comparison == ComparisonMode::flip) {
        ImGui::TextWrapped("%s", flip_result_.c_str());
        if (ImGui::Button("compute again")) begin_flip();
        tooltip("FLIP of the picture as it is now, which takes a while");
    }
    return changes;
}

Changes Compare::set_estimator(render::Estimator estimator) {
    const render::Estimator before = std::exchange(ws_.options.rendering.estimator, estimator);
    try {
        ws_.scene->restart(ws_.options, ws_.camera->camera(), ws_.width, ws_.height);
        return Change::materials;
    } catch (const Error& error) {
        ws_.options.rendering.estimator = before;
        ws_.messages.fail("Cannot use this estimator.", error.what());
        return Change::redraw;
    }
}

Changes Compare::set_visibility(render::Visibility visibility) {
    try {
        ws_.scene->set_visibility(ws_.options, visibility, ws_.camera->camera(), ws_.width, ws_.height);
        return Change::materials;
    } catch (const Error& error) {
        ws_.messages.fail("Cannot use this visibility method.", error.what());
        return Change::redraw;
    }
}

std::unique_ptr<Tool> make_compare(Workspace& workspace) { return std::make_unique<Compare>(workspace); }

} // namespace sr::viewer
