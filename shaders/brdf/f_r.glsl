// f_r(x, wi, wo): the BRDF of the surface [1/sr], never the cosine, never the light. Overlay this file to render with another
// one. The renderer puts the material's model in its place (src/render/gpu/shader_library.cpp).
#include "brdf/models/metallic_roughness.glsl"
