#include "mitsuba/emitters.hpp"
#include "support/address.hpp"

#include <cmath>

using namespace sr;
using namespace sr::testing;

namespace {

const Test surface("unit.mitsuba.capsule.has_the_tubes_surface_and_faces_outwards", [] {
    for (const float half : {0.0f, 0.1f, 3.0f}) {
        const scene::TubeLight light{"", {1, 2, 3}, half * glm::normalize(vec3(1, -2, 1)), 0.25f};
        const mitsuba::Triangles capsule = mitsuba::capsule(light);
        double area = 0.0;
        for (std::size_t i = 0; i < capsule.indices.size(); i += 3) {
            const auto corner = [&](std::size_t k) { return capsule.positions[capsule.indices[i + k]]; };
            const vec3 doubled = glm::cross(corner(1) - corner(0), corner(2) - corner(0));
            area += 0.5 * static_cast<double>(glm::length(doubled));
            if (glm::length(doubled) < 1e-6f) continue; // a sliver at a pole
            EXPECT_GT(glm::dot(doubled, capsule.normals[capsule.indices[i]]), 0.0f);
        }
        EXPECT_NEAR(area / static_cast<double>(light.area()), 1.0, 2e-6);
    }
});

} // namespace
