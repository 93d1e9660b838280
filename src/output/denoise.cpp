#include "output/denoise.hpp"

#include "core/error.hpp"
#include "core/math.hpp"
#include "core/parallel.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <span>
#include <vector>

namespace sr::output {
namespace {

constexpr int passes = 5;
constexpr int radius = 2;
constexpr std::array spline{0.375f, 0.25f, 0.0625f}; // B3, Dammertz 2010, section 3.1
constexpr float noise_widths = 2.0f;                 // σ_l of Schied 2017, section 4.4

/// Normal, depth and object of each pixel, by which the filter distinguishes surfaces.
struct Guides {
    image::Image normals;       // n in the first three channels, not necessarily unit
    std::vector<float> depths;  // along the camera's axis [m]
    std::vector<float> objects; // their numbers
};

/// Surfaces of the picture: tells how much the pixels around a pixel lie on the same surface.
class Surfaces {
public:
    explicit Surfaces(const Guides& guides)
        : guides_(guides), width_(guides.normals.width), height_(guides.normals.height) {
        for (int y = 0; y < height_; ++y) {
            for (int x = 0; x < width_; ++x) {
                const auto n = guides.normals.at(x, y);
                normals_.push_back(glm::normalize(vec3(n[0], n[1], n[2])));
                pure_.push_back(is_alone(x, y) && glm::length(vec3(n[0], n[1], n[2])) > straightest);
                slopes_.emplace_back(slope(x, y, 1, 0), slope(x, y, 0, 1));
            }
        }
    }

    /// True if all of the pixel lies on one surface, as far as its surroundings and its normal's length tell.
    /// A pixel that two surfaces share has no V of its own.
    bool is_pure(int x, int y) const { return pure_[index(x, y)]; }

    /// 0 to 1, of the pixel (x + dx, y + dy) for (x, y).
    float likeness(int x, int y, int dx, int dy) const {
        const std::size_t p = index(x, y), q = index(x + dx, y + dy);
        if (p == q) return 1.0f;
        if (guides_.objects[p] != guides_.objects[q] || !pure_[q]) return 0.0f;
        const float cosine = glm::dot(normals_[p], normals_[q]);
        if (!(cosine > 0.0f)) return 0.0f;
        constexpr float normal_power = 128.0f; // σ_n of Schied 2017, section 4.4
        const float expected =
            std::abs(slopes_[p].x * static_cast<float>(dx) + slopes_[p].y * static_cast<float>(dy));
        constexpr float roughness = 1e-3f; // of depth itself: what no plane's slope tells
        const float off = std::abs(guides_.depths[q] - guides_.depths[p]);
        return std::pow(cosine, normal_power) * std::exp(-off / (expected + roughness * guides_.depths[p]));
    }

private:
    std::size_t index(int x, int y) const {
        return static_cast<std::size_t>(y) * static_cast<std::size_t>(width_) + static_cast<std::size_t>(x);
    }

    bool is_alone(int x, int y) const {
        const float object = guides_.objects[index(x, y)];
        for (int j = std::max(y - 1, 0); j <= std::min(y + 1, height_ - 1); ++j)
            for (int i = std::max(x - 1, 0); i <= std::min(x + 1, width_ - 1); ++i)
                if (guides_.objects[index(i, j)] != object) return false;
        return object >= 0.0f;
    }

    /// The lesser of the steps of depth to both sides: the other may cross an edge.
    float slope(int x, int y, int dx, int dy) const {
        const float here = guides_.depths[index(x, y)];
        float least = 0.0f;
        bool is_first = true;
        for (const int side : {-1, 1}) {
            const int sx = x + side * dx, sy = y + side * dy;
            if (sx < 0 || sx >= width_ || sy < 0 || sy >= height_) continue;
            const float step = static_cast<float>(side) * (guides_.depths[index(sx, sy)] - here);
            if (is_first || std::abs(step) < std::abs(least)) least = step;
            is_first = false;
        }
        return least;
    }

    const Guides& guides_;
    int width_;
    int height_;
    static constexpr float straightest =
        0.98f; // a mean of normals that differ by 23° from side to side is shorter

    std::vector<bool> pure_;
    std::vector<vec3> normals_;
    std::vector<vec2> slopes_; // of depth [m/pixel]
};

/// One pass, whose taps are `step` pixels apart.
class Pass {
public:
    Pass(const image::Image& from, const Surfaces& surfaces, int step)
        : from_(from), surfaces_(surfaces), step_(step) {}

    void filter(int x, int y, std::span<float> to) const {
        const auto here = from_.at(x, y);
        std::ranges::copy(here, to.begin());
        if (here[3] < 0.0f || !surfaces_.is_pure(x, y)) return;
        const float width = noise_widths * std::sqrt(variance_around(x, y));
        if (width == 0.0f) return;
        vec4 sum(0.0f);
        float weights = 0.0f;
        for (int j = -radius; j <= radius; ++j) {
            for (int i = -radius; i <= radius; ++i) {
                if (!holds(x + i * step_, y + j * step_)) continue;
                const auto there = from_.at(x + i * step_, y + j * step_);
                if (there[3] < 0.0f) continue;
                const float far = std::abs(value(there) - value(here)) / width;
                const float w = spline[static_cast<std::size_t>(std::abs(i))]
                                * spline[static_cast<std::size_t>(std::abs(j))] * std::exp(-far)
                                * surfaces_.likeness(x, y, i * step_, j * step_);
                sum += w * vec4(there[0], there[1], there[2], w * there[3]);
                weights += w;
            }
        }
        for (int c = 0; c < 3; ++c)
            to[static_cast<std::size_t>(c)] = sum[c] / weights; // its own weight is not 0
        to[3] = sum.w / (weights * weights);
    }

private:
    static float value(std::span<const float> pixel) { return (pixel[0] + pixel[1] + pixel[2]) / 3.0f; }
    bool holds(int x, int y) const { return x >= 0 && y >= 0 && x < from_.width && y < from_.height; }

