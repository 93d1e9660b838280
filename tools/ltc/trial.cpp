#include "ltc/trial.hpp"

#include "ggx.hpp"
#include "random_emitter.hpp"

#include <algorithm>

namespace sr::ltc {
namespace {

/// A direction and its part of ∫ f_r cosθ.
struct Ray {
    dvec3 w;
    double reflected;
};

constexpr double golden =
    0.6180339887498949; // (√5 - 1)/2: the lattice of the golden ratio is even at any count

double schlick(double F0, double weight) { return F0 + (1.0 - F0) * weight; }

/// ∫ f_r cosθ as a sum over directions distributed as the visible normals and, for plastic, as the cosine.
std::vector<Ray> rays_of(Material material, double cos_o, double alpha, int points) {
    const dvec3 wo = direction_at(cos_o);
    std::vector<Ray> rays;
    const auto add = [&](dvec3 w, double reflected) {
        if (w.z > 0.0 && reflected > 0.0) rays.push_back({w, reflected / points});
    };
    for (int i = 0; i < points; ++i) {
        const double u = (i + 0.5) / points, v = std::fmod(i * golden, 1.0);
        const dvec3 w = visible_direction(u, v, wo, alpha);
        const double F0 = material == Material::metal ? 1.0 : 0.04;
        add(w, f_cos(w, wo, alpha) / p_visible(w, wo, alpha) * schlick(F0, schlick_weight(w, wo)));
        if (material == Material::metal) continue;
        const double phi = 2.0 * pi * v;
        const dvec3 d(std::sqrt(u) * std::cos(phi), std::sqrt(u) * std::sin(phi), std::sqrt(1.0 - u));
        add(d, 1.0 - schlick(0.04, schlick_weight(d, wo)));
    }
    return rays;
}

} // namespace

std::vector<Trial> trials(Shape shape, Material material, const Cell& cell, int count, std::uint64_t seed,
                          int points) {
    Random random(seed);
    const double alpha = cell.roughness * cell.roughness;
    std::vector<Trial> found;
    while (static_cast<int>(found.size()) < count) {
        const double angle = cell.min_angle + random() * (cell.max_angle - cell.min_angle);
        const double cos_o = std::cos(angle);
        const std::vector<Ray> rays = rays_of(material, cos_o, alpha, points);
        double albedo = 0.0;
        for (const Ray& ray : rays) albedo += ray.reflected;
        for (bool is_found = false; !is_found;) { // emitters until one shines into the lobe
            const RandomEmitter emitter = random_emitter(shape, random);
            constexpr std::size_t few = 300;
            const std::size_t stride = std::max<std::size_t>(1, rays.size() / few);
            double estimate = 0.0;
            for (std::size_t i = 0; i < rays.size(); i += stride)
                if (emitter.meets(rays[i].w)) estimate += rays[i].reflected * static_cast<double>(stride);
            if (estimate < 0.07 * albedo) continue;
            double reflected = 0.0;
            for (const Ray& ray : rays)
                if (emitter.meets(ray.w)) reflected += ray.reflected;
            if (reflected < 0.1 * albedo) continue;
            found.push_back({emitter.light, alpha, cos_o, reflected});
            is_found = true;
        }
    }
    return found;
}

std::vector<double> errors(std::span<const Trial> trials, std::span<const double> got) {
    std::vector<double> result;
    for (std::size_t i = 0; i < trials.size(); ++i) {
        const double error = std::abs(got[i] / trials[i].reflected - 1.0);
        result.push_back(std::isnan(error) ? INFINITY : error);
    }
    std::sort(result.begin(), result.end());
    return result;
}

} // namespace sr::ltc
