// Lights of extras.steradian: shapes that no extension of glTF has. A light stands at its node and goes along
// -Z.
#include "gltf/light.hpp"
#include "gltf/polygon.hpp"
#include "gltf/text.hpp"

#include <algorithm>
#include <array>
#include <fmt/format.h>

namespace sr::gltf {
namespace {

using glm::dvec3;
using tinygltf::Value;

/// Which properties a shape takes besides those that all have; it needs the `needs`.
struct Shape {
    std::string_view name;
    std::vector<std::string_view> needs;
    std::vector<std::string_view> takes;
};

const Shape& shape_named(std::string_view name) { // the rules know all names
    static const std::array<Shape, 6> shapes{{
        {"rectangle", {"width", "height"}, {"texture", "two_sided"}},
        {"disk", {"radius"}, {"texture", "two_sided"}},
        {"ellipse", {"width", "height"}, {"texture", "two_sided"}},
        {"sphere", {"radius"}, {}},
        {"tube", {"radius", "length"}, {}},
        {"polygon", {"corners"}, {"two_sided"}},
    }};
    return *std::find_if(shapes.begin(), shapes.end(), [&](const Shape& s) { return s.name == name; });
}

void check_properties(const Document& document, const Value& stated, const Shape& shape,
                      const std::string& title) {
    const auto has = [](const auto& list, std::string_view key) {
        return std::find(list.begin(), list.end(), key) != list.end();
    };
    for (const std::string_view key : shape.needs)
        if (!stated.Has(std::string(key)))
            document.fail(fmt::format("{} is a {} without {}", title, shape.name, key), "give it one");
    for (const std::string_view key :
         {"width", "height", "radius", "length", "corners", "angular_diameter", "texture", "two_sided"})
        if (stated.Has(std::string(key)) && !has(shape.needs, key) && !has(shape.takes, key))
            document.fail(
                fmt::format("{} is a {} with {}", title, shape.name, key),
                fmt::format("a {} has {}: leave {} out", shape.name, fmt::join(shape.needs, " and "), key));
    if (!stated.Has("quantity"))
        document.fail(fmt::format("{} states no quantity", title),
                      R"(give one, as in "quantity": {"value": 800, "unit": "lm"})");
}

/// Builds the shapes, all but their quantity.
class Maker {
public:
    Maker(const Document& document, const PlacedNode& placed, const Value& stated, const std::string& title,
          const LightFrame& frame)
        : document_(document), placed_(placed), stated_(stated), title_(title), frame_(frame) {}

    template<class Flat>
    Flat flat(float half_width, float half_height) const {
        Flat light;
        light.center = vec3(frame_.position);
        light.half_u = half_width * vec3(frame_.u);
        light.half_v = half_height * vec3(frame_.v);
        return light;
    }

    scene::SphereLight sphere() const {
        scene::SphereLight light;
        light.center = vec3(frame_.position);
        light.radius = size("radius");
        return light;
    }

    scene::TubeLight tube() const {
        scene::TubeLight light;
        light.center = vec3(frame_.position);
        light.half_axis = 0.5f * size("length") * vec3(frame_.u);
        light.radius = size("radius");
        return light;
    }

    scene::PolygonLight polygon() const {
        scene::PolygonLight light;
        light.corners = polygon_corners(document_, stated_.Get("corners"), placed_.world_from_node, title_);
        return light;
    }

    float size(const std::string& key) const {
        return scaled_size(document_, number_in(stated_, key, 0.0), frame_, key, title_);
    }

private:
    const Document& document_;
    const PlacedNode& placed_;
    const Value& stated_;
    std::string title_;
    LightFrame frame_;
};

} // namespace

scene::EmissionMap LightTable::map_of(const Value* stated, const PlacedNode& placed) {
    scene::EmissionMap map;
    if (stated && stated->Has("texture"))
        map.texture = textures_.texture(whole_in(*stated, "texture", 0), scene::ColorSpace::srgb);
    if (glm::determinant(glm::dmat3(placed.world_from_node)) < 0.0)
        map.along_u = -map.along_u; // the frame's u does not follow the node's X there
    return map;
}

void LightTable::append_shape(const PlacedNode& placed, Warnings& warnings) {
    const tinygltf::Node& node = document_.model.nodes[static_cast<std::size_t>(placed.node)];
    const Value* stated = steradian_in(node.extras);
    if (!stated || !stated->Has("shape")) return;
    const std::string title =
        fmt::format("light {} (/nodes/{}/extras/steradian)", in_quotes(node.name), placed.node);
    const std::string shape = text_in(*stated, "shape");
    check_properties(document_, *stated, shape_named(shape), title);
    std::optional<LightFrame> frame;
    warnings.attempt(without_lamp, [&] { frame = sided_frame_of(document_, placed, title); });
    if (!frame) return;
    const Maker maker(document_, placed, *stated, title, *frame);
    const dvec3 white(1.0);
    const auto finish_flat = [&](auto light) {
        light.name = node.name;
        state_flat(document_, light, stated, white, title);
        lights_.emplace_back(std::move(light));
    };
    const auto finish_mapped = [&](auto light) {
        light.map = map_of(stated, placed);
        finish_flat(std::move(light));
    };
    const auto finish_round = [&](auto light) {
        light.name = node.name;
        light.is_visible = flag_in(stated, "visible", true);
        const Conversion conversion = [&](scene::Quantity quantity, double value) {
            return scene::radiance_from(quantity, value, scene::radiator_of(light));
        };
        light.L =
            emitted(document_, statement_of(document_, stated, title), white, conversion, title, area_takes);
        lights_.emplace_back(std::move(light));
    };
    if (shape == "sphere") return finish_round(maker.sphere());
    if (shape == "tube") return finish_round(maker.tube());
    if (shape == "polygon") return finish_flat(maker.polygon());
    if (shape == "disk")
        return finish_mapped(maker.flat<scene::DiskLight>(maker.size("radius"), maker.size("radius")));
    const float half_width = 0.5f * maker.size("width"), half_height = 0.5f * maker.size("height");
    if (shape == "ellipse") return finish_mapped(maker.flat<scene::DiskLight>(half_width, half_height));
    finish_mapped(maker.flat<scene::RectangleLight>(half_width, half_height));
}

} // namespace sr::gltf
