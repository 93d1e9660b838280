#include "brdf/brdf_under_test.hpp"

#include "core/error.hpp"
#include "core/file.hpp"

#include <array>
#include <cctype>
#include <fmt/format.h>
#include <string_view>

namespace sr::brdf {
namespace {

bool is_word(char c) { return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_'; }

/// True if the text has `function(…) {`: not a call and no prototype, which a ';' follows.
bool declares(std::string_view text, std::string_view function) {
    constexpr std::string_view blank = " \t\r\n\v\f";
    for (auto at = text.find(function); at != text.npos; at = text.find(function, at + 1)) {
        const std::string_view after = text.substr(at + function.size());
        const auto open = after.find_first_not_of(blank);
        if ((at > 0 && is_word(text[at - 1])) || open == after.npos || after[open] != '(') continue;
        const auto brace = after.find_first_of(";{", open);
        if (brace == after.npos || after[brace] == ';') continue;
        const auto last = after.find_last_not_of(blank, brace - 1);
        if (after[last] == ')') return true;
    }
    return false;
}

} // namespace

UserShader read_user_shader(const std::filesystem::path& file) {
    UserShader shader{read_text(file), file.string(), false};
    if (!declares(shader.text, "f_r"))
        throw Error({file.string()}, "does not declare f_r",
                    "write vec3 f_r(Surface x, vec3 wi, vec3 wo) { … }, as shaders/brdf/f_r.glsl does");
    int count = 0;
    for (const char* name : {"has_peak", "sample_f_r", "p_f_r"}) count += declares(shader.text, name);
    if (count != 0 && count != 3)
        throw Error({file.string()}, "declares a part of its sampling only",
                    "declare has_peak, sample_f_r and p_f_r, as shaders/brdf/sample_f_r.glsl does, or none");
    shader.has_sampling = count == 3;
    return shader;
}

render::Features features_of(const BrdfUnderTest& tested) {
    scene::Scene scene;
    scene.materials.push_back(tested.material);
    scene::Mesh mesh;
    mesh.tangents.emplace_back(1.0f, 0.0f, 0.0f, 1.0f);
    render::Features lights;
    lights.has_energy_compensation = tested.has_energy_compensation;
    return render::shading_features(scene, mesh, lights);
}

std::vector<glsl::Root> overlay_path(const BrdfUnderTest& tested) {
    std::vector<glsl::Root> path;
    if (tested.user) {
        path.push_back(glsl::Root::single(tested.user->place, "brdf/f_r.glsl", tested.user->text));
        if (tested.user->has_sampling)
            path.push_back(glsl::Root::memory(
                "its sampling",
                {{"brdf/sample_f_r.glsl", "#include \"brdf/f_r.glsl\"\n"},
                 {"trial/density.glsl",
                  "#include \"brdf/f_r.glsl\"\n"
                  "float density(Surface x, vec3 wi, vec3 wo) { return p_f_r(x, wi, wo); }\n"}}));
    }
    path.push_back(glsl::embedded());
    return path;
}

std::vector<glsl::Root> shader_path(const BrdfUnderTest& tested) {
    const render::Features features = features_of(tested);
    std::vector<glsl::Root> path = overlay_path(tested);
    path.insert(path.end() - 1,
                glsl::Root::memory("specialised", {{"interface/features.glsl", features.glsl()},
                                                   {"brdf/model.glsl", features.model_glsl()}}));
    return path;
}

} // namespace sr::brdf
