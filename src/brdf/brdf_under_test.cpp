#include "brdf/brdf_under_test.hpp"

#include "core/error.hpp"
#include "core/file.hpp"
#include "glsl/source.hpp"
#include "render/gpu/shader_library.hpp"

#include <utility>

namespace sr::brdf {

UserShader read_user_shader(const std::filesystem::path& file) {
    UserShader shader{read_text(file), file.string(), false};
    if (!glsl::declares(shader.text, "f_r"))
        throw Error(
            {file.string()}, "does not declare f_r",
            "write vec3 f_r(Surface x, vec3 wi, vec3 wo) { … }, as shaders/brdf/models/lambert.glsl does");
    int count = 0;
    for (const char* name : {"has_peak", "sample_f_r", "pdf_f_r"}) count += glsl::declares(shader.text, name);
    if (count != 0 && count != 3)
        throw Error(
            {file.string()}, "declares a part of its sampling only",
            "declare has_peak, sample_f_r and pdf_f_r, as shaders/brdf/models/phong.glsl does, or none");
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
    if (tested.user)
        path.push_back(glsl::Root::single(tested.user->place, "brdf/f_r.glsl", tested.user->text));
    path.push_back(glsl::embedded());
    return path;
}

std::vector<glsl::Root> shader_path(const BrdfUnderTest& tested) {
    const render::Features features = features_of(tested);
    std::vector<glsl::Root> path = overlay_path(tested);
    glsl::Files files = render::brdf_files(tested.material.model, path);
    files["interface/features.glsl"] = features.glsl();
    files["interface/fragment.glsl"] = "#include \"brdf_eval/fragment.glsl\"\n";
    path.insert(path.end() - 1, glsl::Root::memory("specialised", std::move(files)));
    return path;
}

} // namespace sr::brdf
