#include "viewer/document/equation_code.hpp"

#include "core/error.hpp"
#include "render/gpu/shader_library.hpp"

#include <algorithm>
#include <array>
#include <fmt/format.h>
#include <string_view>

namespace sr::viewer {
namespace {

constexpr const char* sum = "integrator/reflected.glsl";
constexpr const char* integrand = "integrator/integrand.glsl";
constexpr const char* mirror_reflectance = "vec3 L_k = x.base_color * light";
constexpr const char* mirror_sum = "integrator/mirrored.glsl";

/// The function that gives the light of an emitter as it arrives at x (shaders/light/sample_light.glsl).
std::string function_of(const scene::Light& light) {
    const std::string variety = scene::variety_of(light);
    if (variety == "sun") return "sample_sun";
    if (variety.starts_with("round ")) return "sample_sphere";
    return fmt::format("sample_{}", scene::light_kind_names()[light.index()]);
}

/// The function that computes a term.
std::string function_of(EquationTerm term, const scene::Light* light) {
    switch (term) {
    case EquationTerm::emission: return "emitted";
    case EquationTerm::f_r: return "f_r";
    case EquationTerm::light: return light ? function_of(*light) : "sample_light";
    case EquationTerm::visibility: return "visibility";
    case EquationTerm::cosine: return "cosine";
    }
    return {};
}

/// True if a line begins the definition of a function: not a call, no prototype.
bool defines(std::string_view line, const std::string& function) {
    constexpr std::array types{"vec3 ", "float ", "LightSample "};
    const bool is_declared =
        std::ranges::any_of(types, [&](const char* type) { return line.starts_with(type + function + "("); });
    return is_declared && (line.find(';') == std::string_view::npos || line.find('{') < line.find(';'));
}

std::vector<std::string_view> lines_in(std::string_view text) {
    std::vector<std::string_view> lines;
    while (!text.empty()) {
        const std::size_t end = std::min(text.find('\n'), text.size());
        lines.push_back(text.substr(0, end));
        text.remove_prefix(std::min(end + 1, text.size()));
    }
    return lines;
}

/// Lines of the same file around flat line `at`, which counts from 0.
CodeExcerpt excerpt_around(const glsl::Source& source, std::size_t at) {
    constexpr std::size_t before = 4, after = 14;
    const auto texts = lines_in(source.text);
    const auto follows = [&](std::size_t i) {
        return i < texts.size() && i < source.lines.size() && source.lines[i].file == source.lines[i - 1].file
               && source.lines[i].line == source.lines[i - 1].line + 1;
    };
    std::size_t begin = at, end = at + 1;
    while (begin > 0 && at - begin < before && follows(begin)) --begin;
    const auto is_end_of_function = [&](std::size_t i) { return texts[i].starts_with("}"); };
    while (end - at < after && follows(end) && !is_end_of_function(end - 1)) ++end;
    const glsl::Source::Line origin = source.lines[at];
    CodeExcerpt excerpt{
        source.files[static_cast<std::size_t>(origin.file)], origin.line, source.lines[begin].line, {}};
    for (std::size_t i = begin; i < end; ++i) excerpt.lines.emplace_back(texts[i]);
    return excerpt;
}

/// A change of a file that leaves a term out. Where `of_mirror`, the term of an ideal mirror.
struct Omission {
    EquationTerm term{};
    const char* file = "";
    std::string from, to;
    bool of_mirror = false;
};

std::vector<Omission> omissions_of(int left_out) {
    const std::string each = "for (int k = first_at_work(kind); k < end_light; k = next_at_work(k)) {";
    const std::string each_mirrored = "for (int k = first_light; k < end_light; ++k) {";
    const std::string others = fmt::format(" if (k == {}) continue;", left_out);
    return {{EquationTerm::emission, "integrator/emitted.glsl", "return x.emission;", "return vec3(0.0);"},
            {EquationTerm::f_r, integrand, "f_r(x, light.wi, wo) * light", "light"},
            {EquationTerm::f_r, mirror_sum, mirror_reflectance, "vec3 L_k = light", true},
            {EquationTerm::light, sum, each, each + others},
            {EquationTerm::light, mirror_sum, each_mirrored, each_mirrored + others, true},
            {EquationTerm::visibility, "visibility/seen.glsl", "L * visibility(x, wi, distance, light, ray)",
             "L"},
            {EquationTerm::cosine, integrand, " * cos_i, x", ", x"}};
}

} // namespace

/// Returns forward.frag as the renderer specialises it.
glsl::Source EquationCode::expanded() const {
    glsl::Files files = render::brdf_files(model, path);
    files["visibility/visibility.glsl"] = fmt::format("#include \"visibility/{}.glsl\"\n", visibility);
    std::vector<glsl::Root> roots(path.begin(), path.end() - 1);
    roots.push_back(glsl::Root::memory("specialised", std::move(files)));
    roots.push_back(path.back());
    return glsl::expand(roots, "forward.frag");
}

std::optional<CodeExcerpt> EquationCode::of(EquationTerm term, const scene::Light* light) const {
    if (is_mirror && term == EquationTerm::cosine) return std::nullopt; // the delta has divided it out
    const std::string function = function_of(term, light);
    const bool is_reflectance = is_mirror && term == EquationTerm::f_r;
    const glsl::Source source = expanded();
    const auto texts = lines_in(source.text);
    const auto computes = [&](std::string_view line) {
        return is_reflectance ? line.find(mirror_reflectance) != std::string_view::npos
                              : defines(line, function);
    };
    const auto found = std::ranges::find_if(texts, computes);
    if (found == texts.end()) return std::nullopt;
    return excerpt_around(source, static_cast<std::size_t>(found - texts.begin()));
}

std::optional<LeftOut> EquationCode::without(EquationTerm term, int light) const {
    glsl::Files files;
    std::optional<LeftOut> shown;
    const glsl::Root* untrusted = nullptr;
    const std::vector<std::string> used = expanded().files;
    for (const Omission& omission : omissions_of(light)) {
        if (omission.term != term) continue;
        const auto root = std::ranges::find_if(
            path, [&](const glsl::Root& r) { return r.text_of(omission.file).has_value(); });
        if (root == path.end() || std::ranges::find(used, root->place_of(omission.file)) == used.end())
            continue;
        std::string text = *root->text_of(omission.file);
        const std::size_t at = text.find(omission.from);
        if (at == std::string::npos) continue;
        const std::size_t begin = text.rfind('\n', at) + 1; // npos + 1 is 0
        const int line =
            1 + static_cast<int>(std::ranges::count(std::string_view(text).substr(0, begin), '\n'));
        const std::string before = text.substr(begin, text.find('\n', at) - begin);
        text.replace(at, omission.from.size(), omission.to);
        const std::string after = text.substr(begin, text.find('\n', at) - begin);
        if (root->is_untrusted()) untrusted = &*root;
        files[omission.file] = std::move(text);
        if (omission.of_mirror != is_mirror && shown) continue;
        shown = {root->place_of(omission.file), line, before, after, glsl::embedded()};
    }
    if (!shown) return std::nullopt;
    shown->overlay = glsl::Root::memory("without a term", std::move(files));
    if (untrusted) shown->overlay = shown->overlay.untrusted(untrusted->permitted());
    return shown;
}

} // namespace sr::viewer
