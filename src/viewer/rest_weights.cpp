#include "viewer/rest_weights.hpp"

#include <limits>

namespace sr::viewer {

void RestWeights::take(const render::Resting& resting, int width, int height) {
    constexpr int endless = std::numeric_limits<int>::max();
    std::vector<float> weights(static_cast<std::size_t>(width) * static_cast<std::size_t>(height));
    for (int y = 0; y < height; ++y) {
        const std::size_t first = static_cast<std::size_t>(y) * static_cast<std::size_t>(width);
        const std::size_t row = static_cast<std::size_t>(height - 1 - y) * static_cast<std::size_t>(width);
        for (std::size_t x = 0; x < static_cast<std::size_t>(width); ++x) {
            const int samples = resting.samples_of(first + x, endless);
            weights[row + x] = samples == endless ? 0.0f : 1.0f / static_cast<float>(samples);
        }
    }
    texture_.emplace(GL_TEXTURE_2D, "weights of pixels that rest");
    glTexImage2D(GL_TEXTURE_2D, 0, GL_R32F, width, height, 0, GL_RED, GL_FLOAT, weights.data());
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAX_LEVEL, 0);
}

} // namespace sr::viewer
