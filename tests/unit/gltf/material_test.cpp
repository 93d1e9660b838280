#include "loading.hpp"

#include <cmath>
#include <fmt/format.h>
#include <fstream>
#include <variant>

using namespace sr;
using namespace sr::testing;
using sr::testing::Test;

namespace {

// A triangle with both texture coordinate sets, its material, and three textures of two images.
MadeGltf with_material(const char* material) {
    MadeGltf made = MadeGltf::triangle();
    made.attributes()["NORMAL"] = made.floats({0, 0, 1, 0, 0, 1, 0, 0, 1}, "VEC3");
    made.attributes()["TEXCOORD_0"] = made.floats({0, 1, 1, 1, 0, 0}, "VEC2");
    made.attributes()["TEXCOORD_1"] = made.attributes()["TEXCOORD_0"];
    made.root["images"] =
        json::array({{{"uri", png_uri()}, {"name", "first"}}, {{"uri", png_uri()}, {"name", "second"}}});
    made.root["samplers"] =
        json::parse(R"([{"magFilter": 9728, "minFilter": 9985, "wrapS": 33071, "wrapT": 33648}])");
    made.root["textures"] = json::parse(R"([{"source": 1}, {"source": 0, "sampler": 0}, {"source": 1}])");
    made.root["materials"] = json::array({json::parse(material)});
    made.primitive()["material"] = 0;
    return made;
}

scene::Material material_of(const char* material) {
    return load(with_material(material)).scene.materials.at(0);
}

const Test fallback("unit.gltf.material.the_default_is_appended_once", [] {
    MadeGltf made = with_material(R"({"name": "own"})");
    json bare = made.primitive();
    bare.erase("material");
    made.root["meshes"][0]["primitives"].push_back(bare);
    made.root["meshes"][0]["primitives"].push_back(bare);
    const scene::Scene scene = load(made).scene;
    ASSERT_EQ(scene.materials.size(), 2u);
    EXPECT_EQ(scene.meshes.at(0).material, 0);
    EXPECT_EQ(scene.meshes.at(1).material, 1);
    EXPECT_EQ(scene.meshes.at(2).material, 1);
    EXPECT_EQ(scene.materials[1].base_color, vec4(1));
    EXPECT_EQ(scene.materials[1].metallic, 1.0f);
    EXPECT_EQ(scene.materials[1].roughness, 1.0f);
    EXPECT_EQ(scene.materials[1].emission, vec3(0));
    EXPECT_EQ(scene.materials[1].ior, 1.5f);
});

const Test factors("unit.gltf.material.factors", [] {
    const scene::Material material =
        material_of(R"({"name": "m", "doubleSided": true, "alphaMode": "MASK", "alphaCutoff": 0.25,
        "emissiveFactor": [1, 0.5, 0], "pbrMetallicRoughness":
        {"baseColorFactor": [0.1, 0.2, 0.3, 0.4], "metallicFactor": 0.5, "roughnessFactor": 0.75}})");
    EXPECT_EQ(material.name, "m");
    EXPECT_EQ(material.base_color, vec4(0.1f, 0.2f, 0.3f, 0.4f));
    EXPECT_EQ(material.metallic, 0.5f);
    EXPECT_EQ(material.roughness, 0.75f);
    EXPECT_EQ(material.emission, vec3(1, 0.5f, 0));
    EXPECT_TRUE(material.is_double_sided);
    EXPECT_EQ(material.alpha_mode, scene::AlphaMode::mask);
    EXPECT_EQ(material.alpha_cutoff, 0.25f);
    EXPECT_EQ(material_of(R"({"alphaMode": "BLEND"})").alpha_mode, scene::AlphaMode::blend);
    EXPECT_EQ(material_of("{}").alpha_mode, scene::AlphaMode::opaque);
});

