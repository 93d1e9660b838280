#include "render/triangle_buffer.hpp"

#include "core/error.hpp"
#include "gl/context.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <fmt/format.h>

namespace sr::render {
namespace {

constexpr GLuint all_bits = 0xff;

/// Returns the pixels that the box may cover, rows from below: all of them if it reaches behind the camera.
PixelRect rectangle_of(const scene::Bounds& box, const mat4& clip_from_world, int width, int height) {
    vec2 from(1.0f), to(-1.0f);
    for (unsigned corner = 0; corner < 8; ++corner) {
        const vec3 world(corner & 1u ? box.max.x : box.min.x, corner & 2u ? box.max.y : box.min.y,
                         corner & 4u ? box.max.z : box.min.z);
        const vec4 clip = clip_from_world * vec4(world, 1.0f);
        if (!(clip.w > 0.0f)) return {0, 0, width, height};
        from = glm::min(from, glm::max(vec2(clip) / clip.w, vec2(-1.0f)));
        to = glm::max(to, glm::min(vec2(clip) / clip.w, vec2(1.0f)));
    }
    const vec2 size(width, height);
    const glm::ivec2 first(glm::floor((0.5f + 0.5f * from) * size) - 1.0f); // a pixel more, for rounding
    const glm::ivec2 end(glm::ceil((0.5f + 0.5f * to) * size) + 1.0f);
    return common_part({first.x, first.y, end.x - first.x, end.y - first.y}, {0, 0, width, height});
}

/// Narrows the scissor, and restores it.
class NarrowScissor {
public:
    NarrowScissor(int width, int height)
        : was_enabled_(glIsEnabled(GL_SCISSOR_TEST) == GL_TRUE), whole_{0, 0, width, height} {
        std::array<GLint, 4> box{};
        glGetIntegerv(GL_SCISSOR_BOX, box.data());
        if (was_enabled_) whole_ = {box[0], box[1], box[2], box[3]};
        glEnable(GL_SCISSOR_TEST);
    }
    ~NarrowScissor() {
        glScissor(whole_.column, whole_.row, whole_.width, whole_.height);
        if (!was_enabled_) glDisable(GL_SCISSOR_TEST);
    }
    NarrowScissor(const NarrowScissor&) = delete;
    NarrowScissor& operator=(const NarrowScissor&) = delete;

    /// @return whether a pixel is left
    bool to(const PixelRect& rectangle) const {
        const PixelRect part = common_part(whole_, rectangle);
        glScissor(part.column, part.row, part.width, part.height);
        return !part.is_empty();
    }

private:
    bool was_enabled_;
    PixelRect whole_;
};

Faces faces_of(const Draw& draw) {
    if (draw.is_double_sided) return Faces::all;
    return draw.mirrors ? Faces::clockwise : Faces::counterclockwise;
}

} // namespace

bool TriangleBuffer::is_useful(const GpuScene& scene) {
    return gl::is_software_renderer(reinterpret_cast<const char*>(glGetString(GL_RENDERER)))
           && std::ranges::any_of(scene.opaque_draws(), [](const Draw& draw) { return draw.number > 0; });
}

TriangleBuffer::TriangleBuffer(const RenderTarget& frame) : width_(frame.width()), height_(frame.height()) {
    triangles_.bind(0);
    glTexImage2D(GL_TEXTURE_2D, 0, GL_R32I, width_, height_, 0, GL_RED_INTEGER, GL_INT, nullptr);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAX_LEVEL, 0);
    glBindFramebuffer(GL_FRAMEBUFFER, framebuffer_.id());
    glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, triangles_.id(), 0);
    glFramebufferTexture2D(GL_FRAMEBUFFER, GL_DEPTH_STENCIL_ATTACHMENT, GL_TEXTURE_2D, frame.depth().id(), 0);
    const GLenum status = glCheckFramebufferStatus(GL_FRAMEBUFFER);
    if (status != GL_FRAMEBUFFER_COMPLETE)
        throw Error(fmt::format("the driver refuses a picture of triangles of {}×{} pixels (status {:#x})",
                                width_, height_, status),
                    "choose a smaller --size");
}

void TriangleBuffer::draw_before(const OpenPixels& open, const GpuScene& scene, const mat4& clip_from_world) {
    draw_all();
    for (const Draw& draw : scene.opaque_draws()) {
        if (draw.number == 0) continue;
        const GpuMesh& mesh = scene.mesh_of(draw);
        const std::vector<std::uint32_t> indices = mesh.read_indices();
        const std::vector<std::uint32_t> triangles = open.triangles_before(
            mesh.read_positions(), indices, draw.world_from_object, clip_from_world, faces_of(draw));
        selections_.emplace_back(triangles, indices);
    }
}

void TriangleBuffer::begin(const GpuScene& scene, const mat4& clip_from_world) {
    rectangles_.clear();
    for (const Draw& draw : scene.opaque_draws())
        if (draw.number > 0)
            rectangles_.push_back(rectangle_of(draw.bounds, clip_from_world, width_, height_));
    glBindFramebuffer(GL_FRAMEBUFFER, framebuffer_.id());
    glDepthFunc(GL_LEQUAL); // of surfaces in one place the last one is seen, as a pass that tests for equal
                            // depth has it
    glEnable(GL_STENCIL_TEST);
    glStencilMask(all_bits);
    glStencilOp(GL_KEEP, GL_KEEP, GL_REPLACE);
}

void TriangleBuffer::write_number(const Draw& draw) const { glStencilFunc(GL_ALWAYS, draw.number, all_bits); }

void TriangleBuffer::draw(const GpuScene& scene, const Draw& draw, const gl::Program& program) const {
    glUniform1i(program.uniform("draws_some"), selections_.empty() ? GL_FALSE : GL_TRUE);
    if (selections_.empty()) return scene.draw(draw);
    const TriangleSelection& triangles = selections_[static_cast<std::size_t>(draw.number) - 1];
    triangles.show_numbers(triangle_numbers_unit);
    glBindSampler(triangle_numbers_unit, 0);
    scene.draw(draw, triangles);
}

void TriangleBuffer::shade(const GpuScene& scene, ShaderLibrary& shaders, const std::string& fragment,
                           ProgramTerms terms) const {
    glDisable(GL_CULL_FACE);
    glDisable(GL_DEPTH_TEST);
    glEnable(GL_STENCIL_TEST);
    glStencilOp(GL_KEEP, GL_KEEP, GL_KEEP);
    triangles_.bind(seen_triangles_unit);
    glBindSampler(seen_triangles_unit, 0);
    const NarrowScissor scissor(width_, height_);
    for (const Draw& draw : scene.opaque_draws()) {
        if (draw.number == 0 || !scissor.to(rectangles_[static_cast<std::size_t>(draw.number) - 1])) continue;
        glStencilFunc(GL_EQUAL, draw.number, all_bits);
        shaders.pixel_program(fragment, draw.features, terms).use();
        scene.bind(draw);
        scene.show_arrays(draw);
        glBindVertexArray(no_vertices_.id());
        glDrawArrays(GL_TRIANGLES, 0, 3);
    }
    glDisable(GL_STENCIL_TEST);
}

} // namespace sr::render
