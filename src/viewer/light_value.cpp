#include "viewer/light_value.hpp"

#include "core/error.hpp"
#include "core/text.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <fmt/format.h>

namespace sr::viewer {
namespace {

using scene::Light;
using scene::Quantity;

/// The own quantity from a stated one; absent where that does not determine it.
std::optional<double> native(Quantity quantity, double value, const LightGroup& group) {
    const Light& light = group.lights.front();
    if (scene::has_profile(light)) {
        if (quantity != Quantity::flux) return std::nullopt;
        const int profile = std::get<scene::PointLight>(light).profile;
        return value / scene::flux_of(group.profiles[static_cast<std::size_t>(profile)]);
    }
    if (group.lights.size() == 1)
        return std::visit([&](const auto& l) { return scene::quantity_from(l, quantity, value); }, light);
    scene::Radiator all; // without an axis
    for (const Light& part : group.lights)
        std::visit(
            [&](const auto& l) {
                if constexpr (requires { l.radiator(); }) all.flux_area += l.radiator().flux_area;
            },
            part);
    return scene::radiance_from(quantity, value, all);
}

[[noreturn]] void refuse(std::string_view what) {
    throw Error(
        what, "type a number with lm, cd, lx, cd/m^2, W, W/sr, W/m^2, K or EV, e.g. 800 lm, 6500 K or +1 EV");
}

vec3 with_color(const scene::LightColor& color, vec3 now) {
    return color.rgb * static_cast<float>(scene::luminance(now));
}

std::string text_of(double value, Quantity quantity, scene::UnitSystem units) {
    return fmt::format("{:.4g} {}", value, scene::name_of({quantity, units}));
}

} // namespace

std::string value_text(const LightGroup& group) {
    const Light& light = group.lights.front();
    const double value = scene::luminance(quantity_of(light));
    std::string text = has_profile(light) ? fmt::format("factor {:.4g}", value)
                                          : text_of(value, scene::quantity_kind_of(light), group.units);
    double flux = 0.0;
    for (const Light& part : group.lights) {
        const auto phi = scene::flux_of(part, group.profiles);
        if (!phi) return text;
        flux += scene::luminance(*phi);
    }
    return text + ", " + text_of(flux, Quantity::flux, group.units);
}

vec3 parse_quantity(std::string_view typed, const LightGroup& group) {
    std::string_view text = trimmed(typed);
    if (text.starts_with('+')) text.remove_prefix(1); // which std::from_chars does not take
    double value = 0.0;
    const auto [end, failure] = std::from_chars(text.data(), text.data() + text.size(), value);
    constexpr double most_EV = 30.0;
    if (failure == std::errc{} && trimmed(text.substr(static_cast<std::size_t>(end - text.data()))) == "EV") {
        if (!(std::abs(value) <= most_EV)) refuse("a change lies between -30 and 30 EV");
        return quantity_of(group.lights.front()) * static_cast<float>(std::exp2(value));
    }
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

} // namespace sr::viewer
