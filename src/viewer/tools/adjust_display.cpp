// Display tool: exposure, tone curve, views.
#include "core/error.hpp"
#include "gl/program.hpp"
#include "output/variables.hpp"
#include "viewer/fields.hpp"
#include "viewer/panels/legend.hpp"
#include "viewer/tools/tool.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <imgui.h>
#include <utility>
#include <vector>

namespace sr::viewer {
namespace {

constexpr float exposure_step = 1.0f / 3.0f; // [EV]

/// Returns the view after `view` in the table; null, radiance, after the last one.
const output::Variable* view_after(const output::Variable* view) {
    bool is_next = !view;
    for (const output::Variable& variable : output::all_variables()) {
        if (is_next && output::view_named(variable.name)) return &variable;
        is_next = is_next || &variable == view;
    }
    return nullptr;
}

} // namespace

class AdjustDisplay : public Tool {
public:
    using Tool::Tool;

    std::optional<Changes> handle(const Event& event) override;
    Changes draw(const Overlay& overlay) override;
    Changes draw_section() override;

private:
    Changes draw_views();
    Changes fit_range();
    Changes set_view(const output::Variable* view);
    Changes next_background();

    const vec3 background_at_start_ = ws_.options.rendering.background; // [cd/m²]
    std::size_t background_ = 0;                                        // in use, of those to choose from
};

std::optional<Changes> AdjustDisplay::handle(const Event& event) {
    if (const auto* chosen = std::get_if<ViewEvent>(&event)) return set_view(chosen->view);
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
    case Command::fit_range: return fit_range();
    case Command::next_view: return set_view(view_after(display.view));
    case Command::next_background: return next_background();
    default: return std::nullopt;
    }
    return Change::display;
}

Changes AdjustDisplay::draw_section() {
    const bool is_unfolded = ImGui::CollapsingHeader("Picture", ImGuiTreeNodeFlags_DefaultOpen);
    tooltip("exposure, tone curve and what of the equation is shown; the render stays as it is");
    if (!is_unfolded) return {};
    Exposure& exposure = ws_.exposure;
    DisplaySettings& display = ws_.display;
    bool is_automatic = exposure.is_automatic();
    if (ImGui::Checkbox("auto", &is_automatic)) {
        if (is_automatic)
            exposure.make_automatic();
        else
            exposure.fix(exposure.ev100());
    }
    tooltip(ws_.keys.hint("the exposure follows the picture", Command::auto_exposure));
    ImGui::SameLine();
    float ev = exposure.ev100();
    if (number_field("EV100", ev, {-10.0f, 20.0f, "%.2f", false})) exposure.fix(ev);
    tooltip("exposure value at ISO 100: 1 more is half as bright; a click with Ctrl types it");
    const bool is_open = ImGui::BeginCombo("tone curve", display.curve->name.data());
    tooltip(ws_.keys.hint("the curve from exposed radiance to the screen", Command::next_tone_curve));
    if (is_open) {
        for (const image::ToneCurve& curve : image::tone_curves())
            if (ImGui::Selectable(curve.name.data(), &curve == display.curve)) display.curve = &curve;
        ImGui::EndCombo();
    }
    const Changes changes = draw_views();
    if (!display.view || display.view->display != output::Display::false_color) return changes;
    image::Decades& decades = display.decades;
    ImGui::DragFloatRange2("decades", &decades.first, &decades.last, 0.05f, -12.0f, 12.0f, "10^%.1f");
    tooltip("first and last luminance of the colours, as powers of ten [cd/m^2]");
    decades.last = std::max(decades.last, decades.first + 0.5f);
    ImGui::SameLine();
    const bool is_fitted = ImGui::Button("fit");
    tooltip(ws_.keys.hint("give the colours the range of the picture", Command::fit_range));
    return is_fitted ? changes | fit_range() : changes;
}

