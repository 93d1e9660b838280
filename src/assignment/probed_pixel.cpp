#include "assignment/probed_pixel.hpp"

#include "assignment/value_check.hpp"

#include <fmt/format.h>
#include <optional>

namespace sr::assignment {

using nlohmann::ordered_json;

std::string rgb_text(vec3 value) { return text_of(glm::dvec4(glm::dvec3(value), 0.0), "vec3"); }

std::string name_at(const scene::Light& light, std::size_t k) {
    const std::string& name = scene::name_of(light);
    return name.empty() ? fmt::format("light {}", k) : fmt::format("'{}'", name);
}

namespace {

/// cosθ between the normal and the way to the middle of the light; absent for lights that are nowhere.
std::optional<float> cosine_to(const scene::Light& light, const render::PixelTerms& terms) {
    if (const auto* sun = std::get_if<scene::DirectionalLight>(&light))
        return -glm::dot(terms.n, glm::normalize(sun->direction));
    if (const auto center = scene::center_of(light))
        return glm::dot(terms.n, glm::normalize(*center - terms.x));
    return std::nullopt;
}

} // namespace

ordered_json terms_json(const scene::RenderScene& stage, const render::PixelTerms& terms) {
    ordered_json lights = ordered_json::array();
    for (std::size_t k = 0; k < terms.lights.size(); ++k) {
        const render::LightTerms& t = terms.lights[k];
        const auto cosine = cosine_to(stage.lights[k], terms);
        lights.push_back({{"name", scene::name_of(stage.lights[k])},
                          {"cos", cosine ? ordered_json(*cosine) : ordered_json()},
                          {"V", t.V},
                          {"E", luminance(t.E)},
                          {"f_r", luminance(t.f_r)},
                          {"L_r", {t.L_r.x, t.L_r.y, t.L_r.z}}});
    }
    return {{"x", {terms.x.x, terms.x.y, terms.x.z}},
            {"n", {terms.n.x, terms.n.y, terms.n.z}},
            {"L_e", {terms.L_e.x, terms.L_e.y, terms.L_e.z}},
            {"L_o", {terms.L_o.x, terms.L_o.y, terms.L_o.z}},
            {"lights", lights}};
}

std::string reason_of_darkness(const scene::Light& light, std::size_t k, const render::PixelTerms& terms,
                               const render::PixelTerms& reference) {
    const render::LightTerms& t = terms.lights[k];
    const std::string name = name_at(light, k);
    if (luminance(reference.lights[k].L_r) > 0.01f * luminance(reference.L_o))
        return fmt::format("{} adds 0 by mistake: with the reference it adds {}.", name,
                           rgb_text(reference.lights[k].L_r));
    const auto cosine = cosine_to(light, terms);
    if (cosine && *cosine <= 0.0f)
        return fmt::format(
            "{} adds 0: cosθ = {:.2f} towards its middle. It is below the horizon of the surface.", name,
            *cosine);
    if (t.V == 0.0f) return fmt::format("{} adds 0: V = 0. Something stands between x and the light.", name);
    if (luminance(t.E) == 0.0f)
        return fmt::format("{} adds 0: E = 0 though cosθ is {:.2f}. It sends nothing in this direction.",
                           name, cosine.value_or(0.0f));
    return fmt::format("{} adds 0: f_r = {:.3g} for E = {:.3g} lx.", name, luminance(t.f_r), luminance(t.E));
}

} // namespace sr::assignment
