#include "render/visibility/cpu_shadow_rays.hpp"

#include "core/error.hpp"
#include "core/parallel.hpp"
#include "glsl/untrusted.hpp"
#include "render/passes.hpp"

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cmath>
#include <fmt/format.h>
#include <limits>

namespace sr::render {
namespace {

constexpr int rays_a_pass = 7; // Keep in sync with shaders/interface/rays.glsl.
// Most pixels have rays to a third of the lights. The more lights at once, the fewer passes read the
// surfaces; but pixels that do have more rays sample all of these lights again in every pass.
constexpr int lights_a_pass = 16;
constexpr std::size_t target_memory = std::size_t{512} << 20; // [bytes] that may go into targets

int rays_that_fit(int width, int height, int wanted) {
    const std::size_t target =
        static_cast<std::size_t>(width) * static_cast<std::size_t>(height) * sizeof(vec4);
    const int fitting = static_cast<int>(std::min<std::size_t>(rays_a_pass, target_memory / target));
    return std::clamp(std::min(fitting - 1, wanted), 1, rays_a_pass);
}

bool is_finite(vec4 v) { return std::isfinite(v.x + v.y + v.z); }

gl::Texture float_texture(const char* name, int width, int height) {
    gl::Texture texture(GL_TEXTURE_2D, name);
    glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA32F, width, height, 0, GL_RGBA, GL_FLOAT, nullptr);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAX_LEVEL, 0);
    return texture;
}

gl::Texture attached(int index, int width, int height) {
    gl::Texture texture = float_texture(index == 0 ? "receivers" : "rays", width, height);
    glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0 + static_cast<GLenum>(index), GL_TEXTURE_2D,
                           texture.id(), 0);
    return texture;
}

} // namespace

CpuShadowRays::CpuShadowRays(const GpuScene& scene, const RenderTarget& frame, int width, int height,
                             std::size_t max_rays, int light_choices)
    : scene_(scene),
      width_(width),
      height_(height),
      chooses_(light_choices > 0),
      rays_per_light_(chooses_ ? light_choices + 1 : scene.rays_per_light()),
      max_rays_(max_rays),
      last_rays_(float_texture("last rays", width, height)) {
    glBindFramebuffer(GL_FRAMEBUFFER, framebuffer_.id());
    const int rays = rays_that_fit(width, height, rays_to(scene.light_count()));
    std::vector<GLenum> attachments;
    for (int i = 0; i <= rays; ++i) {
        targets_.push_back(attached(i, width, height));
        attachments.push_back(GL_COLOR_ATTACHMENT0 + static_cast<GLenum>(i));
    }
    glFramebufferTexture2D(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_TEXTURE_2D, frame.depth().id(), 0);
    glDrawBuffers(static_cast<GLsizei>(attachments.size()), attachments.data());
    if (glCheckFramebufferStatus(GL_FRAMEBUFFER) != GL_FRAMEBUFFER_COMPLETE
        || glGetError() == GL_OUT_OF_MEMORY)
        throw Error(fmt::format("the driver refuses {} float pictures of {}×{} pixels for rays", rays + 1,
                                width, height),
                    "choose a smaller --size, or --visibility ray-glsl");
}

std::vector<RowRange> CpuShadowRays::divide(RowRange all, int light_count) const {
    const std::size_t per_row =
        static_cast<std::size_t>(width_) * static_cast<std::size_t>(rays_to(std::max(light_count, 1)));
    const std::size_t most = std::min(BufferTexture::max_texels(), max_rays_ / channels());
    const int rows =
        static_cast<int>(std::min<std::size_t>(static_cast<std::size_t>(all.count), most / per_row));
    if (rows == 0)
        throw Error(
            fmt::format("{} rays to a row of {} pixels are more than fit into memory", per_row, width_),
            "choose a smaller --size, or --visibility ray-glsl");
    std::vector<RowRange> bands;
    for (int first = 0; first < all.count; first += rows)
        bands.push_back({all.first + first, std::min(rows, all.count - first)});
    return bands;
}

void CpuShadowRays::find(RowRange band, int first_light, int end_light, FrameData& frame_data,
                         ShaderLibrary& shaders) {
    planes_ = {chooses_ ? 0 : first_light * rays_per_light_,
               static_cast<std::size_t>(width_) * static_cast<std::size_t>(band.count)};
    const int light_count = end_light - first_light;
    values_.assign(planes_.size * static_cast<std::size_t>(rays_to(light_count)) * channels(), 0.0f);
    const int step = chooses_ ? light_count : lights_a_pass;
    for (int first = first_light; first < end_light; first += step) {
        const int end = std::min(end_light, first + step);
        frame_data.select_lights(first, end);
        const int most = rays_to(end - first);
        const int rays_a_pass = static_cast<int>(targets_.size()) - 1;
        int taken = 0;
        while (taken < most && record_and_answer(band, taken, shaders)) taken += rays_a_pass;
    }
    upload_answers();
    upload_block({planes_.first_ray, static_cast<std::int32_t>(planes_.size), width_, band.first});
    frame_data.select_lights(first_light, end_light);
}

