// EXT_lights_area, as drafted in Khronos' glTF pull request 2525: flat emitters of constant luminance [nit].
#include "gltf/light.hpp"
#include "gltf/text.hpp"

#include <cmath>
#include <fmt/format.h>
#include <optional>
#include <variant>

namespace sr::gltf {
namespace {

using glm::dvec3;
using tinygltf::Value;

/// Half the edges of a rectangle, or the semi-axes of a disk, `size` high and `aspect` times as wide.
template<class Flat>
Flat flat(const Document& document, const LightFrame& frame, double size, double aspect,
          const std::string& title) {
    const double half_width = 0.5 * frame.scale * size * aspect;
    const double half_height = 0.5 * frame.scale * size;
    const double area = 4.0 * half_width * half_height;
    if (!(size > 0.0 && aspect > 0.0) || !(area > 0.0) || !std::isfinite(static_cast<float>(area)))
        document.fail(fmt::format("{} has the size {}, the aspect {} and the scale {}", title, size, aspect,
                                  frame.scale),
                      "give positive ones");
    Flat result;
    result.center = vec3(frame.position);
    result.half_u = vec3(half_width * frame.u);
    result.half_v = vec3(half_height * frame.v);
    return result;
}

/// What EXT_lights_area itself says of a light.
struct AreaSource {
    std::variant<scene::DiskLight, scene::RectangleLight> light; // its place and size
    dvec3 own{0.0};                                              // colour times intensity
};

AreaSource source_of(const Document& document, const PlacedNode& placed, const Value& light,
                     const std::string& title) {
    std::string type = text_in(light, "type");
    if (type.empty()) type = text_in(light, "shape"); // its name in the draft's first versions
    if (type != "rect" && type != "disk")
        document.fail(fmt::format("{} has the type {}", title, in_quotes(type)), "give \"rect\" or \"disk\"");
    const LightFrame frame = sided_frame_of(document, placed, title);
    const double size = number_in(light, "size", 1.0);
    const dvec3 own = emitted_color(document, color_in(light), number_in(light, "intensity", 1000.0), title);
    if (type == "disk") return {flat<scene::DiskLight>(document, frame, size, 1.0, title), own};
    const double aspect = light.Has("rect") ? number_in(light.Get("rect"), "aspect", 1.0) : 1.0;
    return {flat<scene::RectangleLight>(document, frame, size, aspect, title), own};
}

} // namespace

void LightTable::append_area(const PlacedNode& placed, Warnings& warnings) {
    const tinygltf::Node& node = document_.model.nodes[static_cast<std::size_t>(placed.node)];
    const Value* reference = extension(node.extensions, "EXT_lights_area");
    if (!reference) return;
    const int index = whole_in(*reference, "light", 0);
    if (document_.is_lost(fmt::format("/extensions/EXT_lights_area/lights/{}", index))) return;
    const Value& light = extension(document_.model.extensions, "EXT_lights_area")->Get("lights").Get(index);
    const std::string name = text_in(light, "name");
    const std::string title = light_title("EXT_lights_area", index, name);
    std::optional<AreaSource> source;
    warnings.attempt(without_lamp, [&] { source = source_of(document_, placed, light, title); });
    if (!source) return;

    const Value* stated = steradian_in(node.extras);
    if (stated && stated->Has("shape")) stated = nullptr; // that is a light of its own
    std::visit(
        [&](auto& result) {
            result.name = name.empty() ? node.name : name;
            result.map = map_of(stated, placed);
            state_flat(document_, result, stated, source->own, title);
            lights_.emplace_back(std::move(result));
        },
        source->light);
}

} // namespace sr::gltf
