#include "viewer/stopping.hpp"

namespace sr::viewer {

void Stopping::begin() {
    convergence_ = render::Convergence(rule_.error.value_or(0.0));
    spent_ = 0.0;
    looked_at_ = 0;
    is_done_ = false;
}

bool Stopping::took_sample(render::Renderer& renderer, double seconds) {
    spent_ += seconds;
    if (renderer.knows_error() && render::is_time_to_look(renderer.sample_count())) look(renderer);
    is_done_ = is_enough(renderer, seconds);
    if (is_done_ && renderer.knows_error() && renderer.sample_count() >= 2
        && looked_at_ != renderer.sample_count())
        look(renderer);
    return looked_at_ == renderer.sample_count() && renderer.resting().any(renderer.sample_count());
}

bool Stopping::is_enough(const render::Renderer& renderer, double seconds) const {
    if (renderer.sample_count() >= rule_.samples) return true;
    if (rule_.error && (convergence_.is_reached() || renderer.all_rest())) return true;
    return rule_.seconds && spent_ + seconds > *rule_.seconds;
}

void Stopping::look(render::Renderer& renderer) {
    convergence_.look(renderer);
    looked_at_ = renderer.sample_count();
}

std::optional<double> Stopping::error() const {
    const auto& seen = convergence_.seen();
    return seen ? std::optional(seen->error) : std::nullopt;
}

} // namespace sr::viewer
