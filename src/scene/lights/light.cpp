#include "scene/lights/light.hpp"

#include "core/error.hpp"
#include "scene/lights/emitter.hpp"

namespace sr::scene {
namespace {

/// I, E or L.
template<class L>
auto& quantity_in(L& light) {
    if constexpr (requires { light.L; })
        return light.L;
    else if constexpr (requires { light.I; })
        return light.I;
    else
        return light.E;
}

/// The sizes that a light has now.
template<class L>
std::span<const Dimension<L>> sizes_in(const L& light) {
    if constexpr (requires { light.sizes(); })
        return light.sizes();
    else if constexpr (requires { light.radius; })
        return light.radius > 0.0f ? std::span<const Dimension<L>>(L::dimensions)
                                   : std::span<const Dimension<L>>{};
    else
        return {};
}

} // namespace

const std::string& name_of(const Light& light) {
    return std::visit([](const auto& l) -> const std::string& { return l.name; }, light);
}

void set_name(Light& light, const std::string& name) {
    std::visit([&](auto& l) { l.name = name; }, light);
}

std::string variety_of(const Light& light) {
    return std::visit(
        [](const auto& l) {
            const std::string kind(l.kind);
            if constexpr (requires { l.angular_radius; })
                if (l.angular_radius > 0.0f) return std::string("sun");
            if constexpr (requires { l.position; })
                if (l.radius > 0.0f) return "round " + kind;
            if constexpr (requires { l.profile; })
                if (l.profile >= 0) return std::string("profile");
            return kind;
        },
        light);
}

std::optional<bool> visibility_of(const Light& light) {
    return std::visit(
        []<class L>(const L& l) -> std::optional<bool> {
            if constexpr (std::is_same_v<L, MeshLight>) return true;
            if constexpr (std::is_same_v<L, PointLight>)
                return l.radius > 0.0f ? std::optional(l.is_visible) : std::nullopt;
            else if constexpr (
                requires { l.is_visible; } && !requires { l.position; })
                return l.is_visible;
            return std::nullopt;
        },
        light);
}

bool passes_back_faces(const Light& light) {
    return std::visit(
        [](const auto& l) {
            if constexpr (requires { l.passes_back_faces; })
                return l.passes_back_faces;
            else
                return false;
        },
        light);
}

vec3 quantity_of(const Light& light) {
    return std::visit([](const auto& l) { return vec3(quantity_in(l)); }, light);
}

void set_quantity(Light& light, vec3 quantity) {
    std::visit([&](auto& l) { quantity_in(l) = quantity; }, light);
}

Quantity quantity_kind_of(const Light& light) {
    return std::visit(
        [](const auto& l) {
            if constexpr (requires { l.L; })
                return Quantity::radiance;
            else if constexpr (requires { l.I; })
                return Quantity::intensity;
            else
                return Quantity::irradiance;
        },
        light);
}

bool has_profile(const Light& light) {
    const auto* point = std::get_if<PointLight>(&light);
    return point && point->profile >= 0;
}

bool needs_its_scene(const Light& light) {
    return has_profile(light)
           || std::visit(
               []<class L>(const L& l) {
                   if constexpr (requires { l.map; })
                       if constexpr (requires { l.map.is_present(); }) return l.map.is_present();
                   return std::is_same_v<L, MeshLight> || std::is_same_v<L, EnvironmentLight>;
               },
               light);
}

std::optional<vec3> flux_of(const Light& light, const std::vector<LightProfile>& profiles) {
    return std::visit(
        [&](const auto& l) -> std::optional<vec3> {
            if constexpr (requires { l.radiator(); })
                return vec3(pi64 * l.radiator().flux_area * glm::dvec3(l.L));
            else if constexpr (requires { l.flux(profiles); })
                return l.flux(profiles);
            else
                return std::nullopt;
        },
        light);
}

bool has_extent(const Light& light) {
    return std::visit(
        [](const auto& l) {
            if constexpr (requires { l.has_extent(); })
                return l.has_extent();
            else
                return true;
        },
        light);
}

EmitterPoint sample_point(const Light& light, vec3 u) {
    return std::visit([&](const auto& l) { return l.sample_point(u); }, light);
}

EmitterPoint middle_of(const Light& light) {
    return std::visit([](const auto& l) { return l.middle(); }, light);
}

std::optional<vec3> center_of(const Light& light) {
    return std::visit(
        [](const auto& l) -> std::optional<vec3> {
            if constexpr (requires { l.position; })
                return l.position;
            else if constexpr (requires { l.center(); })
                return l.center();
            else if constexpr (requires { l.center; })
                return l.center;
            else
                return std::nullopt;
        },
        light);
}

Bounds bounds_of(const Light& light, float min_half) {
    Bounds bounds;
    const auto center = center_of(light);
    if (!center) return bounds;
    bounds = box_around(*center, vec3(min_half));
    std::visit(
        [&](const auto& l) {
            if constexpr (requires { l.bounds(); }) {
                const Bounds own = l.bounds();
                bounds.extend(own.min);
                bounds.extend(own.max);
            }
        },
        light);
    return bounds;
}

Light transformed(Light light, const mat4& by) {
    const Motion motion(by);
    std::visit([&](auto& l) { l.transform(motion); }, light);
    return light;
}

std::vector<LightSize> sizes_of(const Light& light) {
    return std::visit(
        [](const auto& l) {
            std::vector<LightSize> sizes;
            for (const auto& dimension : sizes_in(l))
                sizes.push_back(
                    {dimension.key, dimension.of(l), dimension.axis ? l.*dimension.axis : vec3(0.0f)});
            return sizes;
        },
        light);
}

void set_size(Light& light, std::size_t index, float value) {
    std::visit(
        [&](auto& l) {
            const auto sizes = sizes_in(l);
            require(index < sizes.size() && value > 0.0f, "the light has the size, and keeps it");
            sizes[index].scale(l, value / sizes[index].of(l));
        },
        light);
}

void take_sizes_of(Light& light, const Light& other) {
    const std::vector<LightSize> sizes = sizes_of(other);
    const std::size_t count = sizes_of(light).size();
    const float across = sizes.size() < count ? 2.0f : 1.0f; // a radius, where an ellipse became a circle
    for (std::size_t i = 0; i < sizes_of(light).size(); ++i) // an ellipse may become a circle on the way
        set_size(light, i, across * sizes[std::min(i, sizes.size() - 1)].size);
}

bool is_scalable(const Light& light) {
    return !sizes_of(light).empty() || std::holds_alternative<PolygonLight>(light)
           || std::holds_alternative<MeshLight>(light);
}

std::optional<LightSurface> surface_of(const Light& light) {
    return std::visit(
        [](const auto& l) -> std::optional<LightSurface> {
            if constexpr (requires { l.surface(); })
                return l.surface();
            else
                return std::nullopt;
        },
        light);
}

} // namespace sr::scene
