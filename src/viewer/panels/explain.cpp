#include "viewer/panels/explain.hpp"

#include "viewer/palette.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <fmt/format.h>
#include <functional>
#include <imgui.h>
#include <numeric>

namespace sr::viewer {
namespace {

constexpr std::array part_names{"luminance", "red", "green", "blue"};
constexpr ImU32 chosen_cell = IM_COL32(120, 84, 0, 255);
constexpr ImU32 bar = IM_COL32(86, 180, 233, 70);

/// The meaning of a term, in a sentence.
const char* meaning_of(EquationTerm term, bool is_mirror) {
    switch (term) {
    case EquationTerm::emission: return "Lₑ: the light that the surface itself sends out towards the eye.";
    case EquationTerm::f_r:
        return is_mirror ? "ρ: the share of the light that the mirror reflects."
                         : "fᵣ: the BRDF, the share of light from ωᵢ that leaves towards ωₒ, per steradian.";
    case EquationTerm::light:
        return "L Ω: the light that arrives face-on without shadows, as radiance times solid angle. A light "
               "without extent has I/d² instead.";
    case EquationTerm::visibility: return "V: the share of the light that nothing blocks.";
    case EquationTerm::cosine:
        return "cos θᵢ: light that arrives at a slant is spread over more of the surface.";
    }
    return "";
}

/// Describes the equation without a term.
const char* omission_of(EquationTerm term) {
    switch (term) {
    case EquationTerm::emission: return "Without Lₑ no surface glows by itself.";
    case EquationTerm::f_r: return "Without fᵣ every surface reflects alike: fᵣ = 1/sr.";
    case EquationTerm::light: return "Without this light the others remain.";
    case EquationTerm::visibility: return "Without V nothing casts shadows: V = 1.";
    case EquationTerm::cosine: return "Without cos θᵢ slanted light counts in full: cos θᵢ = 1.";
    }
    return "";
}

std::string digits(float value) { return fmt::format("{:.4g}", value); }

std::string digits_or_dash(const std::optional<float>& value) { return value ? digits(*value) : "-"; }

void text_line(const std::string& text) { ImGui::TextUnformatted(in_plain_letters(text).c_str()); }

/// Puts a sum or a product into the room: lines break before its signs alone, never within a number.
void equation_line(const std::string& text) {
    const std::string shown = in_plain_letters(text);
    const float right = ImGui::GetContentRegionMax().x;
    for (std::size_t from = 0; from < shown.size();) {
        // A sign stands between spaces; the piece up to the next one begins with its own.
        std::size_t end = shown.size();
        for (const char* sign : {" = ", " + ", " · ", " * "})
            end = std::min(end, shown.find(in_plain_letters(sign), from + 1));
        std::string piece = shown.substr(from, end - from);
        const bool is_first = from == 0;
        if (!is_first) ImGui::SameLine(0.0f, 0.0f);
        if (!is_first && ImGui::GetCursorPosX() + ImGui::CalcTextSize(piece.c_str()).x > right) {
            ImGui::NewLine();
            piece.erase(0, 1);
        }
        ImGui::TextUnformatted(piece.c_str());
        from = end;
    }
}

/// The lights, the brightest at this pixel first.
std::vector<int> by_brightness(const render::PixelTerms& terms, ColorPart part) {
    std::vector<int> order(terms.lights.size());
    std::iota(order.begin(), order.end(), 0);
    std::ranges::stable_sort(order, std::greater{}, [&](int k) {
        return part_of(terms.lights[static_cast<std::size_t>(k)].L_r, part);
    });
    return order;
}

/// Why a light adds nothing.
const char* reason_of(const EquationProduct& product) {
    if (product.L_r > 0.0f) return "";
    return product.V == 0.0f ? "in shadow" : "does not arrive";
}

/// "Lₒ = Lₑ + Σ": the sum with this pixel's numbers, the four brightest lights one by one.
std::string sum_of(const render::PixelTerms& terms, ColorPart part) {
    constexpr std::size_t shown = 4;
    const std::vector<int> order = by_brightness(terms, part);
    std::string text =
        fmt::format("{} = {}", digits(part_of(terms.L_o, part)), digits(part_of(terms.L_e, part)));
    float rest = 0.0f;
    for (std::size_t i = 0; i < order.size(); ++i) {
        const float L_r = part_of(terms.lights[static_cast<std::size_t>(order[i])].L_r, part);
        if (i < shown)
            text += fmt::format(" + {}", digits(L_r));
        else
            rest += L_r;
    }
    if (order.size() > shown) text += fmt::format(" + {} (by {} more)", digits(rest), order.size() - shown);
    return text;
}

float reflectance_of(const ProbeResult& result) {
    return result.lobe && result.lobe->is_mirror ? result.lobe->f_r[0] : 0.0f;
}

/// The product of one light with its numbers.
std::string product_text(const EquationProduct& p, const std::string& name) {
    if (p.is_mirror)
        return fmt::format("{}: {} = ρ {} · L {}", name, digits(p.L_r), digits(*p.f_r), digits(*p.radiance));
    if (!p.f_r) return fmt::format("{}: 0, {}", name, reason_of(p));
    const std::string light = p.radiance
                                  ? fmt::format("{} · {} sr", digits(*p.radiance), digits(p.solid_angle))
                                  : fmt::format("{}", digits(*p.face_on));
    return fmt::format("{}: {} = {}/sr · {} · {:.4f} · {:.4f}", name, digits(p.L_r), digits(*p.f_r), light,
                       p.V, p.cos_i);
}

} // namespace

const char* symbol_of(EquationTerm term) {
    constexpr std::array<const char*, equation_term_count> symbols{"Lₑ", "fᵣ", "L", "V", "cos θᵢ"};
    return symbols[static_cast<std::size_t>(term)];
}

std::string name_of(const ChosenTerm& chosen, const scene::RenderScene& stage) {
    const auto light = static_cast<std::size_t>(chosen.light);
    if (chosen.term == EquationTerm::emission || light >= stage.lights.size()) return symbol_of(chosen.term);
    return fmt::format("{} of {}", symbol_of(chosen.term), scene::name_of(stage.lights[light]));
}

void ExplainPanel::draw_head(const ProbeResult& result, const Ui& ui) {
    ImGui::PushFont(ui.fonts().heading);
    text_line("Lₒ = Lₑ + Σ fᵣ · L · Ω · V · cos θᵢ");
    ImGui::PopFont();
    const float gap = 2.0f * ImGui::GetFontSize(), button = ImGui::GetFrameHeight();
    const float end = ImGui::GetItemRectMax().x - ImGui::GetWindowPos().x + gap;
    const float right = ImGui::GetWindowContentRegionMax().x - button;
    ImGui::SameLine(right);
    if (ImGui::Button("x", {button, 0.0f})) request_.closes = true;
    tooltip("back to all numbers (Esc)");
    const float parts_width = 26.0f * ImGui::GetFontSize(); // of the choices below
    if (end + parts_width < right) ImGui::SameLine(end);
    ImGui::AlignTextToFramePadding();
    ImGui::TextDisabled("pixel %d,%d", result.column, result.row);
    int part = static_cast<int>(part_);
    for (std::size_t i = 0; i < part_names.size(); ++i) {
        ImGui::SameLine();
        ImGui::RadioButton(part_names[i], &part, static_cast<int>(i));
        tooltip(i == 0 ? "numbers of light as luminance, numbers of surfaces weighted likewise"
                       : "numbers of this channel, linear, primaries of Rec. 709");
    }
    part_ = static_cast<ColorPart>(part);
}

void ExplainPanel::draw_equation(const ProbeResult& result, const scene::RenderScene& stage,
                                 const Explanation& explanation, const Ui& ui) {
    const render::PixelTerms& terms = result.terms;
    if (!is_narrow_) ImGui::PushFont(ui.fonts().heading);
    equation_line(sum_of(terms, part_));
    const auto light = static_cast<std::size_t>(explanation.chosen.light);
    if (light < terms.lights.size())
        equation_line(product_text(product_of(terms.lights[light], part_, reflectance_of(result)),
                                   scene::name_of(stage.lights[light])));
    if (!is_narrow_) ImGui::PopFont();
}

/// Draws a number that chooses its term.
void ExplainPanel::cell(const std::string& text, const ChosenTerm& here, const ChosenTerm& chosen) {
    ImGui::TableNextColumn();
    ImGui::PushID(static_cast<int>(here.term));
    if (here == chosen) ImGui::TableSetBgColor(ImGuiTableBgTarget_CellBg, chosen_cell);
    if (ImGui::Selectable(in_plain_letters(text).c_str())) request_.chosen = here;
    tooltip(fmt::format("show the code of {}", symbol_of(here.term)));
    ImGui::PopID();
}

void ExplainPanel::draw_light(int light, const ProbeResult& result, const scene::RenderScene& stage,
                              const ChosenTerm& chosen) {
    const render::PixelTerms& terms = result.terms;
    const EquationProduct p =
        product_of(terms.lights[static_cast<std::size_t>(light)], part_, reflectance_of(result));
    const auto at = [&](EquationTerm term) { return ChosenTerm{term, light}; };
    ImGui::PushID(light);
    ImGui::TableNextRow();
    ImGui::TableNextColumn();
    text_line(fmt::format("{} {}", light, scene::name_of(stage.lights[static_cast<std::size_t>(light)])));
    if (is_narrow_) draw_share(p, part_of(terms.L_o, part_));
    cell(digits_or_dash(p.f_r), at(EquationTerm::f_r), chosen);
    const bool has_extent = p.solid_angle > 0.0f || p.is_mirror;
    const std::string unit(scene::name_of({scene::Quantity::irradiance, stage.scene.units}));
    cell(has_extent  ? digits_or_dash(p.radiance)
         : p.face_on ? fmt::format("{} {}", digits(*p.face_on), unit)
                     : "-",
         at(EquationTerm::light), chosen);
    ImGui::TableNextColumn();
    text_line(p.solid_angle > 0.0f && !p.is_mirror ? digits(p.solid_angle) : "");
    cell(p.is_mirror           ? ""
         : p.f_r || p.V < 1.0f ? fmt::format("{:.4f}", p.V)
                               : "-",
         at(EquationTerm::visibility), chosen);
    cell(p.is_mirror ? "" : p.f_r ? fmt::format("{:.4f}", p.cos_i) : "-", at(EquationTerm::cosine), chosen);
    if (!is_narrow_) draw_share(p, part_of(terms.L_o, part_));
    ImGui::PopID();
}

/// Draws what the light adds to the pixel, in numbers and as a bar.
void ExplainPanel::draw_share(const EquationProduct& p, float L_o) const {
    ImGui::TableNextColumn();
    const float share = p.L_r / std::max(1e-30f, L_o);
    const ImVec2 from = ImGui::GetCursorScreenPos();
    ImGui::GetWindowDrawList()->AddRectFilled(
        from,
        {from.x + std::clamp(share, 0.0f, 1.0f) * 7.0f * ImGui::GetFontSize(),
         from.y + ImGui::GetTextLineHeight()},
        bar);
    const bool is_wide = ImGui::GetWindowWidth() > 44.0f * ImGui::GetFontSize(); // the reason fits, too
    if (p.L_r > 0.0f) {
        text_line(fmt::format("{} ({:.1f} %)", digits(p.L_r), 100.0f * share));
    } else {
        text_line(is_wide ? fmt::format("0: {}", reason_of(p)) : "0");
        tooltip(reason_of(p));
    }
}

/// Height of the table: that of all rows in a narrow panel, which scrolls as a whole; else what is left.
float ExplainPanel::height_of_products(std::size_t lights) const {
    if (!is_narrow_) return std::max(ImGui::GetContentRegionAvail().y, 5.0f * ImGui::GetFrameHeight());
    const ImGuiStyle& style = ImGui::GetStyle();
    const float row = ImGui::GetTextLineHeight() + 2.0f * style.CellPadding.y;
    return static_cast<float>(lights + 2) * row + style.ScrollbarSize + 2.0f * style.CellPadding.y;
}

void ExplainPanel::draw_products(const ProbeResult& result, const scene::RenderScene& stage,
                                 const ChosenTerm& chosen) {
    const auto flags = ImGuiTableFlags_SizingFixedFit | ImGuiTableFlags_RowBg | ImGuiTableFlags_BordersInnerV
                       | ImGuiTableFlags_ScrollX | (is_narrow_ ? 0 : ImGuiTableFlags_ScrollY);
    const std::string radiance(scene::radiance_unit(stage.scene.units));
    std::array<std::pair<std::string, const char*>, 7> heads{
        {{"light", "the light's name, the brightest at this pixel first"},
         {"fᵣ [1/sr]", "the BRDF, the mean over the light"},
         {fmt::format("· L [{}]", radiance), "radiance of the light, the mean that makes the product exact"},
         {"· Ω [sr]", "solid angle of the light, seen from the surface, without shadows"},
         {"· V", "the share of the light that nothing blocks, 0 to 1"},
         {"· cos θᵢ", "the mean cosine between the normal and the light, 0 to 1"},
         {fmt::format("= Lᵣ [{}]", radiance),
          "the light that this light makes the surface reflect towards the eye"}}};
    // The result first, where not all columns have room.
    if (is_narrow_) std::rotate(heads.begin() + 1, heads.end() - 1, heads.end());
    const float height = height_of_products(result.terms.lights.size());
    if (!ImGui::BeginTable("products", static_cast<int>(heads.size()), flags, {0.0f, height})) return;
    ImGui::TableSetupScrollFreeze(1, 1);
    draw_table_heads(heads);
    for (const int light : by_brightness(result.terms, part_)) draw_light(light, result, stage, chosen);
    ImGui::TableNextRow();
    ImGui::TableNextColumn();
    text_line("the surface itself");
    for (int i = 0; !is_narrow_ && i < 5; ++i) ImGui::TableNextColumn();
    cell(fmt::format("Lₑ {}", digits(part_of(result.terms.L_e, part_))),
         {EquationTerm::emission, chosen.light}, chosen);
    ImGui::EndTable();
}

/// Draws the file's lines; the one that computes the term is marked.
void ExplainPanel::draw_code(const scene::RenderScene& stage, const Explanation& explanation, const Ui& ui) {
    const std::optional<CodeExcerpt>& code = explanation.code;
    ImGui::TextUnformatted(in_plain_letters(name_of(explanation.chosen, stage)).c_str());
    ImGui::SameLine();
    if (!code) {
        ImGui::TextDisabled("has no line of its own in these shaders.");
        return;
    }
    ImGui::TextDisabled("%s:%d", code->file.c_str(), code->line);
    if (explanation.has_cpu_rays && explanation.chosen.term == EquationTerm::visibility)
        ImGui::TextWrapped("The CPU traces these rays here (Embree). The lines ask the same question in GLSL "
                           "(--visibility ray-glsl).");
    ImGui::PushFont(ui.fonts().code);
    ImGui::PushTextWrapPos();
    for (std::size_t i = 0; i < code->lines.size(); ++i) {
        const int at = code->first + static_cast<int>(i);
        const std::string text = in_plain_letters(fmt::format("{:3} {}", at, code->lines[i]));
        if (at == code->line)
            ImGui::TextColored(ImGui::ColorConvertU32ToFloat4(palette::orange), "%s", text.c_str());
        else
            ImGui::TextDisabled("%s", text.c_str());
    }
    ImGui::PopTextWrapPos();
    ImGui::PopFont();
}

/// Draws the button that leaves the term out, the changed line, and what becomes of the pixel.
void ExplainPanel::draw_omission(const ProbeResult& result, const Explanation& explanation, const Ui& ui,
                                 const Keymap& keymap) {
    const bool is_out = explanation.left_out.has_value();
    const std::string label = keymap.hint(is_out ? "take it back" : "leave it out", Command::leave_out_term);
    if (ImGui::Button(label.c_str())) request_.toggles_term = true;
    tooltip("the picture without this term, beside the picture");
    if (!is_out) return;
    ImGui::SameLine();
    text_line(omission_of(explanation.chosen.term));
    ImGui::PushFont(ui.fonts().code);
    const LeftOut& out = *explanation.left_out;
    const auto colored = [](ImU32 color, const std::string& text) {
        ImGui::TextColored(ImGui::ColorConvertU32ToFloat4(color), "%s", in_plain_letters(text).c_str());
    };
    ImGui::PushTextWrapPos();
    ImGui::TextDisabled("%s:%d", out.file.c_str(), out.line);
    colored(palette::vermilion, "- " + out.before);
    colored(palette::green, "+ " + out.after);
    ImGui::PopTextWrapPos();
    ImGui::PopFont();
    if (!explanation.L_o_without) return;
    const float with = part_of(result.terms.L_o, part_), without = part_of(*explanation.L_o_without, part_);
    const bool is_same = std::abs(without - with) < 0.005f * std::max(with, 1e-30f);
    const std::string ratio = is_same       ? ", the same"
                              : with > 0.0f ? fmt::format(", {:.3g} times as much", without / with)
                                            : std::string();
    text_line(fmt::format("Lₒ here: {} with it, {} without{}{}", digits(with), digits(without), ratio,
                          explanation.is_final ? "." : ", so far."));
}

ExplainPanel::Request ExplainPanel::draw(const ProbeResult& result, const scene::RenderScene& stage,
                                         const Explanation& explanation, Layout& layout, const Ui& ui,
                                         const Keymap& keys) {
    request_ = {};
    const bool is_docked = layout.is_docked();
    const float room = layout.rest().size.y;
    const float height = std::min(0.48f * room, 23.0f * ImGui::GetFontSize());
    if (is_docked) {
        place_next_window(layout.take_below_picture(height));
    } else {
        const vec2 size = layout.rest().size;
        ImGui::SetNextWindowPos({0.02f * size.x, 0.45f * size.y}, ImGuiCond_FirstUseEver);
        ImGui::SetNextWindowSize({0.96f * size.x, 0.53f * size.y});
    }
    const int flags = ui.panel_flags(true) & ~(is_docked ? 0 : ImGuiWindowFlags_NoMove);
    if (ImGui::Begin("Explain", nullptr, flags | ImGuiWindowFlags_NoNavInputs)) {
        draw_head(result, ui);
        const ImVec2 space = ImGui::GetContentRegionAvail();
        is_narrow_ = space.x < 60.0f * ImGui::GetFontSize();
        const float width = std::min(0.58f * space.x, 46.0f * ImGui::GetFontSize());
        if (!is_narrow_) ImGui::BeginChild("numbers", {width, space.y});
        if (result.terms.coverage == 0.0f)
            text_line("No surface is seen here: Lₒ is the background.");
        else
            draw_equation(result, stage, explanation, ui);
        draw_products(result, stage, explanation.chosen);
        if (!is_narrow_) {
            ImGui::EndChild();
            ImGui::SameLine();
            ImGui::BeginChild("code", {0.0f, space.y}, true);
        }
        ImGui::PushTextWrapPos();
        text_line(meaning_of(explanation.chosen.term, reflectance_of(result) > 0.0f));
        ImGui::PopTextWrapPos();
        draw_omission(result, explanation, ui, keys);
        ImGui::Separator();
        draw_code(stage, explanation, ui);
        if (!is_narrow_) ImGui::EndChild();
    }
    if (!is_docked) keep_in_viewport();
    ImGui::End();
    return request_;
}

} // namespace sr::viewer
