// Textures of emitters, as the light table reads them again and again.
#include "render/gpu/light_texels.hpp"
#include "support/address.hpp"
#include "support/random.hpp"

#include <glm/gtc/packing.hpp>
#include <span>

using namespace sr;
using sr::testing::Test;

namespace {

using Uv = std::array<vec2, 3>;

/// Two textures of 8×8 texels: red grows to the right, green upwards.
scene::Scene two_textures() {
    scene::Scene scene;
    for (int t = 0; t < 2; ++t) {
        std::vector<std::uint8_t> texels;
        for (int y = 0; y < 8; ++y)
            for (int x = 0; x < 8; ++x)
                for (const int value : {32 * x, 32 * y, 255 * t, 255})
                    texels.push_back(static_cast<std::uint8_t>(value));
        scene::TextureImage& image = scene.images.emplace_back();
        image.width = image.height = 8;
        image.texels = std::move(texels);
        scene.textures.emplace_back().image = t;
    }
    return scene;
}

const Test remembered("unit.render.emission_maps.what_is_remembered_is_what_is_measured", [] {
    const scene::Scene scene = two_textures();
    const std::array<Uv, 3> places{Uv{vec2(0, 0), vec2(0.4, 0), vec2(0, 0.4)},
                                   Uv{vec2(0.5, 0.5), vec2(1, 0.5), vec2(0.5, 1)},
                                   Uv{vec2(0.9, 0.1), vec2(0.9, 0.2), vec2(1, 0.1)}};
    render::EmissionMaps maps;
    // The same questions again, other ones, fewer, more: always as if nobody had asked before.
    for (const std::vector<std::pair<int, std::size_t>>& questions :
         {std::vector<std::pair<int, std::size_t>>{{0, 0}, {1, 1}},
          {{0, 0}, {1, 1}},
          {{1, 0}, {0, 1}},
          {{0, 2}},
          {{0, 2}, {0, 1}, {1, 2}}}) {
        maps.rewind();
        for (const auto& [texture, place] : questions)
            EXPECT_EQ(maps.mean(scene, texture, places[place]),
                      render::EmissionMaps().mean(scene, texture, places[place]));
    }
    EXPECT_NE(render::EmissionMaps().mean(scene, 0, places[0]),
              render::EmissionMaps().mean(scene, 0, places[1]));
    EXPECT_NE(render::EmissionMaps().mean(scene, 0, places[0]),
              render::EmissionMaps().mean(scene, 1, places[0]));
});

/// The texel that shaders find (shaders/light/emission_map.glsl).
vec4 texel_of(const render::EmissionMapPlace& place, std::span<const std::uint64_t> texels, int x, int y) {
    constexpr int side = render::EmissionMaps::side;
    const int cells = (place.width + side - 1) / side;
    const int block = place.blocks.at(static_cast<std::size_t>(cells * (y / side) + x / side));
    return glm::unpackHalf4x16(
        texels[static_cast<std::size_t>(side * side * block + side * (y % side) + x % side)]);
}

const Test texels_once("unit.render.emission_maps.each_texture_is_there_once", [] {
    const scene::Scene scene = two_textures();
    render::EmissionMaps maps;
    EXPECT_EQ(maps.texel_count(), 0u);
    for (const int texture : {0, 1, 0})
        EXPECT_EQ(maps.add(scene, texture).blocks, std::vector<int>{1 + texture});
    ASSERT_EQ(maps.texel_count(), 3 * render::EmissionMaps::block_texels);
    std::vector<std::uint64_t> texels(maps.texel_count());
    maps.write_texels(scene, texels);
    for (int t = 0; t < 2; ++t) {
        const vec4 last = texel_of(maps.add(scene, t), texels, 7, 7);
        const vec4 expected(224.0f / 255.0f, 224.0f / 255.0f, static_cast<float>(t), 1.0f);
        for (int c = 0; c < 4; ++c) EXPECT_NEAR(last[c], expected[c], 1.0f / 2048.0f) << t << " " << c;
    }
});

// A glow in a dark texture takes the blocks that it touches, and every texel is found again.
const Test dark_cells("unit.render.emission_maps.dark_cells_share_a_block", [] {
    constexpr int width = 150, height = 70; // neither a multiple of a cell's side
    scene::Scene scene;
    std::vector<std::uint8_t> texels(4 * width * height, 0);
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) texels[static_cast<std::size_t>(4 * (y * width + x) + 3)] = 255;
    const auto code = [&](int x, int y) -> std::uint8_t& {
        return texels[static_cast<std::size_t>(4 * (y * width + x) + 1)];
    };
    for (int y = 30; y < height; ++y)
        for (int x = 140; x < width; ++x) code(x, y) = static_cast<std::uint8_t>(x + y);
    code(0, 0) = 1; // the faintest light
    scene.images.push_back({"glow", width, height, texels});
    scene.textures.emplace_back();
    render::EmissionMaps maps;
    const render::EmissionMapPlace& place = maps.add(scene, 0);
    EXPECT_EQ(place.blocks, (std::vector<int>{1, 0, 0, 0, 2, 0, 0, 0, 0, 3, 0, 0, 0, 0, 4}));
    std::vector<std::uint64_t> stored(maps.texel_count());
    maps.write_texels(scene, stored);
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) {
            const vec4 texel = texel_of(place, stored, x, y);
            const float green = static_cast<float>(code(x, y)) / 255.0f;
            EXPECT_NEAR(texel.g, green, green / 2048.0f) << x << " " << y;
            EXPECT_EQ(vec2(texel.r, texel.b), vec2(0.0f)) << x << " " << y;
        }
});

// Triangles in the dark are known by their cells, and have the mean that their points have: wherever they
// lie, and however the texture goes on beyond its edges.
const Test dark_triangles("unit.render.emission_maps.a_triangle_in_the_dark_has_the_mean_of_its_points", [] {
    constexpr int width = 150, height = 70;
    std::vector<std::uint8_t> texels(4 * width * height, 0);
    for (const auto& [left, top] :
         {std::pair{0, 0}, {146, 40}, {62, 31}, {100, 66}}) // over edges of cells, too
        for (int y = top; y < top + 4; ++y)
            for (int x = left; x < left + 4; ++x) texels[static_cast<std::size_t>(4 * (y * width + x))] = 255;
    sr::testing::Random random(5);
    for (const auto wrap : {scene::Wrap::repeat, scene::Wrap::mirrored_repeat, scene::Wrap::clamp_to_edge}) {
        scene::Scene scene;
        scene.images.push_back({"points", width, height, texels});
        scene.textures.emplace_back().sampler = {.wrap_u = wrap, .wrap_v = wrap};
        render::EmissionMaps maps;
        maps.add(scene, 0);
        int lit = 0;
        for (int i = 0; i < 20'000; ++i) {
            const vec2 at(random.within(-3.0, 4.0), random.within(-3.0, 4.0));
            const double reach = random.scale_within(0.001, 0.2);
            Uv uv;
            for (vec2& corner : uv) corner = at + vec2(random.in_cube(reach));
            const vec3 measured = render::EmissionMaps().mean(scene, 0, uv);
            EXPECT_EQ(maps.mean(scene, 0, uv), measured) << i;
            lit += measured.r > 0.0f;
        }
        EXPECT_GT(lit, 100);
        EXPECT_LT(lit, 10'000);
    }
});

} // namespace
