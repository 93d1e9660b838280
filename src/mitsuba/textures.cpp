#include "mitsuba/textures.hpp"

#include "image/display.hpp"
#include "image/file.hpp"
#include "mitsuba/new_folder.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <fmt/format.h>
#include <limits>

namespace sr::mitsuba {
namespace {

template<class Texel>
void fill(image::Image& picture, const std::vector<Texel>& texels, bool is_srgb, Part part, vec3 factor) {
    constexpr auto scale = static_cast<float>(std::numeric_limits<Texel>::max());
    for (std::size_t i = 0; i < texels.size() / 4; ++i) {
        for (std::size_t c = 0; c < 3; ++c) {
            // Alpha is linear in every image.
            const float stored = static_cast<float>(texels[4 * i + (part == Part::alpha ? 3 : c)]) / scale;
            const bool is_encoded = is_srgb && part == Part::color;
            picture.pixels[3 * i + c] =
                factor[static_cast<int>(c)] * (is_encoded ? image::linear_of_srgb(stored) : stored);
        }
    }
}

std::string_view wrap_mode(scene::Wrap wrap) {
    switch (wrap) {
    case scene::Wrap::repeat: return "repeat";
    case scene::Wrap::mirrored_repeat: return "mirror";
    case scene::Wrap::clamp_to_edge: return "clamp";
    }
    return "repeat";
}

} // namespace

std::string Textures::file_of(int index, Part part, vec3 factor) {
    const scene::Texture& texture = scene_.textures[static_cast<std::size_t>(index)];
    const scene::TextureImage& source = scene_.images[static_cast<std::size_t>(texture.image)];
    const bool is_srgb = texture.color_space == scene::ColorSpace::srgb;
    const std::string content = fmt::format("{} {} {} {} {} {}", texture.image, is_srgb,
                                            static_cast<int>(part), factor.x, factor.y, factor.z);
    const auto [entry, is_new] = files_.try_emplace(content, fmt::format("textures/{}.exr", files_.size()));
    if (is_new) {
        image::Image picture(source.width, source.height, 3);
        std::visit([&](const auto& texels) { fill(picture, texels, is_srgb, part, factor); }, source.texels);
        make_folder(folder_ / "textures");
        image::write(picture, folder_ / entry->second, image::SampleType::floating);
    }
    return entry->second;
}

std::string Textures::file_of(const scene::EnvironmentMap& map, vec3 factor) {
    // Mitsuba's first row is at the pole itself and its left edge shows -Z. Rows half as far apart as ours
    // begin at the pole and still hold all of our rows' middles, between which radiance is linear.
    const int width = map.width(), height = 2 * map.height() + 1;
    image::Image picture(width, height, 3);
    for (int j = 0; j < height; ++j) {
        const int above = std::clamp((j - 1) / 2, 0, map.height() - 1);
        const int below = std::clamp(j / 2, 0, map.height() - 1);
        for (int i = 0; i < width; ++i) {
            const auto at = [&](int row) {
                return map.texels()[static_cast<std::size_t>(row) * static_cast<std::size_t>(width)
                                    + static_cast<std::size_t>(i)];
            };
            const vec3 L = factor * 0.5f * (at(above) + at(below));
            std::ranges::copy(std::array{L.r, L.g, L.b}, picture.at(i, j).begin());
        }
    }
    const std::string name = fmt::format("textures/environment_{}.exr", files_.size());
    files_.emplace(name, name);
    make_folder(folder_ / "textures");
    image::write(picture, folder_ / name, image::SampleType::floating);
    return name;
}

void Textures::write(Xml& xml, std::string_view name, int index, const mat3& uv_transform, Part part,
                     vec3 factor) {
    const scene::Texture& texture = scene_.textures[static_cast<std::size_t>(index)];
    const scene::Sampler& sampler = texture.sampler;
    if (sampler.wrap_u != sampler.wrap_v) {
        const std::string warning =
            fmt::format("texture {} wraps otherwise in u than in v: exported as it wraps in u", index);
        if (std::ranges::find(warnings_, warning) == warnings_.end()) warnings_.push_back(warning);
    }
    xml.open("texture", "bitmap", name);
    xml.text("filename", file_of(index, part, factor));
    xml.flag("raw", true);
    xml.text("wrap_mode", wrap_mode(sampler.wrap_u));
    xml.text("filter_type", sampler.magnification == scene::Filter::nearest ? "nearest" : "bilinear");
    if (uv_transform != mat3(1.0f)) {
        mat4 matrix(uv_transform); // Mitsuba takes the translation from the fourth column
        matrix[3] = vec4(vec2(uv_transform[2]), 0.0f, 1.0f);
        matrix[2] = vec4(0.0f, 0.0f, 1.0f, 0.0f);
        xml.transform("to_uv", matrix);
    }
    xml.close();
}

} // namespace sr::mitsuba
