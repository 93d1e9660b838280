#include "scene/own_light.hpp"

#include "scene/spectrum.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace sr::scene {
namespace {

constexpr int columns = 64, rows = 36;

/// A light, or a part of one, as a point.
struct Source {
    vec3 position{0.0f};
    vec3 axis{0.0f};            // unit; zero: none
    float I = 0.0f;             // along the axis, as luminous intensity [cd]
    float area = 0.0f;          // [m²]; nearer than this allows nothing gets brighter
    bool is_flat = false;       // I falls with the cosine
    bool is_two_sided = false;  // of a flat one
    float outer_cosine = -2.0f; // of a spot
    bool is_parallel = false;   // I is E [lx], the axis where it goes
    bool is_everywhere = false; // I is E, whatever faces where
};

float luminance_of(vec3 rgb) { return static_cast<float>(luminance(glm::dvec3(rgb))); }

/// The mean of a texture's colours, by some of its texels.
float mean_luminance(const Scene& scene, int texture) {
    if (texture < 0) return 1.0f;
    const Texture& used = scene.textures[static_cast<std::size_t>(texture)];
    const TextureImage& image = scene.images[static_cast<std::size_t>(used.image)];
    return std::visit(
        [](const auto& texels) {
            const std::size_t count = texels.size() / 4;
            const std::size_t step = std::max<std::size_t>(1, count / 1021); // a prime: no column of its own
            const auto max_value =
                static_cast<double>(std::numeric_limits<std::decay_t<decltype(texels[0])>>::max());
            double sum = 0.0;
            std::size_t taken = 0;
            for (std::size_t i = 0; i < count; i += step, ++taken)
                sum += std::pow(luminance({texels[4 * i] / max_value, texels[4 * i + 1] / max_value,
                                           texels[4 * i + 2] / max_value}),
                                2.2);
            return taken > 0 ? static_cast<float>(sum / static_cast<double>(taken)) : 0.0f;
        },
        image.texels);
}

class Sources {
public:
    explicit Sources(const Scene& scene) : scene_(scene) {}

    void operator()(const PointLight& light) {
        const float I = light.profile < 0 ? luminance_of(light.I)
                                          : luminance_of(flux_of(light, scene_.profiles).value_or(vec3(0.0f)))
                                                / (4.0f * pi);
        all.push_back({light.position, vec3(0.0f), I, pi * light.radius * light.radius});
    }
    void operator()(const SpotLight& light) {
        Source source{light.position, light.direction, luminance_of(light.I),
                      pi * light.radius * light.radius};
        source.outer_cosine = std::cos(light.outer_angle);
        all.push_back(source);
    }
    void operator()(const DirectionalLight& light) {
        Source source{vec3(0.0f), light.direction, luminance_of(light.E)};
        source.is_parallel = true;
        all.push_back(source);
    }
    void operator()(const EnvironmentLight& light) {
        Source source;
        source.I = pi * luminance_of(light.map ? light.L * light.map->mean() : light.L);
        source.is_everywhere = true;
        all.push_back(source);
    }
    /// A light of any other kind, whose radiance is the same in all directions.
    template<class Area>
    void operator()(const Area& light) {
        if constexpr (requires { light.normal(); }) {
            float L = luminance_of(light.L);
            if constexpr (requires { light.map; }) L *= mean_luminance(scene_, light.map.texture);
            if constexpr (requires { light.center(); })
                add_flat(light.center(), light.normal(), light.area(), L, light.is_two_sided);
            else
                add_flat(light.center, light.normal(), light.area(), L, light.is_two_sided);
        } else {
            const auto side = static_cast<float>(light.radiator().axis_area.value_or(0.0));
            all.push_back({light.center, vec3(0.0f), side * luminance_of(light.L), side});
        }
    }
    void operator()(const MeshLight& light) {
        if (light.texture >= 0) return; // painted glows: what they send to others is next to nothing
        constexpr std::size_t max_triangles = 64; // triangles that stand for all
        const std::size_t step = light.triangles.size() / max_triangles + 1;
        const float L = static_cast<float>(step) * luminance_of(light.L);
        for (std::size_t i = 0; i < light.triangles.size(); i += step) {
            const auto& c = light.triangles[i].corners;
            const vec3 across = glm::cross(c[1] - c[0], c[2] - c[0]);
            const float doubled = glm::length(across);
            if (doubled > 0.0f)
                add_flat((c[0] + c[1] + c[2]) / 3.0f, across / doubled, 0.5f * doubled, L,
                         light.is_two_sided);
        }
    }