const Test extensions("unit.gltf.material.extensions", [] {
    const scene::Material material = material_of(R"({"emissiveFactor": [1, 0.5, 0], "extensions": {
        "KHR_materials_emissive_strength": {"emissiveStrength": 20}, "KHR_materials_ior": {"ior": 1.25},
        "KHR_materials_specular": {"specularFactor": 0.5, "specularColorFactor": [2, 1, 0],
                                   "specularTexture": {"index": 0}, "specularColorTexture": {"index": 0, "texCoord": 1}},
        "KHR_materials_unlit": {}}})");
    EXPECT_EQ(material.emission, vec3(20, 10, 0));
    EXPECT_EQ(material.ior, 1.25f);
    EXPECT_EQ(material.specular, 0.5f);
    EXPECT_EQ(material.specular_color, vec3(2, 1, 0));
    EXPECT_TRUE(material.specular_texture.is_present());
    EXPECT_EQ(material.specular_color_texture.texcoord, 1);
    EXPECT_NE(material.specular_texture.texture,
              material.specular_color_texture.texture); // linear and sRGB
    EXPECT_TRUE(material.is_unlit);
    EXPECT_EQ(material_of(R"({"extensions": {"KHR_materials_ior": {"ior": 0}}})").ior, 0.0f);
    EXPECT_FALSE(material_of("{}").is_unlit);
});

const Test transmission("unit.gltf.material.light_that_goes_through", [] {
    const scene::Material m = material_of(R"({"pbrMetallicRoughness": {"metallicFactor": 0}, "extensions": {
        "KHR_materials_transmission": {"transmissionFactor": 0.5, "transmissionTexture": {"index": 0}},
        "KHR_materials_volume": {"thicknessFactor": 0.25, "thicknessTexture": {"index": 0, "texCoord": 1},
                                 "attenuationDistance": 2, "attenuationColor": [1, 0.5, 0]},
        "KHR_materials_diffuse_transmission": {"diffuseTransmissionFactor": 0.75,
            "diffuseTransmissionTexture": {"index": 0}, "diffuseTransmissionColorFactor": [0.1, 0.2, 0.3],
            "diffuseTransmissionColorTexture": {"index": 0}}}})");
    EXPECT_EQ(m.transmission, 0.5f);
    EXPECT_EQ(m.thickness, 0.25f);
    EXPECT_EQ(m.thickness_texture.texcoord, 1);
    EXPECT_EQ(m.attenuation_distance, 2.0f);
    EXPECT_EQ(m.attenuation_color, vec3(1, 0.5f, 0));
    EXPECT_EQ(m.diffuse_transmission, 0.75f);
    EXPECT_EQ(m.diffuse_transmission_color, vec3(0.1f, 0.2f, 0.3f));
    EXPECT_EQ(m.transmission_texture.texture, m.diffuse_transmission_texture.texture); // both linear
    EXPECT_NE(m.transmission_texture.texture, m.diffuse_transmission_color_texture.texture);
    EXPECT_TRUE(m.is_transmissive());
    EXPECT_TRUE(m.transmits_diffusely());
    const vec3 sigma = scene::attenuation_coefficient(m);
    EXPECT_EQ(sigma.x, 0.0f);
    EXPECT_NEAR(sigma.y, 0.5f * std::log(2.0f), 1e-6f);
    EXPECT_TRUE(std::isfinite(sigma.z) && sigma.z > 30.0f) << "black, and finite";

    const scene::Material plain = material_of("{}");
    EXPECT_FALSE(plain.is_transmissive());
    EXPECT_FALSE(plain.transmits_diffusely());
    EXPECT_EQ(scene::attenuation_coefficient(plain), vec3(0.0f));
    EXPECT_FALSE(material_of(R"({"extensions": {"KHR_materials_transmission": {"transmissionFactor": 1}}})")
                     .is_transmissive())
        << "metal lets nothing through";
});

