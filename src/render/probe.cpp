#include "render/probe.hpp"

#include "core/error.hpp"

namespace sr::render {
namespace {

/// One pixel of a picture, by any of the shaders that draw surfaces.
class Pixel {
public:
    Pixel(const GpuScene& scene, const scene::Camera& camera, RenderOptions options, std::string shader,
          int column, int row)
        : column_(column),
          row_(row),
          renderer_(scene, camera, windowed(options, std::move(shader), column, row)) {}

    /// The mean of `samples` samples, lit by the lights [first, end).
    vec4 mean(int samples, int first, int end) {
        renderer_.clear();
        renderer_.use_lights(first, end);
        for (int i = 0; i < samples; ++i) renderer_.add_sample();
        const image::Image film = renderer_.film();
        const auto texel = film.at(column_, row_);
        return {texel[0], texel[1], texel[2], texel[3]};
    }

private:
    static RenderOptions windowed(RenderOptions options, std::string shader, int column, int row) {
        options.shader = std::move(shader);
        options.window = PixelRect{column, row, 1, 1};
        return options;
    }

    int column_;
    int row_;
    Renderer renderer_;
};

vec3 quotient(vec3 a, vec3 b) {
    return {b.x > 0.0f ? a.x / b.x : 0.0f, b.y > 0.0f ? a.y / b.y : 0.0f, b.z > 0.0f ? a.z / b.z : 0.0f};
}

} // namespace

std::optional<PixelTerms> probe(const GpuScene& scene, const scene::Camera& camera,
                                const RenderOptions& options, int column, int row,
                                const std::stop_token& stop, const std::function<void()>& between_steps) {
    require(column >= 0 && column < options.width && row >= 0 && row < options.height,
            "the pixel is in the picture");
    const auto lights = static_cast<std::size_t>(scene.light_count());
    PixelTerms terms;

    RenderOptions centre = options;
    centre.samples = 1;
    centre.background = vec3(0.0f);
    const auto at_centre = [&](const char* shader) {
        return vec3(Pixel(scene, camera, centre, shader, column, row).mean(1, 0, 0));
    };
    terms.x = at_centre("views/position.frag");
    terms.n = at_centre("views/normal.frag");
    terms.wo = at_centre("views/to_viewer.frag");

    // One shader after the other: each renderer has targets of its own.
    const auto for_each_light = [&](const char* shader, auto take) {
        Pixel pixel(scene, camera, options, shader, column, row);
        for (std::size_t k = 0; k < lights && !stop.stop_requested(); ++k) {
            take(terms.lights[k], pixel.mean(options.samples, static_cast<int>(k), static_cast<int>(k) + 1));
            if (between_steps) between_steps();
        }
    };
    terms.lights.resize(lights);
    {
        Pixel beauty(scene, camera, options, "forward.frag", column, row);
        const vec4 L_o = beauty.mean(options.samples, 0, scene.light_count());
        terms.L_o = vec3(L_o);
        terms.coverage = L_o.w;
        terms.L_e = vec3(beauty.mean(options.samples, 0, 0));
    }
    for_each_light("forward.frag", [&](LightTerms& t, vec4 film) { t.L_r = vec3(film) - terms.L_e; });
    for_each_light("views/irradiance.frag", [](LightTerms& t, vec4 film) {
        t.E = vec3(film);
        t.f_r = quotient(t.L_r, t.E);
    });
    for_each_light("views/arrival.frag", [&](LightTerms& t, vec4 film) {
        if (film.w > 0.0f) t.wi = vec3(film) / film.w;
        t.cos_i = glm::dot(t.wi, terms.n);
    });
    for_each_light("views/extent.frag", [](LightTerms& t, vec4 film) {
        t.solid_angle = film.x;
        t.V = film.z > 0.0f ? film.y / film.z : 1.0f;
    });
    for (LightTerms& t : terms.lights) t.V_color = vec3(t.V);
    if (scene.visibility_backend() && scene.visibility_backend()->casters().is_tinted())
        for_each_light("views/unshadowed.frag", [](LightTerms& t, vec4 film) {
            for (int c = 0; c < 3; ++c) t.V_color[c] = film[c] > 0.0f ? t.E[c] / film[c] : 1.0f;
        });
    if (stop.stop_requested()) return std::nullopt;
    return terms;
}

} // namespace sr::render
