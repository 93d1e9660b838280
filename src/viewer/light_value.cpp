#include "viewer/light_value.hpp"

#include "core/error.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <fmt/format.h>

namespace sr::viewer {
namespace {

using scene::Light;
using scene::Quantity;

template<class AnyLight>
auto& own(AnyLight& light) {
    if constexpr (requires { light.L; })
        return light.L;
    else if constexpr (requires { light.I; })
        return light.I;
    else
        return light.E;
}

/// The own quantity from a stated one; absent where that does not determine it.
std::optional<double> native(Quantity quantity, double value, const LightGroup& group) {
    const Light& light = group.lights.front();
    if (const auto* point = std::get_if<scene::PointLight>(&light)) {
        if (point->profile < 0) return scene::point_intensity_from(quantity, value, point->radius);
        if (quantity != Quantity::flux) return std::nullopt;
        return value / scene::flux_of(group.profiles[static_cast<std::size_t>(point->profile)]);
    }
    if (const auto* spot = std::get_if<scene::SpotLight>(&light))
        return scene::spot_intensity_from(quantity, value, *spot);
    if (const auto* sun = std::get_if<scene::DirectionalLight>(&light))
        return scene::sun_irradiance_from(quantity, value, sun->angular_radius);
    scene::Radiator all;
    for (const Light& part : group.lights)
        std::visit(
            [&](const auto& l) {
                if constexpr (requires { scene::radiator_of(l); }) {
                    const scene::Radiator one = scene::radiator_of(l);
                    all.flux_area += one.flux_area;
                    all.axis_area = group.lights.size() == 1 ? one.axis_area : std::nullopt;
                }
            },
            part);
    return scene::radiance_from(quantity, value, all);
}

std::string_view trimmed(std::string_view text) {
    const auto first = text.find_first_not_of(" \t");
    if (first == std::string_view::npos) return {};
    return text.substr(first, text.find_last_not_of(" \t") - first + 1);
}

[[noreturn]] void refuse(std::string_view what) {
    throw Error(what, "type a number with lm, cd, lx, cd/m^2, W, W/sr, W/m^2 or K, e.g. 800 lm or 6500 K");
}

vec3 with_color(const scene::LightColor& color, vec3 now) {
    return color.rgb * static_cast<float>(scene::luminance(now));
}

std::string text_of(double value, Quantity quantity, scene::UnitSystem units) {
    return fmt::format("{:.4g} {}", value, scene::name_of({quantity, units}));
}

} // namespace

vec3 quantity_of(const Light& light) {
    return std::visit([](const auto& l) { return vec3(own(l)); }, light);
}

void set_quantity(Light& light, vec3 quantity) {
    std::visit([&](auto& l) { own(l) = quantity; }, light);
}

Quantity kind_of(const Light& light) {
    if (std::holds_alternative<scene::DirectionalLight>(light)) return Quantity::irradiance;
    const bool is_punctual =
        std::holds_alternative<scene::PointLight>(light) || std::holds_alternative<scene::SpotLight>(light);
    return is_punctual ? Quantity::intensity : Quantity::radiance;
}

bool has_profile(const Light& light) {
    const auto* point = std::get_if<scene::PointLight>(&light);
    return point && point->profile >= 0;
}

std::string value_text(const LightGroup& group) {
    const Light& light = group.lights.front();
    const double value = scene::luminance(quantity_of(light));
    std::string text = has_profile(light) ? fmt::format("factor {:.4g}", value)
                                          : text_of(value, kind_of(light), group.units);
    double flux = 0.0;
    for (const Light& part : group.lights) {
        const auto phi = scene::flux_of(part, group.profiles);
        if (!phi) return text;
        flux += scene::luminance(*phi);
    }
    return text + ", " + text_of(flux, Quantity::flux, group.units);
}

vec3 typed_quantity(std::string_view typed, const LightGroup& group) {
    const std::string_view text = trimmed(typed);
    double value = 0.0;
    const auto [end, failure] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (failure != std::errc{} || !(value >= 0.0 && value < 1e30))
        refuse(fmt::format("'{}' is no quantity", text));
    const std::string_view name = trimmed(text.substr(static_cast<std::size_t>(end - text.data())));
    const vec3 now = quantity_of(group.lights.front());
    if (name == "K") {
        if (!(value >= 500.0 && value <= 1e6)) refuse("a temperature lies between 500 and 1000000 K");
        return with_color(scene::color_of_blackbody(value), now);
    }
    const vec3 hue = scene::with_unit_luminance(glm::dvec3(now));
    if (name.empty()) return hue * static_cast<float>(value);
    const auto unit = scene::unit_named(name);
    if (!unit) refuse(fmt::format("there is no unit '{}'", name));
    const double in_scene = scene::converted(value, unit->system, group.units, scene::lumens_per_watt);
    const auto stated = native(unit->quantity, in_scene, group);
    if (!stated || !std::isfinite(*stated)) refuse(fmt::format("such a light cannot be stated in {}", name));
    return hue * static_cast<float>(*stated);
}

std::optional<vec3> center_of(const Light& light) {
    return std::visit(
        [](const auto& l) -> std::optional<vec3> {
            if constexpr (requires { l.position; })
                return l.position;
            else if constexpr (
                requires { l.half_axis; } || requires { l.half_u; })
                return l.center;
            else if constexpr (requires { l.center(); })
                return l.center();
            else if constexpr (requires { l.center; })
                return l.center;
            else if constexpr (requires { l.triangles; }) {
                vec3 sum(0.0f);
                for (const auto& triangle : l.triangles)
                    for (const vec3 corner : triangle.corners) sum += corner;
                return sum / static_cast<float>(3 * l.triangles.size());
            } else
                return std::nullopt;
        },
        light);
}

Light transformed(Light light, const mat4& by) {
    const mat3 m(by);
    const float scale = std::cbrt(std::abs(glm::determinant(m)));
    const mat3 rotation = m / scale; // exact for the uniform scales that the viewer makes
    const auto moved = [&](vec3& point) { point = vec3(by * vec4(point, 1.0f)); };
    std::visit(
        [&](auto& l) {
            if constexpr (requires { l.position; }) moved(l.position);
            if constexpr (requires { l.rotation; }) l.rotation += std::atan2(rotation[2].x, rotation[2].z);
            if constexpr (requires { l.direction; }) l.direction = glm::normalize(rotation * l.direction);
            if constexpr (requires { l.world_from_profile; })
                l.world_from_profile = rotation * l.world_from_profile;
            if constexpr (requires { l.half_u; }) {
                l.half_u = m * l.half_u;
                l.half_v = m * l.half_v;
            }
            if constexpr (requires { l.half_axis; }) l.half_axis = m * l.half_axis;
            if constexpr (requires { l.radius; }) l.radius *= scale;
            if constexpr (requires { l.corners; })
                for (vec3& corner : l.corners) moved(corner);
            else if constexpr (requires { l.center; })
                moved(l.center);
            if constexpr (requires { l.triangles; })
                for (auto& triangle : l.triangles)
                    for (vec3& corner : triangle.corners) moved(corner);
        },
        light);
    return light;
}

scene::Bounds bounds_of(const Light& light, float least) {
    scene::Bounds bounds;
    const auto center = center_of(light);
    if (!center) return bounds;
    vec3 half(least);
    std::visit(
        [&](const auto& l) {
            if constexpr (requires { l.radius; }) half = glm::max(half, vec3(l.radius));
            if constexpr (requires { l.half_axis; }) half += glm::abs(l.half_axis);
            if constexpr (requires { l.half_u; }) half += glm::abs(l.half_u) + glm::abs(l.half_v);
            if constexpr (requires { l.corners; })
                for (const vec3 corner : l.corners) bounds.extend(corner);
            if constexpr (requires { l.triangles; })
                for (const auto& triangle : l.triangles)
                    for (const vec3 corner : triangle.corners) bounds.extend(corner);
        },
        light);
    bounds.extend(*center - half);
    bounds.extend(*center + half);
    return bounds;
}

} // namespace sr::viewer
