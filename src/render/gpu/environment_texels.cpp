#include "render/gpu/environment_texels.hpp"

#include "core/error.hpp"

#include <algorithm>

namespace sr::render {

std::size_t EnvironmentTexels::place_of(const std::shared_ptr<const scene::EnvironmentMap>& map) {
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
