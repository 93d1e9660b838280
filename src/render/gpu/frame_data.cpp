#include "render/gpu/frame_data.hpp"

namespace sr::render {

void FrameData::upload(const FrameBlock& block) {
    block_ = block;
    glBindBuffer(GL_UNIFORM_BUFFER, buffer_.id());
    glBufferData(GL_UNIFORM_BUFFER, sizeof(block_), &block_, GL_STREAM_DRAW);
    glBindBufferBase(GL_UNIFORM_BUFFER, frame_block, buffer_.id());
}

void FrameData::select_lights(int first, int end) {
    FrameBlock block = block_;
    block.first_light = first;
    block.end_light = end;
    upload(block);
}

} // namespace sr::render
