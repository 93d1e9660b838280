#include "render/probe.hpp"

#include "core/error.hpp"
#include "render/passes.hpp"

#include <algorithm>
#include <array>
#include <utility>

namespace sr::render {

/// One pixel of a picture, by any of the shaders that draw surfaces.
class ProbedPixel {
public:
    ProbedPixel(const GpuScene& scene, const scene::Camera& camera, RenderOptions options, std::string shader,
                int column, int row)
        : column_(column),
          row_(row),
          renderer_(scene, camera, windowed(options, std::move(shader), column, row)) {}

    /// The mean of `samples` samples, lit by the lights [first, end).
    vec4 mean(int samples, int first, int end) {
        renderer_.clear();
        renderer_.use_lights(first, end);
        for (int i = 0; i < samples; ++i) renderer_.add_sample();
        const auto texel = renderer_.read_pixel(column_, row_);
        return {texel[0], texel[1], texel[2], texel[3]};
    }

private:
    static RenderOptions windowed(RenderOptions options, std::string shader, int column, int row) {
        options.shader = std::move(shader);
        options.lights = LightSampling::all; // each light has its terms
        options.window = PixelRect{column, row, 1, 1};
        return options;
    }

    int column_;
    int row_;
    Renderer renderer_;
};

namespace {

vec3 quotient(vec3 a, vec3 b) {
    return {b.x > 0.0f ? a.x / b.x : 0.0f, b.y > 0.0f ? a.y / b.y : 0.0f, b.z > 0.0f ? a.z / b.z : 0.0f};
}

/// Terms of lights that a shader renders.
struct TermKind {
    const char* shader;
    void (*take)(const PixelTerms& pixel, LightTerms& light, vec4 film);
};

/// In the order of Probing::Kind. The last one is for scenes with tinted shadows.
constexpr std::array<TermKind, 5> term_kinds{{
    {"forward.frag",
     [](const PixelTerms& pixel, LightTerms& t, vec4 film) { t.L_r = vec3(film) - pixel.L_e; }},
    {"views/irradiance.frag",
     [](const PixelTerms&, LightTerms& t, vec4 film) {
         t.E = vec3(film);
         t.f_r = quotient(t.L_r, t.E);
     }},
    {"views/arrival.frag",
     [](const PixelTerms& pixel, LightTerms& t, vec4 film) {
         t.wi = film.w > 0.0f ? vec3(film) / film.w : vec3(0.0f);
         t.cos_i = glm::dot(t.wi, pixel.n);
     }},
    {"views/solid_angle.frag",
     [](const PixelTerms&, LightTerms& t, vec4 film) {
         t.solid_angle = film.x;
         t.V = film.z > 0.0f ? film.y / film.z : 1.0f;
         t.V_color = vec3(t.V);
     }},
    {"views/unshadowed.frag",
     [](const PixelTerms&, LightTerms& t, vec4 film) {
         for (int c = 0; c < 3; ++c) t.V_color[c] = film[c] > 0.0f ? t.E[c] / film[c] : 1.0f;
     }},
}};

} // namespace

struct Probing::Run {
    const GpuScene& scene;
    scene::Camera camera;
    RenderOptions options;
    int column;
    int row;
    int first_samples;    // of the first round; 0: there is only one round
    std::size_t next = 0; // step of the round; 0: the pixel without its lights
    PixelTerms terms{};
    std::optional<ProbedPixel> pixel{}; // one at a time: each renderer has targets of its own

    bool is_tinted() const {
        return scene.visibility_backend() && scene.visibility_backend()->casters().is_tinted();
    }
    std::size_t kind_count() const { return is_tinted() ? term_kinds.size() : term_kinds.size() - 1; }
    std::size_t end() const { return 1 + kind_count() * terms.lights.size(); }
    int samples() const {
        return first_samples > 0 ? std::min(first_samples, options.samples) : options.samples;
    }

    void step();

private:
    void take_pixel();
    void take_term(const TermKind& kind, std::size_t light);
};

/// x, n and wo at the centre, and the whole pixel with and without lights.
void Probing::Run::take_pixel() {
    RenderOptions centre = options;
    centre.samples = 1;
    centre.background = vec3(0.0f);
    const auto at_centre = [&](const char* shader) {
        return vec3(ProbedPixel(scene, camera, centre, shader, column, row).mean(1, 0, 0));
    };
    terms.x = at_centre("views/position.frag");
    terms.n = at_centre("views/normal.frag");
    terms.wo = at_centre("views/to_viewer.frag");
    ProbedPixel beauty(scene, camera, options, "forward.frag", column, row);
    const vec4 L_o = beauty.mean(samples(), 0, scene.light_count());
    terms.L_o = vec3(L_o);
    terms.coverage = L_o.w;
    terms.L_e = vec3(beauty.mean(samples(), 0, 0));
}

void Probing::Run::take_term(const TermKind& kind, std::size_t light) {
    if (light == 0) {
        pixel.reset();
        pixel.emplace(scene, camera, options, kind.shader, column, row);
    }
    const int k = static_cast<int>(light);
    kind.take(terms, terms.lights[light], pixel->mean(samples(), k, k + 1));
}

void Probing::Run::step() {
    const std::size_t lights = terms.lights.size();
    if (next == 0)
        take_pixel();
    else
        take_term(term_kinds[(next - 1) / lights], (next - 1) % lights);
    if (++next < end()) return;
    pixel.reset();
    if (std::exchange(first_samples, 0) > 0) next = 0;
}

Probing::Probing(const GpuScene& scene, const scene::Camera& camera, const RenderOptions& options, int column,
                 int row, int first_samples)
    : run_(new Run{scene, camera, options, column, row, first_samples}) {
    require(column >= 0 && column < options.width && row >= 0 && row < options.height,
            "the pixel is in the picture");
    run_->terms.lights.resize(static_cast<std::size_t>(scene.light_count()));
}

Probing::~Probing() = default;

void Probing::step() { run_->step(); }
bool Probing::is_done() const { return run_->first_samples == 0 && run_->next == run_->end(); }
bool Probing::is_first_round() const { return run_->first_samples > 0; }
bool Probing::has(Kind kind) const {
    return !is_first_round() || run_->next > (static_cast<std::size_t>(kind) + 1) * run_->terms.lights.size();
}
const PixelTerms& Probing::terms() const { return run_->terms; }

std::optional<PixelTerms> probe(const GpuScene& scene, const scene::Camera& camera,
                                const RenderOptions& options, int column, int row,
                                const std::stop_token& stop) {
    Probing probing(scene, camera, options, column, row);
    while (!probing.is_done() && !stop.stop_requested()) probing.step();
    return stop.stop_requested() ? std::nullopt : std::optional(probing.terms());
}

namespace {

/// Triangle with the draw that it belongs to.
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
          target_("f_r", width, height_, Depths::none) {
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

std::optional<PixelBrdf> evaluate_brdf(const GpuScene& scene, const scene::Camera& camera,
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
    const RenderTarget frame("seen", options.width, options.height, Depths::plain);
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
