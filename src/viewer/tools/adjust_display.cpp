// Display tool: exposure, tone curve, false colour.
#include "viewer/tools/tool.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <fmt/format.h>
#include <imgui.h>

namespace sr::viewer {
namespace {

constexpr float exposure_step = 1.0f / 3.0f; // [EV]

/// In the order of image::ToneCurve.
constexpr std::array curves{"linear", "ACES", "neutral", "AgX"};

/// Draws the colours of false colour and the luminances that they stand for.
void draw_legend(const DisplaySettings& display, std::string_view unit) {
    // The colours of shaders/display/false_color.glsl.
    constexpr std::array<ImU32, 9> viridis{
        IM_COL32(68, 1, 84, 255),    IM_COL32(71, 45, 123, 255),  IM_COL32(59, 82, 139, 255),
        IM_COL32(44, 114, 142, 255), IM_COL32(33, 145, 140, 255), IM_COL32(39, 174, 129, 255),
        IM_COL32(92, 200, 99, 255),  IM_COL32(170, 220, 50, 255), IM_COL32(253, 231, 36, 255)};
    const ImVec2 at = ImGui::GetCursorScreenPos();
    const float width = ImGui::CalcItemWidth(), height = ImGui::GetFontSize();
    const float step = width / static_cast<float>(viridis.size() - 1);
    for (std::size_t i = 0; i + 1 < viridis.size(); ++i) {
        const float x = at.x + step * static_cast<float>(i);
        ImGui::GetWindowDrawList()->AddRectFilledMultiColor({x, at.y}, {x + step, at.y + height}, viridis[i],
                                                            viridis[i + 1], viridis[i + 1], viridis[i]);
    }
    ImGui::Dummy({width, height});
    const vec2 r = display.false_color_range;
    ImGui::TextUnformatted(fmt::format("{:.3g} .. {:.3g} .. {:.3g} {}", std::exp2(r.x),
                                       std::exp2(0.5f * (r.x + r.y)), std::exp2(r.y), unit)
                               .c_str());
}

} // namespace

class AdjustDisplay : public Tool {
public:
    using Tool::Tool;

    std::optional<Changes> handle(const Event& event) override;
    Changes draw_section() override;
};

std::optional<Changes> AdjustDisplay::handle(const Event& event) {
    const auto command = command_in(event);
    if (!command) return std::nullopt;
    Exposure& exposure = ws_.exposure;
    DisplaySettings& display = ws_.display;
    switch (*command) {
    case Command::darker: exposure.fix(exposure.ev100() + exposure_step); break;
    case Command::brighter: exposure.fix(exposure.ev100() - exposure_step); break;
    case Command::auto_exposure: exposure.make_automatic(); break;
    case Command::next_tone_curve:
        display.curve =
            static_cast<image::ToneCurve>((static_cast<std::size_t>(display.curve) + 1) % curves.size());
        break;
    case Command::false_color: display.is_false_color = !display.is_false_color; break;
    default: return std::nullopt;
    }
    return Change::display;
}

Changes AdjustDisplay::draw_section() {
    if (!ImGui::CollapsingHeader("Picture", ImGuiTreeNodeFlags_DefaultOpen)) return {};
    Exposure& exposure = ws_.exposure;
    DisplaySettings& display = ws_.display;
    bool is_automatic = exposure.is_automatic();
    if (ImGui::Checkbox("auto", &is_automatic)) {
        if (is_automatic)
            exposure.make_automatic();
        else
            exposure.fix(exposure.ev100());
    }
    ImGui::SameLine();
    float ev = exposure.ev100();
    if (ImGui::SliderFloat("EV100", &ev, -10.0f, 20.0f, "%.2f")) exposure.fix(ev);
    int curve = static_cast<int>(display.curve);
    if (ImGui::Combo("tone curve", &curve, curves.data(), static_cast<int>(curves.size())))
        display.curve = static_cast<image::ToneCurve>(curve);
    ImGui::Checkbox("false colour", &display.is_false_color);
    if (!display.is_false_color) return {};
    vec2& range = display.false_color_range;
    ImGui::DragFloatRange2("log2", &range.x, &range.y, 0.1f, -30.0f, 40.0f, "%.1f");
    range.y = std::max(range.y, range.x + 0.5f);
    draw_legend(display, scene::radiance_unit(ws_.scene->stage().scene.units));
    return {};
}

std::unique_ptr<Tool> make_adjust_display(Workspace& workspace) {
    return std::make_unique<AdjustDisplay>(workspace);
}

} // namespace sr::viewer
