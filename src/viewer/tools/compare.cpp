// Comparison tool: a wipe, a difference or a ꟻLIP map between two pictures: the render, kept renders, files.
#include "compare/planes.hpp"
#include "core/error.hpp"
#include "core/parallel.hpp"
#include "image/file.hpp"
#include "settings/render_settings.hpp"
#include "viewer/document/picture_errors.hpp"
#include "viewer/fields.hpp"
#include "viewer/panels/file_dialog.hpp"
#include "viewer/panels/kept_pictures.hpp"
#include "viewer/tools/tool.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <filesystem>
#include <fmt/format.h>
#include <imgui.h>
#include <utility>

namespace sr::viewer {

namespace {

/// In the order of ComparisonMode.
constexpr std::array modes{"render alone", "wipe", "difference", "FLIP map"};

constexpr const char* other_camera = " The reference is of another camera.";
constexpr const char* too_many = "Eight pictures are kept: remove one of them first.";
constexpr const char* how_to_compare = "Press B to cycle comparisons.";

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

ComparedPicture compared(const KeptPicture& kept) {
    return {kept.picture.film(), kept.picture.is_display_referred()};
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
    FilmSum film() const override {
        return ws_.shown_picture() ? ws_.shown_picture()->picture.sum() : FilmSum{};
    }
    FilmSum reference_film() const override;
    bool holds_keyboard() const override { return dialog_.is_open(); }
    Activity activity() const override {
        return flipping_ || measuring_ ? Activity::waiting : Activity::idle;
    }

private:
    Changes keep_render();
    Changes load(const std::string& file);
    Changes next_mode();
    Changes show_next();
    Changes pair_changed();
    std::string pair() const;
    ComparedPicture shown_picture() const;
    Changes compare_with_next();
    Changes say_none_is_kept();
    Changes begin_measuring();
    Changes take_flip();
    Changes take_metrics();
    bool has_other_camera() const;
    void begin_flip();
    Changes draw_methods();
    Changes draw_pictures();
    Changes draw_modes();
    Changes set_estimator(render::Estimator estimator);
    Changes set_visibility(render::Visibility visibility);

    FileDialog dialog_;
    std::optional<Reference> flip_; // the map, as a film
    std::optional<std::future<FlipMap>> flipping_;
    std::string flip_result_;
    bool had_other_camera_ = false;
    KeptPicturesList list_;
    std::optional<std::future<compare::Metrics>> measuring_;
    std::string measured_pair_;               // of `metrics_`, or of what is being measured
    std::string measured_unit_;               // of their differences
    std::optional<compare::Metrics> metrics_; // measured last
};

std::optional<Changes> Compare::handle(const Event& event) {
    if (const auto* dropped = std::get_if<FileEvent>(&event))
        return is_picture(dropped->file) ? std::optional(load(dropped->file)) : std::nullopt;
    const auto command = command_in(event);
    if (command == Command::compare) return next_mode();
    if (command == Command::keep_picture) return keep_render();
    if (command == Command::next_picture) return show_next();
    if (command == Command::next_reference) return compare_with_next();
    if (command == Command::measure_pictures) return begin_measuring();
    if (command != Command::cancel) return std::nullopt;
    if (dialog_.is_open()) {
        dialog_.close();
        return Change::redraw;
    }
    if (ws_.display.comparison == ComparisonMode::none && !ws_.kept.shown()) return std::nullopt;
    ws_.display.comparison = ComparisonMode::none;
    ws_.kept.show(std::nullopt);
    return Change::display;
}

Changes Compare::keep_render() {
    const ProgressiveRender& render = ws_.scene->render();
    if (render.sample_count() == 0) return {};
    if (ws_.kept.is_full()) {
        ws_.messages.notify(too_many);
        return Change::redraw;
    }
    const std::string view = ws_.display.view ? fmt::format("{}, ", ws_.display.view->name) : "";
    const char letter = ws_.kept.keep(
        {fmt::format("{}{} samples, {}, {}", view, render.sample_count(),
                     name_in(settings::estimators, ws_.options.rendering.estimator), ws_.camera->argument()),
         render.read_film(), ws_.camera->argument()});
    if (ws_.display.comparison == ComparisonMode::none) ws_.display.comparison = ComparisonMode::wipe;
    ws_.messages.notify(fmt::format("Reference kept. It is picture {}. {}", letter, how_to_compare));
    return pair_changed();
}

Changes Compare::load(const std::string& file) {
    if (ws_.kept.is_full()) {
        ws_.messages.notify(too_many);
        dialog_.close();
        return Change::redraw;
    }
    try {
        const char letter = ws_.kept.keep(read_reference(file));
        if (ws_.display.comparison == ComparisonMode::none) ws_.display.comparison = ComparisonMode::wipe;
        ws_.messages.clear_error();
        ws_.messages.notify(fmt::format("Comparing with {}, picture {}. {}",
                                        ws_.kept.reference()->picture.name(), letter, how_to_compare));
        dialog_.close();
        return pair_changed();
    } catch (const Error& error) {
        ws_.messages.fail("Cannot compare with this file.", error.what());
        dialog_.retry();
    }
    return Change::display;
}

/// Shows the next kept picture in place of the render, and after the last one the render.
Changes Compare::show_next() {
    if (ws_.kept.all().empty()) return say_none_is_kept();
    ws_.kept.show_next();
    const KeptPicture* const shown = ws_.kept.shown();
    ws_.messages.notify(shown ? fmt::format("Picture {}: {}.", shown->letter, shown->picture.name())
                              : "The render.");
    return pair_changed();
}

Changes Compare::compare_with_next() {
    const auto index = ws_.kept.reference_index();
    if (!index) return say_none_is_kept();
    ws_.kept.compare_with((*index + 1) % ws_.kept.all().size());
    ws_.messages.notify(fmt::format("Comparing {}.{}", pair(), has_other_camera() ? other_camera : ""));
    return pair_changed();
}

Changes Compare::say_none_is_kept() {
    ws_.messages.notify(fmt::format("No picture is kept. {} keeps the render as picture A.",
                                    ws_.keys.text(Command::keep_picture)));
    return Change::redraw;
}

/// The map is of the pair that is compared.
Changes Compare::pair_changed() {
    if (ws_.display.comparison == ComparisonMode::flip) begin_flip();
    return Change::display;
}

/// "the render against B".
std::string Compare::pair() const {
    const KeptPicture *const shown = ws_.kept.shown(), *const reference = ws_.kept.reference();
    return fmt::format("{} against {}",
                       shown ? std::string(1, shown->letter)
                             : fmt::format("the render ({} samples)", ws_.scene->render().sample_count()),
                       reference ? std::string(1, reference->letter) : "nothing");
}

ComparedPicture Compare::shown_picture() const {
    const KeptPicture* const shown = ws_.kept.shown();
    return shown ? compared(*shown) : ComparedPicture{ws_.scene->render().read_film()};
}

/// Runs on a thread, as the ꟻLIP map does.
Changes Compare::begin_measuring() {
    const KeptPicture* const reference = ws_.kept.reference();
    if (!reference) return say_none_is_kept();
    if (measuring_ || ws_.scene->render().sample_count() == 0) return {};
    metrics_.reset();
    measured_pair_ = pair();
    ComparedPicture shown = shown_picture(), other = compared(*reference);
    measured_unit_ = shown.is_displayed || other.is_displayed
                         ? "of a screen's code values"
                         : scene::radiance_unit(ws_.scene->stage().scene.units);
    measuring_ = started([shown = std::move(shown), other = std::move(other), display = ws_.display] {
        return measure_errors(shown, other, display);
    });
    return Change::redraw;
}

Changes Compare::next_mode() {
    const bool is_kept = ws_.kept.reference() && !ws_.is_term_left_out;
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
    const KeptPicture *const shown = ws_.kept.shown(), *const reference = ws_.kept.reference();
    const std::string& camera = shown ? shown->picture.camera() : ws_.camera->argument();
    return reference && !reference->picture.camera().empty() && !camera.empty()
           && reference->picture.camera() != camera;
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
    const KeptPicture* const reference = ws_.kept.reference();
    if (flipping_ || !reference || ws_.scene->render().sample_count() == 0) return;
    flip_result_ = "computing ...";
    flipping_ = started([shown = shown_picture(), other = compared(*reference), display = ws_.display] {
        return flip_map(shown, other, display);
    });
}

Changes Compare::update(double /*seconds*/) {
    const auto is_ready = [](const auto& work) { return work && is_done(*work); };
    Changes changes;
    if (is_ready(flipping_)) changes |= take_flip();
    if (is_ready(measuring_)) changes |= take_metrics();
    return changes;
}

Changes Compare::take_flip() {
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

Changes Compare::take_metrics() {
    auto measuring = std::exchange(measuring_, std::nullopt);
    try {
        metrics_ = measuring->get();
        ws_.messages.notify(fmt::format("Measured {}: relMSE {:.4g}, FLIP {:.4g}.", measured_pair_,
                                        metrics_->rel_mse, metrics_->flip));
    } catch (const Error& error) {
        ws_.messages.notify(error.what());
    }
    return Change::redraw;
}

FilmSum Compare::reference_film() const {
    if (ws_.is_term_left_out) return {};
    if (ws_.display.comparison == ComparisonMode::flip) return flip_ ? flip_->sum() : FilmSum{};
    return ws_.kept.reference() ? ws_.kept.reference()->picture.sum() : FilmSum{};
}

Changes Compare::draw(const Overlay& overlay) {
    if (const KeptPicture* const shown = ws_.kept.shown(); shown && !ws_.is_mixing)
        draw_caption(ws_.shown_area().from + 10.0f * overlay.scale,
                     fmt::format("{}: {}", shown->letter, shown->picture.name()));
    const auto file = dialog_.draw();
    return file ? load(*file) : dialog_.wants_focus() ? Changes(Change::redraw) : Changes();
}

Changes Compare::draw_section() {
    const bool is_unfolded = ImGui::CollapsingHeader("Compare");
    tooltip("the render beside a kept one or a picture, and methods to compare");
    if (!is_unfolded) return {};
    Changes changes = draw_methods();
    if (ImGui::Button("keep this render")) changes |= keep_render();
    tooltip(ws_.keys.hint("as a picture with a letter, and as the reference", Command::keep_picture));
    ImGui::SameLine();
    if (ImGui::Button("load a picture")) dialog_.show(FileDialog::Purpose::compare, ws_.scene->loaded().file);
    tooltip("as the reference: EXR or HDR as radiance, PNG or JPEG as what a screen shows");
    return ws_.kept.reference() ? changes | draw_pictures() | draw_modes() : changes;
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

Changes Compare::draw_pictures() {
    Changes changes;
    const KeptPicturesOutcome outcome = list_.draw(ws_.kept);
    if (outcome.measures) changes |= begin_measuring();
    if (outcome.has_changed) changes |= ws_.kept.reference() ? pair_changed() : Changes(Change::display);
    if (!ws_.kept.reference()) ws_.display.comparison = ComparisonMode::none;
    if (measuring_) ImGui::TextUnformatted("measuring ...");
    if (metrics_) draw_metrics(*metrics_, measured_pair_, measured_unit_);
    return changes;
}

Changes Compare::draw_modes() {
    Changes changes;
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
