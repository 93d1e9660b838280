#include "render/adaptive/open_pixels.hpp"

#include "support/address.hpp"

#include <algorithm>
#include <array>
#include <glm/gtc/quaternion.hpp>
#include <random>

using namespace sr;
using namespace sr::testing;
using render::Faces, render::OpenPixels, render::PixelMask, render::PixelRect;

namespace {

constexpr int width = 31, height = 19;

/// Freezes all pixels but these few.
PixelMask frozen_but(int open, std::mt19937& random) {
    PixelMask frozen(std::size_t{width} * height, 255);
    for (int i = 0; i < open; ++i) frozen[random() % frozen.size()] = 0;
    return frozen;
}

bool is_open(const PixelMask& frozen, int column, int row) {
    return frozen[static_cast<std::size_t>(row * width + column)] == 0;
}

const Test counts("unit.render.open_pixels.a_rectangle_has_what_its_pixels_have", [] {
    std::mt19937 random(1);
    for (int round = 0; round < 200; ++round) {
        const PixelMask frozen = frozen_but(round % 7, random);
        const OpenPixels open(frozen, width, height);
        const auto place = [&](int size) {
            return static_cast<int>(random() % static_cast<unsigned>(size + 6)) - 3;
        };
        const PixelRect part{place(width), place(height), place(width), place(height)};
        bool expected = false;
        for (int row = 0; row < height; ++row)
            for (int column = 0; column < width; ++column)
                expected = expected
                           || (is_open(frozen, column, row) && column >= part.column && row >= part.row
                               && column < part.column + part.width && row < part.row + part.height);
        EXPECT_EQ(open.any_in(part), expected) << "round " << round;
    }
});

/// Triangles of all sizes before a camera at the origin, of which some reach behind it.
struct Soup {
    std::vector<vec3> positions; // far from the object's origin
    std::vector<vec3> corners;   // in the world, as a driver may place them
    std::vector<std::uint32_t> indices;
    mat4 world_from_object{1.0f};
    mat4 clip_from_world{1.0f};

    Soup(float far, std::mt19937& random) {
        std::uniform_real_distribution<float> unit(-1.0f, 1.0f);
        clip_from_world[2][3] = -1.0f; // w = -z
        clip_from_world[3][3] = 0.0f;
        const mat3 turned = glm::mat3_cast(glm::quat(glm::normalize(glm::quat(0.8f, 0.3f, 0.4f, 0.3f))));
        world_from_object = mat4(turned);
        world_from_object[3] = vec4(-far * (turned * vec3(1.0f)), 1.0f);
        for (int i = 0; i < 300; ++i) {
            const float size = std::exp2(-static_cast<float>(i % 8));
            const vec3 center(1.5f * unit(random), 1.5f * unit(random), i % 10 == 0 ? -0.1f : -1.5f);
            for (int corner = 0; corner < 3; ++corner) {
                const vec3 place = center + size * vec3(unit(random), unit(random), unit(random));
                indices.push_back(static_cast<std::uint32_t>(positions.size()));
                positions.push_back(vec3(far) + glm::transpose(turned) * place);
                corners.push_back(placed(positions.back()));
            }
        }
    }

    /// Adds up the products from first to last.
    vec3 placed(vec3 position) const {
        const mat4& m = world_from_object;
        vec3 sum = vec3(m[0]) * position.x;
        sum += vec3(m[1]) * position.y;
        sum += vec3(m[2]) * position.z;
        return sum + vec3(m[3]);
    }