    std::vector<Source> all;

private:
    void add_flat(vec3 center, vec3 normal, float area, float L, bool is_two_sided) {
        all.push_back({center, normal, L * area, area, true, is_two_sided});
    }

    const Scene& scene_;
};

/// On a surface at x that faces along n [lx].
float irradiance(const Source& source, vec3 x, vec3 n) {
    if (source.is_everywhere) return source.I;
    if (source.is_parallel) return source.I * std::max(-glm::dot(n, source.axis), 0.0f);
    const vec3 to_source = source.position - x;
    const float d2 = glm::dot(to_source, to_source);
    if (!(d2 > 0.0f)) return 0.0f;
    const vec3 wi = to_source / std::sqrt(d2);
    float cos_y = source.is_flat ? -glm::dot(source.axis, wi) : 1.0f;
    if (source.is_two_sided) cos_y = std::abs(cos_y);
    if (source.outer_cosine > -glm::dot(source.axis, wi)) return 0.0f;
    return source.I * std::max(cos_y, 0.0f) * std::max(glm::dot(n, wi), 0.0f)
           / std::max(d2, source.area / pi);
}

/// The surface point that is seen at a point of the picture.
struct Seen {
    float distance = std::numeric_limits<float>::infinity(); // along the ray, in its own length
    vec3 x{0.0f};
    vec3 n{0.0f};
    const Material* material = nullptr;
};

/// Rays through the middles of the picture's points.
class View {
public:
    View(const Camera& camera, float aspect_ratio)
        : half_(half_extent(camera, aspect_ratio)),
          world_from_camera_(camera.world_from_camera),
          camera_from_world_(glm::inverse(camera.world_from_camera)),
          is_perspective_(std::holds_alternative<Perspective>(camera.projection)) {}

    struct Ray {
        vec3 origin;
        vec3 direction;
    };
    Ray ray(int column, int row) const {
        const vec2 place = (vec2(column, row) + 0.5f) / vec2(columns, rows);
        const vec2 at = half_ * vec2(2.0f * place.x - 1.0f, 1.0f - 2.0f * place.y);
        if (!is_perspective_)
            return {vec3(world_from_camera_ * vec4(at, 0.0f, 1.0f)), -vec3(world_from_camera_[2])};
        return {vec3(world_from_camera_[3]), mat3(world_from_camera_) * vec3(at, -1.0f)};
    }

    /// In columns and rows; absent behind a perspective camera.
    std::optional<vec2> place(vec3 x) const {
        const vec3 p(camera_from_world_ * vec4(x, 1.0f));
        if (is_perspective_ && !(p.z < 0.0f)) return std::nullopt;
        const vec2 at = (is_perspective_ ? vec2(p) / -p.z : vec2(p)) / half_;
        return vec2((at.x + 1.0f) * 0.5f * columns, (1.0f - at.y) * 0.5f * rows);
    }

private:
    vec2 half_;
    mat4 world_from_camera_;
    mat4 camera_from_world_;
    bool is_perspective_;
};

class Picture {
public:
    explicit Picture(const View& view) : view_(view), points_(columns * rows) {}

    void draw(const std::array<vec3, 3>& corners, const Material& material, bool mirrors) {
        vec2 low(INFINITY), high(-INFINITY);
        for (const vec3 corner : corners) {
            const auto at = view_.place(corner);
            low = at ? glm::min(low, *at) : vec2(0.0f);
            high = at ? glm::max(high, *at) : vec2(columns, rows);
            if (!at) break;
        }
        const int first_column = static_cast<int>(std::clamp(std::floor(low.x), 0.0f, float(columns)));
        const int end_column = static_cast<int>(std::clamp(std::ceil(high.x), 0.0f, float(columns)));
        const int first_row = static_cast<int>(std::clamp(std::floor(low.y), 0.0f, float(rows)));
        const int end_row = static_cast<int>(std::clamp(std::ceil(high.y), 0.0f, float(rows)));
        for (int row = first_row; row < end_row; ++row)
            for (int column = first_column; column < end_column; ++column)
                meet(column, row, corners, material, mirrors);
    }

