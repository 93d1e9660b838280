// V(x, y): 1 where nothing stands between x and the emitter's point at `distance` in direction wi, 0 where something
// does, in between where a surface lets a part of the light through; for red, green and blue, since glass has a colour.
//
// A file in the place of this one may return a float instead: the integrators only multiply by V.
//
// `light` is the emitter's index, for emitters do not shadow themselves; `ray` counts the rays that x sends to one
// light, from 0 up to rays_per_light. The renderer overlays this file with the way it finds V: ray.glsl walks a tree,
// record.glsl notes the ray down for the CPU, resolve.glsl reads what the CPU found.
#include "visibility/none.glsl"
