#include "core/error.hpp"
#include "support/address.hpp"
#include "support/gl.hpp"
#include "support/scenes.hpp"

#include <algorithm>
#include <cmath>

using namespace sr;
using namespace sr::testing;
using render::Visibility;

namespace {

constexpr std::array providers{Visibility::ray_on_cpu, Visibility::ray_in_glsl, Visibility::map};

const std::vector<scene::Light> zoo{
    scene::PointLight{"", {-1.0f, 1.0f, 0.0f}, vec3(3.0f, 1.0f, 0.5f)},
    scene::SpotLight{"", {1.0f, 2.0f, 0.5f}, {0.0f, -1.0f, 0.0f}, vec3(0.2f, 5.0f, 1.0f)},
    scene::DirectionalLight{"", glm::normalize(vec3(1.0f, -0.02f, 0.3f)), vec3(0.7f)},
    scene::RectangleLight{"", {0.0f, 1.5f, 0.0f}, {0.3f, 0, 0}, {0, 0, 0.3f}, vec3(10.0f)},
};

mat3 turned(vec3 half) {
    return mat3_cast(glm::quat(glm::normalize(glm::quat(0.8f, 0.3f, 0.4f, 0.33f))))
           * mat3(half.x, 0, 0, 0, half.y, 0, 0, 0, half.z);
}

// A plane sees all that is above it, at any angle: no ray meets the surface that it leaves. (Each way to find
// V is another program, in which a rectangle's points may come out 1e-5 of its extent elsewhere.)
const Test empty("law.shadow.nothing_in_the_way_is_no_shadow", [] {
    for (const float half_edge : {3.0f, 3000.0f}) {
        auto plane = lambert_plane(half_edge);
        plane.materials[0].specular = 1.0f;
        plane.materials[0].roughness = 0.5f;
        const auto camera = camera_from_above(2.0f);
        const auto bare = picture(plane, zoo, camera, 64, 2, 0, Visibility::none);
        for (const Visibility visibility : providers)
            EXPECT_LT(max_relative_difference(picture(plane, zoo, camera, 64, 2, 0, visibility), bare, 1e-3f),
                      2e-4f);
    }
});

// So does every face of a convex body, far from the origin, too, where coordinates are coarse.
const Test convex("law.shadow.a_convex_body_does_not_shadow_itself", [] {
    const vec3 far(0.0f, 0.0f, 0.0f);
    for (const vec3 offset : {far, vec3(700.0f, 40.0f, -300.0f)}) {
        scene::Scene scene;
        add_box(scene, offset, turned(vec3(0.8f, 0.5f, 0.9f)), 3, lambert());
        auto camera = camera_from_above(1.5f);
        camera.world_from_camera[3] += vec4(offset, 0.0f);
        const std::vector<scene::Light> lights{
            scene::PointLight{"", offset + vec3(1.0f, 3.0f, 0.5f), vec3(3.0f)},
            scene::DirectionalLight{"", glm::normalize(vec3(1.0f, -0.3f, 0.2f)), vec3(1.0f)}};
        const auto bare = picture(scene, lights, camera, 96, 1, 0, Visibility::none);
        for (const Visibility visibility : providers) {
            const auto shadowed = picture(scene, lights, camera, 96, 1, 0, visibility);
            EXPECT_LT(max_relative_difference(shadowed, bare, 1e-2f), 1e-5f) << offset.x;
        }
    }
});

const Test closed("law.shadow.a_closed_box_leaks_nothing", [] {
    for (const float scale : {0.01f, 1.0f}) {
        auto scene = lambert_plane(4.0f);
        add_box(scene, {0.0f, 1.0f, 0.0f}, turned(vec3(0.4f, 0.3f, 0.5f) * scale), 7, lambert());
        const std::vector<scene::Light> lights{
            scene::PointLight{"", {0.0f, 1.0f, 0.0f}, vec3(1e4f)},
            scene::RectangleLight{
                "", {0.0f, 1.0f, 0.0f}, {0.1f * scale, 0, 0}, {0, 0, 0.1f * scale}, vec3(1e6f)}};
        for (const Visibility visibility : providers) {
            const auto image = picture(scene, lights, camera_from_above(2.0f), 128, 2, 0, visibility);
            float largest = 0.0f;
            for (std::size_t i = 0; i < image.pixels.size(); i += 4)
                largest = std::max(largest, image.pixels[i]);
            EXPECT_EQ(largest, 0.0f);
        }
    }
});

/// A plane, and above it at height h a sheet that covers x > edge, which the camera does not see: its back is
/// culled.
scene::Scene under_an_edge(float edge, float h) {
    auto scene = lambert_plane(4.0f);
    add_quad(scene, {edge + 3.0f, h, 0.0f}, {3.0f, 0, 0}, {0, 0, 3.0f}, lambert());
    return scene;
}

const Test umbra("law.shadow.a_point_lights_umbra_ends_where_geometry_says", [] {
    constexpr int size = 200;
    constexpr float extent = 1.0f, pixel = 2.0f * extent / size;
    const std::vector<scene::Light> lights{scene::PointLight{"", {-0.1f, 2.0f, 0.0f}, vec3(1.0f)}};
    constexpr float shadow = 0.1f + (0.1f + 0.1f) * 0.5f / (2.0f - 0.5f); // by similar triangles
    for (const Visibility visibility : providers) {
        const auto image =
            picture(under_an_edge(0.1f, 0.5f), lights, camera_from_above(extent), size, 1, 0, visibility);
        for (int y = 0; y < size; ++y) {
            for (int x = 0; x < size; ++x) {
                const float at = place_of(x, y, size, extent).x;
                if (std::abs(at - shadow) < pixel) continue;
                ASSERT_EQ(image.at(x, y)[0] > 0.0f, at < shadow) << x << ", " << y;
            }
        }
    }
});

// Along x, V falls from 1 to 0 like the distribution of a uniform variable, whose variance is width²/12.
const Test penumbra("law.shadow.a_penumbra_is_as_wide_as_similar_triangles_say", [] {
    constexpr int size = 128;
    constexpr float extent = 0.06f;
    const std::vector<scene::Light> lights{
        scene::RectangleLight{"", {0.0f, 2.0f, 0.0f}, {0.05f, 0, 0}, {0, 0, 0.05f}, vec3(1.0f)}};
    const auto camera = camera_from_above(extent);
    const auto bare = picture(lambert_plane(4.0f), lights, camera, size, 8, 0, Visibility::none);
    for (const Visibility visibility : providers) {
        const int samples = visibility == Visibility::map ? 64 : 8; // which all pixels share
        const auto image = picture(under_an_edge(0.0f, 0.8f), lights, camera, size, samples, 0, visibility);
        double last = 1.0, mean = 0.0, square = 0.0;
        for (int x = 0; x < size; ++x) {
            double lit = 0.0, all = 0.0;
            for (int y = 0; y < size; ++y) {
                lit += image.at(x, y)[0];
                all += bare.at(x, y)[0];
            }
            const double V = lit / all, at = (x + 0.0) / size * 2.0 * extent - extent;
            mean += (last - V) * at;
            square += (last - V) * at * at;
            last = V;
        }
        EXPECT_EQ(last, 0.0) << "the umbra is in the picture";
        const double width = std::sqrt(12.0 * (square - mean * mean));
        EXPECT_NEAR(width / (0.1 * 0.8 / 1.2), 1.0, 0.02);
    }
});

// Light stays linear with shadows, over more rays than one pass of the recorder takes.
const Test superposition("law.shadow.superposition", [] {
    context();
    auto scene = lambert_plane(4.0f);
    scene.materials[0].specular = 1.0f;
    scene.materials[0].roughness = 0.3f;
    add_box(scene, {0.0f, 0.5f, 0.0f}, turned(vec3(0.3f)), 1, lambert());
    std::vector<scene::Light> lights = zoo;
    for (int i = 0; i < 3; ++i)
        lights.push_back(scene::RectangleLight{
            "", {1.0f, 1.5f, static_cast<float>(i) - 1.0f}, {0.1f, 0, 0}, {0, 0, 0.1f}, vec3(20.0f)});
    for (const Visibility visibility : providers) {
        const render::GpuScene gpu_scene(scene, lights, visibility);
        const auto shone = [&](int first, int end) {
            render::RenderOptions options;
            options.width = options.height = 64;
            options.samples = 1;
            render::Renderer renderer(gpu_scene, camera_from_above(2.0f), options);
            renderer.use_lights(first, end);
            renderer.add_sample();
            return renderer.read_film();
        };
        const auto together = shone(0, static_cast<int>(lights.size()));
        image::Image sum(64, 64, 4);
        for (int k = 0; k < static_cast<int>(lights.size()); ++k) {
            const auto alone = shone(k, k + 1);
            for (std::size_t i = 0; i < sum.pixels.size(); ++i) sum.pixels[i] += alone.pixels[i];
        }
        EXPECT_LT(max_relative_difference(together, sum, 1e-3f), 1e-5f);
    }
});

// A picture whose rays do not fit into memory at once is shaded in bands of rows, to the same bits.
const Test bands("law.shadow.bands_of_rows_make_the_same_picture", [] {
    context();
    auto scene = lambert_plane(4.0f);
    add_box(scene, {0.0f, 0.5f, 0.0f}, turned(vec3(0.3f)), 1, lambert());
    const render::GpuScene gpu_scene(scene, zoo, Visibility::ray_on_cpu);
    const auto shaded = [&](std::size_t max_rays) {
        render::RenderOptions options;
        options.width = options.height = 64;
        options.samples = 2;
        options.max_rays = max_rays;
        render::Renderer renderer(gpu_scene, camera_from_above(2.0f), options);
        for (int i = 0; i < 2; ++i) renderer.add_sample();
        return renderer.read_film();
    };
    const auto rays_to_a_row =
        static_cast<std::size_t>(64 * gpu_scene.most_rays(static_cast<int>(zoo.size())));
    EXPECT_EQ(shaded(7 * rays_to_a_row).pixels, shaded(64 * rays_to_a_row).pixels);
    EXPECT_THROW(shaded(rays_to_a_row - 1), Error);
});

// Within a window and under some of the lights, pixels are what they are in the whole picture.
const Test window("law.shadow.a_window_shows_what_the_picture_shows", [] {
    context();
    auto scene = lambert_plane(4.0f);
    add_box(scene, {0.0f, 0.5f, 0.0f}, turned(vec3(0.3f)), 1, lambert());
    const render::GpuScene gpu_scene(scene, zoo, Visibility::ray_on_cpu);
    render::RenderOptions options;
    options.width = options.height = 64;
    options.samples = 2;
    render::Renderer whole(gpu_scene, camera_from_above(2.0f), options);
    options.window = render::PixelRect{20, 30, 16, 8};
    render::Renderer part(gpu_scene, camera_from_above(2.0f), options);
    for (const int first : {0, 2}) {
        for (render::Renderer* renderer : {&whole, &part}) {
            renderer->clear();
            renderer->use_lights(first, first + 2);
            renderer->add_sample();
        }
        const auto a = whole.read_film(), b = part.read_film();
        for (int y = 30; y < 38; ++y)
            for (int x = 20; x < 36; ++x) ASSERT_EQ(a.at(x, y)[0], b.at(x, y)[0]) << x << ", " << y;
    }
});

/// One light of each kind that has an extent, over whatever lies around the origin.
std::vector<scene::Light> emitters() {
    const vec3 L(10.0f);
    scene::MeshLight roof{"", {}, L};
    const vec3 ridge[2]{{-0.2f, 1.6f, 0.0f}, {0.2f, 1.6f, 0.0f}};
    for (const float side : {-1.0f, 1.0f}) {
        const vec3 eave(0.1f * side, 1.4f, 0.3f * side);
        roof.triangles.push_back({{ridge[0], ridge[1], eave}, {}});
        if (side < 0.0f) std::swap(roof.triangles.back().corners[0], roof.triangles.back().corners[1]);
    }
    return {scene::RectangleLight{"", {0.0f, 1.5f, 0.0f}, {0.2f, 0, 0}, {0, 0, 0.3f}, L},
            scene::DiskLight{"", {0.1f, 1.5f, 0.0f}, {0.3f, 0, 0}, {0, 0, 0.15f}, L},
            scene::SphereLight{"", {0.1f, 1.5f, 0.1f}, 0.25f, L},
            scene::TubeLight{"", {0.0f, 1.5f, 0.0f}, {0.3f, 0.1f, 0.0f}, 0.1f, L},
            scene::PolygonLight{"", {{-0.2f, 1.5f, -0.2f}, {0.3f, 1.5f, -0.1f}, {0.0f, 1.5f, 0.3f}}, L},
            roof,
            scene::DirectionalLight{"", glm::normalize(vec3(0.3f, -1.0f, 0.1f)), vec3(3.0f), 0.1f},
            scene::SpotLight{"", {0.0f, 1.5f, 0.0f}, {0, -1, 0}, vec3(5.0f), INFINITY, 0.2f, 0.9f, 0.15f}};
}

// Depth maps come out at what rays come out at: in the umbra, in the penumbra and where the horizon of a
// surface cuts the emitter, diffuse and glossy.
const Test maps("law.shadow.depth_maps_converge_to_rays", [] {
    context();
    auto scene = under_an_edge(0.0f, 0.6f);
    scene.materials[0].specular = 1.0f;
    scene.materials[0].roughness = 0.5f;
    add_box(scene, {-0.4f, 0.2f, 0.0f}, turned(vec3(0.2f)), 4, lambert());
    const auto lights = emitters();
    const auto shone = [&](Visibility visibility) {
        const render::GpuScene gpu_scene(scene, lights, visibility);
        render::RenderOptions options;
        options.width = options.height = 24;
        options.samples = 256; // the maps' points are shared by all pixels: 128 are 0.5 % off
        options.maps.size = 128;
        render::Renderer renderer(gpu_scene, camera_from_above(0.8f), options);
        std::vector<image::Image> films;
        for (int k = 0; k < static_cast<int>(lights.size()); ++k) {
            renderer.clear();
            renderer.use_lights(k, k + 1);
            for (int i = 0; i < options.samples; ++i) renderer.add_sample();
            films.push_back(renderer.read_film());
        }
        return films;
    };
    const auto rays = shone(Visibility::ray_on_cpu), mapped = shone(Visibility::map);
    for (std::size_t k = 0; k < lights.size(); ++k) {
        double sum = 0.0, difference = 0.0, square = 0.0;
        for (std::size_t i = 0; i < rays[k].pixels.size(); i += 4) {
            const double off = mapped[k].pixels[i] - rays[k].pixels[i];
            sum += rays[k].pixels[i];
            difference += off;
            square += off * off;
        }
        const double mean = sum / (24.0 * 24.0);
        // A tube's points differ by half of what they add (standard deviation), others' by less.
        const bool is_tube = std::holds_alternative<scene::TubeLight>(lights[k]);
        EXPECT_NEAR(difference / sum, 0.0, is_tube ? 2e-2 : 5e-3) << "light " << k;
        EXPECT_LT(std::sqrt(square / (24.0 * 24.0)) / mean, is_tube ? 0.06 : 0.05) << "light " << k;
    }
});

} // namespace