    const std::vector<Seen>& points() const { return points_; }

private:
    /// Möller & Trumbore 1997.
    void meet(int column, int row, const std::array<vec3, 3>& c, const Material& material, bool mirrors) {
        const View::Ray ray = view_.ray(column, row);
        const vec3 ab = c[1] - c[0], ac = c[2] - c[0];
        const vec3 p = glm::cross(ray.direction, ac);
        const float determinant = glm::dot(ab, p); // positive: the front is seen
        if (determinant == 0.0f || (!material.is_double_sided && (determinant < 0.0f) != mirrors)) return;
        const vec3 from_a = ray.origin - c[0];
        const float u = glm::dot(from_a, p) / determinant;
        const vec3 q = glm::cross(from_a, ab);
        const float v = glm::dot(ray.direction, q) / determinant;
        const float t = glm::dot(ac, q) / determinant;
        Seen& seen = points_[static_cast<std::size_t>(row * columns + column)];
        if (!(u >= 0.0f && v >= 0.0f && u + v <= 1.0f && t > 0.0f && t < seen.distance)) return;
        const vec3 n = glm::normalize(glm::cross(ab, ac));
        seen = {t, ray.origin + t * ray.direction, glm::dot(n, ray.direction) < 0.0f ? n : -n, &material};
    }

    const View& view_;
    std::vector<Seen> points_;
};

void draw(Picture& picture, const Scene& scene) {
    for (const Instance& instance : scene.instances) {
        const Mesh& mesh = scene.meshes[static_cast<std::size_t>(instance.mesh)];
        const Material& material = scene.materials[static_cast<std::size_t>(mesh.material)];
        const bool mirrors = glm::determinant(mat3(instance.world_from_object)) < 0.0f;
        for (std::size_t t = 0; t + 2 < mesh.indices.size(); t += 3) {
            std::array<vec3, 3> corners;
            for (std::size_t i = 0; i < 3; ++i)
                corners[i] =
                    vec3(instance.world_from_object * vec4(mesh.positions[mesh.indices[t + i]], 1.0f));
            picture.draw(corners, material, mirrors);
        }
    }
}

} // namespace

std::optional<float> lit_share(const Scene& scene, std::span<const Light> lights, const Camera& camera,
                               float aspect_ratio) {
    const View view(camera, aspect_ratio);
    Picture picture(view);
    draw(picture, scene);
    Sources sources(scene);
    for (const Light& light : lights) std::visit(sources, light);
    // A town of lamps is known by some of them.
    const std::size_t step = sources.all.size() / 4096 + 1;
    std::vector<float> lit, bright;
    for (const Seen& seen : picture.points()) {
        if (!seen.material) continue;
        if (seen.material->is_unlit) {
            bright.push_back(luminance_of(vec3(seen.material->base_color)));
            continue;
        }
        float E = 0.0f;
        for (std::size_t i = 0; i < sources.all.size(); i += step)
            E += static_cast<float>(step) * irradiance(sources.all[i], seen.x, seen.n);
        lit.push_back(E / pi);
        const float L_e = seen.material->is_emissive()
                              ? luminance_of(seen.material->emission)
                                    * mean_luminance(scene, seen.material->emission_texture.texture)
                              : 0.0f;
        bright.push_back(E / pi + L_e);
    }
    if (lit.empty()) return std::nullopt;
    const auto at = static_cast<std::ptrdiff_t>(0.95 * static_cast<double>(bright.size()));
    std::nth_element(bright.begin(), bright.begin() + at, bright.end());
    const float threshold =
        std::max(bright[static_cast<std::size_t>(at)] / 200.0f, std::numeric_limits<float>::min());
    return static_cast<float>(std::ranges::count_if(lit, [&](float L) { return L >= threshold; }))
           / static_cast<float>(lit.size());
}

} // namespace sr::scene
