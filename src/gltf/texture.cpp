#include "gltf/texture.hpp"

#include "gltf/extensions.hpp"
#include "image/webp.hpp"

#include <algorithm>
#include <fmt/format.h>

namespace sr::gltf {
namespace {

// glTF 2.0 specification, section 5.26: OpenGL's numbers.
scene::Wrap wrap_of(int code) {
    if (code == TINYGLTF_TEXTURE_WRAP_CLAMP_TO_EDGE) return scene::Wrap::clamp_to_edge;
    if (code == TINYGLTF_TEXTURE_WRAP_MIRRORED_REPEAT) return scene::Wrap::mirrored_repeat;
    return scene::Wrap::repeat;
}

scene::Sampler sampler_of(const tinygltf::Sampler& from) {
    scene::Sampler to;
    to.wrap_u = wrap_of(from.wrapS);
    to.wrap_v = wrap_of(from.wrapT);
    if (from.magFilter == TINYGLTF_TEXTURE_FILTER_NEAREST) to.magnification = scene::Filter::nearest;
    switch (from.minFilter) { // absent (-1): ours to choose, so the best
    case TINYGLTF_TEXTURE_FILTER_NEAREST:
    case TINYGLTF_TEXTURE_FILTER_NEAREST_MIPMAP_NEAREST:
    case TINYGLTF_TEXTURE_FILTER_NEAREST_MIPMAP_LINEAR: to.minification = scene::Filter::nearest; break;
    default: break;
    }
    switch (from.minFilter) {
    case TINYGLTF_TEXTURE_FILTER_NEAREST:
    case TINYGLTF_TEXTURE_FILTER_LINEAR: to.mipmap = scene::Mipmap::none; break;
    case TINYGLTF_TEXTURE_FILTER_NEAREST_MIPMAP_NEAREST:
    case TINYGLTF_TEXTURE_FILTER_LINEAR_MIPMAP_NEAREST: to.mipmap = scene::Mipmap::nearest; break;
    default: break;
    }
    return to;
}

/// EXT_texture_webp names a WebP beside the PNG or JPEG, which those read that cannot decode it.
int source_of(const tinygltf::Texture& from) {
    const tinygltf::Value* webp = extension(from.extensions, "EXT_texture_webp");
    return webp && image::decodes_webp() ? whole_in(*webp, "source", from.source) : from.source;
}

} // namespace

TextureTable::TextureTable(const Document& document, Warnings& warnings)
    : document_(document), warnings_(warnings) {}

int TextureTable::texture(int gltf_texture, scene::ColorSpace color_space) {
    const tinygltf::Texture& from = document_.model.textures[static_cast<std::size_t>(gltf_texture)];
    const std::string pointer = fmt::format("/textures/{}", gltf_texture);
    if (document_.is_lost(pointer)) return -1;
    const int source = source_of(from);
    const int count = static_cast<int>(document_.images.size());
    if (source < 0 || source >= count) {
        const bool is_ktx = source < 0
                            && (extension(from.extensions, "KHR_texture_basisu")
                                || extension(from.extensions, "GOOGLE_texture_basis"));
        warnings_.add(source < 0 ? pointer + " has no image in a supported format"
                                 : fmt::format("{} has image {}, and there are {}", pointer, source, count),
                      is_ktx ? fmt::format("the material is shown without it; {}", convert_ktx)
                             : "the material is shown without it");
        return -1;
    }
    const auto [image, is_new] = image_of_source_.try_emplace(source, static_cast<int>(sources_.size()));
    if (is_new) sources_.push_back(source);

    scene::Texture texture;
    texture.image = image->second;
    if (from.sampler >= 0)
        texture.sampler = sampler_of(document_.model.samplers[static_cast<std::size_t>(from.sampler)]);
    texture.color_space = color_space;
    const auto found = std::find(textures_.begin(), textures_.end(), texture);
    if (found != textures_.end()) return static_cast<int>(found - textures_.begin());
    textures_.push_back(texture);
    return static_cast<int>(textures_.size()) - 1;
}

} // namespace sr::gltf
