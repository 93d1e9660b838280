#pragma once
// What a surface is made of, and the images that say so. Plain data, linear unless it says otherwise.
#include "core/math.hpp"

#include <cstdint>
#include <string>
#include <variant>
#include <vector>

namespace sr::scene {

/// A decoded picture: `width * height` RGBA texels, first row on top (glTF: uv (0,0) is its upper left
/// corner). The values are as stored in the file; whether they are sRGB-encoded is the Texture's business.
struct TextureImage {
    std::string name;
    int width = 0;
    int height = 0;
    /// 4 * width * height values, of 8 or (16-bit PNGs) 16 bits.
    std::variant<std::vector<std::uint8_t>, std::vector<std::uint16_t>> texels;
};

enum class Wrap { repeat, mirrored_repeat, clamp_to_edge };

/// The texel of a row of `size` that index `i` stands for, within the row or beyond it.
int wrapped(int i, int size, Wrap wrap);

enum class Filter { nearest, linear };
/// Which mip levels minification reads.
enum class Mipmap { none, nearest, linear };

struct Sampler {
    Wrap wrap_u = Wrap::repeat;
    Wrap wrap_v = Wrap::repeat;
    Filter magnification = Filter::linear;
    Filter minification = Filter::linear;
    Mipmap mipmap = Mipmap::linear;

    bool operator==(const Sampler&) const = default;
};

enum class ColorSpace { linear, srgb };

/// An image as a material reads it.
struct Texture {
    int image = 0; // index into Scene::images
    Sampler sampler;
    ColorSpace color_space = ColorSpace::linear;

    bool operator==(const Texture&) const = default;
};

/// A material's reference to a texture; absent where `texture` is negative.
struct TextureSlot {
    int texture = -1;        // index into Scene::textures
    int texcoord = 0;        // which of the mesh's texture coordinate sets, 0 or 1
    mat3 uv_transform{1.0f}; // KHR_texture_transform: uv' = (uv_transform * (uv, 1)).xy

    bool is_present() const { return texture >= 0; }
};

enum class AlphaMode { opaque, mask, blend };

/// glTF 2.0 metallic-roughness with KHR_materials_ior, _specular, _emissive_strength and _unlit.
/// Each factor multiplies its texture, if there is one.
struct Material {
    std::string name;

    vec4 base_color{1.0f}; // linear, alpha in w
    TextureSlot base_color_texture;
    float metallic = 1.0f;  // texture: blue channel
    float roughness = 1.0f; // texture: green channel; alpha = roughness² is formed in shaders/surface/
    TextureSlot metallic_roughness_texture;
    float normal_scale = 1.0f;
    TextureSlot normal_texture; // tangent space, +Y up

    vec3 emission{0.0f}; // L_e [cd/m²]: emissiveFactor times KHR_materials_emissive_strength
    TextureSlot emission_texture;

    float ior = 1.5f;      // KHR_materials_ior; 0 stands for infinity (F0 = 1), as the extension says
    float specular = 1.0f; // KHR_materials_specular; texture: alpha channel
    TextureSlot specular_texture;
    vec3 specular_color{1.0f};
    TextureSlot specular_color_texture;

    AlphaMode alpha_mode = AlphaMode::opaque;
    float alpha_cutoff = 0.5f;
    bool is_double_sided = false;
    bool is_unlit = false; // KHR_materials_unlit: L_o is the base colour [cd/m²], no light touches it

    bool is_emissive() const { return emission.x > 0.0f || emission.y > 0.0f || emission.z > 0.0f; }
};

} // namespace sr::scene
