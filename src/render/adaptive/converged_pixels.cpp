#include "render/adaptive/converged_pixels.hpp"

#include "core/error.hpp"

#include <algorithm>
#include <limits>

namespace sr::render {
namespace {

constexpr int never = std::numeric_limits<int>::max();

} // namespace

void ConvergedPixels::add(const PixelMask& pixels, int sample) {
    const auto size = static_cast<std::size_t>(width_) * static_cast<std::size_t>(height_);
    require(pixels.size() == size, "the mask has the picture's size");
    require(events_.empty() || events_.back().sample <= sample, "pixels are frozen in the samples' order");
    if (frozen_from_.empty()) frozen_from_.assign(size, never);
    for (std::size_t i = 0; i < size; ++i)
        if (pixels[i] != 0) frozen_from_[i] = std::min(frozen_from_[i], sample);
    if (events_.empty() || events_.back().sample < sample) events_.push_back({sample, {}});
    events_.back().active = bounds_at(sample);
    uploaded_ = -1;
}

int ConvergedPixels::samples_of(std::size_t pixel, int taken) const {
    return frozen_from_.empty() ? taken : std::min(taken, frozen_from_[pixel]);
}

int ConvergedPixels::event_of(int sample) const {
    const auto after = std::ranges::upper_bound(events_, sample, {}, &Event::sample);
    return static_cast<int>(after - events_.begin()) - 1;
}

PixelRect ConvergedPixels::active(int sample) const {
    const int event = event_of(sample);
    return event < 0 ? PixelRect{0, 0, width_, height_} : events_[static_cast<std::size_t>(event)].active;
}

PixelRect ConvergedPixels::bounds_at(int sample) const {
    int left = width_, right = 0, top = height_, bottom = 0;
    for (int row = 0; row < height_; ++row) {
        for (int column = 0; column < width_; ++column) {
            const auto i = static_cast<std::size_t>(row) * static_cast<std::size_t>(width_);
            if (frozen_from_[i + static_cast<std::size_t>(column)] <= sample) continue;
            left = std::min(left, column);
            right = std::max(right, column + 1);
            top = std::min(top, row);
            bottom = row + 1;
        }
    }
    return {left, top, std::max(0, right - left), std::max(0, bottom - top)};
}

void ConvergedPixels::bind(int sample, GLuint unit) {
    const int event = event_of(sample);
    require(event >= 0, "a pixel is frozen");
    texture_.bind(unit);
    if (event == uploaded_) return;
    upload(events_[static_cast<std::size_t>(event)].sample);
    uploaded_ = event;
}

PixelMask ConvergedPixels::frozen(int sample) const {
    PixelMask mask(static_cast<std::size_t>(width_) * static_cast<std::size_t>(height_));
    std::ranges::transform(frozen_from_, mask.begin(), [sample](int from) {
        return static_cast<std::uint8_t>(from <= sample ? 255 : 0);
    });
    return mask;
}

void ConvergedPixels::upload(int sample) {
    const PixelMask mask = frozen(sample);
    PixelMask texels;
    texels.reserve(mask.size());
    for (int row = height_ - 1; row >= 0; --row) {
        const auto first = mask.begin() + std::ptrdiff_t{row} * width_;
        texels.insert(texels.end(), first, first + width_);
    }
    glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
    glTexImage2D(GL_TEXTURE_2D, 0, GL_R8, width_, height_, 0, GL_RED, GL_UNSIGNED_BYTE, texels.data());
    glPixelStorei(GL_UNPACK_ALIGNMENT, 4);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAX_LEVEL, 0);
}

} // namespace sr::render