    /// Returns whether the ray through this place of the picture hits triangle `i` before the camera [pixels,
    /// rows from top to bottom], from its front.
    bool is_seen(std::size_t i, vec2 place, Faces faces) const {
        const vec3 direction(2.0f * place.x / width - 1.0f, 1.0f - 2.0f * place.y / height, -1.0f);
        const vec3 a = corners[3 * i], b = corners[3 * i + 1], c = corners[3 * i + 2];
        const vec3 n = glm::cross(b - a, c - a);
        const float cosine = glm::dot(n, direction), t = glm::dot(n, a) / cosine;
        if (!(t > 0.0f)) return false;
        if (faces == Faces::counterclockwise && cosine > 0.0f) return false;
        if (faces == Faces::clockwise && cosine < 0.0f) return false;
        const vec3 at = t * direction;
        return glm::dot(glm::cross(b - a, at - a), n) >= 0.0f
               && glm::dot(glm::cross(c - b, at - b), n) >= 0.0f
               && glm::dot(glm::cross(a - c, at - c), n) >= 0.0f;
    }
};

// From the closed form: rays through 64 places of every open pixel.
const Test keeps("unit.render.open_pixels.a_triangle_that_an_open_pixel_sees_is_kept", [] {
    std::mt19937 random(2);
    for (const float far : {0.0f, 1e6f}) // there a corner's place is rounded to a pixel
        for (const Faces faces : {Faces::counterclockwise, Faces::clockwise, Faces::all}) {
            const Soup soup(far, random);
            const PixelMask frozen = frozen_but(24, random);
            const std::vector<std::uint32_t> kept =
                OpenPixels(frozen, width, height)
                    .triangles_before(soup.positions, soup.indices, soup.world_from_object,
                                      soup.clip_from_world, faces);
            EXPECT_TRUE(std::ranges::is_sorted(kept));
            if (far == 0.0f) {
                EXPECT_LT(kept.size(), 200u) << "of 300: some are left out";
            }
            int seen = 0;
            for (std::size_t i = 0; i < soup.indices.size() / 3; ++i) {
                bool is_seen = false;
                for (int row = 0; row < height; ++row)
                    for (int column = 0; column < width; ++column)
                        for (int k = 0; k < 64 && is_open(frozen, column, row) && !is_seen; ++k)
                            is_seen =
                                soup.is_seen(i, vec2(column + (k % 8) / 7.0, row + (k / 8) / 7.0), faces);
                seen += is_seen;
                if (is_seen) {
                    EXPECT_TRUE(std::ranges::binary_search(kept, static_cast<std::uint32_t>(i)))
                        << "triangle " << i;
                }
            }
            EXPECT_GT(seen, 10);
        }
});

/// Returns the triangles that are kept of one that lies counterclockwise in the upper left quarter, and of
/// the same one turned.
std::vector<std::uint32_t> kept_of_two(const PixelMask& frozen, Faces faces) {
    const std::array positions{vec3(-0.9f, 0.1f, 0.5f), vec3(-0.1f, 0.1f, 0.5f), vec3(-0.5f, 0.9f, 0.5f)};
    const std::array<std::uint32_t, 6> indices{0, 1, 2, 0, 2, 1};
    return OpenPixels(frozen, width, height)
        .triangles_before(positions, indices, mat4(1.0f), mat4(1.0f), faces);
}

const Test faces("unit.render.open_pixels.backs_are_left_out", [] {
    const PixelMask open(std::size_t{width} * height, 0);
    using Triangles = std::vector<std::uint32_t>;
    EXPECT_EQ(kept_of_two(open, Faces::counterclockwise), Triangles{0});
    EXPECT_EQ(kept_of_two(open, Faces::clockwise), Triangles{1});
    EXPECT_EQ(kept_of_two(open, Faces::all), (Triangles{0, 1}));
});

const Test others("unit.render.open_pixels.triangles_elsewhere_are_left_out", [] {
    PixelMask frozen(std::size_t{width} * height, 255);
    EXPECT_TRUE(kept_of_two(frozen, Faces::all).empty()) << "nothing is open";
    frozen[std::size_t{width} * (height - 1) + 3] = 0; // below it
    EXPECT_TRUE(kept_of_two(frozen, Faces::all).empty());
    frozen[std::size_t{width} * 3 + 8] = 0; // in its middle
    EXPECT_EQ(kept_of_two(frozen, Faces::all).size(), 2u);
});

} // namespace
