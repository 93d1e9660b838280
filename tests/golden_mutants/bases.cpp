#include "golden_mutants/bases.hpp"

#include "core/math.hpp"
#include "golden_mutants/change.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace sr::testing {
namespace {

using image::Image;

struct Light {
    vec3 direction;
    vec3 color;
};

const std::array base_lights{Light{glm::normalize(vec3(0.5f, 0.7f, 0.5f)), vec3(1.0f, 0.95f, 0.85f)},
                             Light{glm::normalize(vec3(-0.7f, 0.4f, 0.6f)), vec3(0.15f, 0.2f, 0.3f)}};

/// Radiance by each light, alpha and depth at a place of the render; x and y in units of the height.
struct Seen {
    std::array<vec3, 2> light{};
    float alpha = 1.0f;
    float depth = 0.0f;
};

Seen ball(vec2 offset, float radius, float pixel, const RenderBase& o) {
    const vec2 p = offset / radius;
    const vec3 n(p.x, -p.y, std::sqrt(std::max(0.0f, 1.0f - glm::dot(p, p))));
    const vec2 q = p - vec2(o.gloss_offset * pixel / radius, 0.0f);
    const vec3 glossy(q.x, -q.y, std::sqrt(std::max(0.0f, 1.0f - glm::dot(q, q))));
    Seen seen;
    for (std::size_t k = 0; k < 2; ++k) {
        const vec3 h = glm::normalize(base_lights[k].direction + vec3(0.0f, 0.0f, 1.0f));
        const float a2 = o.roughness * o.roughness * o.roughness * o.roughness;
        const float nh = std::max(glm::dot(glossy, h), 0.0f), d = nh * nh * (a2 - 1.0f) + 1.0f;
        const float gloss = o.has_gloss ? 0.02f * a2 / (pi * d * d) : 0.0f;
        const float cosine = std::max(glm::dot(n, base_lights[k].direction), 0.0f);
        seen.light[k] = base_lights[k].color * cosine * (vec3(0.5f, 0.12f, 0.1f) + gloss);
    }
    seen.depth = 4.0f - radius * n.z;
    return seen;
}

Seen ground(vec2 p, vec2 ball_at, float radius, float pixel, const RenderBase& o) {
    Seen seen;
    const float z = 0.35f / (p.y - 0.3f), x = (p.x - 0.6f) * z;
    const int column = static_cast<int>(std::floor(x * 3.0f)), row = static_cast<int>(std::floor(z * 3.0f));
    const float wear = 0.9f + 0.1f * std::sin(11.0f * x) * std::cos(7.0f * z);
    const vec3 rho = (column + row) % 2 == 0 ? vec3(0.6f, 0.55f, 0.5f) : vec3(0.12f, 0.14f, 0.2f);
    const float tile = column == 1 && row == 3 ? o.tile : 1.0f;
    const vec2 from_shadow = (p - ball_at - radius * vec2(-0.5f, 0.95f) - vec2(o.shadow_offset * pixel, 0.0f))
                             / (radius * vec2(1.2f, 0.3f));
    const bool is_dark = o.has_shadow && glm::dot(from_shadow, from_shadow) < 1.0f;
    for (std::size_t k = 0; k < 2; ++k)
        seen.light[k] =
            is_dark && k == 0
                ? o.shadow_leak * base_lights[k].color * rho * wear * tile * base_lights[k].direction.y
                : base_lights[k].color * rho * wear * tile * base_lights[k].direction.y;
    seen.depth = z;
    return seen;
}

Seen seen_at(vec2 p, float pixel, const RenderBase& o) {
    const vec2 ball_at(0.55f + o.ball_offset * pixel, 0.55f);
    const float radius = 0.2f * o.ball_radius;
    if (p.x > 0.75f && p.x < 0.9f && p.y > 0.08f && p.y < 0.16f)
        return {{o.lamp * vec3(1.0f, 0.9f, 0.75f), vec3(0.0f)}, 1.0f, 2.0f};
    if (glm::length(p - ball_at) < radius) return ball(p - ball_at, radius, pixel, o);
    if (p.y > 0.45f) return ground(p, ball_at, radius, pixel, o);
    return {{vec3(0.0f), vec3(0.05f, 0.06f, 0.08f) * (0.5f + p.y)}, 0.0f, 0.0f};
}

void put_small_things(Image& image, const RenderBase& o) {
    const auto set = [&image](int x, int y, vec3 L, float depth) {
        if (x < 0 || y < 0 || x >= image.width || y >= image.height) return;
        const auto pixel = image.at(x, y);
        std::ranges::copy(std::array{L.x, L.y, L.z, 1.0f, L.x, L.y, L.z, 0.0f, 0.0f, 0.0f, depth},
                          pixel.begin());
    };
    if (o.has_wire)
        for (int y = 0; y < image.height * 2 / 5 - o.wire_end; ++y)
            set(image.width / 8 + y / 9 + o.wire_offset, y, o.wire * vec3(1.0f, 0.6f, 0.4f), 3.0f);
    if (o.has_object)
        for (const auto& [x, y] : {std::pair{0, 0}, {1, 0}, {2, 0}, {0, 1}, {1, 1}, {2, 1}, {1, 2}})
            set(image.width * 3 / 8 + x, image.height / 5 + y, vec3(0.2f, 0.9f, 0.4f), 3.0f);
}

} // namespace

