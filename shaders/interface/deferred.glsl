#extension GL_ARB_shader_storage_buffer_object : require
#extension GL_ARB_shader_image_load_store : require // for early_fragment_tests
// The samples of the opaque surfaces that wait for their V: the CPU traces their rays and adds up L V. Pixels are those of
// a band of rows, lower left first. The block holds the number of samples of each pixel; behind these numbers, for each
// pixel, x [m] and the triangle that it lies on; and with them, for each sample, its ray as visibility/named_ray.glsl
// states it, and L. Keep in sync with src/render/visibility/deferred_visibility.cpp.
// A driver on the CPU stores number by number and pixel by pixel, so two numbers of 32 bits go as one of 64, by their bits.
#include "interface/rays.glsl"

const int receiver_pairs = 2;
const int sample_pairs = 4;

layout(std430) buffer Deferred { double deferred[]; };

int deferred_count; // samples of this pixel so far

int deferred_pairs_of(int pixel) { return plane_size + pixel * (receiver_pairs + sample_pairs * most_rays); }

double pair(float a, float b) { return packDouble2x32(floatBitsToUint(vec2(a, b))); }
