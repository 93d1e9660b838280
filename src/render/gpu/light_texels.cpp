#include "render/gpu/light_texels.hpp"

#include "core/error.hpp"
#include "image/display.hpp"
#include "render/sampling.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <glm/gtc/packing.hpp>
#include <limits>
#include <utility>
#include <variant>

namespace sr::render {
namespace {

/// The light of every value that a texel can store, as a half float.
template<class Texel>
std::vector<std::uint16_t> halves_of_values(bool is_srgb) {
    constexpr std::size_t max_value = std::numeric_limits<Texel>::max();
    std::vector<std::uint16_t> halves(max_value + 1);
    for (std::size_t i = 0; i <= max_value; ++i) {
        const float stored = static_cast<float>(i) / static_cast<float>(max_value);
        halves[i] = glm::packHalf1x16(is_srgb ? image::linear_of_srgb(stored) : stored);
    }
    return halves;
}

template<class Texel>
const std::vector<std::uint16_t>& halves_of(bool is_srgb) {
    static const std::array tables{halves_of_values<Texel>(false), halves_of_values<Texel>(true)};
    return tables[is_srgb ? 1 : 0];
}

const scene::TextureImage& image_of(const scene::Scene& scene, const scene::Texture& texture) {
    return scene.images[static_cast<std::size_t>(texture.image)];
}

/// Calls work(values, halves) with an image's values and the light of each as a half float.
auto with_halves(const scene::Scene& scene, const scene::Texture& texture, const auto& work) {
    return std::visit(
        [&]<class Texel>(const std::vector<Texel>& values) {
            return work(values, halves_of<Texel>(texture.color_space == scene::ColorSpace::srgb));
        },
        image_of(scene, texture).texels);
}

/// The part of a cell that is within its image.
struct Cell {
    std::size_t first = 0;      // texel of the image
    std::size_t row_texels = 0; // of the image
    std::size_t columns = 0;
    std::size_t rows = 0;
};

std::vector<Cell> cells_of(const scene::TextureImage& image) {
    constexpr std::size_t side = EmissionMaps::side;
    const auto width = static_cast<std::size_t>(image.width);
    const auto height = static_cast<std::size_t>(image.height);
    std::vector<Cell> cells;
    for (std::size_t y = 0; y < height; y += side)
        for (std::size_t x = 0; x < width; x += side)
            cells.push_back({y * width + x, width, std::min(side, width - x), std::min(side, height - y)});
    return cells;
}

bool has_light(const auto& values, const Cell& cell) {
    for (std::size_t y = 0; y < cell.rows; ++y) {
        const auto* texel = &values[4 * (cell.first + y * cell.row_texels)];
        unsigned sum = 0;
        for (std::size_t x = 0; x < cell.columns; ++x, texel += 4)
            sum |= static_cast<unsigned>(texel[0] | texel[1] | texel[2]);
        if (sum != 0) return true;
    }
    return false;
}

/// Half as many as a cdf's guide has slots. Keep in sync with shaders/light/cdf.glsl.
std::size_t guide_texels(std::size_t entries) {
    return std::max(std::bit_floor(entries) / 8, std::size_t{1});
}

/// The guide of an ascending cdf (Chen & Asau 1974): for each share g / slots the first entry above it. A
/// texel has the two slots that begin at its x and y, and in z where they end.
std::vector<vec4> guide_of(std::span<const float> cdf) {
    std::vector<vec4> guide(guide_texels(cdf.size()));
    const float slots = 2.0f * static_cast<float>(guide.size());
    std::size_t entry = 0;
    const auto first_above = [&](std::size_t slot) {
        while (entry + 1 < cdf.size() && !(cdf[entry] > static_cast<float>(slot) / slots)) ++entry;
        return static_cast<float>(entry);
    };
    for (std::size_t i = 0; i < guide.size(); ++i) {
        const float x = first_above(2 * i);
        const float y = first_above(2 * i + 1);
        guide[i] = vec4(x, y, first_above(2 * i + 2), 0.0f);
    }
    return guide;
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

const EmissionMapPlace& EmissionMaps::add(const scene::Scene& scene, int index) {
    if (const auto known = places_.find(index); known != places_.end()) return known->second;
    const scene::Texture& texture = scene.textures[static_cast<std::size_t>(index)];
    const scene::TextureImage& image = image_of(scene, texture);
    EmissionMapPlace place{image.width,
                           image.height,
                           static_cast<int>(texture.sampler.wrap_u)
                               + 4 * static_cast<int>(texture.sampler.wrap_v),
                           {}};
    std::visit(
        [&](const auto& values) {
            for (const Cell& cell : cells_of(image))
                place.blocks.push_back(has_light(values, cell) ? static_cast<int>(block_count_++) : 0);
        },
        image.texels);
    textures_.push_back(index);
    return places_.emplace(index, std::move(place)).first->second;
}

void EmissionMaps::write_texels(const scene::Scene& scene, std::span<std::uint64_t> texels) const {
    constexpr std::uint64_t opaque = std::uint64_t{0x3c00} << 48; // an alpha of 1
    std::ranges::fill(texels, opaque); // black: block 0, and what of a cell is beyond its image
    for (const int index : textures_) {
        const scene::Texture& texture = scene.textures[static_cast<std::size_t>(index)];
        const std::vector<Cell> cells = cells_of(image_of(scene, texture));
        with_halves(scene, texture, [&](const auto& values, const std::vector<std::uint16_t>& halves) {
            const auto half = [&](std::size_t i) { return std::uint64_t{halves[values[i]]}; };
            for (std::size_t c = 0; c < cells.size(); ++c) {
                const auto block = static_cast<std::size_t>(places_.at(index).blocks[c]);
                if (block == 0) continue;
                for (std::size_t y = 0; y < cells[c].rows; ++y)
                    for (std::size_t x = 0; x < cells[c].columns; ++x) {
                        const std::size_t i = 4 * (cells[c].first + y * cells[c].row_texels + x);
                        texels[block_texels * block + side * y + x] =
                            half(i) | half(i + 1) << 16 | half(i + 2) << 32 | opaque;
                    }
            }
        });
    }
}

vec3 EmissionMaps::mean(const scene::Scene& scene, int index, const std::array<vec2, 3>& uv) {
    if (next_mean_ == means_.size()) means_.emplace_back();
    Mean& known = means_[next_mean_++];
    if (known.texture != index || known.uv != uv)
        known = {index, uv, is_dark(scene, index, uv) ? vec3(0.0f) : measure_mean(scene, index, uv)};
    return known.color;
}

bool EmissionMaps::is_dark(const scene::Scene& scene, int index, const std::array<vec2, 3>& uv) const {
    // Beyond so many texels, rounding may exceed the one texel that the box has around it.
    constexpr float farthest = 1e5f;
    // To look at more cells takes as long as to measure.
    constexpr int max_cells = 64;
    const auto place = places_.find(index);
    if (place == places_.end()) return false;
    const auto& [width, height, wrap, blocks] = place->second;
    vec2 low(farthest), high(-farthest);
    for (const vec2& corner : uv) {
        const vec2 at = scene::texel_place(corner, width, height) + 0.5f;
        if (!(std::abs(at.x) < farthest && std::abs(at.y) < farthest)) return false;
        low = glm::min(low, at - 1.0f);
        high = glm::max(high, at + 1.0f);
    }
    const glm::ivec2 first(glm::floor(low)), last(glm::floor(high));
    const scene::Sampler& sampler = scene.textures[static_cast<std::size_t>(index)].sampler;
    const auto in_image = [&](glm::ivec2 texel) {
        return glm::ivec2(scene::wrapped(texel.x, width, sampler.wrap_u),
                          scene::wrapped(texel.y, height, sampler.wrap_v));
    };
    const glm::ivec2 begin = in_image(first) / side, end = in_image(last) / side;
    if (in_image(last) - in_image(first) != last - first) return false; // it goes over an edge
    if ((end.x - begin.x + 1) * (end.y - begin.y + 1) > max_cells) return false;
    const int cells_of_row = (width + side - 1) / side;
    for (int y = begin.y; y <= end.y; ++y)
        for (int x = begin.x; x <= end.x; ++x)
            if (blocks[static_cast<std::size_t>(y) * cells_of_row + x] != 0) return false;
    return true;
}

vec3 EmissionMaps::measure_mean(const scene::Scene& scene, int index, const std::array<vec2, 3>& uv) {
    const scene::Texture& texture = scene.textures[static_cast<std::size_t>(index)];
    const scene::TextureImage& image = image_of(scene, texture);
    static const std::array points = points_of_triangle();
    return with_halves(scene, texture, [&](const auto& values, const std::vector<std::uint16_t>& halves) {
        vec3 sum(0.0f);
        for (const vec2 b : points) {
            const vec2 at = scene::texel_place(uv[0] + b.x * (uv[1] - uv[0]) + b.y * (uv[2] - uv[0]),
                                               image.width, image.height)
                            + 0.5f;
            const int x =
                scene::wrapped(static_cast<int>(std::floor(at.x)), image.width, texture.sampler.wrap_u);
            const int y =
                scene::wrapped(static_cast<int>(std::floor(at.y)), image.height, texture.sampler.wrap_v);
            const std::size_t first = std::size_t{4} * (static_cast<std::size_t>(y) * image.width + x);
            for (std::size_t c = 0; c < 3; ++c)
                sum[static_cast<int>(c)] += glm::unpackHalf1x16(halves[values[first + c]]);
        }
        return sum / static_cast<float>(points.size());
    });
}

std::size_t EnvironmentTexels::add(const std::shared_ptr<const scene::EnvironmentMap>& map) {
    const auto known = std::ranges::find(places_, map, &Place::map);
    if (known != places_.end()) return known->first;
    const std::size_t first = texel_count_;
    if (first > std::size_t{1} << 24)
        throw Error("two environments are too large together", "use a smaller one");
    const auto height = static_cast<std::size_t>(map->height());
    const auto width = static_cast<std::size_t>(map->width());
    texel_count_ += height + map->texels().size() + guide_texels(height) + height * guide_texels(width);
    places_.push_back({map, first});
    return first;
}

void EnvironmentTexels::write_texels(std::span<vec4> texels) const {
    auto next = texels.begin();
    for (const Place& place : places_) {
        const scene::EnvironmentMap& map = *place.map;
        float above = 0.0f;
        for (int j = 0; j < map.height(); ++j) {
            const float cdf = map.row_cdf()[static_cast<std::size_t>(j)];
            const double density = (static_cast<double>(cdf) - above) / map.solid_angle(j);
            *next++ = vec4(density, map.pole_heights(j), cdf);
            above = cdf;
        }
        for (std::size_t i = 0; i < map.texels().size(); ++i)
            *next++ = vec4(map.texels()[i], map.texel_cdf()[i]);
        const std::span<const float> texel_cdf(map.texel_cdf());
        const auto width = static_cast<std::size_t>(map.width());
        next = std::ranges::copy(guide_of(map.row_cdf()), next).out;
        for (std::size_t i = 0; i < texel_cdf.size(); i += width)
            next = std::ranges::copy(guide_of(texel_cdf.subspan(i, width)), next).out;
    }
}

} // namespace sr::render