const Test bad_volumes("unit.gltf.material.bad_volumes_are_named", [] {
    const gltf::Loaded loaded = load(with_material(
        R"({"name": "m", "extensions": {"KHR_materials_volume": {"attenuationDistance": 0}}})"));
    EXPECT_TRUE(std::isinf(loaded.scene.materials.at(0).attenuation_distance));
    EXPECT_TRUE(warns_once(
        loaded, "material \"m\": attenuationDistance is 0, not more than 0: nothing is attenuated"));
    EXPECT_NE(error_of(with_material(R"({"extensions": {"KHR_materials_volume": {"thicknessFactor": -1}}})"))
                  .find("thicknessFactor is -1"),
              std::string::npos);
});

const Test bad_factors("unit.gltf.material.bad_factors_are_named", [] {
    const gltf::Loaded loaded =
        load(with_material(R"({"name": "m", "pbrMetallicRoughness": {"roughnessFactor": 1.5}})"));
    EXPECT_EQ(loaded.scene.materials.at(0).roughness, 1.0f);
    EXPECT_TRUE(warns_once(loaded, "material \"m\": roughnessFactor is 1.5, outside 0 to 1: it is clamped"));
    EXPECT_NE(error_of(with_material(R"({"emissiveFactor": [-1, 0, 0]})")).find("give zero or more"),
              std::string::npos);
    EXPECT_NE(
        error_of(with_material(R"({"extensions": {"KHR_materials_ior": {"ior": 0.5}}})")).find("ior is 0.5"),
        std::string::npos);
    EXPECT_NE(error_of(with_material(R"({"alphaMode": "GLOW"})")).find("must be one of OPAQUE, MASK, BLEND"),
              std::string::npos);
});

const Test color_spaces("unit.gltf.material.colour_textures_are_srgb_and_others_linear", [] {
    const gltf::Loaded loaded =
        load(with_material(R"({"normalTexture": {"index": 0, "scale": 0.5}, "emissiveTexture": {"index": 0},
        "occlusionTexture": {"index": 1}, "pbrMetallicRoughness":
        {"baseColorTexture": {"index": 0}, "metallicRoughnessTexture": {"index": 2}}})"));
    const scene::Scene& scene = loaded.scene;
    const scene::Material& material = scene.materials.at(0);
    const auto space = [&](const scene::TextureSlot& slot) {
        return scene.textures.at(slot.texture).color_space;
    };
    EXPECT_EQ(space(material.base_color_texture), scene::ColorSpace::srgb);
    EXPECT_EQ(space(material.emission_texture), scene::ColorSpace::srgb);
    EXPECT_EQ(space(material.metallic_roughness_texture), scene::ColorSpace::linear);
    EXPECT_EQ(space(material.normal_texture), scene::ColorSpace::linear);
    EXPECT_EQ(material.normal_scale, 0.5f);
    EXPECT_EQ(scene.textures.size(), 2u); // textures 0 and 2 are the same image and sampler
    ASSERT_EQ(scene.images.size(),
              1u); // occlusion has no part in direct light, and its image is not decoded
    EXPECT_EQ(scene.images[0].name, "second");
    EXPECT_TRUE(loaded.warnings.empty());
});

const Test sampler("unit.gltf.material.samplers", [] {
    const scene::Scene scene =
        load(with_material(R"({"normalTexture": {"index": 0}, "emissiveTexture": {"index": 1}})")).scene;
    const scene::Texture normal = scene.textures.at(scene.materials.at(0).normal_texture.texture);
    EXPECT_EQ(normal.sampler, scene::Sampler{});
    const scene::Texture emission = scene.textures.at(scene.materials.at(0).emission_texture.texture);
    EXPECT_EQ(emission.sampler,
              (scene::Sampler{scene::Wrap::clamp_to_edge, scene::Wrap::mirrored_repeat,
                              scene::Filter::nearest, scene::Filter::linear, scene::Mipmap::nearest}));
});

