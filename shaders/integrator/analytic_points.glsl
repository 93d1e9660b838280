// How many points a lobe and emitter the analytic estimator takes, about; 0: the fitted lobe alone. The renderer
// overlays this file with --analytic-points.
const int analytic_points = 24;
