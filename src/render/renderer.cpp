#include "render/renderer.hpp"

#include "core/error.hpp"
#include "render/sampling.hpp"

#include <algorithm>
#include <fmt/format.h>

namespace sr::render {
namespace {

/// The analytic estimator evaluates f_r lobe by lobe.
/// @throws Error if a user's folder changes f_r and not its lobes.
void require_lobes(std::span<const glsl::Root> users) {
    const auto has = [](std::string_view name) {
        return [name](const glsl::Root& root) { return root.text_of(name).has_value(); };
    };
    const auto changed = std::find_if(users.begin(), users.end(), has("brdf/f_r.glsl"));
    if (changed == users.end() || std::any_of(users.begin(), users.end(), has("brdf/lobes.glsl"))) return;
    throw Error({changed->place_of("brdf/f_r.glsl")}, "the analytic estimator reads brdf/lobes.glsl instead",
                "overlay that file too, or use --estimator sampled");
}

/// The estimator stands behind the user's own roots and in front of the embedded ones.
std::vector<glsl::Root> shader_path(const RenderOptions& options) {
    std::vector<glsl::Root> path = options.shader_path;
    require(!path.empty(), "the shader path has a root");
    if (options.estimator == Estimator::sampled) return path;
    require_lobes(std::span(path).first(path.size() - 1));
    const std::string limits = fmt::format("const int analytic_points = {};\n"
                                           "const int most_outlined_triangles = {};\n",
                                           options.analytic_points, most_outlined_triangles);
    path.insert(path.end() - 1,
                glsl::Root::memory("estimator", {{"integrator/reflected.glsl",
                                                  "#include \"integrator/reflected_analytic.glsl\"\n"},
                                                 {"interface/estimator.glsl", limits}}));
    return path;
}

} // namespace

Renderer::Renderer(const GpuScene& scene, const scene::Camera& camera, const RenderOptions& options)
    : scene_(scene),
      camera_(camera),
      options_(options),
      end_light_(scene.light_count()),
      shaders_(shader_path(options)),
      frame_("frame", options.width, options.height, true),
      film_("film", options.width, options.height, false) {
    prepare_answers();
    clear();
}

void Renderer::prepare_answers() {
    const bool is_asked = scene_.occluders() && scene_.occluders()->occlusion();
    const int rays_per_point = scene_.light_count() * scene_.rays_per_light();
    if (is_asked == ray_answers_.has_value() && rays_per_point == rays_per_point_) return;
    ray_answers_.reset();
    rays_per_point_ = rays_per_point;
    if (is_asked)
        ray_answers_.emplace(scene_, frame_, options_.width, options_.height, options_.most_answers);
}

void Renderer::compile() {
    for (const Draw& draw : scene_.opaque_draws()) {
        shaders_.mesh_program("depth.frag", depth_features(draw.features));
        shaders_.mesh_program(options_.shader, draw.features, opaque_visibility());
        if (ray_answers_) shaders_.mesh_program("record.frag", draw.features, VisibilityTerm::record);
    }
    for (const Draw& draw : scene_.blended_draws())
        shaders_.mesh_program(options_.shader, draw.features, blended_visibility(scene_));
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

void Renderer::look_from(const scene::Camera& camera) {
    camera_ = camera;
    clear();
}

void Renderer::restart(const scene::Camera& camera) {
    prepare_answers();
    use_lights(0, scene_.light_count());
    look_from(camera);
}

void Renderer::add_sample() {
    keep_to_window();
    const View view = begin_frame();
    depth_pass(frame_, scene_, shaders_, options_.background);
    shade_opaque();
    keep_to_window();
    blend_pass(frame_, scene_, shaders_, options_.shader, view.eye);
    glBindVertexArray(no_vertices_.id());
    accumulate_pass(film_, frame_, shaders_);
    glDisable(GL_SCISSOR_TEST);
    ++sample_count_;
}

void Renderer::keep_to_window() const {
    if (!options_.window) return;
    const Window& w = *options_.window;
    glEnable(GL_SCISSOR_TEST);
    glScissor(w.column, options_.height - w.row - w.height, w.width, w.height); // GL counts rows from below
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
        forward_pass(frame_, scene_, shaders_, options_.shader, opaque_visibility());
        return;
    }
    const Window all{0, 0, options_.width, options_.height};
    const Window& w = options_.window ? *options_.window : all;
    const Band rows{options_.height - w.row - w.height, w.height};
    const std::vector<Band> bands = ray_answers_->bands(rows, end_light_ - first_light_);
    glEnable(GL_SCISSOR_TEST);
    for (const Band& band : bands) {
        glScissor(w.column, band.first, w.width, band.count);
        ray_answers_->find(band, first_light_, end_light_, frame_data_, shaders_);
        forward_pass(frame_, scene_, shaders_, options_.shader, VisibilityTerm::answered);
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
