#include "render/renderer.hpp"

#include "core/error.hpp"
#include "glsl/source.hpp"
#include "render/sampling.hpp"

#include <algorithm>
#include <chrono>
#include <fmt/format.h>
#include <utility>

namespace sr::render {
namespace {

/// LightSampling::automatic samples one light where there are more: tools/bench/results/lights.md.
constexpr int max_lights_to_visit = 32;

/// Times the parts of a frame one after the other; does nothing without PassTimes.
class PassClock {
public:
    explicit PassClock(PassTimes* times) : times_(times) {}

    /// Ends a part, which began where the last one ended.
    void end(double PassTimes::*part) {
        if (!times_) return;
        glFinish();
        const auto now = std::chrono::steady_clock::now();
        times_->*part += std::chrono::duration<double>(now - std::exchange(last_, now)).count();
    }

private:
    PassTimes* times_;
    std::chrono::steady_clock::time_point last_ = std::chrono::steady_clock::now();
};

/// The analytic estimator evaluates f_r lobe by lobe.
/// @throws Error if a user's folder changes f_r without its lobes.
void require_lobes(std::span<const glsl::Root> path) {
    for (const glsl::Root& root : path.first(path.size() - 1)) {
        if (!root.text_of("brdf/f_r.glsl")) continue;
        if (glsl::declares(glsl::expand(path, "brdf/f_r.glsl").text, "lobes")) return;
        throw Error({root.place_of("brdf/f_r.glsl")}, "declares no lobes, which the analytic estimator reads",
                    "declare those of shaders/brdf/brdf.glsl, or use --estimator sampled");
    }
}

/// Returns the files with which the analytic estimator overlays shaders/integrator/ and its constants; absent
/// for the sampled one.
std::optional<glsl::Root> estimator(const RenderOptions& options) {
    if (options.estimator == Estimator::sampled) return std::nullopt;
    require_lobes(options.shader_path);
    const std::string limits = fmt::format("const int analytic_points = {};\n"
                                           "const int max_outlined_triangles = {};\n"
                                           "const int light_choices = 0;\n",
                                           options.analytic_points, max_outlined_triangles);
    return glsl::Root::memory(
        "estimator", {{"integrator/reflected.glsl", "#include \"integrator/reflected_analytic.glsl\"\n"},
                      {"interface/estimator.glsl", limits}});
}

/// Makes means of sums: `samples` of each pixel.
void divide(image::Image& film, const std::vector<int>& samples) {
    for (std::size_t i = 0; i < film.pixels.size(); ++i)
        film.pixels[i] *= 1.0f / static_cast<float>(samples[i / 4]);
}

/// Returns whether the shader asks for V: the views of what a surface is do not. One that cannot be expanded
/// may: who compiles it says what is wrong.
bool asks_for_visibility(const RenderOptions& options) {
    try {
        return glsl::declares(glsl::expand(options.shader_path, options.shader).text, "visibility");
    } catch (const Error&) {
        return true;
    }
}

} // namespace

std::shared_ptr<ShaderLibrary> Renderer::programs(const RenderOptions& options) {
    require(!options.shader_path.empty(), "the shader path has a root");
    return std::make_shared<ShaderLibrary>(options.shader_path, estimator(options), options.trial);
}

Renderer::Renderer(const GpuScene& scene, const scene::Camera& camera, const RenderOptions& options,
                   std::shared_ptr<ShaderLibrary> shaders)
    : scene_(scene),
      camera_(camera),
      options_(options),
      has_shadows_(options.has_shadows && asks_for_visibility(options)),
      end_light_(scene.light_count()),
      shaders_(shaders ? std::move(shaders) : programs(options)),
      depths_(depths_of_frame()),
      films_(options.width, options.height, depths_, options.estimates_error),
      converged_(options.width, options.height) {
    ask_for_shadows();
    ask_for_triangles();
    ask_for_frame();
    clear();
}

void Renderer::resize(int width, int height, int samples) {
    deferred_.reset();
    films_.drop_sums();
    shadow_rays_.reset(); // its framebuffer holds on to the films' depth
    triangles_.reset();   // likewise
    frame_.reset();       // likewise
    const Depths depths_before = std::exchange(depths_, depths_of_frame());
    if (width != options_.width || height != options_.height || depths_ != depths_before)
        films_ = Films(width, height, depths_, options_.estimates_error);
    options_.width = width;
    options_.height = height;
    options_.samples = samples;
    use_lights(0, scene_.light_count());
    ask_for_shadows();
    ask_for_triangles();
    ask_for_frame();
    sample_count_ = 0; // the films are new
    clear();
}

/// Returns light_choices().
int Renderer::choices_of_lights() const {
    const bool is_wanted =
        options_.lights == LightSampling::one
        || (options_.lights == LightSampling::automatic && scene_.light_count() > max_lights_to_visit);
    const auto sums_itself = [](const glsl::Root& root) {
        return root.text_of("integrator/reflected.glsl").has_value();
    };
    const std::vector<glsl::Root>& path = options_.shader_path;
    const bool is_possible = options_.estimator == Estimator::sampled && !depth_maps_
                             && options_.shader == "forward.frag"
                             && std::none_of(path.begin(), path.end() - 1, sums_itself);
    return is_wanted && is_possible ? options_.light_choices : 0;
}

/// Returns whether V is a factor that can be left to the CPU: the renderer's own shaders make it one, what
/// somebody else puts in their place may not.
bool Renderer::can_defer_visibility() const {
    return options_.shader == "forward.frag" && options_.shader_path.size() == 1
           && DeferredVisibility::is_offered();
}

std::optional<TracedRays> Renderer::traced_rays() const {
    if (deferred_) return deferred_->traced();
    return shadow_rays_ ? std::optional(shadow_rays_->traced()) : std::nullopt;
}

void Renderer::ask_for_shadows() {
    depth_maps_.reset();
    if (has_shadows_ && scene_.visibility_backend() && scene_.visibility_backend()->shadow_map_scene())
        depth_maps_.emplace(scene_, options_.maps);
    const bool is_asked =
        has_shadows_ && scene_.visibility_backend() && scene_.visibility_backend()->occlusion();
    const int choices_before = std::exchange(light_choices_, choices_of_lights());
    const int rays_per_point = scene_.light_count() * scene_.rays_per_light();
    if (is_asked == (shadow_rays_ || deferred_) && rays_per_point == rays_per_point_
        && light_choices_ == choices_before)
        return;
    deferred_.reset();
    shadow_rays_.reset();
    rays_per_point_ = rays_per_point;
    if (is_asked && can_defer_visibility())
        deferred_.emplace(scene_, options_.width, options_.height, options_.max_rays, light_choices_);
    else if (is_asked)
        shadow_rays_.emplace(scene_, films_.film(0), options_.width, options_.height, options_.max_rays,
                             light_choices_);
}

/// Only the renderer's own shaders can look up triangles.
Depths Renderer::depths_of_frame() const {
    const bool looks_up = options_.shader == "forward.frag" && options_.shader_path.size() == 1;
    return looks_up && TriangleBuffer::is_useful(scene_) ? Depths::with_stencils : Depths::plain;
}

/// A frame that is shaded twice is rasterised both times.
void Renderer::ask_for_triangles() {
    triangles_.reset();
    triangles_of_.reset();
    if (depths_ == Depths::with_stencils && !shadow_rays_) triangles_.emplace(films_.film(0));
}

/// A sample can be added as it is drawn where each pixel is written once. Blending over other surfaces, and
/// surfaces in one place, take a picture of their own.
void Renderer::ask_for_frame() {
    const auto has_number = [](const Draw& draw) { return draw.number > 0; };
    const bool writes_once = triangles_ && std::ranges::all_of(scene_.opaque_draws(), has_number)
                             && scene_.blended_draws().empty() && !counts_surfaces(options_.shader)
                             && (!deferred_ || deferred_->shades_once());
    frame_.reset();
    if (!writes_once) frame_.emplace("frame", films_.film(0));
}

void Renderer::compile() {
    if (depth_maps_) depth_maps_->compile(*shaders_);
    for (const Draw& draw : scene_.opaque_draws()) {
        shaders_->mesh_program(depth_shader_of(draw, triangles_.has_value()), depth_features(draw.features));
        if (!deferred_)
            compile_shading(*shaders_, draw, options_.shader, opaque_terms(), triangles_.has_value());
        if (shadow_rays_)
            shaders_->mesh_program("record.frag", draw.features, {VisibilityTerm::record, light_choices_});
    }
    if (deferred_) deferred_->compile(*shaders_, triangles_.has_value());
    for (const Draw& draw : scene_.blended_draws())
        shaders_->mesh_program(fragment_of(draw, options_.shader), draw.features, blended_terms());
    compile_background(*shaders_, background());
    shaders_->fullscreen_program("accumulate.frag");
}

void Renderer::use_lights(int first, int end) {
    require(0 <= first && first <= end && end <= scene_.light_count(), "the lights exist");
    first_light_ = first;
    end_light_ = end;
}

void Renderer::clear() {
    converged_ = ConvergedPixels(options_.width, options_.height);
    if (triangles_) triangles_->draw_all();
    triangles_of_.reset();
    repeat();
}

void Renderer::repeat() {
    // New films are black. Later the first sample takes the place of what they hold, where it draws.
    const bool is_replaced = sample_count_ > 0 && !converged_.any(0);
    sample_count_ = rows_done_ = 0;
    films_.clear(options_.window.value_or(PixelRect{0, 0, options_.width, options_.height}), is_replaced);
}

void Renderer::look_from(const scene::Camera& camera) {
    camera_ = camera;
    clear();
}

void Renderer::add_sample() {
    const PixelRect part = window();
    require(!part.is_empty(), "a pixel takes samples");
    require(rows_done_ == 0, "no sample is incomplete");
    draw(part);
    ++sample_count_;
}

bool Renderer::add_rows(int count) {
    const PixelRect whole = window();
    require(!whole.is_empty() && count > 0, "a pixel takes samples");
    PixelRect part = whole;
    part.row += rows_done_;
    part.height = std::min(count, whole.height - rows_done_);
    draw(part);
    rows_done_ += part.height;
    if (rows_done_ < whole.height) return false;
    rows_done_ = 0;
    ++sample_count_;
    return true;
}

void Renderer::draw(const PixelRect& part) {
    PassClock clock(pass_times_);
    leave_out_triangles(); // before textures are bound for the frame
    const View view = begin_frame();
    set_scissor(part);
    const RenderTarget& target = this->target();
    begin_pass(target);
    if (converged_.any(sample_count_)) {
        glBindVertexArray(no_vertices_.id());
        converged_.bind(sample_count_, 0);
        mask_pass(target, *shaders_);
    }
    depth_pass(target, scene_, *shaders_, view.clip_from_world, triangles());
    glBindVertexArray(no_vertices_.id());
    if (!skips_background()) background_pass(target, scene_, *shaders_, background(), writing());
    clock.end(&PassTimes::depth);
    shade_opaque(part);
    set_scissor(part);
    blend_pass(target, scene_, *shaders_, options_.shader, view.eye, blended_terms());
    clock.end(&PassTimes::shading);
    if (frame_) {
        glBindVertexArray(no_vertices_.id());
        accumulate_pass(film_of_sample(), *frame_, *shaders_, writing_of_film(),
                        skips_background() ? Pixels::with_surface : open_pixels());
    }
    films_.changed();
    clock.end(&PassTimes::adding);
    glDisable(GL_SCISSOR_TEST);
}

/// Leaves out the triangles that no pixel sees, or only frozen ones do. To find them takes about as long as
/// to draw them, so a camera's first sample draws all.
void Renderer::leave_out_triangles() {
    const int event = converged_.event_of(sample_count_);
    const bool is_first = sample_count_ == 0 && event < 0 && !triangles_of_;
    if (!triangles_ || event == triangles_of_ || is_first) return;
    triangles_of_ = event;
    const OpenPixels open(converged_.frozen(sample_count_), options_.width, options_.height);
    const View view = view_of(camera_, options_.width, options_.height, vec2(0.5f));
    triangles_->draw_before(open, scene_, view.clip_from_world);
}

Background Renderer::background() const {
    if (counts_surfaces(options_.shader)) return {.is_behind_all = true};
    const bool has_environments = !scene_.visible_environments().empty() && options_.shader == "forward.frag";
    return {.L = options_.background, .has_environments = has_environments};
}

int Renderer::half_of_sample() const { return films_.has_halves() ? half_of(sample_count_) : 0; }

const RenderTarget& Renderer::film_of_sample() const { return films_.film(half_of_sample()); }

const RenderTarget& Renderer::target() const { return frame_ ? *frame_ : film_of_sample(); }

Pixels Renderer::open_pixels() const { return converged_.any(sample_count_) ? Pixels::open : Pixels::all; }

/// Black adds nothing to a film, so a frame may keep what it has behind the surfaces, if these alone are
/// added.
bool Renderer::skips_background() const {
    const bool adds_surfaces = !frame_ || (scene_.blended_draws().empty() && open_pixels() == Pixels::all);
    return writing_of_film() == Writing::adds && background().is_black() && adds_surfaces;
}

Writing Renderer::writing_of_film() const { return sample_count_ == 0 ? Writing::replaces : Writing::adds; }

Writing Renderer::writing() const { return frame_ ? Writing::replaces : writing_of_film(); }

PixelRect Renderer::window() const {
    const PixelRect active = converged_.active(sample_count_);
    return options_.window ? common_part(*options_.window, active) : active;
}

void Renderer::set_scissor(const PixelRect& window) const {
    if (window.width == options_.width && window.height == options_.height) return glDisable(GL_SCISSOR_TEST);
    glEnable(GL_SCISSOR_TEST);
    glScissor(window.column, options_.height - window.row - window.height, window.width,
              window.height); // GL counts rows from below
}

View Renderer::begin_frame() {
    const bool halves = options_.estimates_error;
    const int index = halves ? sample_count_ / 2 : sample_count_;
    const std::uint32_t seed = halves ? half_seed(half_of(sample_count_), options_.seed) : options_.seed;
    const View view =
        view_of(camera_, options_.width, options_.height, sub_pixel(index, options_.samples, seed));
    if (depth_maps_)
        depth_maps_->draw(static_cast<std::uint32_t>(index), seed, first_light_, end_light_, *shaders_);
    frame_data_.upload({.clip_from_world = view.clip_from_world,
                        .eye = view.eye,
                        .sample_index = static_cast<std::uint32_t>(index),
                        .seed = seed,
                        .first_light = first_light_,
                        .end_light = end_light_,
                        .frame_size = vec2(options_.width, options_.height),
                        .sample_digits = sample_digits(index, seed)});
    return view;
}

ProgramTerms Renderer::opaque_terms() const {
    ProgramTerms terms = blended_terms();
    if (shadow_rays_) terms.visibility = VisibilityTerm::resolve;
    return terms;
}

ProgramTerms Renderer::blended_terms() const {
    if (!scene_.visibility_backend() || !has_shadows_) return {VisibilityTerm::none, light_choices_};
    // A pixel can have several blended layers, so the shader traces their rays itself.
    const bool has_maps = scene_.visibility_backend()->shadow_map_scene() != nullptr;
    return {has_maps ? VisibilityTerm::map : VisibilityTerm::ray, light_choices_};
}

void Renderer::shade_opaque(const PixelRect& window) {
    if (deferred_ && first_light_ != end_light_) {
        PixelSums& sums = films_.sums(half_of_sample());
        deferred_->shade(target(), triangles(), window, first_light_, end_light_, frame_data_, *shaders_,
                         sums, writing());
        if (scene_.blended_draws().empty()) return;
        glBindVertexArray(no_vertices_.id()); // what is blended over the frame covers L_r, too
        sums.draw_into(target(), window, *shaders_, open_pixels());
        return sums.clear(window);
    }
    if (!shadow_rays_ || first_light_ == end_light_) {
        forward_pass(target(), scene_, *shaders_, options_.shader, opaque_terms(), triangles(), writing());
        return;
    }
    const RowRange rows{options_.height - window.row - window.height, window.height};
    const std::vector<RowRange> bands = shadow_rays_->divide(rows, end_light_ - first_light_);
    glEnable(GL_SCISSOR_TEST);
    for (const RowRange& band : bands) {
        glScissor(window.column, band.first, window.width, band.count);
        shadow_rays_->find(band, first_light_, end_light_, frame_data_, *shaders_);
        forward_pass(target(), scene_, *shaders_, options_.shader, opaque_terms(), nullptr);
    }
    glDisable(GL_SCISSOR_TEST);
}

const gl::Texture& Renderer::film_sum() const { return films_.sum(*shaders_); }

std::vector<int> Renderer::pixel_samples() const {
    std::vector<int> samples(static_cast<std::size_t>(options_.width)
                             * static_cast<std::size_t>(options_.height));
    for (std::size_t i = 0; i < samples.size(); ++i) samples[i] = converged_.samples_of(i, sample_count_);
    return samples;
}

image::Image Renderer::read_film() const {
    require(sample_count_ > 0, "the film has samples");
    image::Image film = films_.read();
    divide(film, pixel_samples());
    glsl::require_ended_loops(film.pixels, shaders_->loops());
    return film;
}

std::array<float, 4> Renderer::read_pixel(int column, int row) const {
    require(sample_count_ > 0, "the film has samples");
    std::array<float, 4> texel = films_.read(column, row);
    const std::size_t pixel = static_cast<std::size_t>(row) * static_cast<std::size_t>(options_.width)
                              + static_cast<std::size_t>(column);
    for (float& value : texel)
        value *= 1.0f / static_cast<float>(converged_.samples_of(pixel, sample_count_));
    glsl::require_ended_loops(texel, shaders_->loops());
    return texel;
}

image::Image Renderer::read_first_half() const {
    require(films_.has_halves() && sample_count_ > 0, "the renderer estimates its error, and has samples");
    image::Image film = films_.read_half(0);
    std::vector<int> samples = pixel_samples();
    for (int& count : samples) count = samples_of_half(0, count);
    divide(film, samples);
    return film;
}

std::optional<ErrorEstimate> Renderer::estimate_error() const {
    require(films_.has_halves(), "the renderer estimates its error");
    if (sample_count_ < 2) return std::nullopt;
    return render::estimate_error(read_film(), read_first_half(), pixel_samples());
}

} // namespace sr::render
