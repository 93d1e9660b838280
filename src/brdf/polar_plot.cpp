#include "brdf/polar_plot.hpp"

#include "core/luminance.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <fmt/format.h>

namespace sr::brdf {
namespace {

constexpr double center_x = 320.0, center_y = 330.0, radius = 250.0; // [px]
constexpr int steps = 1440;                                          // of θ_i, from -90° to 90°

struct View {
    float degrees;
    const char* color; // Okabe & Ito 2008: told apart by everybody
};
constexpr std::array<View, 4> views{
    {{0.0f, "#0072b2"}, {30.0f, "#009e73"}, {60.0f, "#d55e00"}, {80.0f, "#cc79a7"}}};

vec3 in_plane(float theta) { return {std::sin(theta), 0.0f, std::cos(theta)}; }

std::string point(double theta, double r) {
    return fmt::format("{:.1f},{:.1f}", center_x + r * radius * std::sin(theta),
                       center_y - r * radius * std::cos(theta));
}

std::string escaped(const std::string& text) {
    std::string result;
    for (const char c : text) {
        if (c == '<')
            result += "&lt;";
        else if (c == '>')
            result += "&gt;";
        else if (c == '&')
            result += "&amp;";
        else
            result += c;
    }
    return result;
}

/// The grid: rings at quarters, a spoke every 30°.
std::string grid() {
    std::string svg;
    for (const double r : {0.25, 0.5, 0.75, 1.0})
        svg += fmt::format("<path d=\"M{} A{:.1f} {:.1f} 0 0 1 {}\" class=\"grid\"/>\n",
                           point(-glm::half_pi<double>(), r), r * radius, r * radius,
                           point(glm::half_pi<double>(), r));
    for (int degrees = -90; degrees <= 90; degrees += 30) {
        const double theta = glm::radians(static_cast<double>(degrees));
        svg += fmt::format("<path d=\"M{} L{}\" class=\"grid\"/>\n", point(theta, 0.0), point(theta, 1.0));
        const std::string at = point(theta, 1.06);
        const auto comma = at.find(',');
        svg += fmt::format("<text x=\"{}\" y=\"{}\" text-anchor=\"middle\">{}°</text>\n", at.substr(0, comma),
                           at.substr(comma + 1), degrees);
    }
    return svg;
}

std::string curve(Trial& trial, const View& view, std::size_t row) {
    const vec3 wo = in_plane(-glm::radians(view.degrees));
    std::vector<Pair> pairs;
    for (int i = 1; i < steps; ++i)
        pairs.push_back({in_plane(pi * (static_cast<float>(i) / steps - 0.5f)), wo});
    const std::vector<vec3> f = trial.values(pairs);
    std::vector<double> lobe;
    for (std::size_t i = 0; i < f.size(); ++i)
        lobe.push_back(std::max(0.0, static_cast<double>(luminance(f[i]) * pairs[i].wi.z)));
    const double most = *std::max_element(lobe.begin(), lobe.end());
    std::string path;
    for (std::size_t i = 0; i < lobe.size(); ++i)
        path += (i == 0 ? "M" : " L")
                + point(std::asin(static_cast<double>(pairs[i].wi.x)), most > 0.0 ? lobe[i] / most : 0.0);
    const glm::dvec3 albedo = trial.albedos(std::array{wo}, 8192)[0];
    const double y = 400.0 + 20.0 * static_cast<double>(row);
    return fmt::format(
        "<path d=\"{}\" fill=\"none\" stroke=\"{}\" stroke-width=\"2\"/>\n"
        "<path d=\"M{} L{}\" stroke=\"{}\" stroke-dasharray=\"5 4\"/>\n"
        "<text x=\"70\" y=\"{}\" fill=\"{}\">wo at {}°: at most {:.4g} /sr, albedo {:.3f} {:.3f} "
        "{:.3f}</text>\n",
        path, view.color, point(-glm::radians(static_cast<double>(view.degrees)), 0.0),
        point(-glm::radians(static_cast<double>(view.degrees)), 1.0), view.color, y, view.color, view.degrees,
        most, albedo.x, albedo.y, albedo.z);
}

} // namespace

std::string polar_plot(Trial& trial, const std::string& title) {
    std::string svg =
        "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"640\" height=\"490\" font-family=\"sans-serif\" "
        "font-size=\"14\">\n<style>.grid{fill:none;stroke:#ccc}</style>\n"
        "<rect width=\"640\" height=\"490\" fill=\"white\"/>\n";
    svg += fmt::format("<text x=\"320\" y=\"30\" text-anchor=\"middle\" font-size=\"18\">{}: f_r cosθ, each "
                       "view to its own scale</text>\n",
                       escaped(title));
    svg += grid();
    for (std::size_t i = 0; i < views.size(); ++i) svg += curve(trial, views[i], i);
    return svg + "</svg>\n";
}

} // namespace sr::brdf
