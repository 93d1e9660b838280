#include "render/emission_maps.hpp"

#include "render/sampling.hpp"

#include <algorithm>
#include <cmath>
#include <glm/gtc/packing.hpp>

namespace sr::render {
namespace {

float linear_of_srgb(float s) { // IEC 61966-2-1
    return s <= 0.04045f ? s / 12.92f : std::pow((s + 0.055f) / 1.055f, 2.4f);
}

template<class Texel>
void append(const std::vector<Texel>& values, bool is_srgb, std::vector<std::uint64_t>& texels) {
    constexpr auto scale = static_cast<float>(std::numeric_limits<Texel>::max());
    const auto linear = [&](Texel value) {
        const float stored = static_cast<float>(value) / scale;
        return is_srgb ? linear_of_srgb(stored) : stored;
    };
    for (std::size_t i = 0; i < values.size(); i += 4)
        texels.push_back(
            glm::packHalf4x16({linear(values[i]), linear(values[i + 1]), linear(values[i + 2]), 1.0f}));
}

int wrapped(int i, int size, scene::Wrap wrap) {
    if (wrap == scene::Wrap::clamp_to_edge) return std::clamp(i, 0, size - 1);
    const int period = wrap == scene::Wrap::repeat ? size : 2 * size;
    const int m = ((i % period) + period) % period;
    return m < size ? m : 2 * size - 1 - m;
}

} // namespace

EmissionMapPlace EmissionMaps::place_of(int index) {
    if (const auto known = places_.find(index); known != places_.end()) return known->second;
    const scene::Texture& texture = scene_.textures[static_cast<std::size_t>(index)];
    const scene::TextureImage& image = scene_.images[static_cast<std::size_t>(texture.image)];
    const EmissionMapPlace place{static_cast<int>(texels_.size()), image.width, image.height,
                                 static_cast<int>(texture.sampler.wrap_u)
                                     + 4 * static_cast<int>(texture.sampler.wrap_v)};
    std::visit(
        [&](const auto& texels) { append(texels, texture.color_space == scene::ColorSpace::srgb, texels_); },
        image.texels);
    return places_.emplace(index, place).first->second;
}

vec3 EmissionMaps::mean(int index, const std::array<vec2, 3>& uv) {
    const EmissionMapPlace place = place_of(index);
    const scene::Sampler& sampler = scene_.textures[static_cast<std::size_t>(index)].sampler;
    vec3 sum(0.0f);
    constexpr std::uint32_t points = 64;
    for (std::uint32_t i = 0; i < points; ++i) {
        const vec2 u = sobol_2d(i, 0);
        const vec2 b = u.x + u.y < 1.0f ? u : 1.0f - u;
        const vec2 at = uv[0] + b.x * (uv[1] - uv[0]) + b.y * (uv[2] - uv[0]);
        const int x = wrapped(static_cast<int>(std::floor(at.x * static_cast<float>(place.width))),
                              place.width, sampler.wrap_u);
        const int y = wrapped(static_cast<int>(std::floor(at.y * static_cast<float>(place.height))),
                              place.height, sampler.wrap_v);
        sum +=
            vec3(glm::unpackHalf4x16(texels_[static_cast<std::size_t>(place.first + y * place.width + x)]));
    }
    return sum / static_cast<float>(points);
}

} // namespace sr::render