const Test transform("unit.gltf.material.texture_transform", [] {
    // The extension's own example: the lower left quadrant of the picture, turned clockwise by 90
    // degrees.
    const scene::Material material =
        material_of(R"({"emissiveTexture": {"index": 0, "extensions": {"KHR_texture_transform":
        {"offset": [0, 1], "rotation": 1.57079632679, "scale": [0.5, 0.5], "texCoord": 1}}}})");
    EXPECT_EQ(material.emission_texture.texcoord, 1);
    const auto at = [&](float u, float v) {
        return vec2(material.emission_texture.uv_transform * vec3(u, v, 1));
    };
    EXPECT_LT(glm::length(at(0, 0) - vec2(0, 1)), 1e-6f);
    EXPECT_LT(glm::length(at(1, 0) - vec2(0, 0.5f)), 1e-6f);
    EXPECT_LT(glm::length(at(0, 1) - vec2(0.5f, 1)), 1e-6f);
    // Scale comes before rotation.
    const scene::Material stretched =
        material_of(R"({"emissiveTexture": {"index": 0, "extensions": {"KHR_texture_transform":
        {"rotation": 1.57079632679, "scale": [2, 3]}}}})");
    EXPECT_LT(glm::length(vec2(stretched.emission_texture.uv_transform * vec3(1, 1, 1)) - vec2(3, -2)),
              1e-6f);
});

const Test high_sets("unit.gltf.material.any_two_sets_of_texture_coordinates_are_read", [] {
    MadeGltf made =
        with_material(R"({"emissiveTexture": {"index": 0, "texCoord": 3}, "emissiveFactor": [1, 1, 1],
        "normalTexture": {"index": 1, "texCoord": 1, "extensions": {"KHR_texture_transform": {"texCoord": 2}}}})");
    made.attributes()["TEXCOORD_2"] = made.floats({2, 1, 1, 1, 2, 2}, "VEC2");
    made.attributes()["TEXCOORD_3"] = made.floats({3, 1, 1, 1, 3, 3}, "VEC2");
    const gltf::Loaded loaded = load(made);
    EXPECT_TRUE(loaded.warnings.empty()) << ::testing::PrintToString(loaded.warnings);
    const scene::Material& material = loaded.scene.materials.at(0);
    const scene::Mesh& mesh = loaded.scene.meshes.at(0);
    EXPECT_EQ(mesh.texcoords[material.emission_texture.texcoord].at(0), vec2(3, 1));
    EXPECT_EQ(mesh.texcoords[material.normal_texture.texcoord].at(0), vec2(2, 1));
});

const Test third_set("unit.gltf.material.a_third_set_of_texture_coordinates_is_warned_of", [] {
    const MadeGltf made = with_material(R"({"emissiveTexture": {"index": 0, "texCoord": 2},
        "emissiveFactor": [1, 1, 1], "pbrMetallicRoughness": {"baseColorTexture": {"index": 0},
        "metallicRoughnessTexture": {"index": 0, "texCoord": 1}}})");
    const scene::Material material = load(made).scene.materials.at(0);
    EXPECT_FALSE(material.emission_texture.is_present());
    EXPECT_EQ(material.emission, vec3(0)); // all of it lit would be a lamp
    EXPECT_NE(loss_of(made).find("TEXCOORD_0, TEXCOORD_1 and TEXCOORD_2"), std::string::npos);
});

const Test images("unit.gltf.material.images_are_decoded", [] {
    const scene::Scene scene = load(with_material(R"({"emissiveTexture": {"index": 1}})")).scene;
    ASSERT_EQ(scene.images.size(), 1u);
    EXPECT_EQ(scene.images[0].name, "first");
    EXPECT_EQ(scene.images[0].width, 1);
    EXPECT_EQ(scene.images[0].height, 1);
    EXPECT_EQ(std::get<std::vector<std::uint8_t>>(scene.images[0].texels),
              (std::vector<std::uint8_t>{255, 128, 0, 255}));
});

