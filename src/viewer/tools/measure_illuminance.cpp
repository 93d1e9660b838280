// Illuminance tool: measures the light on a plane, and shows it as isolines, as a plan and as figures.
#include "core/error.hpp"
#include "image/whole_file.hpp"
#include "viewer/config.hpp"
#include "viewer/panels/illuminance.hpp"
#include "viewer/tools/tool.hpp"

#include <algorithm>
#include <chrono>
#include <fmt/format.h>
#include <utility>

namespace sr::viewer {
namespace {

constexpr double settle_time = 0.3; // [s] without a change before the plane is measured again

} // namespace

class MeasureIlluminance : public Tool {
public:
    using Tool::Tool;

    std::optional<Changes> handle(const Event& event) override;
    Changes update(double seconds) override;
    void notice(Changes changes) override;
    Changes draw(const Overlay& overlay) override;
    Activity activity() const override {
        if (!is_open_ || is_measured_ || ws_.is_mixing) return Activity::idle;
        return render_ ? Activity::active : Activity::waiting;
    }

private:
    Changes toggle();
    void measure_again();
    void start();
    void advance();
    void take_samples();
    void fail(const std::string& problem);
    void report() const;
    std::string progress() const;
    std::string condition() const;
    Changes apply(const IlluminanceOutcome& outcome);
    std::vector<scene::Light> lamps() const;
    void write(const std::string& extension);
    std::optional<output::GridPlace> pointed_cell() const;

