#include "render/lobe.hpp"

#include "core/error.hpp"
#include "render/passes.hpp"

namespace sr::render {
namespace {

/// A triangle and what it is drawn with.
struct Seen {
    const Draw* draw = nullptr;
    int triangle = 0; // of its mesh
};

/// The nearest triangle that the scissor's one pixel sees, transparent ones included.
std::optional<Seen> seen_at(const GpuScene& scene, const RenderTarget& frame, ShaderLibrary& shaders,
                            int column, int row) {
    seen_pass(frame, scene, shaders);
    const image::Image film = frame.read();
    const auto texel = film.at(column, row);
    if (texel[3] == 0.0f) return std::nullopt;
    for (const auto* draws : {&scene.opaque_draws(), &scene.blended_draws()})
        for (const Draw& draw : *draws)
            if (draw.instance == static_cast<int>(texel[0])) return Seen{&draw, static_cast<int>(texel[1])};
    return std::nullopt;
}

/// Where the answers go: to every second texel, since textures are filtered by squares of two by two pixels,
/// in which the pixel has to keep its place.
class Answers {
public:
    Answers(std::size_t count, int column, int row_from_below)
        : column_(column),
          row_(row_from_below),
          height_(2 * static_cast<int>((count + rows_of - 1) / rows_of)),
          target_("f_r", width, height_, false) {
        target_.bind();
        glDisable(GL_SCISSOR_TEST);
        glClearColor(0.0f, 0.0f, 0.0f, 0.0f);
        glClear(GL_COLOR_BUFFER_BIT);
        glEnable(GL_SCISSOR_TEST);
    }

    /// Lets the pixel of a picture of this size fall on the place of answer i.
    void aim(std::size_t i, int picture_width, int picture_height) const {
        const auto [x, y] = place(i);
        glViewport(x - column_, y - row_, picture_width, picture_height);
        glScissor(x, y, 1, 1);
    }

    std::vector<vec3> read(std::size_t count) const {
        const image::Image image = target_.read();
        std::vector<vec3> answers;
        for (std::size_t i = 0; i < count; ++i) {
            const auto [x, y] = place(i);
            const auto texel = image.at(x, height_ - 1 - y);
            answers.emplace_back(texel[0], texel[1], texel[2]);
        }
        return answers;
    }

private:
    static constexpr std::size_t rows_of = 64;
    static constexpr int width = 2 * rows_of;

    std::pair<int, int> place(std::size_t i) const {
        return {2 * static_cast<int>(i % rows_of) + column_ % 2,
                2 * static_cast<int>(i / rows_of) + row_ % 2};
    }

    int column_;
    int row_;
    int height_;
    RenderTarget target_;
};

} // namespace

std::optional<PixelBrdf> brdf_at(const GpuScene& scene, const scene::Camera& camera,
                                 const RenderOptions& options, int column, int row,
                                 std::span<const vec3> wi) {
    require(column >= 0 && column < options.width && row >= 0 && row < options.height,
            "the pixel is in the picture");
    require(!wi.empty(), "a direction is asked for");
    const int row_from_below = options.height - 1 - row;
    ShaderLibrary shaders(options.shader_path, {}, options.trial);
    FrameData frame_data;
    const View view = view_of(camera, options.width, options.height, vec2(0.5f));
    frame_data.upload(
        {view.clip_from_world, view.eye, 0, options.seed, 0, 0, vec2(options.width, options.height)});
    scene.bind_lights();
    glEnable(GL_SCISSOR_TEST);
    glScissor(column, row_from_below, 1, 1);
    const RenderTarget frame("seen", options.width, options.height, true);
    const auto seen = seen_at(scene, frame, shaders, column, row);
    if (!seen) {
        glDisable(GL_SCISSOR_TEST);
        return std::nullopt;
    }
    const Answers answers(wi.size(), column, row_from_below);
    const gl::Program& program = shaders.mesh_program("views/lobe.frag", seen->draw->features);
    program.use();
    glDisable(GL_DEPTH_TEST);
    glDisable(GL_CULL_FACE);
    scene.bind(*seen->draw);
    const GLint asked = program.uniform("asked_wi");
    for (std::size_t i = 0; i < wi.size(); ++i) {
        glUniform3f(asked, wi[i].x, wi[i].y, wi[i].z);
        answers.aim(i, options.width, options.height);
        scene.draw_triangle(*seen->draw, seen->triangle);
    }
    glDisable(GL_SCISSOR_TEST);
    return PixelBrdf{scene::brdf_model(seen->draw->features.model).is_delta, answers.read(wi.size())};
}

} // namespace sr::render