const Test view_image("unit.gltf.material.images_may_lie_in_a_buffer_view", [] {
    MadeGltf made = with_material(R"({"emissiveTexture": {"index": 1}})");
    const std::vector<std::uint8_t> junk{1, 2, 3, 4};
    const int accessor = made.accessor(junk, "SCALAR", 5121);
    made.root["images"][0] = {{"bufferView", made.root["accessors"][accessor]["bufferView"]},
                              {"mimeType", "image/png"},
                              {"name", "junk"}};
    EXPECT_TRUE(loss_of(made).starts_with("made.gltf: /images/0 \"junk\": ")) << loss_of(made);
    made.root["bufferViews"].back()["byteLength"] = 5000;
    EXPECT_NE(loss_of(made).find("of /buffers/0, which has"), std::string::npos);
});

const Test bad_images("unit.gltf.material.absent_images_cost_something_only_if_used", [] {
    MadeGltf made = with_material(R"({"emissiveTexture": {"index": 1}})");
    made.root["images"][1] = {{"uri", "../no.png"}};
    EXPECT_TRUE(load(made).warnings.empty());
    made.root["images"][0] = {{"uri", "no.png"}};
    EXPECT_EQ(loss_of(made), "made.gltf: /images/0/uri names \"no.png\": no such file: check the path");
    made.root["images"][0] = {{"uri", "../no.png"}};
    EXPECT_NE(loss_of(made).find("leaves the folder"), std::string::npos);
    made.root["images"][0] = {{"name", "nothing"}};
    EXPECT_EQ(loss_of(made), "made.gltf: /images/0 has neither bufferView nor uri: export the file again");
});

const Test foreign_texture("unit.gltf.material.a_texture_without_image_is_warned_of", [] {
    MadeGltf made = with_material(R"({"emissiveTexture": {"index": 0}})");
    made.root["textures"][0].erase("source");
    const gltf::Loaded loaded = load(made);
    EXPECT_FALSE(loaded.scene.materials.at(0).emission_texture.is_present());
    EXPECT_TRUE(warns_once(loaded, "/textures/0 has no image in a supported format"));
});

// Base colour white, normal flat, metallic and roughness by their factors; of what glows, nothing.
const Test lost_images("unit.gltf.material.a_lost_image_leaves_the_factors", [] {
    MadeGltf made = with_material(R"({"emissiveFactor": [1, 1, 1], "emissiveTexture": {"index": 1},
        "normalTexture": {"index": 1}, "pbrMetallicRoughness": {"baseColorFactor": [0.5, 1, 1, 1],
        "baseColorTexture": {"index": 1}, "metallicRoughnessTexture": {"index": 0}, "metallicFactor": 0.25}})");
    const std::vector<json> broken{{{"uri", "no.png"}},
                                   {{"uri", "data:image/png;base64,iVBORw0KGgo="}},
                                   {{"uri", 5}},
                                   {{"bufferView", 77}},
                                   "picture",
                                   nullptr,
                                   {{"uri", "data:image/png;base64,AAAA"}},
                                   {{"uri", "http://a/b.png"}}};
    for (const json& image : broken) {
        SCOPED_TRACE(image.dump());
        made.root["images"][0] = image;
        EXPECT_NE(loss_of(made).find("/images/0"), std::string::npos);
        const scene::Material material = load(made).scene.materials.at(0);
        EXPECT_FALSE(material.base_color_texture.is_present());
        EXPECT_FALSE(material.normal_texture.is_present());
        EXPECT_TRUE(material.metallic_roughness_texture.is_present()); // of the other image
        EXPECT_EQ(material.base_color, vec4(0.5f, 1, 1, 1));
        EXPECT_EQ(material.emission, vec3(0));
    }
});

