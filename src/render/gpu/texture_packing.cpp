#include "render/gpu/texture_packing.hpp"

#include <cstdint>
#include <variant>

namespace sr::render {
namespace {

using scene::Material;
using scene::TextureSlot;

constexpr int roughness_channel = 1, metallic_channel = 2; // glTF 2.0, section 3.9.2

const scene::TextureImage& image_of(const scene::Scene& scene, const TextureSlot& slot) {
    const auto texture = static_cast<std::size_t>(slot.texture);
    return scene.images[static_cast<std::size_t>(scene.textures[texture].image)];
}

bool has_8_bits(const scene::TextureImage& image) {
    return std::holds_alternative<std::vector<std::uint8_t>>(image.texels);
}

/// Returns whether both slots read the same places of images of one size in the same way.
bool are_read_alike(const scene::Scene& scene, const TextureSlot& a, const TextureSlot& b) {
    const scene::TextureImage &of_a = image_of(scene, a), &of_b = image_of(scene, b);
    return scene.textures[static_cast<std::size_t>(a.texture)].sampler
               == scene.textures[static_cast<std::size_t>(b.texture)].sampler
           && a.texcoord == b.texcoord && a.uv_transform == b.uv_transform && of_a.width == of_b.width
           && of_a.height == of_b.height && has_8_bits(of_a) && has_8_bits(of_b);
}

/// Returns whether the material itself lets its metalness and roughness be packed.
bool can_be_packed(const scene::Scene& scene, const Material& m) {
    const TextureSlot &base = m.base_color_texture, &normal = m.normal_texture,
                      &packed = m.metallic_roughness_texture;
    return base.is_present() && normal.is_present() && packed.is_present() && base.texture != normal.texture
           && m.alpha_mode == scene::AlphaMode::opaque && !m.is_transmissive() && !m.is_specular_glossiness
           && scene.textures[static_cast<std::size_t>(normal.texture)].color_space
                  == scene::ColorSpace::linear
           && are_read_alike(scene, base, packed) && are_read_alike(scene, normal, packed);
}

/// The alpha that the material gives its texture of this slot.
PackedAlpha alpha_of(const scene::Scene& scene, const Material& m, TextureSlot Material::*slot) {
    const int image = scene.textures[static_cast<std::size_t>(m.metallic_roughness_texture.texture)].image;
    if (slot == &Material::normal_texture) return {image, metallic_channel};
    if (slot == &Material::base_color_texture) return {image, roughness_channel};
    return {};
}

/// Calls visit(material, member, texture) for each texture of each material.
void for_each_use(const scene::Scene& scene, const auto& visit) {
    for (std::size_t i = 0; i < scene.materials.size(); ++i)
        for (const scene::TextureInput& input : scene::texture_inputs)
            if (const TextureSlot& slot = scene.materials[i].*input.member; slot.is_present())
                visit(i, input.member, static_cast<std::size_t>(slot.texture));
}

/// Fills in where textures have their alphas from. Materials that disagree about one are no longer packed.
/// @return whether there were any
bool find_alphas(const scene::Scene& scene, TexturePacking& packing) {
    packing.alpha_from.assign(scene.textures.size(), {});
    std::vector<bool> is_known(scene.textures.size(), false), is_disputed = is_known;
    for_each_use(scene, [&](std::size_t i, TextureSlot Material::*slot, std::size_t texture) {
        const PackedAlpha alpha =
            packing.is_packed[i] ? alpha_of(scene, scene.materials[i], slot) : PackedAlpha{};
        if (is_known[texture] && packing.alpha_from[texture] != alpha) is_disputed[texture] = true;
        is_known[texture] = true;
        packing.alpha_from[texture] = alpha;
    });
    bool disagree = false;
    for_each_use(scene, [&](std::size_t i, TextureSlot Material::*, std::size_t texture) {
        if (!packing.is_packed[i] || !is_disputed[texture]) return;
        packing.is_packed[i] = false;
        disagree = true;
    });
    return disagree;
}

} // namespace

TexturePacking pack_textures(const scene::Scene& scene, bool is_wanted) {
    TexturePacking packing;
    for (const Material& material : scene.materials)
        packing.is_packed.push_back(is_wanted && can_be_packed(scene, material));
    while (find_alphas(scene, packing)) { // who shared a texture with those that disagreed, may now disagree
    }
    std::vector<bool> is_replaced(scene.textures.size(), false), is_read = is_replaced;
    for_each_use(scene, [&](std::size_t i, TextureSlot Material::*slot, std::size_t texture) {
        const bool is_elsewhere = packing.is_packed[i] && slot == &Material::metallic_roughness_texture;
        (is_elsewhere ? is_replaced : is_read)[texture] = true;
    });
    for (std::size_t i = 0; i < scene.textures.size(); ++i)
        packing.is_needed.push_back(is_read[i] || !is_replaced[i]);
    return packing;
}

} // namespace sr::render
