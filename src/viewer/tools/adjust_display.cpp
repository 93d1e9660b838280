// Display tool: exposure, tone curve, views.
#include "core/error.hpp"
#include "gl/program.hpp"
#include "output/variables.hpp"
#include "viewer/tools/tool.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <imgui.h>

namespace sr::viewer {
namespace {

constexpr float exposure_step = 1.0f / 3.0f; // [EV]

/// Returns the view after `view` in the table; null, radiance, after the last one.
const output::Variable* next_view(const output::Variable* view) {
    bool is_next = !view;
    for (const output::Variable& variable : output::all_variables()) {
        if (is_next && output::view_named(variable.name)) return &variable;
        is_next = is_next || &variable == view;
    }
    return nullptr;
}

/// Draws the false colours with labelled decades.
void draw_legend(const image::Decades& decades, std::string_view unit) {
    const ImVec2 at = ImGui::GetCursorScreenPos();
    const float width = ImGui::CalcItemWidth(), height = ImGui::GetFontSize();
    ImDrawList& list = *ImGui::GetWindowDrawList();
    const float step = width / static_cast<float>(image::viridis.size() - 1);
    const auto color = [](const vec3& c) { return ImGui::ColorConvertFloat4ToU32({c.r, c.g, c.b, 1.0f}); };
    for (std::size_t i = 0; i + 1 < image::viridis.size(); ++i) {
        const float x = at.x + step * static_cast<float>(i);
        const ImU32 left = color(image::viridis[i]), right = color(image::viridis[i + 1]);
        list.AddRectFilledMultiColor({x, at.y}, {x + step, at.y + height}, left, right, right, left);
    }
    const float range = decades.last - decades.first;
    const int stride = static_cast<int>(std::ceil(range / 4.0f)); // decades between two labels
    for (int k = static_cast<int>(std::ceil(decades.first)); static_cast<float>(k) <= decades.last; ++k) {
        const float x = at.x + width * (static_cast<float>(k) - decades.first) / range;
        list.AddLine({x, at.y + 0.6f * height}, {x, at.y + height}, IM_COL32_WHITE);
        if (k % stride != 0) continue;
        const std::string label = fmt::format("1e{}", k);
        const float half = 0.5f * ImGui::CalcTextSize(label.c_str()).x;
        list.AddText({x - half, at.y + height}, ImGui::GetColorU32(ImGuiCol_Text), label.c_str());
    }
    ImGui::Dummy({width, 2.0f * height});
    ImGui::SameLine();
    ImGui::TextUnformatted(unit.data(), unit.data() + unit.size());
}

} // namespace

class AdjustDisplay : public Tool {
public:
    using Tool::Tool;

    std::optional<Changes> handle(const Event& event) override;
    Changes draw_section() override;

private:
    Changes draw_views();
    Changes set_view(const output::Variable* view);
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
        if (++display.curve == image::tone_curves().data() + image::tone_curves().size())
            display.curve = image::tone_curves().data();
        break;
    case Command::false_color: {
        const output::Variable* luminance = output::view_named("luminance");
        return set_view(display.view == luminance ? nullptr : luminance);
    }
    case Command::next_view: return set_view(next_view(display.view));
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
    if (ImGui::BeginCombo("tone curve", display.curve->name.data())) {
        for (const image::ToneCurve& curve : image::tone_curves())
            if (ImGui::Selectable(curve.name.data(), &curve == display.curve)) display.curve = &curve;
        ImGui::EndCombo();
    }
    const Changes changes = draw_views();
    if (!display.view || display.view->display != output::Display::false_color) return changes;
    image::Decades& decades = display.decades;
    ImGui::DragFloatRange2("decades", &decades.first, &decades.last, 0.05f, -12.0f, 12.0f, "1e%.1f");
    decades.last = std::max(decades.last, decades.first + 0.5f);
    draw_legend(decades, scene::radiance_unit(ws_.scene->stage().scene.units));
    return changes;
}

Changes AdjustDisplay::draw_views() {
    const output::Variable* const shown = ws_.display.view;
    if (!ImGui::BeginCombo("view", shown ? shown->name : "radiance")) return {};
    const output::Variable* chosen = shown;
    if (ImGui::Selectable("radiance", !shown)) chosen = nullptr;
    for (const output::Variable& variable : output::all_variables())
        if (output::view_named(variable.name) && ImGui::Selectable(variable.name, shown == &variable))
            chosen = &variable;
    ImGui::EndCombo();
    return chosen == shown ? Changes() : set_view(chosen);
}

/// Shows one term of the equation, or radiance if `view` is null. Restarts the render if its shader changes.
Changes AdjustDisplay::set_view(const output::Variable* view) {
    std::string& shader = ws_.options.rendering.shader;
    const std::string before = shader;
    shader = view ? view->shader : render::RenderOptions().shader;
    ws_.messages.notify(view ? fmt::format("View: {}, {}.", view->name, view->what) : "View: radiance.");
    try {
        if (shader != before) ws_.scene->restart(ws_.options, ws_.camera->camera(), ws_.width, ws_.height);
    } catch (const Error& error) {
        shader = before;
        ws_.messages.fail("Cannot show this view.", error.what());
        return Change::redraw;
    }
    ws_.display.view = view;
    if (shader == before) return Change::display;
    ws_.display.comparison = ComparisonMode::none;
    return Change::materials;
}

std::unique_ptr<Tool> make_adjust_display(Workspace& workspace) {
    return std::make_unique<AdjustDisplay>(workspace);
}

} // namespace sr::viewer
