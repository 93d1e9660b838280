// The shadow rays that are recorded for the CPU. Ray r of light k has number k * rays_per_light + r. Where samples
// choose lights (interface/estimator.glsl), that of choice r has number k * (light_choices + 1) + r, and that along the
// BRDF comes last. Keep in sync with RaysBlock in src/render/gpu/blocks.hpp.
const int rays_a_pass = 7; // OpenGL 4.1 has eight colour attachments; the first is the receiver

layout(std140) uniform Rays {
    int first_ray;  // noting down: how many rays of every pixel earlier passes took; resolving: the first number
    int plane_size; // answers a ray
    int row_size;   // answers a row
    int first_row;  // of the answers, counted from the picture's lower edge
    int most_rays;  // that a pixel can have; only for interface/deferred.glsl
};

// The number of this pixel among those of the answers' rows, lower left first.
int pixel_of_rows() { return (int(gl_FragCoord.y) - first_row) * row_size + int(gl_FragCoord.x); }
