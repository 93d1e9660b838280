#include "golden_mutants/picture.hpp"

#include "core/math.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

namespace sr::testing {
namespace {

using image::Image;

struct PointLight {
    const char* name;
    vec3 position;
    vec3 I;      // [cd]
    float reach; // [m] around the foot of the perpendicular on the floor; what is farther is dark
};

constexpr float everywhere = 1e9f;
const std::array lights{PointLight{"key", {1.5f, 2.5f, 1.0f}, {30.0f, 28.0f, 25.0f}, everywhere},
                        PointLight{"fill", {-2.5f, 1.5f, 1.5f}, {3.0f, 5.0f, 8.0f}, everywhere},
                        PointLight{"spot", {0.85f, 1.0f, 0.6f}, {6.0f, 4.0f, 2.0f}, 0.31f}};
constexpr float radius = 0.45f;
constexpr float floor_edge = -1.4f; // the floor ends here, before black

struct Hit {
    vec3 position{0.0f};
    vec3 n{0.0f};
    vec3 rho{0.0f};
};

/// The distance to the sphere along a ray, if it is in front.
std::optional<float> distance_to_sphere(vec3 origin, vec3 w, const PictureOptions& o) {
    if (!o.has_sphere) return std::nullopt;
    const vec3 to = origin - vec3(o.sphere_x, radius, 0.0f);
    const float b = glm::dot(to, w), root = b * b - glm::dot(to, to) + radius * radius;
    if (root < 0.0f || -b - std::sqrt(root) < 1e-3f) return std::nullopt;
    return -b - std::sqrt(root);
}

vec3 floor_reflectance(vec3 p, const PictureOptions& o) {
    const bool is_light =
        (static_cast<int>(std::floor(p.x * 4.0f)) + static_cast<int>(std::floor(p.z * 4.0f))) % 2 == 0;
    const vec3 rho = is_light ? vec3(0.7f, 0.6f, 0.45f) : vec3(0.15f, 0.2f, 0.3f);
    const float wear = 0.85f + 0.15f * std::sin(9.0f * p.x) * std::cos(7.0f * p.z);
    return rho * wear * vec3(o.reflectance_red, 1.0f, 1.0f);
}

std::optional<Hit> hit(vec3 origin, vec3 w, const PictureOptions& o) {
    if (const auto distance = distance_to_sphere(origin, w, o)) {
        const vec3 position = origin + *distance * w;
        return Hit{position, (position - vec3(o.sphere_x, radius, 0.0f)) / radius, {0.6f, 0.25f, 0.2f}};
    }
    const vec3 position = origin - origin.y / w.y * w;
    if (position.z < floor_edge) return std::nullopt;
    return Hit{position, {0.0f, 1.0f, 0.0f}, floor_reflectance(position, o)};
}

vec3 reflected(const Hit& x, const PointLight& light, const PictureOptions& o) {
    const vec3 to = light.position - x.position;
    const float d2 = glm::dot(to, to);
    const vec3 wi = to / std::sqrt(d2);
    const float cosine = glm::dot(x.n, wi);
    if (cosine <= 0.0f || std::hypot(to.x, to.z) > light.reach) return vec3(0.0f);
    const bool casts_shadow = o.key_casts_shadow || light.name != std::string("key");
    if (casts_shadow && distance_to_sphere(x.position + 1e-3f * x.n, wi, o)) return vec3(0.0f);
    return x.rho / (o.divides_by_pi ? pi : 1.0f) * light.I / d2 * (o.has_cosine ? cosine : 1.0f);
}

void put(std::span<float> pixel, std::size_t first, vec3 value) {
    for (int c = 0; c < 3; ++c) pixel[first + static_cast<std::size_t>(c)] += value[c];
}

bool is_lamp(int x, int y, const PictureOptions& o) {
    return x >= o.width * 3 / 4 && x < o.width * 7 / 8 && y >= o.height / 16 && y < o.height / 8;
}

void shade(std::span<float> pixel, vec3 origin, vec3 w, const PictureOptions& o) {
    const auto x = hit(origin, w, o);
    if (!x) return;
    pixel[3] = 1.0f;
    for (std::size_t k = 0; k < lights.size(); ++k) {
        if (std::ranges::find(o.lights, lights[k].name) == o.lights.end()) continue;
        const vec3 L_o = reflected(*x, lights[k], o);
        put(pixel, 0, L_o);
        put(pixel, 4 + 3 * k, L_o);
    }
}

} // namespace

Image picture_of_sphere(const PictureOptions& o) {
    Image picture(o.width, o.height, 4 + 3 * static_cast<int>(lights.size()));
    picture.channel_names = {"R", "G", "B", "A"};
    for (const PointLight& light : lights)
        for (const char* channel : {".R", ".G", ".B"})
            picture.channel_names.push_back(light.name + std::string(channel));
    const vec3 w = glm::normalize(vec3(0.0f, -0.6f, -0.8f));
    const vec3 up(0.0f, 0.8f, -0.6f);
    for (int y = 0; y < o.height; ++y)
        for (int x = 0; x < o.width; ++x) {
            const float u =
                (static_cast<float>(x) + 0.5f + o.offset_x) / static_cast<float>(o.width) * 3.0f - 1.5f;
            const float v = 1.5f - (static_cast<float>(y) + 0.5f) / static_cast<float>(o.height) * 3.0f;
            const vec3 origin = vec3(0.0f, 0.4f, 0.0f) + (vec3(u, 0.0f, 0.0f) + v * up) / o.zoom - 5.0f * w;
            if (!o.is_mostly_black) shade(picture.at(x, y), origin, w, o);
            if (is_lamp(x, y, o)) {
                put(picture.at(x, y), 0, vec3(40.0f, 36.0f, 30.0f));
                picture.at(x, y)[3] = 1.0f;
            }
        }
    return picture;
}

} // namespace sr::testing
