// Wrap modes for textures whose texels lie in a buffer: maps an index i beyond the size back into it,
// 0 repeat, 1 mirrored repeat, 2 clamp to edge (scene::Wrap). Keep in sync with scene::wrapped in src/scene/material.hpp.
int wrapped(int i, int size, int wrap) {
    if (wrap == 2) return clamp(i, 0, size - 1);
    int period = wrap == 0 ? size : 2 * size;
    int m = i - period * int(floor(float(i) / float(period)));
    return m < size ? m : 2 * size - 1 - m;
}

// Position of uv among the texels' centres, in texels. Coordinates that are no numbers, or so far out that the next float is
// more than a texel away, count as 0.
vec2 texel_place(vec2 uv, ivec2 size) {
    vec2 at = uv * vec2(size);
    bool is_near = abs(at.x) < 1.6e7 && abs(at.y) < 1.6e7; // 2^24
    return (is_near ? at : vec2(0.0)) - 0.5;
}
