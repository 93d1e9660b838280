// The equation at a pixel: the code of each term, the code without it, and numbers whose product is exact.
#include "viewer/document/equation_code.hpp"
#include "viewer/document/equation_numbers.hpp"

#include "glsl/source.hpp"
#include "support/address.hpp"

#include <array>
#include <vector>

using namespace sr;
using namespace sr::viewer;
using sr::testing::Test;

namespace {

constexpr std::array all_terms{EquationTerm::emission, EquationTerm::f_r, EquationTerm::light,
                               EquationTerm::visibility, EquationTerm::cosine};
const std::vector<glsl::Root> embedded_path{glsl::embedded()};

EquationCode code_of(scene::Model model, const std::vector<glsl::Root>& path = embedded_path) {
    return {path, model, model == scene::Model::mirror, "ray"};
}

const Test lines_of_terms("unit.viewer.equation.each_term_has_a_line", [] {
    for (std::size_t i = 0; i < scene::brdf_models.size(); ++i) {
        const auto model = static_cast<scene::Model>(i);
        for (const EquationTerm term : all_terms) {
            const scene::Light lamp = scene::SpotLight();
            const auto code = code_of(model).of(term, &lamp);
            if (model == scene::Model::mirror && term == EquationTerm::cosine) {
                EXPECT_FALSE(code);
                continue;
            }
            ASSERT_TRUE(code) << scene::name_of(model) << " " << static_cast<int>(term);
            EXPECT_TRUE(code->file.starts_with("shaders/")) << code->file;
            EXPECT_NE(code->computing_line().find(term == EquationTerm::emission     ? "emitted("
                                                  : term == EquationTerm::light      ? "sample_spot("
                                                  : term == EquationTerm::visibility ? "visibility("
                                                  : term == EquationTerm::cosine     ? "cosine("
                                                  : code_of(model).is_mirror         ? "base_color * light"
                                                                                     : "f_r("),
                      std::string::npos)
                << code->file << ": " << code->computing_line();
        }
    }
});

const Test lines_of_lights("unit.viewer.equation.each_kind_of_light_has_a_line", [] {
    scene::for_each_light_kind([]<class L>(std::type_identity<L>) {
        const scene::Light light = L();
        EXPECT_TRUE(code_of(scene::Model::lambert).of(EquationTerm::light, &light)) << L::kind;
    });
    scene::DirectionalLight sun;
    sun.angular_radius = 0.1f;
    const scene::Light light = sun;
    const auto code = code_of(scene::Model::lambert).of(EquationTerm::light, &light);
    ASSERT_TRUE(code);
    EXPECT_EQ(code->file, "shaders/light/sun.glsl");
});

const Test line_of_overlay("unit.viewer.equation.an_overlay_is_where_its_term_is_computed", [] {
    const std::string text = "#include \"surface/surface.glsl\"\n\n"
                             "vec3 f_r(Surface x, vec3 wi, vec3 wo) { return vec3(0.25); }\n";
    const std::vector<glsl::Root> path{glsl::Root::memory("mine", {{"brdf/f_r.glsl", text}}),
                                       glsl::embedded()};
    const auto code = code_of(scene::Model::ggx, path).of(EquationTerm::f_r, nullptr);
    ASSERT_TRUE(code);
    EXPECT_EQ(code->file, "mine/brdf/f_r.glsl");
    EXPECT_EQ(code->line, 3);
});

const Test without_a_term("unit.viewer.equation.code_without_a_term_differs_in_its_line_alone", [] {
    for (const scene::Model model : {scene::Model::ggx, scene::Model::mirror})
        for (const EquationTerm term : all_terms) {
            const auto out = code_of(model).without(term, 2);
            ASSERT_TRUE(out) << static_cast<int>(term);
            EXPECT_NE(out->before, out->after);
            std::vector<glsl::Root> path{out->overlay, glsl::embedded()};
            const glsl::Source changed = glsl::expand(path, "forward.frag");
            const glsl::Source whole = glsl::expand(embedded_path, "forward.frag");
            EXPECT_EQ(changed.lines.size(), whole.lines.size());
            EXPECT_NE(changed.text.find(out->after), std::string::npos);
        }
    const glsl::Root theirs = glsl::Root::memory(
        "theirs",
        {{"integrator/reflected.glsl", "vec3 reflected(Surface x, vec3 wo) { return vec3(1.0); }\n"},
         {"integrator/mirrored.glsl", "vec3 mirrored(Surface x, vec3 wo) { return vec3(1.0); }\n"}});
    const std::vector<glsl::Root> path{theirs, glsl::embedded()};
    EXPECT_FALSE(code_of(scene::Model::ggx, path).without(EquationTerm::cosine, 0));
});

const Test product_of_numbers("unit.viewer.equation.the_product_of_the_numbers_is_what_the_light_adds", [] {
    render::LightTerms light;
    light.solid_angle = 0.2f;
    light.cos_i = 0.6f;
    light.E = vec3(30.0f, 20.0f, 10.0f);
    light.L_r = vec3(6.0f, 2.0f, 0.5f);
    light.V_color = vec3(0.5f, 0.4f, 0.3f);
    light.V = 0.45f;
    for (const ColorPart part : {ColorPart::luminance, ColorPart::red, ColorPart::green, ColorPart::blue}) {
        const EquationProduct p = product_of(light, part, 0.0f);
        EXPECT_NEAR(*p.f_r * *p.radiance * p.solid_angle * p.V * p.cos_i, part_of(light.L_r, part), 1e-5f);
        EXPECT_NEAR(*p.radiance * p.solid_angle, *p.face_on, 1e-4f);
        const EquationProduct mirrored = product_of(light, part, 0.9f);
        EXPECT_NEAR(*mirrored.f_r * *mirrored.radiance, part_of(light.L_r, part), 1e-5f);
    }
    light.solid_angle = 0.0f;
    EXPECT_FALSE(product_of(light, ColorPart::red, 0.0f).radiance)
        << "a light without extent has no radiance";
    light.E = light.L_r = vec3(0.0f);
    EXPECT_FALSE(product_of(light, ColorPart::red, 0.0f).f_r) << "nothing arrives";
});

} // namespace
