#include "compare/noise_of_seeds.hpp"

#include "compare/compare.hpp"
#include "compare/noise.hpp"
#include "core/error.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <numeric>

namespace sr::compare {
namespace {

using image::Image;

constexpr const char* samples_attribute = "steradian:samples";

} // namespace

void NoiseOfSeeds::Moments::add(const std::vector<double>& values, int count) {
    mean.resize(values.size());
    squares.resize(values.size());
    for (std::size_t i = 0; i < values.size(); ++i) {
        const double before = values[i] - mean[i];
        mean[i] += before / count;
        squares[i] += before * (values[i] - mean[i]);
    }
}

void NoiseOfSeeds::add(const Image& picture) {
    const auto layer = layer_of(picture, "");
    if (!layer) throw Error("the picture has no colours", "render one with R, G and B, or with Y");
    const bool is_named = static_cast<int>(picture.channel_names.size()) == picture.channels;
    std::vector<std::string> names = picture.channel_names;
    std::vector<int> chosen = layer->colors;
    if (is_named) {
        chosen.resize(names.size());
        std::iota(chosen.begin(), chosen.end(), 0);
    } else {
        names = {"Y"};
        if (chosen.size() == 3) names = {"R", "G", "B"};
    }
    if (count_ > 0 && (picture.width != width_ || picture.height != height_ || names != names_))
        throw Error("the pictures of the seeds differ in size or channels",
                    "render the same view with each seed");
    width_ = picture.width;
    height_ = picture.height;
    names_ = names;
    const auto samples = std::ranges::find(picture.attributes, samples_attribute, &image::Attribute::name);
    if (count_ == 0 && samples != picture.attributes.end()) samples_ = std::atof(samples->value.c_str());
    ++count_;
    Image colors = extract(picture, chosen);
    for (float& value : colors.pixels)
        if (!std::isfinite(value)) value = 0.0f; // depth is infinite where nothing is
    const std::size_t channels = names.size();
    const NoiseBlocks blocks(width_, height_);
    std::vector<double> block_means(blocks.count * channels), counts(blocks.count), whole(channels);
    for (std::size_t i = 0; i < colors.pixels.size() / channels; ++i) {
        counts[blocks.of(i)] += 1.0;
        for (std::size_t c = 0; c < channels; ++c) {
            block_means[blocks.of(i) * channels + c] += colors.pixels[i * channels + c];
            whole[c] += colors.pixels[i * channels + c];
        }
    }
    for (std::size_t b = 0; b < block_means.size(); ++b) block_means[b] /= counts[b / channels];
    for (double& sum : whole) sum /= static_cast<double>(width_) * height_;
    pixels_.add({colors.pixels.begin(), colors.pixels.end()}, count_);
    blocks_.add(block_means, count_);
    whole_.add(whole, count_);
}

double NoiseOfSeeds::unseen_error(std::size_t pixel, std::size_t channel) const {
    if (samples_ < 1.0) return 0.0;
    const int x = static_cast<int>(pixel) % width_, y = static_cast<int>(pixel) / width_;
    double low = pixels_.mean[pixel * names_.size() + channel], high = low;
    for (int v = std::max(y - 1, 0); v <= std::min(y + 1, height_ - 1); ++v)
        for (int u = std::max(x - 1, 0); u <= std::min(x + 1, width_ - 1); ++u) {
            const double value =
                pixels_.mean[static_cast<std::size_t>(v * width_ + u) * names_.size() + channel];
            low = std::min(low, value);
            high = std::max(high, value);
        }
    const double chance = 1.0 / (count_ + 2);
    return std::sqrt(chance * (1.0 - chance)) * (high - low) / samples_;
}

std::vector<double> NoiseOfSeeds::unseen_errors() const {
    std::vector<double> errors(pixels_.mean.size());
    for (std::size_t i = 0; i < errors.size(); ++i)
        errors[i] = unseen_error(i / names_.size(), i % names_.size());
    return errors;
}

Image NoiseOfSeeds::errors() const {
    if (count_ < 2) throw Error("one seed does not tell noise", "take at least two, better twelve");
    const std::size_t channels = names_.size();
    Image errors(width_, height_, static_cast<int>(3 * channels));
    for (const char* prefix : {"", "block.", "whole."})
        for (const std::string& name : names_) errors.channel_names.push_back(prefix + name);
    const NoiseBlocks blocks(width_, height_);
    const auto error = [this](const Moments& moments, std::size_t i) {
        return static_cast<float>(std::sqrt(moments.squares[i] / (count_ - 1)));
    };
    const std::size_t pixels = errors.pixels.size() / (3 * channels);
    const std::vector<double> unseen = unseen_errors();
    std::vector<double> in_blocks(blocks.count * channels), counts(blocks.count), in_whole(channels);
    for (std::size_t i = 0; i < pixels; ++i) {
        counts[blocks.of(i)] += 1.0;
        for (std::size_t c = 0; c < channels; ++c)
            in_blocks[blocks.of(i) * channels + c] += unseen[i * channels + c];
    }
    for (std::size_t b = 0; b < in_blocks.size(); ++b) in_whole[b % channels] += in_blocks[b] * in_blocks[b];
    const auto larger = [](float measured, double least) {
        return std::max(measured, static_cast<float>(least));
    };
    for (std::size_t i = 0; i < pixels; ++i)
        for (std::size_t c = 0; c < channels; ++c) {
            float* const to = &errors.pixels[i * 3 * channels];
            const std::size_t b = blocks.of(i) * channels + c;
            to[c] = larger(error(pixels_, i * channels + c), unseen[i * channels + c]);
            to[channels + c] = larger(error(blocks_, b), in_blocks[b] / counts[blocks.of(i)]);
            to[2 * channels + c] =
                larger(error(whole_, c), std::sqrt(in_whole[c]) / static_cast<double>(pixels));
        }
    errors.attributes = {{seeds_attribute, std::to_string(count_)}};
    return errors;
}

} // namespace sr::compare
