#pragma once
// Shadow filter of `render --denoise`, for the analytic estimator.
#include "output/channels.hpp"

namespace sr::output {

/// Filters V in L = L_e + L_r V. The analytic estimator gives L_r, the picture without shadows, free of
/// noise. Renders the scene again without shadows and with the samples of `renderer`, which estimates its
/// error and has no frozen pixels.
/// @return the unfiltered film if it was stopped
image::Image denoise(const render::Renderer& renderer, const AovSource& source, const std::stop_token& stop);

} // namespace sr::output
