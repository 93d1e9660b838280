#pragma once
// GGX and its linearly transformed cosine in doubles, in the frame where n = z and wo lies in the plane y =
// 0. Shares no code with the shaders, so that it can judge them.
#include <algorithm>
#include <cmath>
#include <glm/glm.hpp>
#include <numbers>

namespace sr::ltc {

using glm::dvec3;
using std::numbers::pi;

/// Direction to the viewer with cosine cos_o.
inline dvec3 direction_at(double cos_o) { return {std::sqrt(1.0 - cos_o * cos_o), 0.0, cos_o}; }

/// D(h) [1/sr]. Walter et al. 2007, Eq. 33.
inline double D_ggx(dvec3 h, double alpha) {
    const double d = h.x * h.x + h.y * h.y + alpha * alpha * h.z * h.z;
    return alpha * alpha / (pi * d * d);
}

/// D V cosθ_i [1/sr]: the GGX lobe where F = 1, times the cosine. V: Heitz 2014, Eq. 99.
inline double f_cos(dvec3 wi, dvec3 wo, double alpha) {
    if (wi.z <= 0.0) return 0.0;
    const double a2 = alpha * alpha;
    const double lambda_o = wi.z * std::sqrt(wo.z * wo.z * (1.0 - a2) + a2);
    const double lambda_i = wo.z * std::sqrt(wi.z * wi.z * (1.0 - a2) + a2);
    return D_ggx(glm::normalize(wi + wo), alpha) * 0.5 / (lambda_o + lambda_i) * wi.z;
}

/// (1 - w·h)⁵: what Schlick's approximation weighs 1 - F0 with.
inline double schlick_weight(dvec3 wi, dvec3 wo) {
    return std::pow(1.0 - glm::dot(wo, glm::normalize(wi + wo)), 5.0);
}

/// The density of the normals that wo sees, as directions wi [1/sr]. Heitz 2018, Eq. 2 and 17.
inline double p_visible(dvec3 wi, dvec3 wo, double alpha) {
    const double a2 = alpha * alpha;
    return D_ggx(glm::normalize(wi + wo), alpha) / (2.0 * (wo.z + std::sqrt(a2 + (1.0 - a2) * wo.z * wo.z)));
}

/// The direction of density p_visible for (u, v) in [0, 1)²; may lie below the horizon. Dupuy & Benyoub 2023.
inline dvec3 visible_direction(double u, double v, dvec3 wo, double alpha) {
    const dvec3 o = glm::normalize(dvec3(alpha * wo.x, alpha * wo.y, wo.z));
    const double z = 1.0 - u * (1.0 + o.z);
    const double r = std::sqrt(std::max(0.0, 1.0 - z * z));
    const dvec3 h = dvec3(r * std::cos(2.0 * pi * v), r * std::sin(2.0 * pi * v), z) + o;
    const dvec3 normal = glm::normalize(dvec3(alpha * h.x, alpha * h.y, h.z));
    return 2.0 * glm::dot(wo, normal) * normal - wo;
}

/// A cosine lobe through M = [a 0 b; 0 c 0; 0 0 1], which leaves the horizon where it is.
struct Lobe {
    double a = 1.0;
    double b = 0.0;
    double c = 1.0;

    dvec3 warped(dvec3 w) const { return {(w.x - b * w.z) / a, w.y / c, w.z}; } // M⁻¹ w
    dvec3 unwarped(dvec3 q) const { return {a * q.x + b * q.z, c * q.y, q.z}; } // M q
    /// [1/sr]; integrates to 1 over the hemisphere. Heitz et al. 2016, Eq. 1.
    double density(dvec3 w) const {
        const dvec3 q = warped(w);
        const double q2 = glm::dot(q, q);
        return w.z <= 0.0 ? 0.0 : w.z / (a * c * pi * q2 * q2);
    }
};

} // namespace sr::ltc
