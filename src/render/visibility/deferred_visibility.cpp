#include "render/visibility/deferred_visibility.hpp"

#include "core/error.hpp"
#include "core/parallel.hpp"
#include "gl/context.hpp"

#include <algorithm>
#include <array>
#include <atomic>
#include <bit>
#include <chrono>
#include <cmath>
#include <fmt/format.h>
#include <limits>
#include <span>

namespace sr::render {
namespace {

// Keep in sync with shaders/interface/deferred.glsl.
constexpr std::size_t count_words = 2, receiver_words = 4, sample_words = 8;

constexpr float max_radiance = 1e30f; // [cd/m²]; keep in sync with shaders/integrator/bounded.glsl

constexpr int most_lights_at_once = 16; // more of them shade the surfaces again

// Bytes of the samples of a band. Each band draws the scene again: eight take 1.5 % more of DamagedHelmet's
// time than four.
constexpr std::size_t fewest_bytes = std::size_t{16} << 20, most_bytes = std::size_t{128} << 20;

/// The words of a band, if those of a frame are so many.
std::size_t words_of_band(std::size_t words_of_frame) {
    GLint most = 0;
    glGetIntegerv(GL_MAX_SHADER_STORAGE_BLOCK_SIZE, &most);
    const std::size_t bytes = std::clamp(words_of_frame * sizeof(std::int32_t) / 5, fewest_bytes, most_bytes);
    return std::min(static_cast<std::size_t>(most), bytes) / sizeof(std::int32_t);
}

vec3 floats(const std::int32_t* words) {
    return {std::bit_cast<float>(words[0]), std::bit_cast<float>(words[1]), std::bit_cast<float>(words[2])};
}

/// Samples that wait for their V, as many as are traced at once.
struct Waiting {
    std::array<shadow::Query, shadow::Occlusion::packet> queries;
    std::array<vec3, shadow::Occlusion::packet> L;     // of each query: the sample without V
    std::array<float*, shadow::Occlusion::packet> L_r; // the sum of its pixel
    std::size_t count = 0;