const Test lost_textures("unit.gltf.material.a_lost_texture_leaves_the_factors", [] {
    const char* text = R"({"emissiveFactor": [1, 1, 1], "emissiveTexture": {"index": 1}})";
    const auto expect_dark = [](const MadeGltf& made, std::string_view what) {
        const std::string error = loss_of(made);
        EXPECT_NE(error.find(what), std::string::npos) << error;
        EXPECT_EQ(load(made).scene.materials.at(0).emission, vec3(0));
    };
    MadeGltf made = with_material(text);
    made.root["textures"][1]["source"] = 7;
    expect_dark(made, "/textures/1 has image 7, and there are 2");
    made = with_material(text);
    made.root["textures"][1] = 3;
    expect_dark(made, "/textures/1 must be an object");
    made = with_material(text);
    made.root["materials"][0]["emissiveTexture"]["index"] = 9;
    expect_dark(made, "/materials/0/emissiveTexture/index must be below 3");
    made = with_material(text);
    made.root["textures"][1]["sampler"] = 9;
    EXPECT_NE(loss_of(made).find("/textures/1/sampler must be below 1"), std::string::npos);
    EXPECT_EQ(load(made).scene.materials.at(0).emission, vec3(1)); // read with the default sampler
    made.root["textures"][1]["sampler"] = 0;
    made.root["samplers"][0]["wrapS"] = 5;
    EXPECT_NE(loss_of(made).find("/samplers/0/wrapS must be one of"), std::string::npos);
    EXPECT_EQ(load(made).scene.textures.at(0).sampler.wrap_u, scene::Wrap::repeat);
});

// A buffer that only an image needs is no geometry.
const Test lost_buffer("unit.gltf.material.a_buffer_that_is_not_there_costs_what_lies_in_it", [] {
    MadeGltf made = with_material(R"({"emissiveTexture": {"index": 1}})");
    made.root["buffers"] = json::array({nullptr, {{"uri", "no.bin"}, {"byteLength", 100}}});
    made.root["bufferViews"].push_back({{"buffer", 1}, {"byteLength", 100}});
    made.root["images"][0] = {{"bufferView", made.root["bufferViews"].size() - 1}};
    made.root["buffers"][0] = {{"byteLength", made.bytes.size()},
                               {"uri", "data:;base64," + base64(made.bytes)}};
    EXPECT_NE(loss_of(made).find("/buffers/1/uri names \"no.bin\": no such file"), std::string::npos);
    made.root["accessors"][0]["bufferView"] = made.root["bufferViews"].size() - 1; // of positions
    EXPECT_NE(error_of(made).find("/buffers/1/uri names \"no.bin\": no such file"), std::string::npos);
});

const Test ktx("unit.gltf.material.what_is_ktx2_alone_names_the_conversion", [] {
    MadeGltf made = with_material(R"({"emissiveFactor": [1, 1, 1], "emissiveTexture": {"index": 0}})");
    made.root["textures"][0] = {{"extensions", {{"KHR_texture_basisu", {{"source", 1}}}}}};
    EXPECT_TRUE(warns_once(load(made),
                           "/textures/0 has no image in a supported format: the material is shown "
                           "without it; convert its textures to PNG: gltf-transform ktxdecompress"));
    made.root["textures"][0]["source"] = 0;
    EXPECT_EQ(load(made).scene.images.at(0).name, "first"); // what stands beside it
    // A file that requires the extension loses the texture alone.
    made.root["textures"][0].erase("source");
    made.root["extensionsUsed"] = made.root["extensionsRequired"] = {"KHR_texture_basisu"};
    const std::string error = loss_of(made);
    EXPECT_NE(error.find("/textures/0 has no image in a supported format"), std::string::npos) << error;
    EXPECT_NE(load(made).warnings.at(0).find("gltf-transform ktxdecompress IN.glb OUT.glb"),
              std::string::npos);
    // KTX2 where glTF wants a PNG or JPEG.
    const std::vector<std::uint8_t> magic{0xAB, 'K', 'T', 'X', ' ', '2', '0', 0xBB, '\r', '\n', 0x1A, '\n'};
    made.root["textures"][0] = {{"source", 0}};
    made.root["images"][0] = {{"uri", "data:image/ktx2;base64," + base64(magic)}, {"mimeType", "image/ktx2"}};
    EXPECT_TRUE(loss_of(made).starts_with("made.gltf: /images/0: a KTX2 image, which is not supported"));
});

