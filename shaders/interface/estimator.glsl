// Sample counts of the analytic estimator. The renderer overlays this file with its options (src/render/renderer.cpp).
const int analytic_points = 16;         // a lobe and emitter, about; 0: the fitted lobe alone
const int max_outlined_triangles = 12; // of a mesh; one of more is sampled
