#include "render/gpu/light_texels.hpp"

#include "core/error.hpp"
#include "image/display.hpp"
#include "render/sampling.hpp"

#include <algorithm>
#include <cmath>
#include <glm/gtc/packing.hpp>
#include <limits>

namespace sr::render {
namespace {

/// The linear value of every value that a texel can store.
template<class Texel>
std::vector<float> linear_values(bool is_srgb) {
    constexpr std::size_t max_value = std::numeric_limits<Texel>::max();
    std::vector<float> values(max_value + 1);
    for (std::size_t i = 0; i <= max_value; ++i) {
        const float stored = static_cast<float>(i) / static_cast<float>(max_value);
        values[i] = is_srgb ? image::linear_of_srgb(stored) : stored;
    }
    return values;
}

template<class Texel>
void append(const std::vector<Texel>& values, bool is_srgb, std::vector<std::uint64_t>& texels) {
    const std::vector<float> linear = linear_values<Texel>(is_srgb);
    texels.reserve(texels.size() + values.size() / 4);
    for (std::size_t i = 0; i < values.size(); i += 4)
        texels.push_back(
            glm::packHalf4x16({linear[values[i]], linear[values[i + 1]], linear[values[i + 2]], 1.0f}));
}

/// Evenly spread weights of a triangle's second and third corner.
std::array<vec2, 64> points_of_triangle() {
    std::array<vec2, 64> points;
    for (std::uint32_t i = 0; i < points.size(); ++i) {
        const vec2 u = sobol_2d(i, 0);
        points[i] = u.x + u.y < 1.0f ? u : 1.0f - u;
    }
    return points;
}

} // namespace

EmissionMapPlace EmissionMaps::add(const scene::Scene& scene, int index) {
    if (const auto known = places_.find(index); known != places_.end()) return known->second;
    const scene::Texture& texture = scene.textures[static_cast<std::size_t>(index)];
    const scene::TextureImage& image = scene.images[static_cast<std::size_t>(texture.image)];
    const EmissionMapPlace place{static_cast<int>(texels_.size()), image.width, image.height,
                                 static_cast<int>(texture.sampler.wrap_u)
                                     + 4 * static_cast<int>(texture.sampler.wrap_v)};
    std::visit(
        [&](const auto& texels) { append(texels, texture.color_space == scene::ColorSpace::srgb, texels_); },
        image.texels);
    return places_.emplace(index, place).first->second;
}

vec3 EmissionMaps::mean(const scene::Scene& scene, int index, const std::array<vec2, 3>& uv) {
    if (next_mean_ == means_.size()) means_.emplace_back();
    Mean& known = means_[next_mean_++];
    if (known.texture != index || known.uv != uv) known = {index, uv, measure_mean(scene, index, uv)};
    return known.color;
}

vec3 EmissionMaps::measure_mean(const scene::Scene& scene, int index, const std::array<vec2, 3>& uv) {
    const EmissionMapPlace place = add(scene, index);
    const scene::Sampler& sampler = scene.textures[static_cast<std::size_t>(index)].sampler;
    static const std::array points = points_of_triangle();
    vec3 sum(0.0f);
    for (const vec2 b : points) {
        const vec2 at = scene::texel_place(uv[0] + b.x * (uv[1] - uv[0]) + b.y * (uv[2] - uv[0]), place.width,
                                           place.height)
                        + 0.5f;
        const int x = scene::wrapped(static_cast<int>(std::floor(at.x)), place.width, sampler.wrap_u);
        const int y = scene::wrapped(static_cast<int>(std::floor(at.y)), place.height, sampler.wrap_v);
        sum +=
            vec3(glm::unpackHalf4x16(texels_[static_cast<std::size_t>(place.first + y * place.width + x)]));
    }
    return sum / static_cast<float>(points.size());
}

std::size_t EnvironmentTexels::add(const std::shared_ptr<const scene::EnvironmentMap>& map) {
    const auto known = std::ranges::find(places_, map, &Place::map);
    if (known != places_.end()) return known->first;
    const std::size_t first = texels_.size();
    if (first > std::size_t{1} << 24)
        throw Error("two environments are too large together", "use a smaller one");
    float above = 0.0f;
    for (int j = 0; j < map->height(); ++j) {
        const float cdf = map->row_cdf()[static_cast<std::size_t>(j)];
        const double density = (static_cast<double>(cdf) - above) / map->solid_angle(j);
        texels_.emplace_back(density, map->pole_heights(j), cdf);
        above = cdf;
    }
    for (std::size_t i = 0; i < map->texels().size(); ++i)
        texels_.emplace_back(map->texels()[i], map->texel_cdf()[i]);
    places_.push_back({map, first});
    return first;
}

} // namespace sr::render
