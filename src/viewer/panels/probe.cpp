#include "viewer/panels/probe.hpp"

#include "core/math.hpp"
#include "viewer/palette.hpp"
#include "viewer/ui.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <fmt/format.h>
#include <imgui.h>
#include <imgui_internal.h>
#include <limits>
#include <utility>

namespace sr::viewer {
namespace {

void put(const std::string& line) { ImGui::TextUnformatted(line.data(), line.data() + line.size()); }

std::string three(vec3 v) { return fmt::format("{:.4g} {:.4g} {:.4g}", v.x, v.y, v.z); }

/// Length that a direction is drawn with: to the light, or `far` if it has no place.
float reach(const scene::Light& light, vec3 x, float far) {
    const auto center = center_of(light);
    return center ? glm::distance(*center, x) : far;
}

void line(ImDrawList& list, const Projection& projection, vec3 from, vec3 to, ImU32 color, float width) {
    const auto a = projection(from), b = projection(to);
    if (a && b) list.AddLine({a->x, a->y}, {b->x, b->y}, color, width);
}

void label(ImDrawList& list, const Projection& projection, vec3 point, const char* text) {
    if (const auto at = projection(point)) list.AddText({at->x + 4.0f, at->y - 6.0f}, palette::white, text);
}

/// Terms of a light, in the order of the columns after the first.
std::array<std::string, 7> cells_of(const render::LightTerms& t) {
    const bool arrives = t.V < 1.0f || t.E != vec3(0.0f); // or else nothing would, without shadows, too
    return {t.solid_angle > 0.0f ? fmt::format("{:.4g}", t.solid_angle) : "-",
            fmt::format("{:.3f} {:.3f} {:.3f}", t.wi.x, t.wi.y, t.wi.z),
            fmt::format("{:.4f}", t.cos_i),
            arrives ? fmt::format("{:.4f}", t.V) : "-",
            fmt::format("{:.4g}", luminance(t.f_r)),
            fmt::format("{:.4g}", luminance(t.E)),
            fmt::format("{:.3g} {:.3g} {:.3g}", t.L_r.x, t.L_r.y, t.L_r.z)};
}

/// render::Probing::Kind of each of cells_of().
constexpr std::array<std::size_t, 7> kind_of_cell{3, 2, 2, 3, 1, 1, 0};

/// Draws the heads, each with a tooltip of its meaning.
void header_cells(const scene::Scene& scene) {
    const auto unit = [&](const char* symbol, scene::Quantity quantity) {
        return fmt::format("{} [{}]", symbol, scene::name_of({quantity, scene.units}));
    };
    const std::array<std::pair<std::string, const char*>, 8> heads{
        {{"light", "its number and name; a click selects it"},
         {"Ω [sr]", "solid angle of the light, seen from x, without shadows"},
         {"ωᵢ", "mean direction to the light, in the world"},
         {"cos θᵢ", "mean cosine of the angle between n and ωᵢ, over what arrives"},
         {"V", "visibility: the share of the light that nothing blocks"},
         {"fᵣ [1/sr]", "BRDF for ωᵢ and ωₒ, as luminance: the mean over what arrives"},
         {unit("E", scene::Quantity::irradiance), "irradiance by this light, shadows included, as luminance"},
         {unit("L", scene::Quantity::radiance), "part of Lₒ that this light makes: red, green, blue"}}};
    draw_table_heads(heads);
}

constexpr ImU32 lobe_veil = IM_COL32(0, 158, 115, 26), lobe_net = IM_COL32(120, 220, 190, 90);

/// Polar diagram of the plane of incidence: half a disk, its centre at the bottom.
class PolarFrame {
public:
    PolarFrame(float radius, float scale) : radius_(radius), scale_(scale) {
        const float margin = 1.6f * ImGui::GetFontSize();
        const ImVec2 corner = ImGui::GetCursorScreenPos();
        middle_ = {corner.x + radius + margin, corner.y + radius + margin};
        ImGui::Dummy({2.0f * (radius + margin), radius + 1.5f * margin});
    }

