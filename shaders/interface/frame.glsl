// Data of one frame, that is, of one sample of every pixel. Keep in sync with FrameBlock in src/render/gpu/blocks.hpp.
layout(std140) uniform Frame {
    mat4 clip_from_world; // with this frame's sub-pixel offset
    vec4 eye;             // w = 1: the position of the camera [m]; w = 0: the direction to it (orthographic)
    uint sample_index;    // counts from 0
    uint seed;
    int first_light;      // the emitters at work: from this one
    int end_light;        // up to the one before this
    vec2 frame_size;      // of the picture [pixels]
    uvec4 sample_digits;  // of the sample's point in four dimensions, see random_point.glsl
};