    /// One pixel's variance is itself a guess: its mean over those of 3×3 pixels that are on the surface.
    float variance_around(int x, int y) const {
        float sum = 0.0f;
        int count = 0;
        for (int j = -1; j <= 1; ++j) {
            for (int i = -1; i <= 1; ++i) {
                if (!holds(x + i, y + j) || from_.at(x + i, y + j)[3] < 0.0f) continue;
                if (!(surfaces_.likeness(x, y, i, j) > 0.5f)) continue;
                sum += from_.at(x + i, y + j)[3];
                ++count;
            }
        }
        return sum / static_cast<float>(count);
    }

    const image::Image& from_;
    const Surfaces& surfaces_;
    int step_;
};

/// Filters V. `ratio`: V in R, G and B, and in A the variance of one of them, which is negative where no
/// light would arrive: such pixels have no weight. @return V in R, G and B
///
/// Five passes of 5×5 pixels, each twice as far apart (Dammertz et al. 2010, "Edge-avoiding À-Trous wavelet
/// transform"), weighted by normal, depth, object, and by how far values differ in units of their noise
/// (Schied et al. 2017, "Spatiotemporal variance-guided filtering", Eqs. 3 to 5): a pixel without noise keeps
/// its value to the bit.
image::Image filter_ratio(image::Image ratio, const Guides& guides) {
    require(ratio.channels == 4 && guides.normals.width == ratio.width
                && guides.normals.height == ratio.height && guides.depths.size() * 4 == ratio.pixels.size()
                && guides.objects.size() == guides.depths.size(),
            "the guides have the picture's size");
    const Surfaces surfaces(guides);
    for (int i = 0; i < passes; ++i) {
        image::Image to(ratio.width, ratio.height, 4);
        const Pass pass(ratio, surfaces, 1 << i);
        for_each_row(ratio.height, [&](int y) {
            for (int x = 0; x < ratio.width; ++x) pass.filter(x, y, to.at(x, y));
        });
        ratio = std::move(to);
    }
    return ratio;
}

/// The scene without shadows, under the lights [0, lights), with the samples that the picture has.
image::Image without_shadows(const AovSource& source, int lights, const std::stop_token& stop) {
    render::RenderOptions options = source.options;
    options.has_shadows = false;
    render::Renderer renderer(source.scene, source.camera, options);
    renderer.use_lights(0, lights);
    const int samples = std::ranges::max(source.samples);
    do {
        renderer.add_sample();
        glFinish();
    } while (renderer.sample_count() < samples && !stop.stop_requested());
    return renderer.read_film();
}

Guides guides_of(const AovSource& source, const std::stop_token& stop) {
    std::vector<ImageChannel> channels =
        render_aovs({aov_named("normal"), aov_named("depth"), aov_named("object")}, source, stop);
    if (channels.empty()) return {};
    image::Image normals(source.options.width, source.options.height, 3);
    for (std::size_t i = 0; i < normals.pixels.size(); ++i) normals.pixels[i] = channels[i % 3].values[i / 3];
    return {std::move(normals), std::move(channels[3].values), std::move(channels[4].values)};
}

/// V of each pixel, and in A the variance that its halves show; negative where no light would arrive.
image::Image ratio_of(const image::Image& film, const image::Image& first_half, const image::Image& dark,
                      const image::Image& bright) {
    image::Image ratio(film.width, film.height, 4);
    for (std::size_t i = 0; i < film.pixels.size(); i += 4) {
        float variance = 0.0f, divisors = 0.0f;
        for (std::size_t c = i; c < i + 3; ++c) {
            const float L_r = bright.pixels[c] - dark.pixels[c];
            ratio.pixels[c] = L_r > 0.0f ? (film.pixels[c] - dark.pixels[c]) / L_r : 1.0f;
            if (!(L_r > 0.0f)) continue;
            const float off = (first_half.pixels[c] - film.pixels[c]) / L_r;
            variance += off * off;
            divisors += 1.0f;
        }
        ratio.pixels[i + 3] = divisors > 0.0f ? variance / divisors : -1.0f;
    }
    return ratio;
}

} // namespace

image::Image denoise(const render::Renderer& renderer, const AovSource& source, const std::stop_token& stop) {
    image::Image film = renderer.read_film();
    const image::Image dark = without_shadows(source, 0, stop);
    const image::Image bright = without_shadows(source, source.scene.light_count(), stop);
    const Guides guides = guides_of(source, stop);
    if (stop.stop_requested()) return film;
    const image::Image V = filter_ratio(ratio_of(film, renderer.read_first_half(), dark, bright), guides);
    for (std::size_t i = 0; i < film.pixels.size(); ++i) {
        const float L_r = bright.pixels[i] - dark.pixels[i];
        if (i % 4 != 3 && L_r > 0.0f) film.pixels[i] = dark.pixels[i] + L_r * V.pixels[i];
    }
    return film;
}

} // namespace sr::output
