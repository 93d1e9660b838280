#pragma once
// `render --denoise`: the analytic estimator's shadows, filtered.
#include "cli/aovs.hpp"

namespace sr::cli {

/// L = L_e + L_r V, where L_r is what the analytic estimator has without shadows, and free of noise; V is
/// filtered and the rest is not touched. Renders the scene anew without shadows, with as many samples as
/// `renderer` has, none of whose pixels rests and which knows its error. `goes_on` is asked after every
/// sample.
/// @return the film as it is if it said no
image::Image denoised(const render::Renderer& renderer, const AovSource& source,
                      const std::function<bool()>& goes_on);

} // namespace sr::cli