Image layered_render_base(Extent size, const RenderBase& o) {
    Image image(size.width, size.height, 11);
    image.channel_names = {"R",     "G",      "B",      "A",      "key.R",  "key.G",
                           "key.B", "fill.R", "fill.G", "fill.B", "depth.Z"};
    const float pixel = 1.0f / static_cast<float>(size.height);
    const float weight = 1.0f / static_cast<float>(o.supersampling * o.supersampling);
    for (int y = 0; y < size.height; ++y)
        for (int x = 0; x < size.width; ++x) {
            const auto to = image.at(x, y);
            for (int s = 0; s < o.supersampling * o.supersampling; ++s) {
                const vec2 sub(
                    (static_cast<float>(s % o.supersampling) + 0.5f) / static_cast<float>(o.supersampling),
                    (static_cast<float>(s / o.supersampling) + 0.5f) / static_cast<float>(o.supersampling));
                const Seen seen = seen_at((vec2(x, y) + sub) * pixel, pixel, o);
                for (std::size_t c = 0; c < 3; ++c) {
                    const auto i = static_cast<int>(c);
                    to[c] += weight * (seen.light[0][i] + seen.light[1][i]);
                    to[4 + c] += weight * seen.light[0][i];
                    to[7 + c] += weight * seen.light[1][i];
                }
                to[3] += weight * seen.alpha;
                to[10] += weight * seen.depth;
            }
        }
    put_small_things(image, o);
    return image;
}

Image render_base(Extent size, const RenderBase& o) {
    const Image layered = layered_render_base(size, o);
    Image image(size.width, size.height, 4);
    image.channel_names = {"R", "G", "B", "A"};
    for (int y = 0; y < size.height; ++y)
        for (int x = 0; x < size.width; ++x)
            std::ranges::copy(layered.at(x, y).first(4), image.at(x, y).begin());
    return image;
}

void round_to_codes(Image& image) {
    for (float& value : image.pixels) value = std::round(255.0f * std::clamp(value, 0.0f, 1.0f)) / 255.0f;
}

Image photo_base(Extent size) {
    Image image(size.width, size.height, 3);
    image.channel_names = {"R", "G", "B"};
    std::ranges::fill(image.pixels, 0.4f);
    Random random(7);
    const float edge = static_cast<float>(std::min(size.width, size.height));
    for (int disc = 0; disc < 900; ++disc) {
        // The density of radii falls with their cube, between 1 and 25 % of the frame.
        const float radius = edge * 0.01f / std::sqrt(1.0f - 0.9984f * random.uniform());
        const vec2 at(random.uniform() * static_cast<float>(size.width),
                      random.uniform() * static_cast<float>(size.height));
        const float tone = 0.08f + 0.75f * random.uniform();
        const vec3 color =
            tone * (vec3(1.0f) + 0.25f * (vec3(random.uniform(), random.uniform(), random.uniform()) - 0.5f));
        const float slope = 0.3f * (random.uniform() - 0.5f);
        for (int y = std::max(0, static_cast<int>(at.y - radius));
             y < std::min(size.height, static_cast<int>(at.y + radius) + 1); ++y)
            for (int x = std::max(0, static_cast<int>(at.x - radius));
                 x < std::min(size.width, static_cast<int>(at.x + radius) + 1); ++x) {
                const float cover = std::clamp(radius - glm::length(vec2(x, y) - at) + 0.5f, 0.0f, 1.0f);
                const float shade = 1.0f + slope * (static_cast<float>(x) - at.x) / radius;
                for (std::size_t c = 0; c < 3; ++c) {
                    float& value = image.at(x, y)[c];
                    value += cover * (color[static_cast<int>(c)] * shade - value);
                }
            }
    }
    for (float& value : image.pixels) value += 0.008f * random.normal();
    round_to_codes(image);
    return image;
}

} // namespace sr::testing
