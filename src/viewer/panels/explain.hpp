#pragma once
// Explain panel: the equation with the numbers of a pixel set in it, and the code of the chosen term.
#include "viewer/document/equation_code.hpp"
#include "viewer/document/equation_numbers.hpp"
#include "viewer/keymap.hpp"
#include "viewer/panels/probe.hpp"

namespace sr::viewer {

/// The term that the panel explains.
struct ChosenTerm {
    EquationTerm term = EquationTerm::f_r;
    int light = 0; // of the RenderScene; of all terms but L_e

    bool operator==(const ChosenTerm&) const = default;
};

/// "V of lamp": a term by its symbol, with its light.
std::string name_of(const ChosenTerm& chosen, const scene::RenderScene& stage);
/// The sign of a term: "cos θᵢ".
const char* symbol_of(EquationTerm term);

/// Code and omission of the chosen term, which the panel shows besides the numbers.
struct Explanation {
    ChosenTerm chosen;
    std::optional<CodeExcerpt> code; // absent: the shaders compute it in a way of their own
    std::optional<LeftOut> left_out; // while the picture beside is without the term
    std::optional<vec3> L_o_without; // of this pixel [cd/m²], by the samples so far
    bool is_final = false;           // all samples are there
    bool has_cpu_rays = false;       // V is found beside the shaders
};

class ExplainPanel {
public:
    /// Wishes of a person in the panel.
    struct Request {
        std::optional<ChosenTerm> chosen;
        bool toggles_term = false; // leave it out, or take it back
        bool closes = false;
    };

    /// Draws the panel below the picture, or floating where panels are not docked.
    Request draw(const ProbeResult& result, const scene::RenderScene& stage, const Explanation& explanation,
                 Layout& layout, const Ui& ui, const Keymap& keys);

private:
    void draw_head(const ProbeResult& result, const Ui& ui);
    void draw_equation(const ProbeResult& result, const scene::RenderScene& stage,
                       const Explanation& explanation, const Ui& ui);
    void draw_products(const ProbeResult& result, const scene::RenderScene& stage, const ChosenTerm& chosen);
    float height_of_products(std::size_t lights) const;
    void draw_share(const EquationProduct& product, float L_o) const;
    void draw_light(int light, const ProbeResult& result, const scene::RenderScene& stage,
                    const ChosenTerm& chosen);
    void cell(const std::string& text, const ChosenTerm& here, const ChosenTerm& chosen);
    void draw_code(const scene::RenderScene& stage, const Explanation& explanation, const Ui& ui);
    void draw_omission(const ProbeResult& result, const Explanation& explanation, const Ui& ui,
                       const Keymap& keymap);

    bool is_narrow_ = false; // numbers and code stand below each other, and the panel scrolls as a whole
    ColorPart part_ = ColorPart::luminance;
    Request request_;
};

} // namespace sr::viewer
