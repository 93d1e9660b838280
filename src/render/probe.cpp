#include "render/probe.hpp"

#include "core/error.hpp"

namespace sr::render {
namespace {

/// One pixel of a picture, by any of the shaders that draw surfaces.
class Pixel {
public:
    Pixel(const GpuScene& scene, const scene::Camera& camera, RenderOptions options, std::string shader, int column,
          int row)
        : column_(column), row_(row), renderer_(scene, camera, windowed(options, std::move(shader), column, row)) {}

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
        options.window = Window{column, row, 1, 1};
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

std::optional<PixelTerms> probe(const GpuScene& scene, const scene::Camera& camera, const RenderOptions& options,
                                int column, int row, const std::function<bool()>& goes_on) {
    require(column >= 0 && column < options.width && row >= 0 && row < options.height, "the pixel is in the picture");
    const int samples = options.samples, lights = scene.light_count();
    const auto pixel = [&](const char* shader) { return Pixel(scene, camera, options, shader, column, row); };
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

    Pixel beauty = pixel("forward.frag"), irradiance = pixel("views/irradiance.frag");
    Pixel arrival = pixel("views/arrival.frag"), extent = pixel("views/extent.frag");
    const vec4 L_o = beauty.mean(samples, 0, lights);
    terms.L_o = vec3(L_o);
    terms.coverage = L_o.w;
    terms.L_e = vec3(beauty.mean(samples, 0, 0));
    for (int k = 0; k < lights; ++k) {
        if (!goes_on()) return std::nullopt;
        LightTerms light;
        light.L_r = vec3(beauty.mean(samples, k, k + 1)) - terms.L_e;
        light.E = vec3(irradiance.mean(samples, k, k + 1));
        light.f_r = quotient(light.L_r, light.E);
        const vec4 from = arrival.mean(samples, k, k + 1);
        if (from.w > 0.0f) light.wi = vec3(from) / from.w;
        light.cos_i = glm::dot(light.wi, terms.n);
        const vec4 seen = extent.mean(samples, k, k + 1);
        light.solid_angle = seen.x;
        light.V = seen.z > 0.0f ? seen.y / seen.z : 1.0f;
        terms.lights.push_back(light);
    }
    return terms;
}

} // namespace sr::render