bool CpuShadowRays::record_and_answer(RowRange band, int taken, ShaderLibrary& shaders) {
    upload_block({taken, 0, 0, 0});
    glBindFramebuffer(GL_FRAMEBUFFER, framebuffer_.id());
    glViewport(0, 0, width_, height_);
    record_pass(scene_, shaders, static_cast<int>(targets_.size()), chooses_ ? rays_per_light_ - 1 : 0);
    read(band, 0, receivers_);
    glsl::require_ended_loops({&receivers_[0].x, 4 * receivers_.size()}, shaders.loops());
    std::size_t asked = 0;
    for (int i = 1; i < static_cast<int>(targets_.size()); ++i) {
        read(band, i, rays_);
        asked = answer(band);
        if (asked == 0) return false; // a pixel without this ray has none of the later ones
    }
    last_rays_.bind(last_rays_unit); // the read buffer is still the last target
    glCopyTexSubImage2D(GL_TEXTURE_2D, 0, 0, band.first, 0, band.first, width_, band.count);
    return true;
}

void CpuShadowRays::read(RowRange band, int attachment, std::vector<vec4>& texels) {
    texels.resize(planes_.size);
    glReadBuffer(GL_COLOR_ATTACHMENT0 + static_cast<GLenum>(attachment));
    glReadPixels(0, band.first, width_, band.count, GL_RGBA, GL_FLOAT, texels.data());
}

std::size_t CpuShadowRays::answer(RowRange band) {
    const auto begin = std::chrono::steady_clock::now();
    // A thread costs about as much as some hundred rays.
    constexpr int pixels_per_thread = 1024;
    std::atomic<std::size_t> asked = 0;
    for_each_row(
        band.count,
        [&](int row) {
            const std::size_t first = static_cast<std::size_t>(width_) * static_cast<std::size_t>(row);
            asked += answer_row(first, first + static_cast<std::size_t>(width_));
        },
        1 + width_ * band.count / pixels_per_thread);
    traced_.count += asked;
    traced_.seconds += std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
    return asked;
}

std::size_t CpuShadowRays::answer_row(std::size_t first, std::size_t end) {
    std::vector<shadow::Query> queries;
    std::vector<std::size_t> places;
    std::size_t broken = 0;
    for (std::size_t pixel = first; pixel < end; ++pixel) {
        const vec4 ray = rays_[pixel];
        if (ray.w == 0.0f) continue;
        const vec4 receiver = receivers_[pixel];
        const RecordedRay recorded{ray};
        const int number = recorded.number();
        const int plane = chooses_ ? number % rays_per_light_ : number - planes_.first_ray;
        const std::size_t place = static_cast<std::size_t>(plane) * planes_.size + pixel;
        if (!recorded.is_finite()
            || !is_finite(receiver)) { // a user's shader may write this, Embree must not get it
            std::fill_n(&values_[place * channels()], channels(), std::numeric_limits<float>::quiet_NaN());
            ++broken;
            continue;
        }
        queries.push_back(
            recorded.query(vec3(receiver), static_cast<int>(receiver.w), number / rays_per_light_));
        places.push_back(place);
    }
    std::vector<vec3> V(queries.size());
    scene_.visibility_backend()->occlusion()->answer(queries, V);
    for (std::size_t i = 0; i < V.size(); ++i)
        std::copy_n(&V[i].x, channels(), &values_[places[i] * channels()]);
    return V.size() + broken;
}

void CpuShadowRays::upload_answers() {
    BufferTexture& answers = channels() == 1 ? answers_ : tinted_answers_;
    answers.upload(values_, "choose a smaller --size");
    answers.bind(ray_visibility_unit);
}

std::size_t CpuShadowRays::channels() const {
    return scene_.visibility_backend()->casters().is_tinted() ? 3 : 1;
}

void CpuShadowRays::upload_block(const RaysBlock& block) {
    glBindBuffer(GL_UNIFORM_BUFFER, block_.id());
    glBufferData(GL_UNIFORM_BUFFER, sizeof(block), &block, GL_STREAM_DRAW);
    glBindBufferBase(GL_UNIFORM_BUFFER, rays_block, block_.id());
}

} // namespace sr::render
