#include "render/provenance.hpp"

#include <algorithm>
#include <fmt/format.h>

namespace sr::render {

const char* name_of(Estimator estimator) { return estimator == Estimator::analytic ? "analytic" : "sampled"; }

SampleCounts counted(const std::vector<int>& samples) {
    if (samples.empty()) return {};
    const auto [min, max] = std::ranges::minmax(samples);
    double sum = 0.0;
    for (const int count : samples) sum += count;
    return {sum / static_cast<double>(samples.size()), min, max};
}

std::vector<image::Attribute> attributes_of(const Provenance& p, const gl::ContextInfo& gl) {
    std::vector<image::Attribute> attributes{{"steradian:version", STERADIAN_VERSION},
                                             {"steradian:unit", p.unit},
                                             {"steradian:estimator", name_of(p.estimator)},
                                             {"steradian:visibility", std::string(name_of(p.visibility))},
                                             {"steradian:samples", std::to_string(p.samples.max)},
                                             {"steradian:seed", std::to_string(p.seed)},
                                             {"steradian:camera", p.camera},
                                             {"steradian:GL_RENDERER", gl.renderer},
                                             {"steradian:GL_VERSION", gl.version}};
    if (p.estimator == Estimator::analytic)
        attributes.push_back({"steradian:analytic_points", std::to_string(p.analytic_points)});
    if (p.error) attributes.push_back({"steradian:error", fmt::format("{:.4g}", *p.error)});
    if (p.error_target)
        attributes.push_back({"steradian:error_target", fmt::format("{:.4g}", *p.error_target)});
    if (p.stopped_by) attributes.push_back({"steradian:stopped_by", name_of(*p.stopped_by)});
    if (p.stopped_by == StoppedBy::interruption) attributes.push_back({"steradian:interrupted", "yes"});
    if (p.samples.min < p.samples.max) {
        attributes.push_back({"steradian:samples_mean", fmt::format("{:.1f}", p.samples.mean)});
        attributes.push_back({"steradian:samples_min", std::to_string(p.samples.min)});
    }
    if (!p.view.empty()) attributes.push_back({"steradian:view", p.view});
    if (p.is_denoised) attributes.push_back({"steradian:denoised", "visibility"});
    if (p.seconds) attributes.push_back({"steradian:time", fmt::format("{:.9g} s", *p.seconds)});
    return attributes;
}

} // namespace sr::render
