#extension GL_ARB_shader_storage_buffer_object : require
#extension GL_ARB_shader_image_load_store : require // for early_fragment_tests
// The samples of the opaque surfaces that wait for their V: the CPU traces their rays and adds up L V. Pixels are those of
// a band of rows, lower left first. The block holds the number of samples of each pixel; behind these numbers, for each
// pixel, x [m] and the triangle that it lies on; and with them, for each sample, its ray as visibility/named_ray.glsl
// states it, and L. Floats are there by their bits. Keep in sync with src/render/visibility/deferred_visibility.cpp.
#include "interface/rays.glsl"

const int receiver_words = 4;
const int sample_words = 7;

layout(std430) buffer Deferred { int deferred[]; };

int deferred_count; // samples of this pixel so far

int deferred_words_of(int pixel) { return plane_size + pixel * (receiver_words + sample_words * most_rays); }
