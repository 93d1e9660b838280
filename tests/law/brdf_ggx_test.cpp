#include "support/address.hpp"
#include "support/glsl_table.hpp"

#include <cmath>

using namespace sr;
using namespace sr::testing;

namespace {

const std::vector<float> widths{1e-4f, 1e-3f, 0.01f, 0.05f, 0.1f, 0.25f, 0.5f, 0.75f, 1.0f};

// ∫ D(h) (n·h) dω = 1 over the hemisphere: the microfacets' projected area is the surface's (Walter et al.
// 2007, Eq. 4). Midpoint rule in s with θ = π/2 s⁴, which puts points where narrow lobes are and knows
// nothing of D.
const Test normalised("law.brdf.ggx.normalised", [] {
    std::vector<Row> rows;
    for (const float alpha : widths) rows.push_back({vec4(alpha)});
    const auto integrals = evaluate("#include \"brdf/ggx.glsl\"", R"(
        const int count = 8192;
        float sum = 0.0;
        for (int i = 0; i < count; ++i) {
            float s = (float(i) + 0.5) / float(count);
            float theta = 0.5 * pi * s * s * s * s;
            float dtheta = 0.5 * pi * 4.0 * s * s * s / float(count);
            vec3 h = vec3(sin(theta), 0.0, cos(theta));
            sum += D_ggx(vec3(0.0, 0.0, 1.0), h, a.x) * h.z * 2.0 * pi * h.x * dtheta;
        }
        return vec4(sum);)",
                                    rows);
    for (std::size_t i = 0; i < rows.size(); ++i)
        EXPECT_NEAR(integrals[i].x, 1.0f, 1e-3f) << "alpha " << widths[i];
});

// V = G / (4 cos_i cos_o) with the height-correlated G = 1 / (1 + Λ(wi) + Λ(wo)) (Heitz 2014, Eq. 99; Λ: Eq.
// 72), evaluated here in doubles and divided, where the shader has it in one piece.
const Test smith("law.brdf.ggx.smith_height_correlated", [] {
    std::vector<Row> rows;
    for (const float alpha : widths)
        for (const float cos_i : {0.01f, 0.2f, 0.6f, 1.0f})
            for (const float cos_o : {0.01f, 0.3f, 0.7f, 1.0f})
                rows.push_back({vec4(cos_i, cos_o, alpha, 0.0f)});
    const auto values =
        evaluate("#include \"brdf/ggx.glsl\"", "return vec4(V_smith_ggx(a.x, a.y, a.z));", rows);
    const auto lambda = [](double cos_theta, double alpha) {
        const double tan2 = 1.0 / (cos_theta * cos_theta) - 1.0;
        return 0.5 * (std::sqrt(1.0 + alpha * alpha * tan2) - 1.0);
    };
    for (std::size_t i = 0; i < rows.size(); ++i) {
        const vec4 r = rows[i][0];
        const double expected = 1.0 / (1.0 + lambda(r.x, r.z) + lambda(r.y, r.z)) / (4.0 * r.x * r.y);
        EXPECT_NEAR(values[i].x / expected, 1.0, 1e-5)
            << "cos_i " << r.x << " cos_o " << r.y << " alpha " << r.z;
    }
});

// The value at the pole has a closed form that a wrong power of alpha cannot meet: D(n) = 1 / (π α²).
const Test pole("law.brdf.ggx.value_at_the_pole", [] {
    std::vector<Row> rows;
    for (const float alpha : widths) rows.push_back({vec4(alpha)});
    const auto values = evaluate("#include \"brdf/ggx.glsl\"",
                                 "return vec4(D_ggx(vec3(0.0, 0.0, 1.0), vec3(0.0, 0.0, 1.0), a.x));", rows);
    for (std::size_t i = 0; i < rows.size(); ++i)
        EXPECT_NEAR(values[i].x * pi * widths[i] * widths[i], 1.0f, 1e-5f) << "alpha " << widths[i];
});

} // namespace