// F0 is the specular factor, at an infinite ior; shaders/surface/ has the rest.
const Test glossy("unit.gltf.material.specular_glossiness_goes_before_metallic_roughness", [] {
    const char* text = R"({"name": "m", "pbrMetallicRoughness": {"baseColorFactor": [1, 0, 0, 1],
        "baseColorTexture": {"index": 1}, "metallicRoughnessTexture": {"index": 1}}, "extensions":
        {"KHR_materials_pbrSpecularGlossiness": {"diffuseFactor": [0.1, 0.2, 0.3, 0.4], "glossinessFactor": 0.75,
         "specularFactor": [0.5, 0.25, 0], "diffuseTexture": {"index": 0, "texCoord": 1},
         "specularGlossinessTexture": {"index": 2}}}})";
    const gltf::Loaded loaded = load(with_material(text));
    EXPECT_TRUE(loaded.warnings.empty());
    const scene::Material& m = loaded.scene.materials.at(0);
    EXPECT_TRUE(m.is_specular_glossiness);
    EXPECT_EQ(m.base_color, vec4(0.1f, 0.2f, 0.3f, 0.4f));
    EXPECT_EQ(m.specular_color, vec3(0.5f, 0.25f, 0));
    EXPECT_EQ(vec3(m.metallic, m.roughness, m.ior), vec3(0, 0.25f, 0));
    EXPECT_FALSE(m.metallic_roughness_texture.is_present());
    EXPECT_EQ(m.base_color_texture.texcoord, 1);
    EXPECT_TRUE(m.specular_color_texture.is_present());
    EXPECT_EQ(loaded.scene.textures.at(m.specular_color_texture.texture).color_space,
              scene::ColorSpace::srgb);
    MadeGltf unlit = with_material(text);
    unlit.root["materials"][0]["extensions"]["KHR_materials_unlit"] = json::object();
    EXPECT_EQ(load(unlit).scene.materials.at(0).base_color, vec4(1, 0, 0, 1));
    const scene::Material defaults =
        material_of(R"({"extensions": {"KHR_materials_pbrSpecularGlossiness": {}}})");
    EXPECT_EQ(vec2(defaults.roughness, defaults.specular_color.g), vec2(0, 1));
});

const Test layers("unit.gltf.material.layers", [] {
    const scene::Material m = material_of(R"({"extensions": {
        "KHR_materials_anisotropy": {"anisotropyStrength": 0.5, "anisotropyRotation": 1.25, "anisotropyTexture": {"index": 0}},
        "KHR_materials_clearcoat": {"clearcoatFactor": 0.75, "clearcoatNormalTexture": {"index": 1, "scale": 2}},
        "KHR_materials_sheen": {"sheenColorFactor": [0.1, 0.2, 0.3], "sheenRoughnessFactor": 0.25},
        "KHR_materials_iridescence": {"iridescenceFactor": 1, "iridescenceIor": 1.5, "iridescenceThicknessMaximum": 500}}})");
    EXPECT_EQ(vec2(m.anisotropy, m.anisotropy_rotation), vec2(0.5f, 1.25f));
    EXPECT_TRUE(m.anisotropy_texture.is_present());
    EXPECT_EQ(vec2(m.clearcoat, m.clearcoat_normal_scale), vec2(0.75f, 2.0f));
    EXPECT_EQ(vec4(m.sheen_color, m.sheen_roughness), vec4(0.1f, 0.2f, 0.3f, 0.25f));
    EXPECT_EQ(vec3(m.film_ior, m.min_film_thickness, m.max_film_thickness), vec3(1.5f, 100.0f, 500.0f));
    EXPECT_FALSE(
        load(with_material(R"({"extensions": {"KHR_materials_anisotropy": {"anisotropyStrength": 0.5}}})"))
            .scene.meshes.at(0)
            .tangents.empty());
});

