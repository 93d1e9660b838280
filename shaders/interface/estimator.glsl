// Choices of the estimators. The renderer overlays this file with its options (src/render/renderer.cpp).
const int analytic_points = 16;         // a lobe and emitter, about; 0: the fitted lobe alone
const int max_outlined_triangles = 12; // of a mesh; one of more is sampled
const int light_choices = 0;           // of a sample, in integrator/reflected_from_one.glsl; 0: it visits all lights
