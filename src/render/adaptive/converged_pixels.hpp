#pragma once
// Converged pixels: they are frozen, and nothing is drawn there any more.
#include "gl/object.hpp"
#include "render/film.hpp"

#include <cstdint>
#include <span>
#include <vector>

namespace sr::render {

/// One byte a pixel, rows from top to bottom; not 0: it is meant.
using PixelMask = std::vector<std::uint8_t>;

/// Frozen pixels, each with the number of the first sample that it does not take. A pixel stays frozen, so
/// its samples are the first ones of its sequence. They do not depend on the other pixels.
class ConvergedPixels {
public:
    ConvergedPixels(int width, int height) : width_(width), height_(height) {}

    /// Freezes these pixels from sample number `sample` on, which is not before that of an earlier call.
    void add(const PixelMask& pixels, int sample);

    /// Returns the number of samples that the pixel has of the first `taken` ones.
    int samples_of(std::size_t pixel, int taken) const;

    /// True if any pixel is frozen in sample number `sample`.
    bool any(int sample) const { return event_of(sample) >= 0; }

    /// Returns the bounding rectangle of the pixels that take sample number `sample`; empty if all are
    /// frozen.
    PixelRect active(int sample) const;

    /// Returns the number of the last call of add() that sample number `sample` knows of, so that equal
    /// numbers have equal pixels; -1: none.
    int event_of(int sample) const;

    /// Returns the pixels that are frozen in sample number `sample`.
    PixelMask frozen(int sample) const;

    /// Binds a texture that is not 0 where pixels are frozen in sample number `sample`; rows as GL counts
    /// them. Only if any() do.
    void bind(int sample, GLuint unit);

private:
    struct Event {
        int sample = 0; // from which on more pixels are frozen
        PixelRect active;
    };

    PixelRect bounds_at(int sample) const;
    void upload(int sample);

    int width_;
    int height_;
    std::vector<int> frozen_from_; // for each pixel; empty as long as none does
    std::vector<Event> events_;
    gl::Texture texture_{GL_TEXTURE_2D, "frozen pixels"};
    int uploaded_ = -1; // the event in the texture
};

} // namespace sr::render
