#pragma once
// Pixels that have enough samples rest: nothing is drawn there any more.
#include "gl/object.hpp"
#include "render/film.hpp"

#include <cstdint>
#include <span>
#include <vector>

namespace sr::render {

/// One byte a pixel, rows from top to bottom; not 0: it is meant.
using PixelMask = std::vector<std::uint8_t>;

/// Pixels that rest, each with the number of the first sample that it does not take. A resting pixel stays at
/// rest, so its samples are the first ones of its sequence. They do not depend on the other pixels.
class ConvergedPixels {
public:
    ConvergedPixels(int width, int height) : width_(width), height_(height) {}

    /// These pixels rest from sample number `sample` on, which is none before an earlier call's.
    void add(const PixelMask& pixels, int sample);

    /// Returns the number of samples that the pixel has of the first `taken` ones.
    int samples_of(std::size_t pixel, int taken) const;

    /// True if any pixel rests in sample number `sample`.
    bool any(int sample) const { return event_of(sample) >= 0; }

    /// Returns the bounding rectangle of the pixels that take sample number `sample`; empty if all rest.
    PixelRect working(int sample) const;

    /// Binds a texture that is not 0 where pixels rest in sample number `sample`; rows as GL counts them.
    /// Only if any() do.
    void bind(int sample, GLuint unit);

private:
    struct Event {
        int sample = 0; // from which on more pixels rest
        PixelRect working;
    };

    int event_of(int sample) const; // the last event that sample knows of; -1: none
    PixelRect bounds_at(int sample) const;
    void upload(int sample);

    int width_;
    int height_;
    std::vector<int> rests_from_; // for each pixel; empty as long as none does
    std::vector<Event> events_;
    gl::Texture texture_{GL_TEXTURE_2D, "resting pixels"};
    int uploaded_ = -1; // the event in the texture
};

} // namespace sr::render
