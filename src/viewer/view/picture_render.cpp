#include "viewer/view/picture_render.hpp"

#include "viewer/view/turns.hpp"

#include <algorithm>
#include <chrono>

namespace sr::viewer {

PictureRender::PictureRender(const render::GpuScene& scene, const scene::Camera& camera,
                             const render::RenderOptions& options, const render::StopRule& rule, double guess)
    : renderer_(scene, camera, options), monitor_(rule), expected_(std::max(guess, 1e-3)) {
    renderer_.compile();
}

void PictureRender::look_from(const scene::Camera& camera) {
    renderer_.look_from(camera);
    monitor_.restart();
    spent_ = 0.0;
    rows_ = 0;
}

void PictureRender::advance() {
    using Clock = std::chrono::steady_clock;
    const int height = renderer_.height();
    double taken = 0.0;
    while (!is_done() && taken < turn_budget) {
        const int rows = rows_of_turn(height, expected_, turn_budget - taken);
        const auto begin = Clock::now();
        const bool is_complete = renderer_.add_rows(rows);
        glFinish(); // so that the GPU's time counts
        const double seconds = std::chrono::duration<double>(Clock::now() - begin).count();
        taken += seconds;
        spent_ += seconds;
        rows_ += rows;
        expected_ = spent_ * height / std::min(rows_, height);
        if (!is_complete) continue;
        monitor_.took_sample(renderer_, spent_);
        spent_ = 0.0;
        rows_ = 0;
    }
}

double PictureRender::progress() const {
    return renderer_.sample_count() + 1.0 * std::min(rows_, renderer_.height()) / renderer_.height();
}

} // namespace sr::viewer
