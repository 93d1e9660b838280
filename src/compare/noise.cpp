#include "compare/noise.hpp"

#include "compare/moderated.hpp"
#include "compare/rare_events.hpp"
#include "compare/winsorised.hpp"
#include "core/error.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <fmt/format.h>
#include <optional>

namespace sr::compare {
namespace {

using image::Image;

constexpr double false_alarms = 1e-3;      // of all comparisons of equal images
constexpr double rounding = 1e-6;          // relative; eight units in the last place of a float
constexpr double max_score = 5.0;          // of a pixel in a sum of scores, so that no single one decides
constexpr double many_seeds = 1e6;         // as good as a known standard error
constexpr float max_rare = 4.0f;           // of a rare value, over the largest of the reference
constexpr float max_rare_coverage = 0.25f; // change of alpha by one; 4 of 16 samples

// Rare events of an image: these, and a share of the pixels. Of 300 pairs of renderings of 6144 pixels 18 had
// one or two (tools/golden/false_alarms.py).
constexpr std::size_t few_rare_events = 2;
constexpr double max_rare_share = 1e-4;
constexpr std::size_t max_rare_events = 48;

/// Layers of a noise image, each with the images' colours; a 1×1 image has pixels alone.
struct Noise {
    Image pixels;
    std::optional<Image> blocks;
    std::optional<Image> whole;
    double degrees_of_freedom = many_seeds;

    bool is_number() const { return pixels.width == 1 && pixels.height == 1; }
    double error(const Image& image, std::size_t pixel, std::size_t color) const {
        const auto channels = static_cast<std::size_t>(image.channels);
        return image.pixels[(is_number() ? 0 : pixel * channels) + std::min(color, channels - 1)];
    }
};

/// The indices of the named channels behind "block." and the like, or of the colours of that layer if none
/// are named; absent if they are not there.
std::optional<std::vector<int>> channels_in(const Image& noise, const std::string& prefix,
                                            const std::vector<std::string>& channels, int colors) {
    if (channels.empty()) {
        const auto layer = layer_of(noise, prefix);
        if (!layer || (layer->colors.size() != 1 && static_cast<int>(layer->colors.size()) != colors))
            return std::nullopt;
        return layer->colors;
    }
    std::vector<int> indices;
    for (const std::string& channel : channels) {
        const auto at =
            std::ranges::find(noise.channel_names, prefix.empty() ? channel : prefix + "." + channel);
        if (at == noise.channel_names.end()) return std::nullopt;
        indices.push_back(static_cast<int>(at - noise.channel_names.begin()));
    }
    return indices;
}

std::optional<Image> errors_in(const Image& noise, const std::string& prefix,
                               const std::vector<std::string>& channels, int colors) {
    const auto indices = channels_in(noise, prefix, channels, colors);
    if (!indices) return std::nullopt;
    Image errors = extract(noise, *indices);
    if (!std::ranges::all_of(errors.pixels, [](float s) { return std::isfinite(s) && s >= 0.0f; }))
        throw Error("the noise has values that are negative or not finite",
                    "give standard errors, from 0 up");
    return errors;
}

/// The degrees of freedom of variances whose neighbours scatter as these do: ln s² of ν degrees of freedom
/// has the variance 2/ν, nearly, and so a median distance of 0.6745 √(4/ν) from its neighbour's.
double degrees_by_scatter(const Image& errors) {
    std::vector<double> distances;
    const auto channels = static_cast<std::size_t>(errors.channels);
    for (std::size_t i = channels; i < errors.pixels.size(); ++i) {
        const float a = errors.pixels[i - channels], b = errors.pixels[i];
        if (a > 0.0f && b > 0.0f) distances.push_back(2.0 * std::abs(std::log(static_cast<double>(a / b))));
    }
    if (distances.size() < 64) return many_seeds; // too few to tell
    const auto middle = distances.begin() + static_cast<std::ptrdiff_t>(distances.size() / 2);
    std::ranges::nth_element(distances, middle);
    return std::clamp(4.0 * 0.6745 * 0.6745 / std::max(*middle * *middle, 1e-12), 1.0, many_seeds);
}

Noise read_noise(const Image& image, const AlignedImages& images, const std::vector<std::string>& channels) {
    const bool is_number = image.width == 1 && image.height == 1;
    if (!is_number && (image.width != images.reference.width || image.height != images.reference.height))
        throw Error(fmt::format("the noise is {}x{}, the reference {}x{}", image.width, image.height,
                                images.reference.width, images.reference.height),
                    "give a number, or an image of the reference's size");
    const auto pixels = errors_in(image, "", channels, images.colors);
    if (!pixels)
        throw Error("the noise has other channels than the images",
                    "give it the channels R, G and B, or only one");
    Noise noise{*pixels, errors_in(image, "block", channels, images.colors),
                errors_in(image, "whole", channels, images.colors)};
    if (is_number) return noise;
    const auto seeds = std::ranges::find(image.attributes, seeds_attribute, &image::Attribute::name);
    noise.degrees_of_freedom = seeds == image.attributes.end()
                                   ? degrees_by_scatter(*pixels)
                                   : std::max(1.0, std::atof(seeds->value.c_str()) - 1.0);
    return noise;
}

/// The variance, or the mean of the 3×3 around it if that is larger.
double pooled_variance(const Noise& noise, std::size_t pixel, std::size_t color) {
    const double own = noise.error(noise.pixels, pixel, color);
    if (noise.is_number()) return own * own;
    const int width = noise.pixels.width, height = noise.pixels.height;
    const int x = static_cast<int>(pixel) % width, y = static_cast<int>(pixel) / width;
    double sum = 0.0;
    int count = 0;
    for (int v = std::max(y - 1, 0); v <= std::min(y + 1, height - 1); ++v)
        for (int u = std::max(x - 1, 0); u <= std::min(x + 1, width - 1); ++u, ++count) {
            const double s = noise.error(noise.pixels, static_cast<std::size_t>(v * width + u), color);
            sum += s * s;
        }
    return std::max(own * own, sum / count);
}

/// A difference whose variance is known, or a sum of such.
struct Deviation {
    double difference = 0.0;
    double variance = 0.0;
    double count = 0.0;

