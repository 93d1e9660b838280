#include "viewer/lobe_panel.hpp"

#include "viewer/palette.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <imgui.h>

namespace sr::viewer {
namespace {

constexpr ImU32 lobe_veil = IM_COL32(0, 158, 115, 26), lobe_net = IM_COL32(120, 220, 190, 90);

/// Half a disk, its middle below: where directions of the plane of incidence go.
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
    void label(float angle, float r, ImU32 color, const std::string& words) const {
        const ImVec2 size = ImGui::CalcTextSize(words.c_str()), p = at(angle, r);
        list_.AddText({p.x - 0.5f * size.x, p.y - 0.5f * size.y}, color, words.c_str());
    }
    /// Half circles at quarters, a spoke every 30°.
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

void draw_curve(const Lobe& lobe, const LobeLook& look, const LobeScale& to, const PolarFrame& frame) {
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

/// Each light at its θ_i: on the rim, and on the lobe's value in its direction.
void draw_lights(const Lobe& lobe, const LobeLook& look, const LobeScale& to, int hovered,
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
    if (!is_shown_) return;
    int kind = look_.has_cosine ? 1 : 0;
    ImGui::SameLine();
    ImGui::RadioButton("f_r", &kind, 0);
    ImGui::SameLine();
    ImGui::RadioButton("f_r cos_i", &kind, 1);
    look_.has_cosine = kind == 1;
    ImGui::SameLine();
    ImGui::Checkbox("logarithmic", &look_.is_logarithmic);
    const LobeScale to = scale_of(lobe, look_);
    const PolarFrame frame(120.0f * scale, scale);
    frame.grid();
    const float theta_o = std::abs(plane_angle(lobe, lobe.wo));
    frame.dashes(-theta_o, palette::white);
    frame.label(-theta_o, 0.85f, palette::white, "wo");
    if (lobe.is_mirror) {
        frame.line(theta_o, 0.0f, 1.0f, palette::green, 3.0f);
        ImGui::TextUnformatted(fmt::format("a mirror of reflectance {:.3g}", lobe.f_r[0]).c_str());
    } else {
        draw_curve(lobe, look_, to, frame);
        ImGui::TextUnformatted(
            fmt::format("{} at most {:.4g} 1/sr", look_.has_cosine ? "f_r cos_i" : "f_r", to.largest)
                .c_str());
        if (look_.is_logarithmic) {
            ImGui::SameLine();
            ImGui::TextUnformatted(fmt::format("{:.0f} decades", to.decades).c_str());
        }
    }
    draw_lights(lobe, look_, to, hovered, frame);
    ImGui::SameLine();
    ImGui::TextUnformatted(fmt::format("  wo at {:.1f} deg", glm::degrees(theta_o)).c_str());
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
    const LobeScale to = scale_of(lobe, look_);
    std::vector<ImVec2> places;
    for (std::size_t i = 0; i < lobe.wi.size(); ++i) {
        const float value = shown_value(lobe, lobe.wi[i], lobe.f_r[i], look_);
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

} // namespace sr::viewer
