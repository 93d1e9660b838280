#pragma once
// Light from every direction: the same radiance, or that of a picture.
#include "core/math.hpp"
#include "scene/lights/emitter.hpp"

#include <memory>
#include <vector>

namespace sr::scene {

/// An equirectangular picture: rows from +Y down to -Y, columns once around +Y. The middle column shows -Z,
/// and a quarter of the width to its right is +X. Radiance between the middles of texels is bilinear; it goes
/// on around +Y, and is constant beyond the first and the last row's middles.
///
/// It also holds what samples it: a texel is chosen by its light, which is the mean luminance of the bilinear
/// radiance over it times its solid angle, then a direction uniformly over the texel's solid angle. So the
/// density is constant over a texel, known exactly, and positive wherever there is light.
class EnvironmentMap {
public:
    /// `texels`: rows from top to bottom, width * height of them, finite and not negative [cd/m²].
    EnvironmentMap(int width, int height, std::vector<vec3> texels);

    int width() const { return width_; }
    int height() const { return height_; }
    const std::vector<vec3>& texels() const { return texels_; }

    /// Of row j the probability that it or one above it is chosen, height() of them.
    const std::vector<float>& row_cdf() const { return row_cdf_; }
    /// Of texel (i, j) at j * width() + i the probability, once row j is chosen, of it or one to its left.
    const std::vector<float>& texel_cdf() const { return texel_cdf_; }

    /// From the unit direction w, in the map's own axes [cd/m²].
    vec3 radiance(vec3 w) const;
    /// With which sample() chooses the unit direction w [1/sr]; 0 for a map without light.
    double density(vec3 w) const;
    /// The direction that the random numbers u in [0, 1)² choose. Only of a map with light.
    vec3 sample(vec2 u) const;

    bool has_light() const { return !row_cdf_.empty() && row_cdf_.back() > 0.0f; }
    /// Mean radiance over all directions, each texel taken at its middle latitude [cd/m²].
    vec3 mean() const { return mean_; }

    /// Where the unit direction w is in the picture, (0, 0) its upper left corner, (1, 1) its lower right.
    static vec2 place_of(vec3 w);
    static vec3 direction_of(vec2 place);

    /// Of one texel in row j [sr].
    double solid_angle(int j) const;
    /// Where row j begins and ends, as 1 - cos of the angle to the nearer pole: to +Y where 2 j < height(),
    /// else to -Y. Near a pole nothing cancels.
    vec2 pole_heights(int j) const;

private:
    void build_tables();
    vec3 texel(int i, int j) const; // i goes on around, j is kept within

    int width_;
    int height_;
    std::vector<vec3> texels_;
    std::vector<float> row_cdf_;
    std::vector<float> texel_cdf_;
    vec3 mean_{0.0f};
};

/// Light from infinitely far, from every direction: the same radiance in all of them, or that of a map.
struct EnvironmentLight {
    static constexpr std::string_view kind = "environment";

    std::string name;
    vec3 L{1.0f};                                // radiance [cd/m²]; with a map: its factor [1]
    std::shared_ptr<const EnvironmentMap> map{}; // null: the same radiance in every direction
    float rotation = 0.0f;          // of the map around +Y, counter-clockwise seen from above [rad]
    bool is_visible = true;         // false: it lights the scene but cameras do not see it
    bool passes_back_faces = false; // see passes_back_faces() in light.hpp

    /// To the map's own axes, from the world.
    mat3 map_from_world() const;
    /// From the unit direction w, in the world [cd/m²].
    vec3 radiance(vec3 w) const { return map ? L * map->radiance(map_from_world() * w) : L; }
    std::optional<double> quantity_from(Quantity quantity, double value) const;
    void transform(const Motion& by);
    /// A direction, with the density of shaders/light/environment.glsl.
    EmitterPoint sample_point(vec3 u) const;
    /// It has none: what comes from above.
    EmitterPoint middle() const;
};

} // namespace sr::scene
