#include "render/provenance.hpp"

#include <fmt/format.h>

namespace sr::render {

const char* name_of(Estimator estimator) { return estimator == Estimator::analytic ? "analytic" : "sampled"; }

std::vector<image::Attribute> attributes_of(const Provenance& p, const gl::ContextInfo& gl) {
    std::vector<image::Attribute> attributes{{"steradian:version", STERADIAN_VERSION},
                                             {"steradian:unit", p.unit},
                                             {"steradian:estimator", name_of(p.estimator)},
                                             {"steradian:visibility", std::string(name_of(p.visibility))},
                                             {"steradian:samples", std::to_string(p.samples)},
                                             {"steradian:seed", std::to_string(p.seed)},
                                             {"steradian:camera", p.camera},
                                             {"steradian:GL_RENDERER", gl.renderer},
                                             {"steradian:GL_VERSION", gl.version}};
    if (p.estimator == Estimator::analytic)
        attributes.push_back({"steradian:analytic_points", std::to_string(p.analytic_points)});
    if (p.error) attributes.push_back({"steradian:error", fmt::format("{:.4g}", *p.error)});
    if (p.seconds) attributes.push_back({"steradian:time", fmt::format("{:.9g} s", *p.seconds)});
    return attributes;
}

} // namespace sr::render
