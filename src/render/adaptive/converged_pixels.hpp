#pragma once
// Pixels that have enough samples rest: nothing is drawn there any more.
#include "gl/object.hpp"
#include "render/pixel_rect.hpp"

#include <cstdint>
#include <span>
#include <vector>

namespace sr::render {

/// One byte a pixel, rows from top to bottom; not 0: it is meant.
using PixelMask = std::vector<std::uint8_t>;

/// Which pixels rest, and since when. A pixel that rests stays at rest, so its samples are the first ones of
/// its sequence, whatever the others have.
class ConvergedPixels {
public:
    ConvergedPixels(int width, int height) : width_(width), height_(height) {}

    /// These pixels rest from sample number `sample` on, which is none before an earlier call's.
    void add(const PixelMask& pixels, int sample);

    /// How many of the first `taken` samples the pixel has.
    int samples_of(std::size_t pixel, int taken) const;

    /// Whether any pixel rests in sample number `sample`.
    bool any(int sample) const { return event_of(sample) >= 0; }

    /// What holds all pixels that sample number `sample` is for; nothing is in it if all rest.
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
