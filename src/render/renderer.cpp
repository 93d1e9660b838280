#include "render/renderer.hpp"

#include "core/error.hpp"
#include "render/sampling.hpp"

namespace sr::render {

Renderer::Renderer(const GpuScene& scene, const scene::Camera& camera, const RenderOptions& options)
    : scene_(scene),
      camera_(camera),
      options_(options),
      end_light_(scene.light_count()),
      shaders_(options.shader_path),
      frame_("frame", options.width, options.height, true),
      film_("film", options.width, options.height, false) {
    require(!options.shader_path.empty(), "the shader path has a root");
    if (scene.occluders() && scene.occluders()->occlusion())
        ray_answers_.emplace(scene, frame_, options.width, options.height, options.most_answers);
    clear();
}

void Renderer::compile() {
    for (const Draw& draw : scene_.opaque_draws()) {
        shaders_.mesh_program("depth.frag", depth_features(draw.features));
        shaders_.mesh_program("forward.frag", draw.features, opaque_visibility());
        if (ray_answers_) shaders_.mesh_program("record.frag", draw.features, VisibilityTerm::record);
    }
    for (const Draw& draw : scene_.blended_draws())
        shaders_.mesh_program("forward.frag", draw.features, blended_visibility(scene_));
    shaders_.fullscreen_program("accumulate.frag");
}

void Renderer::use_lights(int first, int end) {
    require(0 <= first && first <= end && end <= scene_.light_count(), "the lights exist");
    first_light_ = first;
    end_light_ = end;
}

void Renderer::clear() {
    sample_count_ = 0;
    film_.bind();
    glClearColor(0.0f, 0.0f, 0.0f, 0.0f);
    glClear(GL_COLOR_BUFFER_BIT);
}

void Renderer::add_sample() {
    const View view = begin_frame();
    depth_pass(frame_, scene_, shaders_, options_.background);
    shade_opaque();
    blend_pass(frame_, scene_, shaders_, view.eye);
    glBindVertexArray(no_vertices_.id());
    accumulate_pass(film_, frame_, shaders_);
    ++sample_count_;
}

View Renderer::begin_frame() {
    const vec2 offset = sub_pixel(sample_count_, options_.samples, options_.seed);
    const View view = view_of(camera_, options_.width, options_.height, offset);
    frame_data_.upload({view.clip_from_world, view.eye, static_cast<std::uint32_t>(sample_count_),
                        options_.seed, first_light_, end_light_});
    return view;
}

VisibilityTerm Renderer::opaque_visibility() const {
    if (!scene_.occluders()) return VisibilityTerm::none;
    return ray_answers_ ? VisibilityTerm::answered : VisibilityTerm::ray;
}

void Renderer::shade_opaque() {
    if (!ray_answers_ || first_light_ == end_light_) {
        forward_pass(frame_, scene_, shaders_, opaque_visibility());
        return;
    }
    const std::vector<Band> bands = ray_answers_->bands(end_light_ - first_light_);
    glEnable(GL_SCISSOR_TEST);
    for (const Band& band : bands) {
        glScissor(0, band.first, options_.width, band.count);
        ray_answers_->find(band, first_light_, end_light_, frame_data_, shaders_);
        forward_pass(frame_, scene_, shaders_, VisibilityTerm::answered);
    }
    glDisable(GL_SCISSOR_TEST);
}

image::Image Renderer::film() const {
    require(sample_count_ > 0, "the film has samples");
    image::Image image = film_.read();
    const float weight = 1.0f / static_cast<float>(sample_count_);
    for (float& value : image.pixels) value *= weight;
    return image;
}

} // namespace sr::render