Changes AdjustDisplay::draw(const Overlay& overlay) {
    const output::Variable* const view = ws_.display.view;
    const ComparisonMode comparison = ws_.display.comparison;
    const bool has_reference = ws_.kept.reference() || ws_.scene->reference();
    const bool has_values = !has_reference || comparison == ComparisonMode::none
                            || comparison == ComparisonMode::wipe; // and no errors instead
    if (view && has_values)
        draw_legend(ws_.shown_area(), *view, ws_.display,
                    output::unit_of(view, ws_.scene->stage().scene.units), overlay.scale);
    if (view && !has_values) {
        const Area picture = ws_.shown_area();
        const float margin = 10.0f * overlay.scale, height = 2.0f * ImGui::GetTextLineHeight();
        draw_caption({picture.from.x + margin, picture.from.y + picture.size.y - height - margin},
                     fmt::format("{} of {} against the reference",
                                 comparison == ComparisonMode::difference ? "difference" : "ꟻLIP",
                                 view->name));
    }
    return {};
}

/// Shows luminance in false colours, and gives them the range of the picture.
Changes AdjustDisplay::fit_range() {
    const output::Variable* const luminance = output::view_named("luminance");
    const Changes changes = ws_.display.view == luminance ? Changes(Change::display) : set_view(luminance);
    if (ws_.scene->render().sample_count() == 0) return changes;
    const auto range = range_of(ws_.scene->render().read_film());
    if (range) ws_.display.decades = *range;
    ws_.messages.notify(range ? fmt::format("Range: {:.3g} to {:.3g} {}.", std::pow(10.0, range->first),
                                            std::pow(10.0, range->last),
                                            scene::radiance_unit(ws_.scene->stage().scene.units))
                              : "The picture has no light to fit a range to.");
    return changes | Change::display;
}

Changes AdjustDisplay::draw_views() {
    const output::Variable* const shown = ws_.display.view;
    const bool is_open = ImGui::BeginCombo("view", shown ? shown->name : "radiance");
    tooltip(ws_.keys.hint("radiance, or one term of the equation", Command::next_view));
    if (!is_open) return {};
    const output::Variable* chosen = shown;
    if (ImGui::Selectable("radiance", !shown)) chosen = nullptr;
    tooltip("the picture itself");
    for (const output::Variable& variable : output::all_variables()) {
        if (!output::view_named(variable.name)) continue;
        if (ImGui::Selectable(variable.name, shown == &variable)) chosen = &variable;
        tooltip(variable.what);
    }
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

/// Shows black, grey or white, at the current exposure, or what the run began with, where there is no
/// surface.
Changes AdjustDisplay::next_background() {
    struct Background {
        const char* name;
        vec3 L; // [cd/m²]
    };
    const float white = 1.0f / image::exposure_factor(ws_.exposure.ev100());
    constexpr float grey = 0.18f; // the reflectance of a photographer's grey card
    std::vector<Background> all{{"black", vec3(0.0f)}, {"grey", vec3(grey * white)}, {"white", vec3(white)}};
    if (background_at_start_ != vec3(0.0f))
        all.insert(all.begin(), {"as at the start", background_at_start_});
    background_ = (background_ + 1) % all.size();
    const auto& [name, L] = all[background_];
    vec3& background = ws_.options.rendering.background;
    const vec3 before = std::exchange(background, L);
    try {
        ws_.scene->restart(ws_.options, ws_.camera->camera(), ws_.width, ws_.height);
    } catch (const Error& error) {
        background = before;
        ws_.messages.fail("Cannot show this background.", error.what());
        return Change::redraw;
    }
    ws_.messages.notify(fmt::format("Background: {}, {:.4g} {}.", name, luminance(L),
                                    scene::radiance_unit(ws_.scene->stage().scene.units)));
    return Change::materials;
}

std::unique_ptr<Tool> make_adjust_display(Workspace& workspace) {
    return std::make_unique<AdjustDisplay>(workspace);
}

} // namespace sr::viewer