    bool is_open_ = false;
    IlluminanceChoice choice_;
    IlluminancePanel panel_;
    std::optional<picture::IlluminanceRender> render_; // while it measures
    std::optional<MeasuredIlluminance> measured_;
    std::vector<output::NamedGrid> parts_; // so far
    int light_ = -1;                       // that is measured alone; -1: all lights
    std::string problem_;
    bool is_measured_ = false; // or refused: nothing is left to do
    double since_change_ = 0.0;
};

std::optional<Changes> MeasureIlluminance::handle(const Event& event) {
    const auto command = command_in(event);
    if (command == Command::illuminance && ws_.show_panel(side::illuminance) && is_open_)
        return Change::redraw;
    if (command == Command::illuminance || (command == Command::cancel && is_open_)) return toggle();
    if (command != Command::write_illuminance) return std::nullopt;
    write(".csv");
    write(".svg");
    return Change::redraw;
}

Changes MeasureIlluminance::toggle() {
    is_open_ = !is_open_;
    render_.reset();
    if (is_open_) measure_again();
    return Change::redraw;
}

void MeasureIlluminance::measure_again() {
    render_.reset();
    is_measured_ = false;
    since_change_ = 0.0;
}

void MeasureIlluminance::notice(Changes changes) {
    if (changes == everything) {
        measured_.reset();
        choice_.receiver.plane.reset(); // of another scene
        choice_.plane.fill('\0');
    }
    if (changes.has(Change::lights) || changes.has(Change::shadows)) measure_again();
}

Changes MeasureIlluminance::update(double seconds) {
    if (!is_open_) return {};
    since_change_ += seconds;
    const bool is_settled = since_change_ > settle_time && !ws_.is_time_held && !ws_.is_mixing
                            && !ws_.scene->render().is_interactive();
    if (is_measured_ || !is_settled) return {};
    try {
        if (!render_) start();
        advance();
    } catch (const Error& error) {
        fail(error.what());
    }
    return Change::redraw;
}

void MeasureIlluminance::fail(const std::string& problem) {
    problem_ = problem;
    ws_.messages.log("Illuminance: " + problem);
    render_.reset();
    measured_.reset();
    is_measured_ = true;
}

void MeasureIlluminance::start() {
    problem_.clear();
    parts_.clear();
    light_ = -1;
    const scene::RenderScene& stage = ws_.scene->stage();
    const std::string& file = ws_.scene->loaded().file;
    if (stage.lights.empty())
        throw Error({file}, "nothing in the scene emits light",
                    ws_.keys.hint("add a light", Command::add_light));
    const std::string plane = choice_.plane.data();
    choice_.receiver.plane.reset();
    if (!plane.empty()) choice_.receiver.plane = picture::parse_plane(plane);
    const scene::Receiver receiver = picture::receiver_of(choice_.receiver, stage.scene, file);
    const double longer = std::max(glm::length(receiver.u), glm::length(receiver.v));
    const settings::Size cells = picture::cells_of(receiver, longer / choice_.cells);
    render::RenderOptions options = render_options(ws_.options, cells.width, cells.height);
    options.estimator = render::Estimator::sampled;
    options.samples = picture::illuminance_samples;
    render_.emplace(ws_.scene->shown_stage(), receiver, ws_.options, options);
    render_->begin();
}

/// Works for a short while.
void MeasureIlluminance::advance() {
    constexpr auto budget = std::chrono::milliseconds(30);
    const auto end = std::chrono::steady_clock::now() + budget;
    while (render_ && std::chrono::steady_clock::now() < end)
        if (render_->add_rows(1 + render_->rows() / 4)) take_samples();
}

/// Shows the cells after 1, 4, 16 and all samples, then goes on to the lights one by one.
void MeasureIlluminance::take_samples() {
    const int samples = render_->sample_count();
    const bool is_complete = samples == picture::illuminance_samples;
    if (light_ < 0 && (is_complete || samples == 1 || samples == 4 || samples == 16)) {
        measured_.emplace(render_->grid(), samples);
        panel_.measured_again();
    }
    if (!is_complete) return;
    if (light_ >= 0) parts_.push_back({render_->name_of_light(light_), render_->grid()});
    if (choice_.has_parts && ++light_ < render_->light_count()) return render_->begin(light_, light_ + 1);
    measured_->parts = std::exchange(parts_, {});
    render_.reset();
    is_measured_ = true;
    report();
}

void MeasureIlluminance::report() const {
    const output::IlluminanceSummary& summary = measured_->summary;
    ws_.messages.notify(
        fmt::format("Illuminance: mean {:.4g} {}, min {:.4g}, max {:.4g}, min/mean {:.3f}, {}x{} "
                    "cells{}.",
                    summary.mean, measured_->grid.unit, summary.min, summary.max, summary.min_over_mean(),
                    measured_->grid.columns, measured_->grid.rows, condition()));
}

/// Describes how the light that is measured, which is that of the picture, differs from the file's.
std::string MeasureIlluminance::condition() const {
    const auto& entries = ws_.scene->lights().entries();
    const auto alone = ws_.scene->alone();
    const auto off =
        std::ranges::count_if(entries, [](const LightEntry& light) { return !light.is_enabled; });
    const std::size_t hidden = ws_.scene->loaded().hidden.size();
    std::string text;
    if (alone && *alone < entries.size())
        text = fmt::format(", by {} alone", entries[*alone].name);
    else if (off > 0)
        text = fmt::format(", without {} light{} that {} off", off, off == 1 ? "" : "s",
                           off == 1 ? "is" : "are");
    if (hidden > 0) text += fmt::format(", without {} hidden object{}", hidden, hidden == 1 ? "" : "s");
    return text;
}

std::string MeasureIlluminance::progress() const {
    if (!problem_.empty()) return "not measured";
    if (is_measured_)
        return fmt::format("{} x {} cells, {} samples each{}", measured_->grid.columns, measured_->grid.rows,
                           measured_->samples, condition());
    if (ws_.is_mixing)
        return ws_.keys.hint("measured when mixing has ended", Command::mix_lights)
               + (measured_ ? "; these are the figures before" : "");
    if (!render_) return "waiting for the picture";
    const std::string samples =
        fmt::format("{} of {} samples", render_->sample_count(), picture::illuminance_samples);
    return light_ < 0
               ? "measuring: " + samples
               : fmt::format("measuring light {} of {}: {}", light_ + 1, render_->light_count(), samples);
}

/// The cell that the pointer is over in the picture.
std::optional<output::GridPlace> MeasureIlluminance::pointed_cell() const {
    const vec2 at = ws_.input.pointer();
    if (ws_.ui.has_pointer() || !choice_.is_over_picture || !ws_.shown_area().contains(at))
        return std::nullopt;
    return measured_->cell_on(ws_.projection().ray(at));
}

Changes MeasureIlluminance::draw(const Overlay& overlay) {
    if (!is_open_) return {};
    const PanelPlace place = ws_.layout.take_side(side::illuminance);
    if (measured_ && choice_.is_over_picture)
        draw_isolines(*measured_, overlay.projection, overlay.scale, overlay.hides);
    if (!place.is_shown) return {};
    const auto pointed = measured_ ? pointed_cell() : std::nullopt;
    return apply(panel_.draw(choice_, measured_ ? &*measured_ : nullptr, progress(), problem_, pointed,
                             place.area, ws_.ui));
}

Changes MeasureIlluminance::apply(const IlluminanceOutcome& outcome) {
    if (outcome.measures_again) measure_again();
    if (outcome.writes_csv) write(".csv");
    if (outcome.writes_plan) write(".svg");
    if (outcome.closes) return toggle();
    const bool has_changed =
        outcome.measures_again || outcome.redraws || outcome.writes_csv || outcome.writes_plan;
    return has_changed ? Changes(Change::redraw) : Changes();
}

/// The lights that a plan marks.
std::vector<scene::Light> MeasureIlluminance::lamps() const {
    const auto alone = ws_.scene->alone();
    const LightEditor& lights = ws_.scene->lights();
    return alone && *alone < lights.entries().size() ? lights.lights_of(*alone) : ws_.scene->stage().lights;
}

void MeasureIlluminance::write(const std::string& extension) {
    if (!is_open_ || !is_measured_ || !measured_)
        return ws_.messages.notify(is_open_
                                       ? "The plane is not measured yet."
                                       : ws_.keys.text(Command::illuminance) + " measures a plane first.");
    const std::string& scene_file = ws_.scene->loaded().file;
    const std::string file = free_name(scene_file, extension);
    try {
        image::write_text(file, extension == ".csv"
                                    ? output::csv_of(measured_->grid, measured_->parts)
                                    : picture::plan_of(measured_->grid, {}, lamps(), scene_file));
        ws_.messages.notify(fmt::format("Wrote {}{}.", file, condition()));
    } catch (const Error& error) {
        ws_.messages.fail("Cannot write the illuminance.", error.what());
    }
}

std::unique_ptr<Tool> make_measure_illuminance(Workspace& workspace) {
    return std::make_unique<MeasureIlluminance>(workspace);
}

} // namespace sr::viewer
