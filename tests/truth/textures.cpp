#include "truth/textures.hpp"

#include <cmath>

namespace sr::truth {
namespace {

constexpr int size = 8; // texels

// Pictures have 8 bits a channel, as files do. Software GL alone would filter them in 8 bits and decode sRGB
// by a polynomial that is off by up to 2 % (Mesa's llvmpipe, lp_bld_format_srgb.c).

/// `value` gives the texel (x, y), four numbers of 0 to 255.
template<class Value>
int add_texture(scene::Scene& scene, scene::ColorSpace color_space, const scene::Sampler& sampler,
                Value value) {
    scene::TextureImage image{"made", size, size, {}};
    auto& texels = image.texels.emplace<std::vector<std::uint8_t>>();
    for (int y = 0; y < size; ++y) {
        for (int x = 0; x < size; ++x) {
            const std::array<int, 4> texel = value(x, y);
            for (const int channel : texel) texels.push_back(static_cast<std::uint8_t>(channel));
        }
    }
    scene.images.push_back(image);
    scene.textures.push_back({static_cast<int>(scene.images.size()) - 1, sampler, color_space});
    return static_cast<int>(scene.textures.size()) - 1;
}

/// Normals that lean up to a quarter of a right angle, +Z being the surface's.
std::array<int, 4> normal_texel(int x, int y) {
    const vec3 n = glm::normalize(vec3(0.3f * std::sin(1.7f * static_cast<float>(x)),
                                       0.3f * std::sin(2.3f * static_cast<float>(y + x)), 1.0f));
    const auto stored = [](float value) { return static_cast<int>(std::lround(127.5f * (value + 1.0f))); };
    return {stored(n.x), stored(n.y), stored(n.z), 255};
}

} // namespace

int add_pattern(scene::Scene& scene, scene::ColorSpace color_space, const scene::Sampler& sampler) {
    return add_texture(scene, color_space, sampler, [](int x, int y) -> std::array<int, 4> {
        const int dimming = (x / 2 + y / 2) % 2 == 1 ? 4 : 1;
        return {(250 - 20 * x) / dimming, (60 + 24 * y) / dimming, (x * y * 37) % 256 / dimming,
                255 - 20 * y};
    });
}

void add_textures(scene::Scene& scene) {
    using enum scene::Wrap;
    const auto sampler = [](scene::Wrap wrap, scene::Filter filter = scene::Filter::linear) {
        return scene::Sampler{wrap, wrap, filter, filter, scene::Mipmap::none};
    };
    scene::Mesh& mesh = scene.meshes[0];
    for (const vec3 p : mesh.positions) mesh.texcoords[0].push_back(vec2(p.x, p.z) * 0.8f + 0.3f);
    mesh.colors = {{1, 0.5f, 1, 1}, {0.5f, 1, 1, 1}, {1, 1, 0.5f, 1}, {0.8f, 0.8f, 0.8f, 1}};
    const float angle = 0.5f; // of the tangents against the texture's u: nothing may rely on their agreeing
    mesh.tangents.assign(4, vec4(std::cos(angle), 0.0f, std::sin(angle), -1.0f));

    const float c = std::cos(0.4f), s = std::sin(0.4f);
    const mat3 turned(vec3(0.7f * c, 0.7f * s, 0.0f), vec3(-0.9f * s, 0.9f * c, 0.0f),
                      vec3(0.2f, -0.3f, 1.0f));
    scene::Material& m = scene.materials[0];
    m.metallic = 0.8f;
    m.roughness = 0.9f;
    m.normal_scale = 0.8f;
    m.specular_color = vec3(0.9f, 1.0f, 0.8f);
    m.base_color_texture = {add_pattern(scene, scene::ColorSpace::linear, sampler(mirrored_repeat)), 0,
                            turned};
    const auto rough_and_metallic = [](int x, int y) -> std::array<int, 4> {
        return {0, 120 + 15 * x, 36 * y, 255};
    };
    m.metallic_roughness_texture.texture =
        add_texture(scene, scene::ColorSpace::linear, sampler(repeat), rough_and_metallic);
    m.normal_texture.texture = add_texture(scene, scene::ColorSpace::linear, sampler(repeat), normal_texel);
    m.specular_texture = {add_pattern(scene, scene::ColorSpace::linear, sampler(clamp_to_edge)), 0, turned};
    m.specular_color_texture.texture =
        add_pattern(scene, scene::ColorSpace::linear, sampler(repeat, scene::Filter::nearest));
}

void add_photograph(scene::Scene& scene) {
    scene::Mesh& mesh = scene.meshes[0];
    for (const vec3 p : mesh.positions) mesh.texcoords[0].push_back(vec2(p.x, p.z) * 0.8f + 0.3f);
    mesh.tangents.assign(4, vec4(1.0f, 0.0f, 0.0f, -1.0f));
    scene::Sampler sampler;
    sampler.mipmap = scene::Mipmap::none;
    scene::Material& m = scene.materials[0];
    m.metallic = 1.0f;
    m.roughness = 0.3f;
    m.normal_scale = 0.5f;
    m.base_color_texture.texture = add_pattern(scene, scene::ColorSpace::srgb, sampler);
    m.normal_texture.texture = add_texture(scene, scene::ColorSpace::linear, sampler, normal_texel);
}

void add_layer_textures(scene::Scene& scene) {
    const scene::Sampler sampler{scene::Wrap::repeat, scene::Wrap::repeat, scene::Filter::linear,
                                 scene::Filter::linear, scene::Mipmap::none};
    const auto add = [&](scene::TextureSlot& slot, auto value) {
        slot.texture = add_texture(scene, scene::ColorSpace::linear, sampler, value);
    };
    const auto waves = [&](int phase) { // all channels between 120 and 255, otherwise in each
        return [phase](int x, int y) -> std::array<int, 4> {
            const auto wave = [&](int a, int b) {
                return static_cast<int>(std::lround(
                    187.5 + 67.0 * std::sin(0.785 * (a * x + b * y) + static_cast<double>(phase))));
            };
            return {wave(1, 0), wave(0, 1), wave(1, 1), wave(1, -1)};
        };
    };
    scene::Material& m = scene.materials[0];
    m.metallic = 0.6f;
    m.roughness = 0.5f;
    add(m.base_color_texture, waves(0));
    add(m.normal_texture, normal_texel);
    add(m.anisotropy_texture, [](int x, int y) -> std::array<int, 4> {
        const double angle = 0.3 * x + 0.2 * y; // its strength is in blue
        return {static_cast<int>(std::lround(127.5 * (1.0 + std::cos(angle)))),
                static_cast<int>(std::lround(127.5 * (1.0 + std::sin(angle)))), 160 + 10 * y, 255};
    });
    add(m.clearcoat_texture, waves(1));
    add(m.clearcoat_roughness_texture, waves(2));
    add(m.clearcoat_normal_texture, [](int x, int y) { return normal_texel(y, x); });
    add(m.sheen_color_texture, waves(3));
    add(m.sheen_roughness_texture, waves(4));
    add(m.iridescence_texture, waves(5));
    add(m.film_thickness_texture, waves(6));
}

} // namespace sr::truth
