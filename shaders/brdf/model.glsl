// The BRDF of the current material: a file of models/, each of which declares f_model, how it is sampled and, where the analytic
// estimator can take it, its lobes. The renderer overlays this file (src/render/shader_library.cpp).
#include "brdf/models/metallic_roughness.glsl"