    double t() const {
        if (difference == 0.0) return 0.0;
        return std::abs(difference) / std::sqrt(variance); // infinite where no noise is expected
    }
    Deviation& operator+=(const Deviation& other) {
        difference += other.difference;
        variance += other.variance;
        count += other.count;
        return *this;
    }
};

/// The number of rare events that the images may have in a sum that none of the noise's pictures had: with n
/// pictures of each image, 1 / (n + 2) are expected (Laplace's rule of succession).
std::size_t most_unseen_events(const std::vector<Noise>& noise) {
    double expected = 0.0;
    for (const Noise& known : noise) expected += 1.0 / (known.degrees_of_freedom + 3.0);
    return most_events(expected, false_alarms / 3.0);
}

/// The number of rare events that the images may have, after as many as the noise's pictures had.
std::size_t most_rare_events(const std::vector<Noise>& noise, double limit) {
    double expected = 0.0;
    for (const Noise& known : noise) {
        if (known.is_number()) continue;
        const double n = known.degrees_of_freedom;
        expected +=
            (static_cast<double>(seen_events(known.pixels, n + 1.0, t_of_z(limit, n))) + 1.0) / (n + 3.0);
    }
    return std::max(few_rare_events, most_events(expected, false_alarms / 3.0));
}

/// The sums of a comparison, by colour.
struct DeviationSums {
    std::vector<Deviation> blocks; // block by block, all colours of each
    std::vector<Deviation> scores; // the same of differences in standard errors
    std::vector<Deviation> totals;
    std::vector<Deviation> whole_blocks; // variances and counts with the pixels that are not compared
    std::vector<Deviation> whole_totals;

