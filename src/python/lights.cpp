#include "python/lights.hpp"

#include "core/error.hpp"
#include "python/values.hpp"
#include "settings/bad_setting.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <nanobind/stl/array.h>
#include <nanobind/stl/optional.h>
#include <nanobind/stl/string.h>
#include <nanobind/stl/string_view.h>
#include <nanobind/stl/vector.h>
#include <type_traits>
#include <utility>

namespace sr::python {

std::vector<EditableLight> lights_of(const scene::Scene& scene, int file) {
    std::vector<EditableLight> lights;
    for (const scene::Light& light : scene.lights) {
        EditableLight& added = lights.emplace_back();
        added.light = light;
        added.origin = scene.origin;
        added.units = scene.units;
        if (has_profile(light)) added.profiles = scene.profiles;
        added.file = file;
        added.source = static_cast<int>(lights.size()) - 1;
    }
    return lights;
}

std::vector<EditableMaterial> materials_of(const scene::Scene& scene) {
    std::vector<EditableMaterial> materials;
    for (std::size_t i = 0; i < scene.materials.size(); ++i)
        materials.push_back({static_cast<int>(i), scene.materials[i]});
    return materials;
}

namespace {

using scene::Light;
using scene::Quantity;
using settings::BadSetting;

// The quantities of a light.

void require_amount(double value, const char* what) {
    if (!std::isfinite(value) || value < 0.0)
        throw BadSetting(what, fmt::format("{} is not a finite number of 0 or more", value));
}

/// The light's own quantity for another one; absent if that one does not determine it.
std::optional<double> own_quantity(const EditableLight& light, Quantity quantity, double value) {
    if (quantity == quantity_kind_of(light.light) && !has_profile(light.light)) return value;
    if (has_profile(light.light)) {
        if (quantity != Quantity::flux) return std::nullopt;
        const double flux = luminance(*flux_of(light.light, light.profiles));
        const double factor = luminance(quantity_of(light.light));
        return flux > 0.0 ? std::optional(value / flux * factor) : std::nullopt;
    }
    return std::visit([&](const auto& l) { return scene::quantity_from(l, quantity, value); }, light.light);
}

/// As luminance; absent if such a light has none.
std::optional<double> amount_of(const EditableLight& light, Quantity quantity) {
    const double own = luminance(quantity_of(light.light));
    if (has_profile(light.light))
        return quantity == Quantity::flux
                   ? std::optional<double>(luminance(*flux_of(light.light, light.profiles)))
                   : std::nullopt;
    const auto unit = own_quantity(light, quantity, 1.0); // they are proportional
    return unit && *unit > 0.0 ? std::optional(own / *unit) : std::nullopt;
}

/// Keeps the colour; a light that is off becomes white.
void set_amount(EditableLight& light, Quantity quantity, double value) {
    constexpr std::array names{"flux", "intensity", "irradiance", "radiance"};
    const char* const name = names[static_cast<std::size_t>(quantity)];
    require_amount(value, name);
    const auto own = own_quantity(light, quantity, value);
    if (!own)
        throw BadSetting(name, fmt::format("does not determine what a {} light emits: set its {}",
                                           variety_of(light.light),
                                           names[static_cast<std::size_t>(quantity_kind_of(light.light))]));
    const vec3 color = quantity_of(light.light);
    const float before = luminance(color);
    const auto after = static_cast<float>(*own);
    set_quantity(light.light, before > 0.0f ? color * (after / before) : vec3(after));
    light.has_new_quantity = true;
}

template<Quantity quantity>
void bind_amount(nb::class_<EditableLight>& type, const char* name, const char* help) {
    type.def_prop_rw(
        name, [](const EditableLight& light) { return amount_of(light, quantity); },
        [](EditableLight& light, double value) { set_amount(light, quantity, value); }, help);
}

// The place of a light.

std::optional<DoubleTriple> position_of(const EditableLight& light) {
    const auto center = center_of(light.light);
    if (!center) return std::nullopt;
    const glm::dvec3 world = light.origin + glm::dvec3(*center);
    return DoubleTriple{world.x, world.y, world.z};
}

void move_by(EditableLight& light, const mat4& by) {
    light.light = transformed(std::move(light.light), by);
    light.motion = by * light.motion;
}

mat4 translation(vec3 by) {
    mat4 matrix(1.0f);
    matrix[3] = vec4(by, 1.0f);
    return matrix;
}

void set_position(EditableLight& light, const DoubleTriple& to) {
    const auto center = center_of(light.light);
    if (!center) throw BadSetting("position", "this light is infinitely far");
    const glm::dvec3 world(to[0], to[1], to[2]);
    if (!std::isfinite(world.x + world.y + world.z)) throw BadSetting("position", "is not finite");
    move_by(light, translation(vec3(world - light.origin) - *center));
}

/// The direction in which the light goes, or a flat one faces; absent where there is none.
std::optional<vec3> direction_of(const Light& light) {
    return std::visit(
        [](const auto& l) -> std::optional<vec3> {
            if constexpr (requires { l.direction; })
                return l.direction;
            else if constexpr (requires { l.normal(); })
                return l.normal();
            else if constexpr (requires { l.world_from_profile; }) // photometric zero is its -Y (ies.hpp)
                return l.profile >= 0 ? std::optional(-l.world_from_profile[1]) : std::nullopt;
            else
                return std::nullopt;
        },
        light);
}

vec3 unit(const Triple& direction) {
    const vec3 v = vector_of(direction);
    const float length = glm::length(v);
    if (!std::isfinite(length) || length == 0.0f) throw BadSetting("direction", "has no length");
    return v / length;
}

/// The rotation by the shortest way; half a turn is around any perpendicular.
mat4 rotation(vec3 from, vec3 to) {
    if (glm::dot(from, to) < -0.999999f) {
        const mat3 frame = scene::frame_around(from);
        return mat4(glm::mat3_cast(glm::angleAxis(pi, frame[0])));
    }
    return mat4(glm::mat3_cast(glm::quat(from, to)));
}

void set_direction(EditableLight& light, const Triple& direction) {
    const auto from = direction_of(light.light);
    if (!from) throw BadSetting("direction", fmt::format("a {} light has none", variety_of(light.light)));
    const vec3 center = center_of(light.light).value_or(vec3(0.0f));
    move_by(light, translation(center) * rotation(*from, unit(direction)) * translation(-center));
}

nb::dict sizes(const EditableLight& light) {
    nb::dict all;
    for (const scene::LightSize& size : sizes_of(light.light)) all[nb::cast(size.key)] = size.size;
    return all;
}

void set_named_size(EditableLight& light, const std::string& key, float value) {
    if (!std::isfinite(value) || value <= 0.0f)
        throw BadSetting(key, fmt::format("{} is not a length above 0", value));
    const std::vector<scene::LightSize> all = sizes_of(light.light);
    const auto found = std::ranges::find(all, key, &scene::LightSize::key);
    if (found == all.end())
        throw BadSetting(key, fmt::format("a {} light has no such size", variety_of(light.light)));
    set_size(light.light, static_cast<std::size_t>(found - all.begin()), value);
    light.has_new_sizes = true;
}

std::string text_of(const EditableLight& light) {
    const auto unit = scene::name_of({quantity_kind_of(light.light), light.units});
    return fmt::format("<Light '{}': {}, {:.6g} {}>", name_of(light.light), variety_of(light.light),
                       luminance(quantity_of(light.light)),
                       has_profile(light.light) ? "of its profile" : unit);
}

// New lights.

template<class L>
EditableLight made(L light, const std::string& name) {
    light.name = name;
    EditableLight result;
    result.light = std::move(light);
    return result;
}

EditableLight point(const Triple& position, float radius, const std::string& name) {
    scene::PointLight light;
    light.position = vector_of(position);
    light.radius = radius;
    return made(std::move(light), name);
}

EditableLight spot(const Triple& position, const Triple& direction, float inner, float outer,
                   const std::string& name) {
    if (!(0.0f <= inner && inner <= outer && outer > 0.0f && outer <= 90.0f))
        throw BadSetting("outer_angle", fmt::format("{}° around {}° are no cone of up to 90°", outer, inner));
    scene::SpotLight light;
    light.position = vector_of(position);
    light.direction = unit(direction);
    light.inner_angle = glm::radians(inner);
    light.outer_angle = glm::radians(outer);
    return made(std::move(light), name);
}

EditableLight directional(const Triple& direction, float angular_diameter, const std::string& name) {
    if (!(0.0f <= angular_diameter && angular_diameter < 180.0f))
        throw BadSetting("angular_diameter", fmt::format("{}° is not below 180°", angular_diameter));
    scene::DirectionalLight light;
    light.direction = unit(direction);
    light.angular_radius = glm::radians(0.5f * angular_diameter);
    return made(std::move(light), name);
}

/// Gives a flat light its place and half its extents.
template<class Flat>
EditableLight flat(const Triple& position, const Triple& direction, float width, float height,
                   const std::string& name) {
    if (!(width > 0.0f && height > 0.0f)) throw BadSetting("width", "sizes are above 0");
    const mat3 frame = scene::frame_around(unit(direction));
    Flat light;
    light.center = vector_of(position);
    light.half_u = 0.5f * width * frame[0];
    light.half_v = 0.5f * height * frame[1];
    if (glm::dot(light.normal(), frame[2]) < 0.0f) light.half_v = -light.half_v;
    return made(std::move(light), name);
}

EditableLight sphere(const Triple& position, float radius, const std::string& name) {
    if (!(radius > 0.0f)) throw BadSetting("radius", "is above 0");
    scene::SphereLight light;
    light.center = vector_of(position);
    light.radius = radius;
    return made(std::move(light), name);
}

void bind_new_lights(nb::module_& m) {
    m.def("point_light", &point);
    m.def("spot_light", &spot);
    m.def("directional_light", &directional);
    m.def("rectangle_light", &flat<scene::RectangleLight>);
    m.def("disk_light",
          [](const Triple& position, const Triple& direction, float radius, const std::string& name) {
              return flat<scene::DiskLight>(position, direction, 2.0f * radius, 2.0f * radius, name);
          });
    m.def("sphere_light", &sphere);
}

void bind_light(nb::module_& m) {
    nb::class_<EditableLight> type(m, "Light",
                                   "A light. Positions are in metres in the file's world. Quantities are "
                                   "luminances of linear Rec. 709 RGB, in "
                                   "lm, cd, lx and cd/m², or in watts where the file counts in watts.");
    type.def_prop_rw(
            "name", [](const EditableLight& light) { return name_of(light.light); },
            [](EditableLight& light, const std::string& name) {
                set_name(light.light, name);
                light.has_new_name = true;
            },
            "its name, which its layer has as well")
        .def_prop_ro(
            "kind", [](const EditableLight& light) { return variety_of(light.light); },
            "point, spot, directional, sun, profile, rectangle, disk, sphere, tube, polygon, mesh or "
            "environment")
        .def_prop_ro(
            "unit",
            [](const EditableLight& light) {
                return has_profile(light.light)
                           ? std::string_view("1")
                           : scene::name_of({quantity_kind_of(light.light), light.units});
            },
            "the unit of `value`; 1 where a profile gives the intensities")
        .def_prop_rw(
            "value", [](const EditableLight& light) { return triple_of(quantity_of(light.light)); },
            [](EditableLight& light, const Triple& value) {
                for (const float channel : value) require_amount(channel, "value");
                set_quantity(light.light, vector_of(value));
                light.has_new_quantity = true;
            },
            "the light's own quantity, I, E or L, as linear RGB in `unit`")
        .def_prop_rw("position", &position_of, &set_position,
                     "the middle of its extent [m]; None if it is far")
        .def_prop_rw(
            "direction",
            [](const EditableLight& light) {
                const auto direction = direction_of(light.light);
                return direction ? std::optional(triple_of(*direction)) : std::nullopt;
            },
            &set_direction, "where the light goes, or a flat light faces; None where there is none")
        .def_prop_ro("sizes", &sizes, "its sizes by name [m]: width, height, radius, length")
        .def("resize", &set_named_size, nb::arg("name"), nb::arg("value"), "Sets one of `sizes`.")
        .def_prop_ro("is_edited", &EditableLight::is_edited)
        .def(
            "copy", [](const EditableLight& light) { return EditableLight(light); },
            "Returns a light like it.")
        .def("__repr__", &text_of);
    bind_amount<Quantity::flux>(type, "flux", "Φ [lm]; None where the light has none of its own");
    bind_amount<Quantity::intensity>(type, "intensity", "I on the axis [cd]; None where it has none");
    bind_amount<Quantity::irradiance>(type, "irradiance",
                                      "E on a surface that faces it [lx]; of directional lights");
    bind_amount<Quantity::radiance>(type, "radiance", "L [cd/m²]; None for lights without extent");
}

template<auto member, auto mark>
void bind_factor(nb::class_<EditableMaterial>& type, const char* name, const char* help) {
    type.def_prop_rw(
        name, [](const EditableMaterial& self) { return self.factors.*member; },
        [name](EditableMaterial& self, float value) {
            if (!(0.0f <= value && value <= 1.0f))
                throw BadSetting(name, fmt::format("{} is not a number from 0 to 1", value));
            self.factors.*member = value;
            self.*mark = true;
        },
        help);
}

void bind_material(nb::module_& m) {
    nb::class_<EditableMaterial> type(m, "Material",
                                      "The factors of a material; textures multiply them as in the file.");
    type.def_prop_ro("name", [](const EditableMaterial& self) { return self.factors.name; })
        .def_prop_ro(
            "index", [](const EditableMaterial& self) { return self.index; },
            "the number in the AOV `material`")
        .def_prop_ro(
            "model", [](const EditableMaterial& self) { return describe(self.factors); },
            "its BRDF and layers")
        .def_prop_ro("is_edited", &EditableMaterial::is_edited)
        .def_prop_rw(
            "emission", [](const EditableMaterial& self) { return triple_of(self.factors.emission); },
            [](EditableMaterial& self, const Triple& value) {
                for (const float channel : value) require_amount(channel, "emission");
                self.factors.emission = vector_of(value);
                self.has_new_emission = true;
            },
            "L_e as linear RGB [cd/m²]; its surfaces become lights")
        .def_prop_rw(
            "base_color",
            [](const EditableMaterial& self) { return triple_of(vec3(self.factors.base_color)); },
            [](EditableMaterial& self, const Triple& value) {
                for (const float channel : value)
                    if (!(0.0f <= channel && channel <= 1.0f))
                        throw BadSetting("base_color",
                                         fmt::format("{} is not a number from 0 to 1", channel));
                self.factors.base_color = vec4(vector_of(value), self.factors.base_color.w);
                self.has_new_base_color = true;
            },
            "linear RGB, 0 to 1")
        .def(
            "copy", [](const EditableMaterial& self) { return EditableMaterial(self); },
            "Returns a material like it.")
        .def("__repr__", [](const EditableMaterial& self) {
            return fmt::format("<Material {} '{}': {}>", self.index, self.factors.name,
                               describe(self.factors));
        });
    bind_factor<&scene::Material::metallic, &EditableMaterial::has_new_metallic>(type, "metallic", "0 to 1");
    bind_factor<&scene::Material::roughness, &EditableMaterial::has_new_roughness>(type, "roughness",
                                                                                   "0 to 1");
}

} // namespace

void bind_lights(nb::module_& m) {
    bind_light(m);
    bind_new_lights(m);
    bind_material(m);
}

} // namespace sr::python
