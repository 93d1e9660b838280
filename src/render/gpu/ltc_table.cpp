#include "render/gpu/ltc_table.hpp"

#include "core/math.hpp"

#include <array>
#include <vector>

namespace sr::render {
namespace {

constexpr std::array<float, ltc_grid * ltc_grid * ltc_numbers> ltc_values{
#include "lut/ggx_ltc.inc"
};

constexpr int sheen_grid = 64;
constexpr std::array<float, sheen_grid * sheen_grid> sheen_albedo{
#include "lut/charlie_albedo.inc"
};

/// 1 - E_avg of a row: 2 ∫ (1 - E) cosθ dcosθ = 4 ∫ (1 - E) s³ ds over s = √cosθ, exact for what is linear
/// between the entries, as the shaders read them.
float mean_loss(const float* row) {
    double sum = 0.0;
    for (int i = 0; i + 1 < ltc_grid; ++i) {
        const double s0 = i / (ltc_grid - 1.0), s1 = (i + 1) / (ltc_grid - 1.0);
        const double f0 = 1.0 - row[i * ltc_numbers + 3], f1 = 1.0 - row[(i + 1) * ltc_numbers + 3];
        const double slope = (f1 - f0) / (s1 - s0), base = f0 - slope * s0;
        const auto integral = [&](double s) { return s * s * s * s * (base + 0.8 * slope * s); };
        sum += integral(s1) - integral(s0);
    }
    return static_cast<float>(sum);
}

} // namespace

std::span<const float> ltc_table() { return ltc_values; }

gl::Texture upload_ltc_table() {
    constexpr std::size_t width = sheen_grid, height = 2 * ltc_grid + sheen_grid;
    std::vector<vec4> texels(width * height);
    for (std::size_t y = 0; y < ltc_grid; ++y) {
        const float* row = &ltc_values[y * ltc_grid * ltc_numbers];
        const float loss = mean_loss(row);
        for (std::size_t x = 0; x < ltc_grid; ++x) {
            const float* entry = row + x * ltc_numbers;
            texels[y * width + x] = vec4(entry[0], entry[1], entry[2], entry[3]);
            texels[(y + ltc_grid) * width + x] = vec4(entry[4], 0.0f, loss, 0.0f);
        }
    }
    for (std::size_t i = 0; i < sheen_albedo.size(); ++i)
        texels[2 * ltc_grid * width + i] = vec4(sheen_albedo[i], 0.0f, 0.0f, 0.0f);
    gl::Texture texture(GL_TEXTURE_2D, "GGX as linearly transformed cosines");
    texture.bind(0);
    glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA32F, width, height, 0, GL_RGBA, GL_FLOAT, texels.data());
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
    return texture;
}

} // namespace sr::render