const Test brdfs("unit.gltf.material.brdfs_of_extras", [] {
    const scene::Material gold = material_of(
        R"({"extras": {"steradian": {"brdf": "conductor", "metal": "gold", "roughness_across": 0.5}}})");
    EXPECT_EQ(gold.model, scene::Model::conductor);
    EXPECT_GT(gold.conductor.k.r, gold.conductor.k.b);
    EXPECT_EQ(gold.roughness_across, 0.5f);
    const auto error_with = [](const char* stated) {
        return error_of(with_material(
            (std::string(R"({"name": "m", "extras": {"steradian": )") + stated + "}}").c_str()));
    };
    EXPECT_EQ(error_with(R"({"brdf": "lambert", "exponent": 5})"),
              "made.gltf: material \"m\" has exponent: that belongs to the brdf phong or blinn_phong: say "
              "so, or leave it out");
    EXPECT_EQ(error_with(R"({"brdf": "conductor"})"),
              "made.gltf: material \"m\" is a conductor that does not say of what once: give it one of "
              "metal, complex_ior and "
              "ior_spectrum");
    EXPECT_NE(error_with(R"({"brdf": "plastic"})").find("brdf"), std::string::npos);
});

/// The schema's entry of a parameter; for values with a form of their own, its description alone.
json schema_entry(const scene::BrdfParameter& parameter) {
    const auto exact = [](float value) { return json::parse(fmt::format("{}", value)); };
    json entry{{"description",
                fmt::format("Of {}: {}.", scene::models_with(parameter, " and "), parameter.meaning)}};
    json number{{"type", "number"}, {"minimum", exact(parameter.min)}, {"maximum", exact(parameter.max)}};
    if (std::holds_alternative<float scene::Material::*>(parameter.member)) {
        entry.update(number);
        if (parameter.fallback) entry["default"] = exact(*parameter.fallback);
    } else if (std::holds_alternative<vec3 scene::Material::*>(parameter.member)) {
        entry.update({{"type", "array"}, {"minItems", 3}, {"maxItems", 3}, {"items", number}});
        if (parameter.fallback) entry["default"] = json::array_t(3, exact(*parameter.fallback));
    }
    return entry;
}

// The schema says of each parameter of a BRDF what the table says.
const Test published("unit.gltf.material.the_schema_has_the_brdf_parameters", [] {
    std::ifstream stream(assets_folder() / "extras.schema.json");
    const json properties = json::parse(stream).at("$defs").at("material").at("properties");
    json names = properties.at("brdf").at("enum");
    names.insert(names.begin(), "metallic_roughness");
    ASSERT_EQ(names.size(), scene::brdf_models.size());
    for (std::size_t i = 0; i < names.size(); ++i) EXPECT_EQ(names[i], scene::brdf_models[i].name);
    for (const scene::BrdfParameter& parameter : scene::brdf_parameters) {
        json stated = properties.value(std::string(parameter.key), json::object());
        if (parameter.member.index() > 1) stated = {{"description", stated.value("description", "")}};
        const json expected = schema_entry(parameter);
        EXPECT_EQ(stated, expected) << parameter.key << ": write " << expected.dump();
    }
});

const Test lost_measurement("unit.gltf.material.without_its_file_a_measured_brdf_is_that_of_gltf", [] {
    const auto folder = test_folder();
    write_text(folder / "short.binary", std::string("\x5a\0\0\0\x5a\0\0\0\xb4\0\0\0cut", 15));
    for (const std::string name : {"no.binary", "short.binary"}) {
        const std::string material =
            R"({"extras": {"steradian": {"brdf": "merl", "file": ")" + name + R"("}}})";
        write_text(folder / "made.gltf", with_material(material.c_str()).gltf());
        const gltf::Loaded loaded = gltf::load(folder / "made.gltf");
        EXPECT_TRUE(warns_once(loaded, name)) << ::testing::PrintToString(loaded.warnings);
        EXPECT_TRUE(warns_once(loaded, "it has glTF's own BRDF"));
        EXPECT_EQ(loaded.scene.materials.at(0).model, scene::Model::metallic_roughness);
        EXPECT_NE(error_at(folder / "made.gltf", {.is_strict = true}).find(name), std::string::npos);
    }
});

} // namespace
