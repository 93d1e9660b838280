#pragma once
// The frame's uniform block.
#include "gl/object.hpp"
#include "render/gpu/blocks.hpp"

namespace sr::render {

class FrameData {
public:
    void upload(const FrameBlock& block);
    /// Changes which lights are at work, and nothing else.
    void select_lights(int first, int end);

private:
    gl::Buffer buffer_{"frame"};
    FrameBlock block_{};
};

} // namespace sr::render