    void add_seen(const shadow::Occlusion& occlusion) {
        std::array<vec3, shadow::Occlusion::packet> V;
        occlusion.answer(std::span(queries).first(count), std::span(V).first(count));
        for (std::size_t i = 0; i < count; ++i) {
            const vec3 seen = L[i] * V[i];
            for (int channel = 0; channel < 3; ++channel)
                L_r[i][channel] += std::min(seen[channel], max_radiance); // NaN stays NaN
        }
        count = 0;
    }
};

} // namespace

bool DeferredVisibility::is_offered() {
    if (!GLAD_GL_ARB_shader_storage_buffer_object || !GLAD_GL_ARB_shader_image_load_store) return false;
    GLint blocks = 0;
    glGetIntegerv(GL_MAX_FRAGMENT_SHADER_STORAGE_BLOCKS, &blocks);
    return blocks > 0 && gl::is_software_renderer(reinterpret_cast<const char*>(glGetString(GL_RENDERER)));
}

DeferredVisibility::DeferredVisibility(const GpuScene& scene, int width, int height, std::size_t max_rays,
                                       int light_choices)
    : scene_(scene),
      width_(width),
      light_choices_(light_choices),
      lights_at_once_(light_choices > 0 ? scene.light_count()
                                        : std::clamp(scene.light_count(), 1, most_lights_at_once)),
      most_rays_(light_choices > 0 ? light_choices + 1 : std::max(1, scene.most_rays(lights_at_once_))) {
    const auto row = static_cast<std::size_t>(width);
    const std::size_t words_of_row = row * (count_words + pixel_words());
    const std::size_t words = words_of_band(words_of_row * static_cast<std::size_t>(height));
    const std::size_t rows = std::min({BufferTexture::max_texels() / row, words / words_of_row,
                                       max_rays / (row * static_cast<std::size_t>(most_rays_))});
    if (rows == 0)
        throw Error(
            fmt::format("the samples of a row of {} pixels take more memory than the driver gives", width),
            "choose a smaller --size, or --visibility ray-glsl");
    rows_at_once_ = std::min(height, static_cast<int>(std::min<std::size_t>(rows, 1u << 30)));
    const auto plane = static_cast<std::size_t>(width) * static_cast<std::size_t>(rows_at_once_);
    const std::vector<std::int32_t> no_samples(count_words * plane, 0);
    glBindBuffer(GL_SHADER_STORAGE_BUFFER, samples_.id());
    glBufferData(GL_SHADER_STORAGE_BUFFER,
                 static_cast<GLsizeiptr>(plane * (count_words + pixel_words()) * sizeof(std::int32_t)),
                 nullptr, GL_STREAM_READ);
    glBufferSubData(GL_SHADER_STORAGE_BUFFER, 0,
                    static_cast<GLsizeiptr>(no_samples.size() * sizeof(std::int32_t)), no_samples.data());
}

std::size_t DeferredVisibility::pixel_words() const {
    return receiver_words + sample_words * static_cast<std::size_t>(most_rays_);
}

void DeferredVisibility::compile(ShaderLibrary& shaders, bool has_triangles) const {
    for (const Draw& draw : scene_.opaque_draws())
        compile_shading(shaders, draw, "deferred.frag", terms(), has_triangles);
    shaders.fullscreen_program("deferred_sum.frag");
}

void DeferredVisibility::shade(const RenderTarget& frame, const TriangleBuffer* triangles,
                               const PixelRect& window, int first_light, int end_light, FrameData& frame_data,
                               ShaderLibrary& shaders, PixelSums& sums, Writing writing) {
    const int first_row = frame.height() - window.row - window.height; // GL counts rows from below
    glEnable(GL_SCISSOR_TEST);
    for (int row = 0; row < window.height; row += rows_at_once_) {
        const RowRange band{first_row + row, std::min(rows_at_once_, window.height - row)};
        glScissor(window.column, band.first, window.width, band.count);
        const RaysBlock block{0, width_ * rows_at_once_, width_, band.first, most_rays_};
        glBindBuffer(GL_UNIFORM_BUFFER, block_.id());
        glBufferData(GL_UNIFORM_BUFFER, sizeof(block), &block, GL_STREAM_DRAW);
        glBindBufferBase(GL_UNIFORM_BUFFER, rays_block, block_.id());
        glBindBufferBase(GL_SHADER_STORAGE_BUFFER, 0, samples_.id());
        for (int first = first_light; first < end_light; first += lights_at_once_) {
            frame_data.select_lights(first, std::min(end_light, first + lights_at_once_));
            forward_pass(frame, scene_, shaders, "deferred.frag", terms(), triangles, writing);
            add_seen(band, sums);
        }
    }
    glDisable(GL_SCISSOR_TEST);
    frame_data.select_lights(first_light, end_light);
}

/// Adds L V of the samples of the band, and forgets the samples.
void DeferredVisibility::add_seen(RowRange band, PixelSums& sums) {
    const auto plane = static_cast<std::size_t>(width_) * static_cast<std::size_t>(rows_at_once_);
    glMemoryBarrier(GL_BUFFER_UPDATE_BARRIER_BIT);
    glBindBuffer(GL_COPY_READ_BUFFER, samples_.id());
    const auto bytes = static_cast<GLsizeiptr>(plane * (count_words + pixel_words()) * sizeof(std::int32_t));
    auto* words = static_cast<std::int32_t*>(
        glMapBufferRange(GL_COPY_READ_BUFFER, 0, bytes, GL_MAP_READ_BIT | GL_MAP_WRITE_BIT));
    if (!words) throw Error("the driver does not show the samples of a frame", "choose a smaller --size");
    const auto begin = std::chrono::steady_clock::now();
    constexpr int pixels_per_thread = 1024; // a thread costs about as much as some hundred rays
    std::atomic<std::size_t> rays = 0;
    for_each_row(
        band.count,
        [&](int row) {
            rays += add_seen_of_row(words, static_cast<std::size_t>(width_) * static_cast<std::size_t>(row),
                                    plane, sums.row(band.first + row));
        },
        1 + width_ * band.count / pixels_per_thread);
    traced_.count += rays;
    traced_.seconds += std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
    glUnmapBuffer(GL_COPY_READ_BUFFER);
}

/// `first`: the row's first pixel; `plane`: the pixels of the block; `sums`: of the row. @return the number
/// of rays
std::size_t DeferredVisibility::add_seen_of_row(std::int32_t* words, std::size_t first, std::size_t plane,
                                                std::span<float> sums) const {
    const shadow::Occlusion& occlusion = *scene_.visibility_backend()->occlusion();
    Waiting waiting;
    std::size_t rays = 0;
    for (std::size_t pixel = first; pixel < first + static_cast<std::size_t>(width_); ++pixel) {
        const int count = words[count_words * pixel];
        if (count == 0) continue;
        words[count_words * pixel] = 0;
        float* const L_r = &sums[3 * (pixel - first)];
        const std::int32_t* receiver = words + count_words * plane + pixel * pixel_words();
        const vec3 x = floats(receiver);
        for (int i = 0; i < count; ++i) {
            const std::int32_t* sample =
                receiver + receiver_words + static_cast<std::size_t>(i) * sample_words;
            const RecordedRay ray{vec4(floats(sample), std::bit_cast<float>(sample[3]))};
            if (!ray.is_finite() || !std::isfinite(x.x + x.y + x.z)) { // Embree must not get it
                *L_r = std::numeric_limits<float>::quiet_NaN();
                continue;
            }
            waiting.queries[waiting.count] = ray.query(x, receiver[3], ray.number());
            waiting.L[waiting.count] = floats(sample + 4);
            waiting.L_r[waiting.count] = L_r;
            ++rays;
            if (++waiting.count == shadow::Occlusion::packet) waiting.add_seen(occlusion);
        }
    }
    waiting.add_seen(occlusion);
    return rays;
}

} // namespace sr::render
