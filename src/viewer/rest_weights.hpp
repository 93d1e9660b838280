#pragma once
// How many samples the pixels have that rest, for those who divide a film's sum by them.
#include "gl/object.hpp"
#include "render/resting.hpp"

#include <optional>

namespace sr::viewer {

class RestWeights {
public:
    /// As pixels of a picture of width × height rest now. Needs a current context.
    void take(const render::Resting& resting, int width, int height);
    /// No pixel rests.
    void clear() { texture_.reset(); }

    /// 1 / samples of each pixel that rests, 0 of the others, GL's rows; null: none rests.
    const gl::Texture* texture() const { return texture_ ? &*texture_ : nullptr; }

private:
    std::optional<gl::Texture> texture_;
};

} // namespace sr::viewer
