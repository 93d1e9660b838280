#include "render/passes.hpp"

#include <algorithm>

namespace sr::render {
namespace {

const char* const plain_background = "plain_background.frag";
const char* const environment_background = "background.frag";
const std::string glass_shader = "glass.frag";
const std::string wireframe_shader = "views/wireframe.frag";
const std::string overdraw_shader = "views/overdraw.frag";

void draw_for(const std::string& fragment, const GpuScene& scene, const Draw& draw) {
    if (fragment == wireframe_shader) scene.show_arrays(draw);
    scene.draw(draw);
}

void cull(bool is_double_sided, GLenum face = GL_BACK) {
    if (is_double_sided)
        glDisable(GL_CULL_FACE);
    else
        glEnable(GL_CULL_FACE);
    glCullFace(face);
}

/// Adds every fragment to the frame, those behind others, too.
void count_fragments() {
    glDepthFunc(GL_ALWAYS);
    glEnable(GL_BLEND);
    glBlendEquation(GL_FUNC_ADD);
    glBlendFuncSeparate(GL_ONE, GL_ONE, GL_ONE, GL_ZERO); // coverage is no count
}

void blend_by_adding() {
    glEnable(GL_BLEND);
    glBlendEquation(GL_FUNC_ADD);
    glBlendFunc(GL_ONE, GL_ONE);
}

/// It also forgets blending by a second colour (glass): Mesa then refuses to draw into several targets,
/// whether blending is on or not.
void write_by(Writing writing) {
    blend_by_adding();
    if (writing == Writing::replaces) glDisable(GL_BLEND);
}

/// Draws the opaque surfaces where the pre-pass left them in front. The others as in forward_pass().
void draw_visible(const GpuScene& scene, ShaderLibrary& shaders, const std::string& fragment,
                  ProgramTerms terms, const TriangleBuffer* triangles, Writing writing) {
    write_by(writing);
    glEnable(GL_DEPTH_TEST);
    glDepthFunc(GL_EQUAL);
    glDepthMask(GL_FALSE);
    if (counts_surfaces(fragment)) count_fragments();
    scene.bind_lights();
    for (const Draw& draw : scene.opaque_draws()) {
        if (triangles && draw.number > 0) continue;
        cull(draw.is_double_sided);
        shaders.mesh_program(fragment, draw.features, terms).use();
        draw_for(fragment, scene, draw);
    }
    if (triangles) triangles->shade(scene, shaders, fragment, terms);
}

/// Larger is farther from the camera.
float view_depth(const Draw& draw, vec4 eye) {
    if (eye.w == 0.0f) return -glm::dot(draw.center, vec3(eye));
    return glm::distance(draw.center, vec3(eye));
}

/// Of surfaces that are drawn into an empty frame.
void nearest_win(const RenderTarget& frame) {
    frame.bind();
    glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
    glDisable(GL_BLEND);
    glEnable(GL_DEPTH_TEST);
    glDepthFunc(GL_LESS);
    glDepthMask(GL_TRUE);
}

/// Draws a triangle over these pixels of the scissor. A driver on the CPU leaves out whole blocks of others.
void draw_over(Pixels pixels) {
    glDisable(GL_CULL_FACE);
    if (pixels == Pixels::all) {
        glDisable(GL_DEPTH_TEST);
    } else {
        glEnable(GL_DEPTH_TEST);
        glDepthMask(GL_FALSE);
        const bool is_behind = pixels == Pixels::with_surface;
        glDepthFunc(is_behind ? GL_GREATER : GL_NOTEQUAL); // closed pixels have depth 0
        glDepthRangef(is_behind ? 1.0f : 0.0f, is_behind ? 1.0f : 0.0f);
    }
    glDrawArrays(GL_TRIANGLES, 0, 3);
    glDepthRangef(0.0f, 1.0f);
}

/// Clears the attachments in the rows of the scissor, at all columns of the viewport: these rows are read
/// back whole.
void clear_rows(int attachments) {
    constexpr float nothing[4]{0.0f, 0.0f, 0.0f, 0.0f}; // a ray without distance asks nothing
    GLint scissor[4], viewport[4];
    glGetIntegerv(GL_SCISSOR_BOX, scissor);
    glGetIntegerv(GL_VIEWPORT, viewport);
    glEnable(GL_SCISSOR_TEST);
    glScissor(0, scissor[1], viewport[2], scissor[3]);
    for (int i = 0; i < attachments; ++i) glClearBufferfv(GL_COLOR, i, nothing);
    glScissor(scissor[0], scissor[1], scissor[2], scissor[3]);
}

} // namespace

bool counts_surfaces(const std::string& shader) { return shader == overdraw_shader; }

const std::string& fragment_of(const Draw& draw, const std::string& shader) {
    return draw.features.has(scene::Layer::transmission) && shader == "forward.frag" ? glass_shader : shader;
}

const char* depth_shader_of(const Draw& draw, bool has_triangles) {
    return has_triangles && draw.number > 0 ? "triangle.frag" : "depth.frag";
}

void begin_pass(const RenderTarget& frame) {
    frame.bind();
    glDepthMask(GL_TRUE);
    glStencilMask(~0u);
    glClear(GL_DEPTH_BUFFER_BIT | GL_STENCIL_BUFFER_BIT);
}

void depth_pass(const RenderTarget& frame, const GpuScene& scene, ShaderLibrary& shaders,
                const mat4& clip_from_world, TriangleBuffer* triangles) {
    nearest_win(frame);
    if (triangles)
        triangles->begin(scene, clip_from_world);
    else
        glColorMask(GL_FALSE, GL_FALSE, GL_FALSE, GL_FALSE);
    for (const Draw& draw : scene.opaque_draws()) {
        cull(draw.is_double_sided);
        if (triangles) triangles->write_number(draw);
        const gl::Program& program =
            shaders.mesh_program(depth_shader_of(draw, triangles != nullptr), depth_features(draw.features));
        program.use();
        if (triangles && draw.number > 0)
            triangles->draw(scene, draw, program);
        else
            scene.draw(draw);
    }
    glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
    glDisable(GL_STENCIL_TEST);
}

void background_pass(const RenderTarget& frame, const GpuScene& scene, ShaderLibrary& shaders,
                     const Background& background, Writing writing) {
    frame.bind();
    write_by(writing);
    glDisable(GL_CULL_FACE);
    glEnable(GL_DEPTH_TEST);
    glDepthFunc(background.is_behind_all ? GL_ALWAYS : GL_LEQUAL);
    glDepthMask(GL_FALSE);
    glDepthRangef(1.0f, 1.0f); // behind all surfaces
    const gl::Program& plain = shaders.fullscreen_program(plain_background);
    plain.use();
    glUniform3fv(plain.uniform("background"), 1, &background.L.x);
    glDrawArrays(GL_TRIANGLES, 0, 3);
    if (background.has_environments) {
        blend_by_adding();
        scene.bind_lights();
        const gl::Program& program = shaders.fullscreen_program(environment_background);
        program.use();
        for (const int environment : scene.visible_environments()) {
            glUniform1i(program.uniform("environment"), environment);
            glDrawArrays(GL_TRIANGLES, 0, 3);
        }
    }
    glDepthRangef(0.0f, 1.0f);
}

void compile_background(ShaderLibrary& shaders, const Background& background) {
    shaders.fullscreen_program(plain_background);
    if (background.has_environments) shaders.fullscreen_program(environment_background);
}

void mask_pass(const RenderTarget& frame, ShaderLibrary& shaders) {
    frame.bind();
    glDisable(GL_BLEND);
    glDisable(GL_CULL_FACE);
    glEnable(GL_DEPTH_TEST);
    glDepthFunc(GL_ALWAYS);
    glDepthMask(GL_TRUE);
    glColorMask(GL_FALSE, GL_FALSE, GL_FALSE, GL_FALSE);
    glDepthRangef(0.0f, 0.0f); // in front of all surfaces
    glBindSampler(0, 0);
    shaders.fullscreen_program("mask.frag").use();
    glDrawArrays(GL_TRIANGLES, 0, 3);
    glDepthRangef(0.0f, 1.0f);
    glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
}

void record_pass(const GpuScene& scene, ShaderLibrary& shaders, int attachments, int light_choices) {
    clear_rows(attachments);
    draw_visible(scene, shaders, "record.frag", {VisibilityTerm::record, light_choices}, nullptr,
                 Writing::replaces);
}

void forward_pass(const RenderTarget& frame, const GpuScene& scene, ShaderLibrary& shaders,
                  const std::string& shader, ProgramTerms terms, const TriangleBuffer* triangles,
                  Writing writing) {
    frame.bind();
    draw_visible(scene, shaders, shader, terms, triangles, writing);
}

void compile_shading(ShaderLibrary& shaders, const Draw& draw, const std::string& shader, ProgramTerms terms,
                     bool has_triangles) {
    if (has_triangles && draw.number > 0)
        shaders.pixel_program(shader, draw.features, terms);
    else
        shaders.mesh_program(shader, draw.features, terms);
}

void add_pass(const RenderTarget& frame, ShaderLibrary& shaders, Pixels pixels) {
    frame.bind();
    shaders.fullscreen_program("deferred_sum.frag").use();
    blend_by_adding();
    draw_over(pixels);
}

void blend_pass(const RenderTarget& frame, const GpuScene& scene, ShaderLibrary& shaders,
                const std::string& shader, vec4 eye, ProgramTerms terms) {
    if (scene.blended_draws().empty()) return;
    frame.bind();
    glEnable(GL_BLEND);
    glBlendEquation(GL_FUNC_ADD);
    glEnable(GL_DEPTH_TEST);
    glDepthFunc(GL_LESS);
    glDepthMask(GL_FALSE);
    scene.bind_lights();
    std::vector<Draw> draws = scene.blended_draws();
    std::stable_sort(draws.begin(), draws.end(),
                     [&](const Draw& a, const Draw& b) { return view_depth(a, eye) > view_depth(b, eye); });
    for (const Draw& draw : draws) {
        const std::string& fragment = fragment_of(draw, shader);
        if (counts_surfaces(fragment))
            count_fragments();
        else if (fragment == glass_shader)
            glBlendFuncSeparate(GL_ONE, GL_SRC1_COLOR, GL_ONE, GL_SRC1_ALPHA);
        else
            glBlendFunc(GL_ONE, GL_ONE_MINUS_SRC_ALPHA); // the shader multiplies by its coverage
        shaders.mesh_program(fragment, draw.features, terms).use();
        if (draw.is_double_sided && draw.is_surface) {
            cull(false, GL_FRONT);
            draw_for(fragment, scene, draw);
        }
        cull(!draw.is_surface);
        draw_for(fragment, scene, draw);
    }
}

void accumulate_pass(const RenderTarget& film, const RenderTarget& frame, ShaderLibrary& shaders,
                     Writing writing, Pixels pixels) {
    film.bind();
    shaders.fullscreen_program("accumulate.frag").use();
    frame.color().bind(0);
    glBindSampler(0, 0);
    write_by(writing);
    draw_over(pixels);
}

void seen_pass(const RenderTarget& frame, const GpuScene& scene, ShaderLibrary& shaders) {
    begin_pass(frame);
    nearest_win(frame);
    constexpr float nothing[4]{0.0f, 0.0f, 0.0f, 0.0f};
    glClearBufferfv(GL_COLOR, 0, nothing);
    for (const auto* draws : {&scene.opaque_draws(), &scene.blended_draws()})
        for (const Draw& draw : *draws) {
            cull(draw.is_double_sided);
            shaders.mesh_program("views/id_buffer.frag", caster_features(draw.features)).use();
            scene.draw(draw);
        }
}

} // namespace sr::render
