#include "core/error.hpp"
#include "gl/context.hpp"
#include "render/renderer.hpp"
#include "support/address.hpp"
#include "support/scenes.hpp"

#include <cstring>

using namespace sr;
using sr::testing::Test;

namespace {

/// A picture through a context of its own; absent if the backend does not work on this machine.
std::optional<image::Image> picture_through(gl::Backend backend) {
    std::unique_ptr<gl::Context> context;
    try {
        context = gl::open_context({backend, true});
    } catch (const Error&) {
        return std::nullopt;
    }
    const std::vector<scene::Light> lights{
        scene::PointLight{"", {0.5f, 1.0f, 0.2f}, vec3(2.0f)},
        scene::RectangleLight{"", {0.0f, 1.5f, 0.0f}, {0.3f, 0, 0}, {0, 0, 0.3f}, vec3(10.0f)}};
    const auto plane = sr::testing::lambert_plane(4.0f);
    const render::GpuScene scene(plane, lights);
    render::RenderOptions options;
    options.width = options.height = 64;
    options.samples = 4;
    render::Renderer renderer(scene, sr::testing::camera_from_above(2.0f), options);
    for (int i = 0; i < options.samples; ++i) renderer.add_sample();
    context->require_silence();
    return renderer.read_film();
}

// EGL and OSMesa are two doors to the same renderer: the same picture comes out of both.
const Test same("unit.gl.backend.egl_and_osmesa_agree", [] {
    const auto egl = picture_through(gl::Backend::egl);
    const auto osmesa = picture_through(gl::Backend::osmesa);
    if (!egl || !osmesa) GTEST_SKIP() << "needs both EGL and OSMesa";
    EXPECT_LT(sr::testing::max_relative_difference(*egl, *osmesa, 1e-4f), 1e-5f);
});

const Test names("unit.gl.backend.names", [] {
    EXPECT_EQ(gl::backend_named("auto"), gl::Backend::automatic);
    EXPECT_EQ(gl::backend_named("osmesa"), gl::Backend::osmesa);
    EXPECT_EQ(gl::backend_named("vulkan"), std::nullopt);
});

} // namespace
