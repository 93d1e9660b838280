#include "render/ray_answers.hpp"

#include "core/error.hpp"
#include "render/passes.hpp"

#include <algorithm>
#include <atomic>
#include <chrono>
#include <fmt/format.h>
#include <thread>

namespace sr::render {
namespace {

constexpr int most_rays = 7;                                  // rays_a_pass of shaders/interface/rays.glsl
constexpr std::size_t target_memory = std::size_t{512} << 20; // [bytes] that may go into targets …
constexpr std::size_t most_answers = std::size_t{64} << 20;   // … and numbers into answers

/// Calls work(row) for all rows, on all cores.
template<class Work>
void for_each_row(int rows, const Work& work) {
    std::atomic<int> next = 0;
    const auto run = [&] {
        for (int row = next++; row < rows; row = next++) work(row);
    };
    std::vector<std::jthread> threads;
    const int count = std::min(rows, static_cast<int>(std::thread::hardware_concurrency()));
    for (int i = 1; i < count; ++i) threads.emplace_back(run);
    run();
}

int rays_that_fit(int width, int height, int wanted) {
    const std::size_t target =
        static_cast<std::size_t>(width) * static_cast<std::size_t>(height) * sizeof(vec4);
    const int fitting = static_cast<int>(std::min<std::size_t>(most_rays, target_memory / target));
    return std::clamp(std::min(fitting - 1, wanted), 1, most_rays);
}

gl::Texture attached(int index, int width, int height) {
    gl::Texture texture(GL_TEXTURE_2D, index == 0 ? "receivers" : "rays");
    glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA32F, width, height, 0, GL_RGBA, GL_FLOAT, nullptr);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAX_LEVEL, 0);
    glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0 + static_cast<GLenum>(index), GL_TEXTURE_2D,
                           texture.id(), 0);
    return texture;
}

} // namespace

RayAnswers::RayAnswers(const GpuScene& scene, const Target& frame, int width, int height)
    : scene_(scene), width_(width), height_(height), rays_per_light_(scene.rays_per_light()) {
    glBindFramebuffer(GL_FRAMEBUFFER, framebuffer_.id());
    const int rays = rays_that_fit(width, height, scene.light_count() * rays_per_light_);
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

std::vector<Band> RayAnswers::bands(Band all, int light_count) const {
    const std::size_t per_row = static_cast<std::size_t>(width_)
                                * static_cast<std::size_t>(std::max(light_count, 1))
                                * static_cast<std::size_t>(rays_per_light_);
    const std::size_t most = std::min(BufferTexture::most_texels(), most_answers);
    const int rows =
        static_cast<int>(std::min<std::size_t>(static_cast<std::size_t>(all.count), most / per_row));
    if (rows == 0)
        throw Error(
            fmt::format("{} rays to a row of {} pixels are more than fit into memory", per_row, width_),
            "choose a smaller --size, or --visibility ray-glsl");
    std::vector<Band> bands;
    for (int first = 0; first < all.count; first += rows)
        bands.push_back({all.first + first, std::min(rows, all.count - first)});
    return bands;
}

void RayAnswers::find(Band band, int first_light, int end_light, FrameData& frame_data,
                      ShaderLibrary& shaders) {
    const auto plane = static_cast<std::size_t>(width_) * static_cast<std::size_t>(band.count);
    const int planes = (end_light - first_light) * rays_per_light_;
    values_.resize(plane * static_cast<std::size_t>(planes));
    const int rays_a_pass = static_cast<int>(targets_.size()) - 1;
    const int lights_a_pass = std::max(1, rays_a_pass / rays_per_light_);
    for (int first = 0; first < planes; first += std::min(rays_a_pass, lights_a_pass * rays_per_light_)) {
        const int count = std::min({rays_a_pass, lights_a_pass * rays_per_light_, planes - first});
        const int light = first_light + first / rays_per_light_;
        upload_block({first_light * rays_per_light_ + first, 0, 0, 0});
        frame_data.select_lights(light, std::min(end_light, light + lights_a_pass));
        glBindFramebuffer(GL_FRAMEBUFFER, framebuffer_.id());
        glViewport(0, 0, width_, height_);
        record_pass(scene_, shaders, count + 1);
        if (first == 0) read_receivers(band);
        for (int i = 0; i < count; ++i) {
            read_rays(band, i + 1);
            answer_plane(band, first_light + (first + i) / rays_per_light_,
                         std::span(values_).subspan(plane * static_cast<std::size_t>(first + i), plane));
        }
    }
    answers_.upload(values_, "choose a smaller --size");
    answers_.bind(answers_unit);
    upload_block({first_light * rays_per_light_, static_cast<std::int32_t>(plane), width_, band.first});
    frame_data.select_lights(first_light, end_light);
}

void RayAnswers::read_receivers(Band band) {
    receivers_.resize(static_cast<std::size_t>(width_) * static_cast<std::size_t>(band.count));
    glReadBuffer(GL_COLOR_ATTACHMENT0);
    glReadPixels(0, band.first, width_, band.count, GL_RGBA, GL_FLOAT, receivers_.data());
}

void RayAnswers::read_rays(Band band, int attachment) {
    rays_.resize(receivers_.size());
    glReadBuffer(GL_COLOR_ATTACHMENT0 + static_cast<GLenum>(attachment));
    glReadPixels(0, band.first, width_, band.count, GL_RGBA, GL_FLOAT, rays_.data());
}

void RayAnswers::answer_plane(Band band, int light, std::span<float> plane) {
    const auto begin = std::chrono::steady_clock::now();
    std::atomic<std::size_t> asked = 0;
    const auto columns = static_cast<std::size_t>(width_);
    for_each_row(band.count, [&](int row) {
        const std::size_t first = columns * static_cast<std::size_t>(row);
        std::vector<shadow::Query> queries;
        std::vector<std::size_t> pixels;
        for (std::size_t pixel = first; pixel < first + columns; ++pixel) {
            const vec4 ray = rays_[pixel];
            plane[pixel] = 0.0f;
            if (!(ray.w > 0.0f)) continue;
            const vec4 receiver = receivers_[pixel];
            queries.push_back(
                {vec3(receiver), static_cast<std::uint32_t>(receiver.w), vec3(ray), ray.w, light});
            pixels.push_back(pixel);
        }
        std::vector<float> V(queries.size());
        scene_.occluders()->occlusion()->answer(queries, V);
        for (std::size_t i = 0; i < V.size(); ++i) plane[pixels[i]] = V[i];
        asked += V.size();
    });
    ray_count_ += asked;
    seconds_ += std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
}

void RayAnswers::upload_block(const RaysBlock& block) {
    glBindBuffer(GL_UNIFORM_BUFFER, block_.id());
    glBufferData(GL_UNIFORM_BUFFER, sizeof(block), &block, GL_STREAM_DRAW);
    glBindBufferBase(GL_UNIFORM_BUFFER, rays_block, block_.id());
}

} // namespace sr::render
