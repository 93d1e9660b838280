// Time tool: a panel with the time of a sample and of a frame by parts, shadow rays, and memory.
#include "viewer/tools/tool.hpp"

#include <algorithm>
#include <array>
#include <fmt/format.h>
#include <fstream>
#include <imgui.h>
#include <optional>
#include <span>
#include <string>
#include <unistd.h>
#include <utility>
#include <vector>

namespace sr::viewer {
namespace {

struct Part {
    const char* name;
    double seconds;
    const char* meaning;
};

constexpr double mebibyte = 1024.0 * 1024.0;

/// Memory of the process in MiB; absent where the system does not say it.
std::optional<double> resident_memory() {
    std::ifstream file("/proc/self/statm");
    double pages = 0.0, resident = 0.0;
    if (!(file >> pages >> resident)) return std::nullopt;
    return resident * static_cast<double>(sysconf(_SC_PAGESIZE)) / mebibyte;
}

using SampleTimes = ProgressiveRender::SampleTimes;

/// The mean of the samples: by pass, if the passes were measured.
std::vector<Part> parts_of_sample(const SampleTimes& times) {
    const double samples = std::max(1, times.samples);
    const double rays = times.rays ? times.rays->seconds : 0.0;
    const Part traced{"shadow rays", rays / samples, "that the CPU traced"};
    if (!times.passes)
        return {{"surfaces", (times.seconds - rays) / samples,
                 "depth, shading and adding to the film; with shadow rays that the GPU traces"},
                traced};
    const auto& [depth, shading, adding] = *times.passes;
    return {{"depth", depth / samples, "of opaque surfaces, with depth maps and the background"},
            {"shading", (shading - rays) / samples,
             "of opaque and of blended surfaces; with shadow rays that the GPU traces"},
            traced,
            {"adding", adding / samples, "of the frame to the film"},
            {"the rest", (times.seconds - depth - shading - adding) / samples,
             "between the passes: memory that a film needs first, and the time that other programs took"}};
}

void draw_parts(const char* name, std::span<const Part> parts) {
    if (!ImGui::BeginTable(name, 2, ImGuiTableFlags_SizingStretchProp)) return;
    double sum = 0.0;
    for (const Part& part : parts) sum += part.seconds;
    const auto row = [](const char* label, double seconds, const char* meaning) {
        ImGui::TableNextRow();
        ImGui::TableNextColumn();
        ImGui::TextUnformatted(label);
        tooltip(meaning);
        ImGui::TableNextColumn();
        ImGui::Text("%.2f ms", 1e3 * seconds);
    };
    row(name, sum, "all parts together");
    for (const Part& part : parts) row(part.name, part.seconds, part.meaning);
    ImGui::EndTable();
}

} // namespace

class ShowTimes : public Tool {
public:
    using Tool::Tool;

    std::optional<Changes> handle(const Event& event) override;
    Changes update(double seconds) override;
    Changes draw(const Overlay& overlay) override;

private:
    void draw_contents();
    void report() const;

    bool is_open_ = false;
    bool was_converged_ = false;
};

std::optional<Changes> ShowTimes::handle(const Event& event) {
    if (command_in(event) != Command::times) return std::nullopt;
    if (ws_.show_panel(side::times) && is_open_) return Change::redraw;
    is_open_ = !is_open_;
    ws_.statistics.measures_frames = is_open_;
    was_converged_ = false;
    return Change::redraw;
}

Changes ShowTimes::update(double /*seconds*/) {
    ws_.scene->render().measure_passes(is_open_); // a scene that was loaded has another render
    if (!is_open_) return {};
    const ProgressiveRender& render = ws_.scene->render();
    if (render.is_converged() && !std::exchange(was_converged_, true)) report();
    if (!render.is_converged()) was_converged_ = false;
    return {};
}

void ShowTimes::report() const {
    std::string text;
    for (const Part& part : parts_of_sample(ws_.scene->render().sample_times()))
        text += fmt::format("{}{} {:.3f} ms", text.empty() ? "" : ", ", part.name, 1e3 * part.seconds);
    ws_.messages.log(fmt::format("A sample: {}.", text));
}

void ShowTimes::draw_contents() {
    const ProgressiveRender& render = ws_.scene->render();
    const SampleTimes times = render.sample_times();
    ImGui::TextWrapped("%s", progress_of(render).c_str());
    ImGui::Separator();
    draw_parts("a sample", parts_of_sample(times));
    if (!times.passes) ImGui::TextDisabled("the next picture is measured by pass");
    ImGui::TextDisabled("mean of %d samples of %d x %d pixels", times.samples, ws_.width, ws_.height);
    if (times.rays && times.rays->seconds > 0.0)
        ImGui::TextDisabled("%.3g million rays a second",
                            1e-6 * static_cast<double>(times.rays->count) / times.rays->seconds);
    ImGui::Separator();
    const FrameTimes& frame = ws_.statistics.last_frame;
    draw_parts("a frame",
               std::array<Part, 3>{{{"sampling", frame.sampling, "samples of the render, whole or in part"},
                                    {"display", frame.display, "exposure and tone curve of the film"},
                                    {"panels", frame.panels, "panels, and marks over the picture"}}});
    ImGui::Separator();
    double kept = 0.0;
    for (const KeptPicture& picture : ws_.kept.all())
        kept += sizeof(float) * static_cast<double>(picture.picture.film().pixels.size());
    if (const auto memory = resident_memory()) ImGui::Text("memory: %.0f MiB", *memory);
    tooltip("of this process; in software GL with all textures and films");
    if (kept > 0.0) ImGui::Text("kept pictures: %.0f MiB", kept / mebibyte);
}

Changes ShowTimes::draw(const Overlay& overlay) {
    if (!is_open_) return {};
    const PanelPlace place = ws_.layout.take_side(side::times);
    if (!place.is_shown) return {};
    if (place.area)
        place_next_window(*place.area);
    else
        ImGui::SetNextWindowSize({260.0f * overlay.scale, 0.0f}, ImGuiCond_FirstUseEver);
    if (ImGui::Begin(side::times, nullptr, ws_.ui.panel_flags(place.area.has_value()))) {
        heading("Time", ws_.ui);
        draw_contents();
    }
    if (!place.area) keep_in_viewport();
    ImGui::End();
    return {};
}

std::unique_ptr<Tool> make_show_times(Workspace& workspace) { return std::make_unique<ShowTimes>(workspace); }

} // namespace sr::viewer