    DeviationSums(const NoiseBlocks& image_blocks, std::size_t colors)
        : blocks(image_blocks.count * colors),
          scores(image_blocks.count * colors),
          totals(colors),
          whole_blocks(blocks.size()),
          whole_totals(colors) {}
};

bool all_know(const std::vector<Noise>& noise, std::optional<Image> Noise::*layer) {
    return std::ranges::all_of(noise,
                               [&](const Noise& n) { return n.is_number() || (n.*layer).has_value(); });
}

/// Returns how many times the variance of independent pixels the sum over a block (or the image) has, of
/// whose mean the layer holds the standard error.
double likeness(const Deviation& whole, const std::vector<Noise>& noise, std::optional<Image> Noise::*layer,
                std::size_t pixel, std::size_t color) {
    double variance = 0.0;
    for (const Noise& n : noise) {
        const double error = n.is_number() ? 0.0 : n.error(*(n.*layer), pixel, color);
        variance += error * error * whole.count * whole.count;
    }
    return whole.variance > 0.0 ? variance / whole.variance : 0.0;
}

/// z of the sum over the block of one colour that is furthest from 0. The variances of blocks add those of
/// pixels as if these were independent; how many times larger they are is known of each block, from few
/// seeds, and of all blocks together.
double largest_block_z(const DeviationSums& sums, const std::vector<Noise>& noise, const NoiseBlocks& blocks,
                       std::size_t colors, std::size_t c, double degrees_of_freedom) {
    std::vector<double> likenesses(blocks.count, 0.0);
    for (std::size_t b = 0; b < blocks.count; ++b)
        likenesses[b] =
            likeness(sums.whole_blocks[b * colors + c], noise, &Noise::blocks, blocks.first_of(b), c);
    const VariancePrior prior = prior_of(likenesses, degrees_of_freedom);
    double largest = 0.0;
    for (std::size_t b = 0; b < blocks.count; ++b) {
        Deviation block = sums.blocks[b * colors + c];
        block.variance *= std::max(1.0, prior.moderated(likenesses[b], degrees_of_freedom));
        largest = std::max(largest, z_of_t(block.t(), degrees_of_freedom + prior.degrees_of_freedom));
    }
    return largest;
}

/// z of the sum of one colour over the image.
double total_z(const DeviationSums& sums, const std::vector<Noise>& noise, std::size_t colors, std::size_t c,
               double degrees_of_freedom) {
    Deviation total = sums.totals[c];
    if (std::ranges::all_of(noise, &Noise::is_number)) return total.t();
    if (all_know(noise, &Noise::whole)) {
        total.variance *= std::max(1.0, likeness(sums.whole_totals[c], noise, &Noise::whole, 0, c));
        return z_of_t(total.t(), degrees_of_freedom);
    }
    // Batch means: the blocks' own scatter tells how much a sum of pixels that err alike may scatter.
    Deviation score;
    for (std::size_t b = c; b < sums.scores.size(); b += colors) score += sums.scores[b];
    const double mean = score.difference / score.count;
    double scatter = 0.0, blocks = 0.0;
    for (std::size_t b = c; b < sums.scores.size(); b += colors) {
        if (sums.scores[b].count == 0.0) continue; // not compared
        blocks += 1.0;
        const double rest = sums.scores[b].difference - mean * sums.scores[b].count;
        scatter += rest * rest;
    }
    score.variance = std::max(score.variance, scatter);
    return z_of_t(score.t(), std::max(1.0, blocks - 1.0));
}

} // namespace

double two_sided_z(double chance) {
    double low = 0.0, high = 40.0; // erfc(40 / sqrt 2) is 0 in double
    for (int i = 0; i < 100; ++i) {
        const double middle = 0.5 * (low + high);
        (std::erfc(middle / std::sqrt(2.0)) > chance ? low : high) = middle;
    }
    return 0.5 * (low + high);
}

double t_of_z(double z, double degrees_of_freedom) {
    const double n = degrees_of_freedom;
    if (n >= many_seeds) return z;
    const double scaled = z * (8.0 * n + 3.0) / (8.0 * n + 1.0);
    return std::sqrt(n * std::expm1(scaled * scaled / n));
}

double z_of_t(double t, double degrees_of_freedom) {
    const double n = degrees_of_freedom;
    if (n >= many_seeds || std::isinf(t)) return t;
    return (8.0 * n + 1.0) / (8.0 * n + 3.0) * std::sqrt(n * std::log1p(t * t / n));
}

std::vector<Image> noise_of(const std::vector<Image>& noise, const std::vector<std::string>& channels) {
    std::vector<Image> known;
    for (const Image& image : noise) {
        if (image.width == 1 && image.height == 1) continue;
        if (!channels_in(image, "", channels, 0)) return {};
        known.push_back(image);
    }
    return known;
}

namespace {

/// The deviation of each pixel's colours, compared or not.
std::vector<Deviation> deviations_of(const AlignedImages& images, const std::vector<Noise>& noise) {
    const auto colors = static_cast<std::size_t>(images.colors);
    std::vector<Deviation> deviations(images.pixels.size() * colors);
    for (std::size_t i = 0; i < images.pixels.size(); ++i)
        for (std::size_t c = 0; c < colors; ++c) {
            const double r = images.reference_at(i)[c];
            Deviation& deviation = deviations[i * colors + c];
            deviation = {static_cast<double>(images.test_at(i)[c]) - r, rounding * rounding * r * r, 1.0};
            for (const Noise& known : noise) deviation.variance += pooled_variance(known, i, c);
        }
    return deviations;
}

NoiseLimits limits_of(const AlignedImages& images, const NoiseBlocks& blocks) {
    const double chance = false_alarms / 3.0 / static_cast<double>(images.colors);
    std::vector<bool> has_pixels(blocks.count, false);
    for (const std::size_t i : images.compared) has_pixels[blocks.of(i)] = true;
    const auto at_least_one = [](auto count) {
        return static_cast<double>(std::max<std::ptrdiff_t>(count, 1));
    };
    return {two_sided_z(chance / at_least_one(std::ssize(images.compared))),
            two_sided_z(chance / at_least_one(std::ranges::count(has_pixels, true))), two_sided_z(chance)};
}

/// The pixels around one that are compared, without it.
std::vector<std::size_t> around(const AlignedImages& images, std::size_t pixel) {
    const int width = images.reference.width, height = images.reference.height;
    const int x = static_cast<int>(pixel) % width, y = static_cast<int>(pixel) / width;
    std::vector<std::size_t> pixels;
    for (int v = std::max(y - 1, 0); v <= std::min(y + 1, height - 1); ++v)
        for (int u = std::max(x - 1, 0); u <= std::min(x + 1, width - 1); ++u) {
            const auto i = static_cast<std::size_t>(v * width + u);
            if (i != pixel && images.pixels[i] == PixelState::compared) pixels.push_back(i);
        }
    return pixels;
}

/// True if, in each colour, the dimmer value is no hole among those around it in its own image, and the
/// brighter one is no more than `brightest`.
/// @param margins of the pixel's colours: a hole is darker than all around it by more
bool may_be_rare(const AlignedImages& images, std::size_t pixel, float brightest,
                 std::span<const float> margins) {
    const auto neighbours = around(images, pixel);
    if (neighbours.empty()) return false;
    for (std::size_t c = 0; c < static_cast<std::size_t>(images.colors); ++c) {
        const float t = images.test_at(pixel)[c], r = images.reference_at(pixel)[c];
        const auto value_at = [&](std::size_t i) {
            return t < r ? images.test_at(i)[c] : images.reference_at(i)[c];
        };
        const float lowest = value_at(std::ranges::min(neighbours, {}, value_at));
        if (std::min(t, r) < lowest - margins[c] || std::max(t, r) > brightest) return false;
    }
    return true;
}

/// True if alpha changed by no more than the few samples that meet a crack.
bool may_be_rare_coverage(const AlignedImages& images, std::size_t pixel) {
    return std::abs(images.test_at(pixel)[0] - images.reference_at(pixel)[0]) <= max_rare_coverage;
}

/// The compared pixels whose scores are rare events; none if they are too many.
std::vector<bool> rare_events(const AlignedImages& images, const NoiseScores& all, const RareEvents& rare,
                              const std::vector<Noise>& noise) {
    const PixelValues& scores = all.pixels;
    const auto colors = static_cast<std::size_t>(images.colors);
    std::vector<bool> fails(images.pixels.size(), false), is_rare(images.pixels.size(), false);
    float largest = 0.0f;
    for (std::size_t k = 0; k < scores.size(); ++k) {
        const std::size_t i = images.compared[k];
        fails[i] = static_cast<double>(scores[k]) > all.limits.pixel;
        for (const float value : images.reference_at(i).first(colors)) largest = std::max(largest, value);
    }
    std::size_t count = rare.known.size();
    for (const std::size_t i : images.compared) {
        if (!fails[i]) continue;
        const auto touching =
            std::ranges::count_if(around(images, i), [&](std::size_t n) { return fails[n]; });
        std::vector<float> margins(all.errors.begin() + static_cast<std::ptrdiff_t>(i * colors),
                                   all.errors.begin() + static_cast<std::ptrdiff_t>((i + 1) * colors));
        for (float& margin : margins) margin *= static_cast<float>(all.limits.pixel);
        is_rare[i] = touching <= 1
                     && (rare.is_coverage ? may_be_rare_coverage(images, i)
                                          : may_be_rare(images, i, max_rare * largest, margins));
        count += is_rare[i] && std::ranges::find(rare.known, i) == rare.known.end();
    }
    const auto share = static_cast<std::size_t>(max_rare_share * static_cast<double>(scores.size()));
    if (count > std::min(max_rare_events, few_rare_events + share)
        || (count > few_rare_events && count > most_rare_events(noise, all.limits.pixel)))
        is_rare.assign(is_rare.size(), false);
    return is_rare;
}

/// The sums over all pixels but those left out.
/// @param unseen the number of rare events that a sum of differences may have
DeviationSums sums_of(const AlignedImages& images, const std::vector<Deviation>& deviations,
                      const std::vector<bool>& left_out, const NoiseBlocks& blocks, std::size_t unseen) {
    const auto colors = static_cast<std::size_t>(images.colors);
    DeviationSums sums(blocks, colors);
    WinsorisedSums in_blocks(sums.blocks.size(), unseen), in_image(colors, unseen);
    for (std::size_t i = 0; i < images.pixels.size(); ++i)
        for (std::size_t c = 0; c < colors; ++c) {
            const Deviation& deviation = deviations[i * colors + c];
            const std::size_t block = blocks.of(i) * colors + c;
            sums.whole_blocks[block] += deviation;
            sums.whole_totals[c] += deviation;
            if (images.pixels[i] != PixelState::compared || left_out[i]) continue;
            const double z =
                std::clamp(std::copysign(deviation.t(), deviation.difference), -max_score, max_score);
            sums.blocks[block] += deviation;
            sums.scores[block] += {z, 1.0, 1.0};
            sums.totals[c] += deviation;
            in_blocks.add(block, deviation.difference);
            in_image.add(c, deviation.difference);
        }
    for (std::size_t b = 0; b < sums.blocks.size(); ++b)
        sums.blocks[b].difference = in_blocks.nearer_to_0(b, sums.blocks[b].difference);
    for (std::size_t c = 0; c < colors; ++c)
        sums.totals[c].difference = in_image.nearer_to_0(c, sums.totals[c].difference);
    return sums;
}

} // namespace

NoiseScores score_noise(const AlignedImages& images, const std::vector<Image>& given,
                        const std::vector<std::string>& channels, const RareEvents& rare) {
    const auto colors = static_cast<std::size_t>(images.colors);
    const NoiseBlocks blocks(images.reference.width, images.reference.height);
    std::vector<Noise> noise;
    for (const Image& image : given) noise.push_back(read_noise(image, images, channels));
    const double n = std::ranges::min_element(noise, {}, &Noise::degrees_of_freedom)->degrees_of_freedom;
    const std::vector<Deviation> deviations = deviations_of(images, noise);
    NoiseScores scores;
    scores.judges_blocks = all_know(noise, &Noise::blocks);
    scores.limits = limits_of(images, blocks);
    scores.errors.assign(deviations.size(), 0.0f);
    for (const std::size_t i : images.compared) {
        double largest = 0.0;
        for (std::size_t c = 0; c < colors; ++c) {
            const Deviation& deviation = deviations[i * colors + c];
            largest = std::max(largest, z_of_t(deviation.t(), n));
            scores.errors[i * colors + c] = static_cast<float>(std::sqrt(deviation.variance));
        }
        scores.pixels.push_back(static_cast<float>(largest));
    }
    std::vector<bool> is_rare(images.pixels.size(), false);
    if (n < many_seeds) is_rare = rare_events(images, scores, rare, noise);
    for (std::size_t k = 0; k < scores.pixels.size(); ++k)
        if (is_rare[images.compared[k]]) {
            scores.rare_events.push_back(images.compared[k]);
            scores.pixels[k] = 0.0f;
        }
    DeviationSums sums = sums_of(images, deviations, is_rare, blocks, most_unseen_events(noise));
    for (std::size_t c = 0; c < colors; ++c) {
        if (scores.judges_blocks)
            scores.max_block = std::max(scores.max_block, largest_block_z(sums, noise, blocks, colors, c, n));
        scores.total = std::max(scores.total, total_z(sums, noise, colors, c, n));
    }
    return scores;
}

} // namespace sr::compare