    ImVec2 at(float angle, float r) const {
        return {middle_.x + radius_ * r * std::sin(angle), middle_.y - radius_ * r * std::cos(angle)};
    }
    void line(float angle, float from, float to, ImU32 color, float width) const {
        list_.AddLine(at(angle, from), at(angle, to), color, width * scale_);
    }
    void dashes(float angle, ImU32 color) const {
        constexpr int count = 12;
        for (int i = 0; i < count; ++i)
            line(angle, (static_cast<float>(i) + 0.2f) / count, (static_cast<float>(i) + 0.7f) / count, color,
                 1.5f);
    }
    void label(float angle, float r, ImU32 color, const std::string& text) const {
        const ImVec2 size = ImGui::CalcTextSize(text.c_str()), p = at(angle, r);
        list_.AddText({p.x - 0.5f * size.x, p.y - 0.5f * size.y}, color, text.c_str());
    }
    /// Half circles at quarters, and a spoke every 30 degrees.
    void grid() const {
        for (const float r : {0.25f, 0.5f, 0.75f, 1.0f}) {
            list_.PathArcTo(middle_, radius_ * r, -pi, 0.0f, 48);
            list_.PathStroke(IM_COL32(120, 120, 120, 110));
        }
        for (int degrees = -90; degrees <= 90; degrees += 30) {
            const float angle = glm::radians(static_cast<float>(degrees));
            line(angle, 0.0f, 1.0f, IM_COL32(120, 120, 120, 110), 1.0f);
            label(angle, 1.1f, palette::grey, fmt::format("{}", degrees));
        }
    }
    ImDrawList& list() const { return list_; }

private:
    float radius_;
    float scale_;
    ImVec2 middle_;
    ImDrawList& list_ = *ImGui::GetWindowDrawList();
};

void draw_curve(const Lobe& lobe, const LobeSettings& look, const LobeScale& to, const PolarFrame& frame) {
    ImDrawList& list = frame.list();
    const auto point = [&](std::size_t meridian, std::size_t i) {
        const std::size_t k = LobeGrid::index(meridian, i);
        const float value = shown_value(lobe, lobe.wi[k], lobe.f_r[k], look);
        list.PathLineTo(frame.at(plane_angle(lobe, lobe.wi[k]), shown_radius(value, to)));
    };
    for (std::size_t i = LobeGrid::points; i > 0; --i) point(LobeGrid::meridians / 2, i);
    for (std::size_t i = 0; i <= LobeGrid::points; ++i) point(0, i);
    list.PathStroke(palette::green, ImDrawFlags_None, 2.0f);
}

/// Draws each light at its θ_i: on the rim, and at the value of the lobe.
void draw_light_directions(const Lobe& lobe, const LobeSettings& look, const LobeScale& to, int hovered,
                           const PolarFrame& frame) {
    for (std::size_t k = 0; k < lobe.light_wi.size(); ++k) {
        if (lobe.light_wi[k] == vec3(0.0f)) continue;
        const bool is_hovered = static_cast<int>(k) == hovered;
        const ImU32 color = is_hovered ? palette::orange : palette::blue;
        const float angle = plane_angle(lobe, lobe.light_wi[k]);
        const float value = shown_value(lobe, lobe.light_wi[k], lobe.light_f_r[k], look);
        frame.line(angle, 0.97f, 1.03f, color, is_hovered ? 4.0f : 2.5f);
        if (!lobe.is_mirror)
            frame.list().AddCircleFilled(frame.at(angle, shown_radius(value, to)), is_hovered ? 5.0f : 3.5f,
                                         color);
        frame.label(angle, 1.2f, color, fmt::format("{}", k));
    }
}

} // namespace

void LobePanel::draw(const Lobe& lobe, int hovered, float scale) {
    ImGui::Checkbox("lobe", &is_shown_);
    tooltip("show the BRDF of this pixel for light from all directions, for the same direction to the eye");
    if (!is_shown_) return;
    int kind = settings_.has_cosine ? 1 : 0;
    ImGui::SameLine();
    ImGui::RadioButton(in_plain_letters("fᵣ").c_str(), &kind, 0);
    tooltip("the BRDF alone [1/sr]");
    ImGui::SameLine();
    ImGui::RadioButton(in_plain_letters("fᵣ cos θᵢ").c_str(), &kind, 1);
    tooltip("the BRDF times the cosine: what a light of the same size and radiance adds from there [1/sr]");
    settings_.has_cosine = kind == 1;
    ImGui::SameLine();
    ImGui::Checkbox("logarithmic", &settings_.is_logarithmic);
    tooltip("lengths by the logarithm, so that a highlight and the rest are seen at once");
    const LobeScale to = scale_of(lobe, settings_);
    const PolarFrame frame(120.0f * scale, scale);
    frame.grid();
    const float theta_o = std::abs(plane_angle(lobe, lobe.wo));
    frame.dashes(-theta_o, palette::white);
    frame.label(-theta_o, 0.85f, palette::white, in_plain_letters("ωₒ"));
    if (lobe.is_mirror) {
        frame.line(theta_o, 0.0f, 1.0f, palette::green, 3.0f);
        ImGui::TextUnformatted(fmt::format("a mirror of reflectance {:.3g}", lobe.f_r[0]).c_str());
    } else {
        draw_curve(lobe, settings_, to, frame);
        ImGui::TextUnformatted(
            in_plain_letters(
                fmt::format("{} at most {:.4g} 1/sr", settings_.has_cosine ? "fᵣ cos θᵢ" : "fᵣ", to.largest))
                .c_str());
        if (settings_.is_logarithmic) {
            ImGui::SameLine();
            ImGui::TextUnformatted(fmt::format("{:.0f} decades", to.decades).c_str());
        }
    }
    draw_light_directions(lobe, settings_, to, hovered, frame);
    ImGui::SameLine();
    ImGui::TextUnformatted(in_plain_letters(fmt::format("  ωₒ at {:.1f}°", glm::degrees(theta_o))).c_str());
}

void LobePanel::draw_in_scene(const Lobe& lobe, vec3 x, const Projection& projection, float scale) const {
    const auto metres = metres_of(x, projection, 130.0f * scale);
    if (!is_shown_ || !metres) return;
    ImDrawList& list = *ImGui::GetBackgroundDrawList();
    const auto place = [&](vec3 wi, float radius) { return projection(x + *metres * radius * wi); };
    if (lobe.is_mirror) {
        const auto from = projection(x), to = place(lobe.wi[0], 1.0f);
        if (!from || !to) return;
        list.AddLine({from->x, from->y}, {to->x, to->y}, palette::green, 3.5f * scale);
        list.AddCircleFilled({to->x, to->y}, 6.0f * scale, palette::green);
        return;
    }
    const LobeScale to = scale_of(lobe, settings_);
    std::vector<ImVec2> places;
    for (std::size_t i = 0; i < lobe.wi.size(); ++i) {
        const float value = shown_value(lobe, lobe.wi[i], lobe.f_r[i], settings_);
        const auto at = place(lobe.wi[i], shown_radius(value, to));
        if (!at) return;
        places.push_back({at->x, at->y});
    }
    const auto at = [&](std::size_t meridian, std::size_t i) { return places[LobeGrid::index(meridian, i)]; };
    for (std::size_t meridian = 0; meridian < LobeGrid::meridians; ++meridian) {
        const bool is_in_plane = meridian % (LobeGrid::meridians / 2) == 0;
        for (std::size_t i = 0; i < LobeGrid::points; ++i) {
            list.AddQuadFilled(at(meridian, i), at(meridian, i + 1), at(meridian + 1, i + 1),
                               at(meridian + 1, i), lobe_veil);
            if (i % 4 == 3) list.AddLine(at(meridian, i + 1), at(meridian + 1, i + 1), lobe_net);
            if (is_in_plane)
                list.AddLine(at(meridian, i), at(meridian, i + 1), palette::green, 2.5f * scale);
            else if (meridian % 2 == 0)
                list.AddLine(at(meridian, i), at(meridian, i + 1), lobe_net);
        }
    }
}

/// Puts a new panel into the corner where it hides the probed pixel and a window "Assignment" least.
void ProbePanel::place_floating() {
    if (!std::exchange(is_placed_, true)) frames_to_place_ = 3;
    ImGui::SetNextWindowSizeConstraints(
        {0.0f, 0.0f}, {ImGui::GetMainViewport()->Size.x, 0.6f * ImGui::GetMainViewport()->Size.y});
    if (frames_to_place_-- <= 0) return;
    const ImVec2 view = ImGui::GetMainViewport()->Size;
    const ImGuiWindow* window = ImGui::FindWindowByName(side::assignment);
    const ImVec2 from = window && window->WasActive ? window->Pos : ImVec2(0.0f, 0.0f);
    const ImVec2 size = window && window->WasActive ? window->Size : ImVec2(0.0f, 0.0f);
    const float pixel =
        view.y * static_cast<float>(result->row) / static_cast<float>(std::max(1, result->height));
    const auto overlap = [](float a, float b, float c, float d) {
        return std::max(0.0f, std::min(b, d) - std::max(a, c));
    };
    const float bottom = view.y - 3.0f * ImGui::GetFontSize();
    vec2 best(0.0f);
    float min_cost = std::numeric_limits<float>::infinity();
    for (const float x : {view.x - 12.0f - size_.x, 12.0f})
        for (const float y : {bottom - size_.y, 12.0f}) {
            const float over = overlap(x, x + size_.x, from.x, from.x + size.x)
                               * overlap(y, y + size_.y, from.y, from.y + size.y);
            const float hidden = pixel >= y && pixel <= y + size_.y ? 0.25f * size_.x * size_.y : 0.0f;
            if (over + hidden >= min_cost) continue;
            min_cost = over + hidden;
            best = {x, y};
        }
    ImGui::SetNextWindowPos({best.x, best.y});
}

void ProbePanel::draw(const scene::RenderScene& stage, const LightEditor& lights, LightSelection& selected,
                      Layout& layout, const Ui& ui) {
    if (!result) {
        is_placed_ = false;
        return;
    }
    bool is_open = true;
    hovered_ = -1;
    const bool is_docked = layout.is_docked();
    if (is_docked)
        place_next_window(layout.take_below_picture(size_.y));
    else
        place_floating();
    const std::string title = in_plain_letters("Lₒ = Lₑ + Σ E fᵣ") + "###probe";
    if (ImGui::Begin(title.c_str(), &is_open, ui.panel_flags(is_docked) | ImGuiWindowFlags_NoNavInputs)) {
        if (is_docked) draw_head(ui, is_open);
        ImGui::BeginGroup();
        draw_terms(stage, lights, selected);
        ImGui::EndGroup();
        const float lobe_width = 300.0f * ui.scale();
        if (is_docked && ImGui::GetItemRectSize().x + lobe_width < ImGui::GetWindowSize().x)
            ImGui::SameLine(0.0f, ImGui::GetFontSize());
        if (result->lobe) {
            ImGui::BeginGroup();
            lobe_.draw(*result->lobe, hovered_, ui.scale());
            ImGui::EndGroup();
        }
    }
    if (!is_docked) keep_in_viewport();
    const ImGuiWindow& window = *ImGui::GetCurrentWindow();
    const float margin = 2.0f * ImGui::GetStyle().WindowPadding.y;
    size_ = {ImGui::GetWindowSize().x, is_docked ? window.ContentSize.y + margin : ImGui::GetWindowSize().y};
    ImGui::End();
    if (!is_open) result.reset();
}

/// Draws the title and the button that closes the panel.
void ProbePanel::draw_head(const Ui& ui, bool& is_open) {
    ImGui::PushFont(ui.fonts().heading);
    put(in_plain_letters("Lₒ = Lₑ + Σ E fᵣ"));
    ImGui::PopFont();
    const float button = ImGui::GetFrameHeight();
    ImGui::SameLine(ImGui::GetWindowContentRegionMax().x - button);
    if (ImGui::Button("x", {button, 0.0f})) is_open = false;
    tooltip("close (Esc)");
}

void ProbePanel::draw_terms(const scene::RenderScene& stage, const LightEditor& lights,
                            LightSelection& selected) {
    const render::PixelTerms& terms = result->terms;
    put(fmt::format("pixel {},{}, {} samples{}, coverage {:.3g}", result->column, result->row,
                    result->samples, result->is_complete ? "" : " (refining)", terms.coverage));
    const glm::dvec3 x = stage.scene.origin + glm::dvec3(terms.x); // in the file's world
    const bool is_far = stage.scene.origin != glm::dvec3(0.0);
    ImGui::PushTextWrapPos();
    put(in_plain_letters(
        fmt::format("x {} m   n {}   ωₒ {}",
                    is_far ? fmt::format("{:.10g} {:.10g} {:.10g}", x.x, x.y, x.z) : three(terms.x),
                    three(terms.n), three(terms.wo))));
    ImGui::PopTextWrapPos();
    draw_table(stage, lights, selected);
    vec3 sum = terms.L_e;
    for (const render::LightTerms& light : terms.lights) sum += light.L_r;
    put(in_plain_letters(
        fmt::format("Lₑ {}   Lₑ + Σ {}   Lₒ {} {}", three(terms.L_e), three(sum), three(terms.L_o),
                    with_superscripts(std::string(scene::radiance_unit(stage.scene.units))))));
    if (result->reference)
        ImGui::TextDisabled(
            "%s", in_plain_letters(fmt::format("Lower numbers: the reference. Lₑ {}   Lₒ {}",
                                               three(result->reference->L_e), three(result->reference->L_o)))
                      .c_str());
}

/// Draws a row for each light. Columns that have no room are reached by scrolling; the names stay.
void ProbePanel::draw_table(const scene::RenderScene& stage, const LightEditor& lights,
                            LightSelection& selected) {
    const auto count = static_cast<int>(result->terms.lights.size());
    const bool is_cut = table_width_ > ImGui::GetContentRegionAvail().x;
    const float lines = result->reference ? 2.0f : 1.0f, margin = 2.0f * ImGui::GetStyle().CellPadding.y;
    const float rows = (1.0f + lines * static_cast<float>(count)) * (ImGui::GetTextLineHeight() + margin);
    const ImVec2 size{0.0f, is_cut ? rows + ImGui::GetStyle().ScrollbarSize + margin : 0.0f};
    const auto flags = ImGuiTableFlags_SizingFixedFit | ImGuiTableFlags_RowBg | ImGuiTableFlags_BordersInnerV
                       | (is_cut ? ImGuiTableFlags_ScrollX : ImGuiTableFlags_NoHostExtendX);
    if (!ImGui::BeginTable("lights", 8, flags, size)) return;
    if (is_cut) ImGui::TableSetupScrollFreeze(1, 1);
    header_cells(stage.scene);
    for (int k = 0; k < count; ++k) draw_row(k, stage, lights, selected);
    table_width_ = ImGui::GetCurrentTable()->ColumnsAutoFitWidth;
    ImGui::EndTable();
}

void ProbePanel::draw_row(int k, const scene::RenderScene& stage, const LightEditor& lights,
                          LightSelection& selected) {
    const render::LightTerms& t = result->terms.lights[static_cast<std::size_t>(k)];
    const auto& entries = lights.entries();
    const auto entry = std::ranges::find_if(
        entries, [k](const LightEntry& l) { return std::ranges::find(l.lights, k) != l.lights.end(); });
    const auto index = static_cast<std::size_t>(entry - entries.begin());
    const auto name = scene::name_of(stage.lights[static_cast<std::size_t>(k)]);
    ImGui::TableNextRow();
    ImGui::TableNextColumn();
    const std::string label = fmt::format("{} {}", k, name);
    if (ImGui::Selectable(label.c_str(), entry != entries.end() && selected.contains(index),
                          ImGuiSelectableFlags_SpanAllColumns)
        && entry != entries.end())
        selected = index;
    if (ImGui::IsItemHovered()) hovered_ = k;
    const auto cells = cells_of(t);
    const bool has_reference =
        result->reference && result->reference->lights.size() == result->terms.lights.size();
    const auto theirs =
        has_reference ? cells_of(result->reference->lights[static_cast<std::size_t>(k)]) : cells;
    for (std::size_t i = 0; i < cells.size(); ++i) {
        ImGui::TableNextColumn();
        put(result->has[kind_of_cell[i]] ? cells[i] : "...");
        if (has_reference) ImGui::TextDisabled("%s", theirs[i].c_str());
    }
}

void ProbePanel::draw_directions(const scene::RenderScene& stage, const Projection& projection,
                                 float scale) const {
    if (!result) return;
    const render::PixelTerms& terms = result->terms;
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
    if (result->lobe) lobe_.draw_in_scene(*result->lobe, terms.x, projection, scale);
    line(list, projection, terms.x, terms.x + 0.15f * far * terms.n, palette::white, 2.0f * scale);
    label(list, projection, terms.x + 0.15f * far * terms.n, "n");
    line(list, projection, terms.x, terms.x + 0.2f * far * terms.wo, palette::white, 1.0f * scale);
    label(list, projection, terms.x + 0.2f * far * terms.wo, in_plain_letters("ωₒ").c_str());
    if (const auto at = projection(terms.x))
        list.AddCircleFilled({at->x, at->y}, 4.0f * scale, palette::orange);
}

} // namespace sr::viewer
