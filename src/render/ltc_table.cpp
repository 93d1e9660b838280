#include "render/ltc_table.hpp"

#include "core/math.hpp"

#include <array>
#include <vector>

namespace sr::render {
namespace {

constexpr std::array<float, ltc_grid * ltc_grid * ltc_numbers> table{
#include "lut/ggx_ltc.inc"
};

} // namespace

std::span<const float> ltc_table() { return table; }

gl::Texture upload_ltc_table() {
    constexpr std::size_t entries = ltc_grid * ltc_grid;
    std::vector<vec4> texels(2 * entries);
    for (std::size_t i = 0; i < entries; ++i) {
        const float* entry = &table[i * ltc_numbers];
        texels[i] = vec4(entry[0], entry[1], entry[2], entry[3]);
        texels[entries + i] = vec4(entry[4], 0.0f, 0.0f, 0.0f);
    }
    gl::Texture texture(GL_TEXTURE_2D, "GGX as linearly transformed cosines");
    texture.bind(0);
    glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA32F, ltc_grid, 2 * ltc_grid, 0, GL_RGBA, GL_FLOAT, texels.data());
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
    return texture;
}

} // namespace sr::render
