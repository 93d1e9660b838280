#include "render/gpu/features.hpp"

#include "core/error.hpp"
#include "support/address.hpp"
#include "support/gl.hpp"
#include "support/scenes.hpp"

#include <cctype>
#include <fmt/format.h>
#include <set>

using namespace sr;
using namespace sr::testing;

namespace {

/// A row of squares, one a material.
scene::Scene squares(const std::vector<scene::Material>& materials) {
    scene::Scene scene;
    for (std::size_t i = 0; i < materials.size(); ++i)
        add_quad(scene, vec3(static_cast<float>(i), 0, 0), {0.4f, 0, 0}, {0, 0, -0.4f}, materials[i]);
    return scene;
}

std::size_t programs_of(const std::vector<scene::Material>& materials) {
    const std::vector<scene::Light> lights{scene::PointLight{"", {0, 2, 0}, vec3(1)}};
    const render::GpuScene scene(squares(materials), lights);
    render::Renderer renderer(scene, camera_from_above(4.0f), {});
    renderer.compile();
    return renderer.program_count();
}

const Test programs("unit.render.features.materials_share_programs", [] {
    context();
    std::vector<scene::Material> coated(15), plain(15);
    for (std::size_t i = 0; i < 15; ++i) {
        coated[i].clearcoat = 1.0f / (1.0f + static_cast<float>(i));
        plain[i].roughness = coated[i].roughness = static_cast<float>(i) / 15.0f;
    }
    std::vector<scene::Material> all = coated;
    all.insert(all.end(), plain.begin(), plain.end());
    EXPECT_EQ(programs_of(coated), programs_of({coated.front()}));
    EXPECT_EQ(programs_of(all), programs_of({coated.front(), plain.front()}));
    EXPECT_GT(programs_of(all), programs_of(plain));
});

// A material without metal, specular part and layers is Lambert's, for which a shader asks for less. Other
// people's shaders may mean something else by it.
const Test matte("unit.render.features.matte_materials_have_lamberts_shader", [] {
    context();
    scene::Material matte = lambert(vec3(0.3f, 0.6f, 0.9f)), shiny = matte, coated = matte, metal = matte;
    shiny.specular = 0.5f;
    coated.clearcoat = 0.5f;
    metal.metallic = 0.5f;
    const auto is_matte = [](const scene::Material& material) {
        const scene::Scene scene = squares({material});
        return render::shading_features(scene, scene.meshes[0], {}).is_matte;
    };
    EXPECT_TRUE(is_matte(matte));
    EXPECT_FALSE(is_matte(shiny));
    EXPECT_FALSE(is_matte(coated));
    EXPECT_FALSE(is_matte(metal));
    const std::vector<scene::Light> lights{
        scene::RectangleLight{"", {0.5f, 1.0f, 0}, {0.3f, 0, 0}, {0, 0, 0.3f}, vec3(5.0f)}};
    const render::GpuScene scene(squares({matte, shiny}), lights);
    const auto film_of = [&](render::RenderOptions options) {
        options.width = options.height = 24;
        render::Renderer renderer(scene, camera_from_above(1.5f), options);
        for (int i = 0; i < 3; ++i) renderer.add_sample();
        return renderer.read_film().pixels;
    };
    render::RenderOptions foreign;
    foreign.shader_path.insert(foreign.shader_path.begin(), glsl::Root::memory("nothing", {}));
    EXPECT_EQ(film_of({}), film_of(foreign)) << "the whole f_r of the material has the same values";
    const auto foreign_programs = [&](const std::vector<scene::Material>& materials) {
        const render::GpuScene of(squares(materials), lights);
        render::Renderer renderer(of, camera_from_above(1.5f), foreign);
        renderer.compile();
        return renderer.program_count();
    };
    EXPECT_EQ(foreign_programs({matte, shiny}), foreign_programs({shiny})) << "there is one for both";
    EXPECT_GT(programs_of({matte, shiny}), programs_of({shiny}));
});

const Test units("unit.render.features.too_many_textures_name_the_material", [] {
    render::Features features;
    std::fill_n(features.has_texture.begin(), 8, true);
    render::require_texture_units(features, "paint", 16);
    features.has_texture[8] = true;
    render::require_texture_units(features, "paint", 17);
    try {
        render::require_texture_units(features, "paint", 16);
        FAIL() << "nine textures and eight of the renderer's own are more than sixteen";
    } catch (const Error& error) {
        EXPECT_NE(std::string(error.what()).find("material \"paint\" reads 9 textures"), std::string::npos)
            << error.what();
    }
});

// The shaders read without a renderer, as tests read them, number the lights as the renderer does.
const Test kinds("unit.render.features.lights_have_the_same_numbers_in_c_and_in_glsl", [] {
    const std::string text = glsl::embedded().text_of("interface/features.glsl").value();
    for (std::size_t kind = 0; kind < scene::light_kind_count; ++kind) {
        const std::string name(scene::light_kind_names()[kind]);
        const std::string number = "const int " + name + "_light = " + std::to_string(kind) + ";";
        EXPECT_NE(text.find(number), std::string::npos) << number;
        EXPECT_NE(render::Features{}.glsl().find(number), std::string::npos) << number;
        EXPECT_NE(text.find("const bool has_" + name + "_lights = true;"), std::string::npos) << name;
    }
});

std::size_t occurrences(const std::string& text, std::string_view words) {
    std::size_t count = 0;
    for (std::size_t at = text.find(words); at != std::string::npos; at = text.find(words, at + 1)) ++count;
    return count;
}

const Test layers("unit.render.features.layers_have_the_same_flags_in_c_and_in_glsl", [] {
    const std::string text = glsl::embedded().text_of("interface/features.glsl").value();
    for (const scene::MaterialLayer& layer : scene::material_layers) {
        const std::string line = "const bool " + std::string(layer.flag) + " = false;";
        EXPECT_EQ(occurrences(text, line), 1u) << line;
        EXPECT_EQ(occurrences(render::Features{}.glsl(), line), 1u) << line;
    }
});

const Test textures("unit.render.features.textures_have_the_same_slots_in_c_and_in_glsl", [] {
    const std::string text = glsl::embedded().text_of("interface/material.glsl").value();
    const std::string features = glsl::embedded().text_of("interface/features.glsl").value();
    for (unsigned slot = 0; slot < scene::slot_count; ++slot) {
        const std::string name(scene::texture_inputs[slot].name);
        for (const std::string& line : {"const int " + name + "_slot = " + std::to_string(slot) + ";",
                                        "uniform sampler2D " + name + "_texture;"})
            EXPECT_NE(text.find(line), std::string::npos) << line;
        EXPECT_NE(features.find("const bool has_" + name + "_texture = true;"), std::string::npos) << name;
        EXPECT_NE(render::Features{}.glsl().find("const bool has_" + name + "_texture = false;"),
                  std::string::npos);
    }
    EXPECT_NE(text.find("const int slot_count = " + std::to_string(scene::slot_count) + ";"),
              std::string::npos);
    EXPECT_EQ(occurrences(text, "uniform sampler2D "), scene::slot_count) << "a texture that the table lacks";
});

/// The channels of "rgba" that the shaders take of a texture's samples.
std::string channels_read(std::string_view name) {
    const std::string sample = fmt::format("texel({}_texture, {}_slot)", name, name);
    std::set<std::size_t> read;
    for (const std::string& file : glsl::embedded().names()) {
        const std::string text = glsl::embedded().text_of(file).value();
        for (std::size_t at = text.find(sample); at != std::string::npos; at = text.find(sample, at + 1)) {
            std::size_t next = at + sample.size();
            if (text[next] != '.')
                read = {0, 1, 2, 3}; // the whole sample
            else
                while (std::isalpha(static_cast<unsigned char>(text[++next])))
                    read.insert(std::string_view("rgbaxyzw").find(text[next]) % 4);
        }
    }
    std::string channels;
    for (const std::size_t c : read) channels += "rgba"[c];
    return channels;
}

// Textures in software GL have no others, but for alphas that belong to another image (packed_alpha()).
const Test read_channels("unit.render.features.textures_have_the_channels_that_shaders_read", [] {
    for (const scene::TextureInput& input : scene::texture_inputs)
        EXPECT_EQ(channels_read(input.name), input.channels) << input.name;
});

} // namespace
