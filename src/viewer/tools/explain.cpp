// Explain tool: the equation at the probed pixel, with the code of each term, and the picture without a term.
#include "viewer/panels/explain.hpp"
#include "core/error.hpp"
#include "core/math.hpp"
#include "viewer/palette.hpp"
#include "viewer/tools/tool.hpp"

#include <algorithm>
#include <fmt/format.h>
#include <imgui.h>
#include <memory>
#include <utility>

namespace sr::viewer {

class Explain : public Tool {
public:
    using Tool::Tool;

    std::optional<Changes> handle(const Event& event) override;
    Changes update(double seconds) override;
    void notice(Changes changes) override;
    Changes draw(const Overlay& overlay) override;
    FilmSum reference_film() const override;
    Activity activity() const override {
        return render_ && !render_->is_converged() ? Activity::active : Activity::idle;
    }

private:
    Changes toggle();
    Changes close();
    Changes choose(ChosenTerm chosen);
    Changes choose_next();
    Changes toggle_term();
    Changes leave_out();
    void take_back();
    void begin();
    bool is_shown() const { return ws_.is_explained && ws_.probed; }
    EquationCode code() const;
    void find_code();
    void leave_pixel();
    void follow_size();
    std::string left_out_name() const;
    void draw_sides() const;

    ExplainPanel panel_;
    Explanation explanation_;
    bool has_begun_ = false;                    // the panel has shown this pixel's numbers
    std::optional<std::size_t> followed_;       // selected light that the panel has followed
    std::vector<glsl::Root> path_;              // of the render
    std::unique_ptr<ProgressiveRender> render_; // without the term
    bool is_same_view_ = true;                  // the probed pixel is where it was
    std::pair<int, int> size_{};                // of render_
    ComparisonMode comparison_before_ = ComparisonMode::none;
};

std::optional<Changes> Explain::handle(const Event& event) {
    const auto command = command_in(event);
    if (command == Command::explain) return toggle();
    if (command == Command::next_term || command == Command::leave_out_term) {
        if (!is_shown()) {
            ws_.messages.notify("Explain a pixel first: E over it.");
            return Change::redraw;
        }
        return command == Command::next_term ? choose_next() : toggle_term();
    }
    if (command != Command::cancel || !is_shown()) return std::nullopt;
    if (!render_) return close();
    take_back();
    return Change::display;
}

/// Explains the probed pixel, or else the one under the pointer; hides the explanation if it is there.
Changes Explain::toggle() {
    if (is_shown()) return ws_.show_panels() ? Changes(Change::redraw) : close();
    if (ws_.probed) ws_.show_panels(); // otherwise the probe does
    if (!ws_.probed && !ws_.shown_area().contains(ws_.input.pointer())) {
        ws_.messages.notify("Point at the picture to explain a pixel.");
        return Change::redraw;
    }
    ws_.is_explained = true;
    if (!ws_.probed) ws_.wanted_probe = ws_.input.pointer();
    return Change::redraw;
}

Changes Explain::close() {
    take_back();
    ws_.is_explained = has_begun_ = false;
    return Change::display;
}

EquationCode Explain::code() const {
    EquationCode code{path_};
    const render::PixelTerms& terms = ws_.probed->terms;
    code.is_mirror = ws_.probed->lobe && ws_.probed->lobe->is_mirror;
    const scene::Scene& scene = ws_.scene->stage().scene;
    const vec3 towards = -terms.wo;
    if (const auto hit = first_hit(scene, {terms.x - 0.01f * towards, towards})) {
        const auto mesh =
            static_cast<std::size_t>(scene.instances[static_cast<std::size_t>(hit->instance)].mesh);
        code.model = scene.materials[static_cast<std::size_t>(scene.meshes[mesh].material)].model;
    }
    const render::VisibilityBackend* const backend = ws_.scene->gpu().visibility_backend();
    code.visibility = !backend ? "none" : backend->shadow_map_scene() ? "map" : "ray";
    return code;
}

/// Begins with the brightest light's BRDF.
void Explain::begin() {
    has_begun_ = is_same_view_ = true;
    size_ = {ws_.width, ws_.height};
    path_ = render_options(ws_.options, ws_.width, ws_.height).shader_path;
    const auto& lights = ws_.probed->terms.lights;
    const auto brightest = std::ranges::max_element(
        lights, {}, [](const render::LightTerms& light) { return luminance(light.L_r); });
    const int light = brightest == lights.end() ? 0 : static_cast<int>(brightest - lights.begin());
    followed_ = ws_.selected.active();
    choose({lights.empty() ? EquationTerm::emission : EquationTerm::f_r, light});
}

Changes Explain::choose(ChosenTerm chosen) {
    take_back();
    explanation_.chosen = chosen;
    find_code();
    return Change::display;
}

void Explain::find_code() {
    const auto& lights = ws_.scene->stage().lights;
    const auto light = static_cast<std::size_t>(explanation_.chosen.light);
    try {
        explanation_.code =
            code().of(explanation_.chosen.term, light < lights.size() ? &lights[light] : nullptr);
    } catch (const Error& error) {
        explanation_.code.reset();
        ws_.messages.notify(error.what());
    }
    const render::VisibilityBackend* const backend = ws_.scene->gpu().visibility_backend();
    explanation_.has_cpu_rays = backend && backend->occlusion();
    const std::string name = name_of(explanation_.chosen, ws_.scene->stage());
    ws_.messages.log(explanation_.code ? fmt::format("Explained: {}, {}:{}", name, explanation_.code->file,
                                                     explanation_.code->line)
                                       : fmt::format("Explained: {}, no line", name));
}

Changes Explain::choose_next() {
    const std::size_t next = (static_cast<std::size_t>(explanation_.chosen.term) + 1) % equation_term_count;
    const bool has_lights = !ws_.probed->terms.lights.empty();
    return choose(
        {has_lights ? static_cast<EquationTerm>(next) : EquationTerm::emission, explanation_.chosen.light});
}

Changes Explain::toggle_term() {
    if (!render_) return leave_out();
    take_back();
    return Change::display;
}

/// Renders the picture without the term beside the picture, by samples of all lights.
Changes Explain::leave_out() {
    const ChosenTerm& chosen = explanation_.chosen;
    const std::string radiance = render::RenderOptions().shader;
    if (ws_.options.rendering.shader != radiance) {
        ws_.messages.notify("Another view than radiance is shown. V goes on to the next.");
        return Change::redraw;
    }
    render::RenderOptions options = render_options(ws_.options, ws_.width, ws_.height);
    try {
        explanation_.left_out = code().without(chosen.term, chosen.light);
        if (!explanation_.left_out) {
            ws_.messages.notify(
                fmt::format("These shaders have {} in a way of their own: it cannot be left out.",
                            in_plain_letters(symbol_of(chosen.term))));
            return Change::redraw;
        }
        options.shader_path.insert(options.shader_path.begin(), explanation_.left_out->overlay);
        options.estimator = render::Estimator::sampled;
        options.lights = render::LightSampling::all;
        options.has_shadows = chosen.term != EquationTerm::visibility;
        render_ = std::make_unique<ProgressiveRender>(ws_.scene->gpu(), ws_.camera->camera(), options,
                                                      ws_.options.stop);
        size_ = {ws_.width, ws_.height};
    } catch (const Error& error) {
        explanation_.left_out.reset();
        ws_.messages.fail("The picture without this term cannot be made.", error.what());
        return Change::redraw;
    }
    ws_.is_term_left_out = true;
    comparison_before_ = std::exchange(ws_.display.comparison, ComparisonMode::wipe);
    ws_.messages.notify(
        fmt::format("Right: without {}. B: difference, alone. Esc takes it back.", left_out_name()));
    return Change::display;
}

void Explain::take_back() {
    explanation_.left_out.reset();
    explanation_.L_o_without.reset();
    if (!render_) return;
    render_.reset();
    ws_.is_term_left_out = false;
    ws_.display.comparison = comparison_before_;
    ws_.messages.notify("The term is back.");
}

Changes Explain::update(double /*seconds*/) {
    if (ws_.is_explained && !ws_.probed && !ws_.wanted_probe) return close(); // the probe has ended
    if (!is_shown()) return {};
    if (!ws_.probed->is_complete) {
        has_begun_ = false;
        return {};
    }
    if (!has_begun_) begin();
    if (followed_ != ws_.selected.active()) {
        followed_ = ws_.selected.active();
        const auto& entries = ws_.scene->lights().entries();
        if (followed_ && *followed_ < entries.size() && !entries[*followed_].lights.empty())
            return choose({explanation_.chosen.term, entries[*followed_].lights.front()});
    }
    if (!render_) return {};
    follow_size();
    const bool was_converged = render_->is_converged();
    if (!was_converged) render_->advance();
    explanation_.is_final = render_->is_converged();
    if (is_same_view_ && !render_->is_interactive() && render_->sample_count() > 0)
        explanation_.L_o_without =
            render_->pixel((vec2(ws_.probed->column, ws_.probed->row) + 0.5f) / vec2(ws_.width, ws_.height));
    if (explanation_.is_final && !was_converged) {
        ws_.messages.log("The picture without the term has converged.");
        return Change::redraw;
    }
    return {};
}

void Explain::notice(Changes changes) {
    if (changes.has(Change::lights) || changes.has(Change::shadows) || changes.has(Change::materials))
        return take_back();
    if (!changes.has(Change::camera)) return;
    leave_pixel();
    if (render_) render_->move(ws_.camera->camera());
}

/// The probed pixel is somewhere else in the picture.
void Explain::leave_pixel() {
    is_same_view_ = false;
    explanation_.L_o_without.reset();
}

void Explain::follow_size() {
    const auto size = std::pair(ws_.width, ws_.height);
    if (size == size_) return;
    size_ = size;
    leave_pixel();
    render_->resize(ws_.width, ws_.height);
}

/// A factor is left out of the terms of all lights.
std::string Explain::left_out_name() const {
    const ChosenTerm& chosen = explanation_.chosen;
    return in_plain_letters(chosen.term == EquationTerm::light ? name_of(chosen, ws_.scene->stage())
                                                               : symbol_of(chosen.term));
}

/// Names the two sides of the picture.
void Explain::draw_sides() const {
    if (ws_.display.comparison != ComparisonMode::wipe) return;
    const Area picture = ws_.picture();
    const float edge = picture.from.x + ws_.display.wipe * picture.size.x;
    const float margin = 0.6f * ImGui::GetFontSize();
    const std::string term = left_out_name();
    ImDrawList& list = *ImGui::GetBackgroundDrawList();
    const auto label = [&](const std::string& text, bool is_left) {
        const ImVec2 size = ImGui::CalcTextSize(text.c_str());
        const float x = is_left ? edge - size.x - 2.0f * margin : edge + 2.0f * margin;
        const float y = ws_.shown_area().from.y + 2.0f * margin;
        list.AddRectFilled({x - margin, y - 0.5f * margin}, {x + size.x + margin, y + size.y + 0.5f * margin},
                           IM_COL32(0, 0, 0, 170), 3.0f);
        list.AddText({x, y}, palette::white, text.c_str());
    };
    label("with " + term, true);
    label("without " + term, false);
}

FilmSum Explain::reference_film() const {
    return render_ && render_->sample_count() > 0 ? render_->shown() : FilmSum{};
}

Changes Explain::draw(const Overlay& /*overlay*/) {
    if (!is_shown() || !has_begun_) return {};
    const ExplainPanel::Request request =
        panel_.draw(*ws_.probed, ws_.scene->stage(), explanation_, ws_.layout, ws_.ui, ws_.keys);
    if (render_) draw_sides();
    if (request.closes) return close();
    if (request.chosen) return choose(*request.chosen);
    return request.toggles_term ? toggle_term() : Changes();
}

std::unique_ptr<Tool> make_explain(Workspace& workspace) { return std::make_unique<Explain>(workspace); }

} // namespace sr::viewer
