#include "viewer/probe_panel.hpp"

#include "image/luminance.hpp"
#include "viewer/palette.hpp"

#include <algorithm>
#include <array>
#include <fmt/format.h>
#include <imgui.h>

namespace sr::viewer {
namespace {

void put(const std::string& line) { ImGui::TextUnformatted(line.data(), line.data() + line.size()); }

std::string three(vec3 v) { return fmt::format("{:.4g} {:.4g} {:.4g}", v.x, v.y, v.z); }

/// Until where a direction is drawn: to the light, or as far as the picture reaches.
float reach(const scene::Light& light, vec3 x, float far) {
    const auto center = center_of(light);
    return center ? glm::distance(*center, x) : far;
}

void line(ImDrawList& list, const Projection& projection, vec3 from, vec3 to, ImU32 color, float width) {
    const auto a = projection(from), b = projection(to);
    if (a && b) list.AddLine({a->x, a->y}, {b->x, b->y}, color, width);
}

void label(ImDrawList& list, const Projection& projection, vec3 point, const char* words) {
    if (const auto at = projection(point)) list.AddText({at->x + 4.0f, at->y - 6.0f}, palette::white, words);
}

/// A light's terms, in the order of the table's columns after the first.
std::array<std::string, 7> cells_of(const render::LightTerms& t) {
    return {t.solid_angle > 0.0f ? fmt::format("{:.4g}", t.solid_angle) : "-",
            fmt::format("{:.3f} {:.3f} {:.3f}", t.wi.x, t.wi.y, t.wi.z),
            fmt::format("{:.4f}", t.cos_i),
            fmt::format("{:.4f}", t.V),
            fmt::format("{:.4g}", image::luminance(t.f_r)),
            fmt::format("{:.4g}", image::luminance(t.E)),
            three(t.L_r)};
}

void header_cells(const scene::Scene& scene) {
    const auto unit = [&](const char* symbol, scene::Quantity quantity) {
        return fmt::format("{} [{}]", symbol, scene::name_of({quantity, scene.units}));
    };
    for (const std::string& head :
         {std::string("light"), std::string("Omega [sr]"), std::string("wi"), std::string("cos_i"),
          std::string("V"), std::string("f_r [1/sr]"), unit("E", scene::Quantity::irradiance),
          unit("L", scene::Quantity::radiance)})
        ImGui::TableSetupColumn(head.c_str());
    ImGui::TableHeadersRow();
}

} // namespace

void ProbePanel::draw(const scene::Stage& stage, const LightEditor& lighting,
                      std::optional<std::size_t>& selected, float scale) {
    if (!answer) return;
    const render::PixelTerms& terms = answer->terms;
    bool is_open = true;
    hovered_ = -1;
    // Where it leaves the pixel in sight.
    const ImVec2 size = ImGui::GetMainViewport()->Size;
    const bool is_pixel_low = 2 * answer->row > answer->height;
    ImGui::SetNextWindowPos({size.x - 12.0f, is_pixel_low ? 12.0f : size.y - 3.0f * ImGui::GetFontSize()},
                            ImGuiCond_Appearing, {1.0f, is_pixel_low ? 0.0f : 1.0f});
    ImGui::SetNextWindowSizeConstraints(
        {0.0f, 0.0f}, {ImGui::GetMainViewport()->Size.x, 0.6f * ImGui::GetMainViewport()->Size.y});
    if (ImGui::Begin("L_o = L_e + sum of E f_r", &is_open,
                     ImGuiWindowFlags_AlwaysAutoResize | ImGuiWindowFlags_NoNavInputs)) {
        put(fmt::format("pixel {},{}, {} samples, coverage {:.3g}", answer->column, answer->row,
                        answer->samples, terms.coverage));
        const glm::dvec3 x = stage.scene.origin + glm::dvec3(terms.x); // in the file's world
        const bool is_far = stage.scene.origin != glm::dvec3(0.0);
        put(fmt::format("x {} m   n {}   wo {}",
                        is_far ? fmt::format("{:.10g} {:.10g} {:.10g}", x.x, x.y, x.z) : three(terms.x),
                        three(terms.n), three(terms.wo)));
        const auto flags =
            ImGuiTableFlags_SizingFixedFit | ImGuiTableFlags_RowBg | ImGuiTableFlags_BordersInnerV;
        if (ImGui::BeginTable("lights", 8, flags)) {
            header_cells(stage.scene);
            for (int k = 0; k < static_cast<int>(terms.lights.size()); ++k)
                draw_row(k, stage, lighting, selected);
            ImGui::EndTable();
        }
        vec3 sum = terms.L_e;
        for (const render::LightTerms& light : terms.lights) sum += light.L_r;
        put(fmt::format("L_e {}   sum {}   L_o {}", three(terms.L_e), three(sum), three(terms.L_o)));
        if (answer->reference)
            ImGui::TextDisabled("%s",
                                fmt::format("The lower numbers are the reference's: L_e {}   L_o {}",
                                            three(answer->reference->L_e), three(answer->reference->L_o))
                                    .c_str());
        if (answer->lobe) lobe_.draw(*answer->lobe, hovered_, scale);
    }
    ImGui::End();
    if (!is_open) answer.reset();
}

void ProbePanel::draw_row(int k, const scene::Stage& stage, const LightEditor& lighting,
                          std::optional<std::size_t>& selected) {
    const render::LightTerms& t = answer->terms.lights[static_cast<std::size_t>(k)];
    const auto& lamps = lighting.entries();
    const auto lamp = std::ranges::find_if(
        lamps, [k](const LightEntry& l) { return std::ranges::find(l.lights, k) != l.lights.end(); });
    const auto index = static_cast<std::size_t>(lamp - lamps.begin());
    const std::string& name = scene::name_of(stage.lights[static_cast<std::size_t>(k)]);
    ImGui::TableNextRow();
    ImGui::TableNextColumn();
    const std::string label = fmt::format("{} {}", k, name);
    if (ImGui::Selectable(label.c_str(), lamp != lamps.end() && selected == index,
                          ImGuiSelectableFlags_SpanAllColumns)
        && lamp != lamps.end())
        selected = index;
    if (ImGui::IsItemHovered()) hovered_ = k;
    const auto cells = cells_of(t);
    const bool has_reference =
        answer->reference && answer->reference->lights.size() == answer->terms.lights.size();
    const auto theirs =
        has_reference ? cells_of(answer->reference->lights[static_cast<std::size_t>(k)]) : cells;
    for (std::size_t i = 0; i < cells.size(); ++i) {
        ImGui::TableNextColumn();
        put(cells[i]);
        if (has_reference) ImGui::TextDisabled("%s", theirs[i].c_str());
    }
}

void ProbePanel::draw_directions(const scene::Stage& stage, const Projection& projection, float scale) const {
    if (!answer) return;
    const render::PixelTerms& terms = answer->terms;
    if (terms.coverage == 0.0f || terms.lights.size() != stage.lights.size()) return;
    ImDrawList& list = *ImGui::GetBackgroundDrawList();
    const vec3 eye(projection.camera.world_from_camera[3]);
    const float far = glm::distance(eye, terms.x);
    for (std::size_t k = 0; k < terms.lights.size(); ++k) {
        const vec3 wi = terms.lights[k].wi;
        if (wi == vec3(0.0f)) continue;
        const bool is_hovered = static_cast<int>(k) == hovered_;
        line(list, projection, terms.x, terms.x + reach(stage.lights[k], terms.x, far) * glm::normalize(wi),
             is_hovered ? palette::orange : palette::blue, (is_hovered ? 3.5f : 1.5f) * scale);
    }
    if (answer->lobe) lobe_.draw_in_scene(*answer->lobe, terms.x, projection, scale);
    line(list, projection, terms.x, terms.x + 0.15f * far * terms.n, palette::white, 2.0f * scale);
    label(list, projection, terms.x + 0.15f * far * terms.n, "n");
    line(list, projection, terms.x, terms.x + 0.2f * far * terms.wo, palette::white, 1.0f * scale);
    label(list, projection, terms.x + 0.2f * far * terms.wo, "wo");
    if (const auto at = projection(terms.x))
        list.AddCircleFilled({at->x, at->y}, 4.0f * scale, palette::orange);
}

} // namespace sr::viewer
