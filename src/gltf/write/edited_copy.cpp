#include "gltf/write/edited_copy.hpp"

#include "core/error.hpp"
#include "core/file.hpp"
#include "gltf/container.hpp"
#include "image/whole_file.hpp"
#include "scene/spectrum.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <fmt/format.h>
#include <glm/gtc/matrix_transform.hpp>
#include <glm/gtc/quaternion.hpp>

namespace sr::gltf {
namespace {

namespace fs = std::filesystem;
using nlohmann::ordered_json;

constexpr std::array light_extensions{"KHR_lights_punctual", "EXT_lights_area", "EXT_lights_ies"};

ordered_json vector_json(glm::dvec3 v) { return {v.x, v.y, v.z}; }

ordered_json vector_json(vec3 v) { return {v.x, v.y, v.z}; }

ordered_json matrix_json(const glm::dmat4& matrix) {
    ordered_json json = ordered_json::array();
    for (int i = 0; i < 16; ++i) json.push_back(matrix[i / 4][i % 4]);
    return json;
}

glm::dvec4 numbers_of(const ordered_json& node, const char* key, glm::dvec4 fallback) {
    const auto found = node.find(key);
    if (found == node.end()) return fallback;
    for (std::size_t i = 0; i < found->size() && i < 4; ++i)
        fallback[static_cast<int>(i)] = (*found)[i].get<double>();
    return fallback;
}

glm::dmat4 parent_from_node(const ordered_json& node) {
    glm::dmat4 m(1.0);
    if (const auto matrix = node.find("matrix"); matrix != node.end()) {
        for (int i = 0; i < 16; ++i) m[i / 4][i % 4] = (*matrix)[static_cast<std::size_t>(i)].get<double>();
        return m;
    }
    const glm::dvec4 t = numbers_of(node, "translation", {0, 0, 0, 0}),
                     r = numbers_of(node, "rotation", {0, 0, 0, 1}),
                     s = numbers_of(node, "scale", {1, 1, 1, 0});
    return glm::translate(m, glm::dvec3(t)) * glm::mat4_cast(glm::dquat(r.w, r.x, r.y, r.z))
           * glm::scale(glm::dmat4(1.0), glm::dvec3(s));
}

/// The rest pose of a node, without animations.
glm::dmat4 world_from_node(const ordered_json& gltf, std::size_t node) {
    const ordered_json& nodes = gltf["nodes"];
    glm::dmat4 m = parent_from_node(nodes[node]);
    for (std::size_t parent = 0; parent < nodes.size(); ++parent) {
        const auto children = nodes[parent].find("children");
        if (children == nodes[parent].end()
            || std::none_of(children->begin(), children->end(),
                            [&](const ordered_json& child) { return child.get<std::size_t>() == node; }))
            continue;
        return world_from_node(gltf, parent) * m; // the loader refuses a second parent and a cycle
    }
    return m;
}

/// Replaces the emission that an object of extras.steradian states.
void state(ordered_json& steradian, const StatedEmission& emission) {
    if (!steradian.is_object()) steradian = ordered_json::object();
    for (const char* key : {"quantity", "color", "temperature", "spectrum"}) steradian.erase(key);
    steradian["quantity"] = {{"value", emission.value}, {"unit", emission.unit}};
    if (emission.value > 0.0)
        steradian["color"] = vector_json(scene::with_unit_luminance(glm::dvec3(emission.color)));
}

/// The frame of a flat light, which shines along -Z.
glm::dmat4 frame_of(vec3 center, vec3 half_u, vec3 half_v) {
    const glm::dvec3 y = glm::normalize(glm::dvec3(half_v));
    const glm::dvec3 back = -glm::normalize(glm::cross(glm::dvec3(half_u), glm::dvec3(half_v)));
    glm::dmat4 m(1.0);
    m[0] = {glm::cross(y, back), 0.0};
    m[1] = {y, 0.0};
    m[2] = {back, 0.0};
    m[3] = {glm::dvec3(center), 1.0};
    return m;
}

/// A frame at `center` whose axis number `axis` points along a vector.
glm::dmat4 frame_along(vec3 center, vec3 along, int axis) {
    const glm::dvec3 a = glm::normalize(glm::dvec3(along));
    const glm::dvec3 other = std::abs(a.y) < 0.9 ? glm::dvec3(0, 1, 0) : glm::dvec3(1, 0, 0);
    const glm::dvec3 b = glm::normalize(glm::cross(other, a));
    glm::dmat4 m(1.0);
    m[axis] = {a, 0.0};
    m[(axis + 1) % 3] = {b, 0.0};
    m[(axis + 2) % 3] = {glm::cross(a, b), 0.0};
    m[3] = {glm::dvec3(center), 1.0};
    return m;
}

/// The JSON of a glTF file, and its edits.
class EditedJson {
public:
    EditedJson(ordered_json gltf, const Edits& edits) : gltf_(std::move(gltf)), edits_(edits) {
        for (const NodeLightEdit& edit : edits.lights)
            if (edit.is_removed) take_light(static_cast<std::size_t>(edit.node));
        for (const NodeLightEdit& edit : edits.lights)
            if (!edit.is_removed) write(edit);
        for (const AddedLight& added : edits.added_lights) add(added);
        for (const MaterialEdit& edit : edits.materials)
            state(gltf_["materials"][static_cast<std::size_t>(edit.material)]["extras"]["steradian"],
                  edit.emission);
        if (edits.first_camera) add_camera(*edits.first_camera);
    }

    const ordered_json& json() const { return gltf_; }

private:
    glm::dmat4 file_from_scene() const { return glm::translate(glm::dmat4(1.0), edits_.origin); }

    ordered_json place_json(vec3 place) const {
        if (edits_.origin == glm::dvec3(0.0)) return vector_json(place);
        return vector_json(edits_.origin + glm::dvec3(place));
    }

    std::size_t append_node(ordered_json node) {
        gltf_["nodes"].push_back(std::move(node));
        return gltf_["nodes"].size() - 1;
    }

    /// Appends a node to the roots of the scene, or puts it before them.
    void add_root(ordered_json node, bool is_first) {
        const std::size_t index = append_node(std::move(node));
        if (!gltf_.contains("scenes") || gltf_["scenes"].empty())
            return; // all nodes without a parent are shown
        const int scene = edits_.scene_index.value_or(gltf_.value("scene", 0));
        ordered_json& roots = gltf_["scenes"][static_cast<std::size_t>(scene)]["nodes"];
        if (roots.is_null()) roots = ordered_json::array();
        roots.insert(is_first ? roots.begin() : roots.end(), index);
    }

    void write(const NodeLightEdit& edit) {
        const auto node = static_cast<std::size_t>(edit.node);
        if (edit.name) rename(node, *edit.name);
        if (edit.emission) state(gltf_["nodes"][node]["extras"]["steradian"], *edit.emission);
        if (!edit.sizes.empty()) resize(node, edit);
        if (edit.motion != mat4(1.0f)) move(node, edit.motion);
    }

    /// Renames a node and its light, whose own name readers prefer. A light of several nodes stays, and this
    /// node gets a copy of it; animations go on to point at that of a single one.
    void rename(std::size_t index, const std::string& name) {
        ordered_json& node = gltf_["nodes"][index];
        node["name"] = name;
        for (const char* extension : light_extensions) {
            const ordered_json::json_pointer pointer(fmt::format("/extensions/{}/light", extension));
            if (!node.contains(pointer)) continue;
            ordered_json& lights = gltf_["extensions"][extension]["lights"];
            ordered_json& reference = node[pointer];
            const auto number = reference.get<std::size_t>();
            if (lights[number].value("name", "").empty()) continue;
            const auto has_it = [&](const ordered_json& other) {
                return other.contains(pointer) && other[pointer] == number;
            };
            if (std::ranges::count_if(gltf_["nodes"], has_it) > 1) {
                ordered_json copy = lights[number];
                reference = lights.size();
                lights.push_back(std::move(copy));
            }
            lights[reference.get<std::size_t>()]["name"] = name;
        }
    }

    /// States the sizes of a light at its node. They scale by the longest axis of the node.
    void resize(std::size_t index, const NodeLightEdit& edit) {
        const glm::dmat3 world(glm::dmat4(edit.motion) * world_from_node(gltf_, index));
        const double scale = std::max({glm::length(world[0]), glm::length(world[1]), glm::length(world[2])});
        ordered_json& node = gltf_["nodes"][index];
        if (node.contains("extensions") && node["extensions"].contains("EXT_lights_area"))
            return resize_area(node["extensions"]["EXT_lights_area"]["light"], edit.sizes, scale);
        constexpr double rounding = 1e-6;
        for (const scene::LightSize& size : edit.sizes) {
            ordered_json& stated = node["extras"]["steradian"][std::string(size.key)];
            const double value = size.size / scale;
            if (!stated.is_number() || std::abs(stated.get<double>() - value) > rounding * value)
                stated = value;
        }
    }

    /// A light of EXT_lights_area can be at several nodes, so this node gets a copy of it.
    void resize_area(ordered_json& reference, const std::vector<scene::LightSize>& sizes, double scale) {
        ordered_json& lights = gltf_["extensions"]["EXT_lights_area"]["lights"];
        ordered_json copy = lights[reference.get<std::size_t>()];
        if (sizes.size() == 1) {
            copy["size"] = 2.0 * sizes[0].size / scale; // the diameter of a disk
        } else {
            copy["size"] = sizes[1].size / scale;
            copy["rect"]["aspect"] = sizes[0].size / sizes[1].size;
        }
        reference = lights.size();
        lights.push_back(std::move(copy));
    }

    /// Removes the light of a node. @return what made it a light, as the JSON of a node
    ordered_json take_light(std::size_t index) {
        ordered_json& node = gltf_["nodes"][index];
        ordered_json light;
        for (const char* name : light_extensions)
            if (node.contains("extensions") && node["extensions"].contains(name)) {
                light["extensions"][name] = node["extensions"][name];
                node["extensions"].erase(name);
            }
        if (node.contains("extras") && node["extras"].is_object() && node["extras"].contains("steradian")) {
            light["extras"]["steradian"] = node["extras"]["steradian"];
            node["extras"].erase("steradian");
        }
        for (const char* key : {"extensions", "extras"})
            if (node.contains(key) && node[key].empty()) node.erase(key);
        return light;
    }

    /// Moves a light to a new child of its node, so that nothing else of the node moves.
    void move(std::size_t index, const mat4& motion) {
        const glm::dmat4 by = file_from_scene() * glm::dmat4(motion) * glm::inverse(file_from_scene());
        const glm::dmat4 world = world_from_node(gltf_, index);
        ordered_json child = take_light(index);
        child["name"] = gltf_["nodes"][index].value("name", "light");
        child["matrix"] = matrix_json(glm::inverse(world) * by * world);
        const std::size_t node = append_node(std::move(child));
        gltf_["nodes"][index]["children"].push_back(node);
    }

    void add(const AddedLight& added) {
        ordered_json node{{"name", scene::name_of(added.light)}};
        ordered_json steradian = ordered_json::object();
        std::visit([&](const auto& light) { place(light, node, steradian); }, added.light);
        for (const scene::LightSize& size : scene::sizes_of(added.light))
            steradian[std::string(size.key)] = size.size;
        state(steradian, added.emission);
        node["extras"]["steradian"] = steradian;
        add_root(std::move(node), false);
    }

    /// Gives a node the place of a light, and the light its kind.
    template<class L>
    void place(const L& light, ordered_json& node, ordered_json& steradian) {
        if constexpr (requires { light.half_u; }) {
            node["matrix"] =
                matrix_json(file_from_scene() * frame_of(light.center, light.half_u, light.half_v));
            if (light.is_two_sided) steradian["two_sided"] = true;
        } else if constexpr (requires { light.half_axis; }) {
            node["matrix"] = matrix_json(file_from_scene() * frame_along(light.center, light.half_axis, 0));
        } else if constexpr (requires { light.direction; }) {
            vec3 position(0.0f);
            if constexpr (requires { light.position; }) position = light.position;
            node["matrix"] = matrix_json(file_from_scene() * frame_along(position, -light.direction, 2));
            node["extensions"]["KHR_lights_punctual"]["light"] = add_punctual(light);
        } else if constexpr (requires { light.position; }) {
            node["translation"] = place_json(light.position);
            node["extensions"]["KHR_lights_punctual"]["light"] = add_punctual(light);
        } else if constexpr (requires { light.radius; }) {
            node["translation"] = place_json(light.center);
        } else {
            require(false, "the light is_addable()");
        }
        if constexpr (requires { light.sizes(); })
            for (const auto& shape : L::shapes)
                if (shape.dimensions.size() == light.sizes().size()) steradian["shape"] = shape.name;
        if constexpr (requires { light.is_visible; })
            if (!light.is_visible) steradian["visible"] = false;
    }

    /// @return the index of a new light of KHR_lights_punctual, whose intensity its node states
    template<class L>
    std::size_t add_punctual(const L& light) {
        ordered_json punctual{{"type", L::kind}, {"intensity", 1.0}};
        if constexpr (requires { light.range; })
            if (std::isfinite(light.range)) punctual["range"] = light.range;
        if constexpr (requires { light.outer_angle; })
            punctual["spot"] = {{"innerConeAngle", light.inner_angle}, {"outerConeAngle", light.outer_angle}};
        ordered_json& lights = gltf_["extensions"]["KHR_lights_punctual"]["lights"];
        lights.push_back(std::move(punctual));
        ordered_json& used = gltf_["extensionsUsed"];
        if (used.is_null() || std::ranges::find(used, "KHR_lights_punctual") == used.end())
            used.push_back("KHR_lights_punctual");
        return lights.size() - 1;
    }

    void add_camera(const scene::Camera& view) {
        ordered_json camera{{"name", "view"}};
        if (const auto* p = std::get_if<scene::Perspective>(&view.projection)) {
            camera["type"] = "perspective";
            camera["perspective"] = {{"yfov", p->yfov}, {"znear", p->znear}};
            if (p->zfar) camera["perspective"]["zfar"] = *p->zfar;
        } else {
            const auto& o = std::get<scene::Orthographic>(view.projection);
            camera["type"] = "orthographic";
            camera["orthographic"] = {
                {"xmag", o.xmag}, {"ymag", o.ymag}, {"znear", std::max(0.0f, o.znear)}, {"zfar", o.zfar}};
        }
        gltf_["cameras"].push_back(camera);
        add_root({{"name", "view"},
                  {"camera", gltf_["cameras"].size() - 1},
                  {"matrix", matrix_json(file_from_scene() * glm::dmat4(view.world_from_camera))}},
                 true);
    }

    ordered_json gltf_;
    const Edits& edits_;
};

void check_target(const fs::path& file, const fs::path& target) {
    std::error_code ignored;
    if (fs::weakly_canonical(target, ignored).parent_path()
        != fs::weakly_canonical(file, ignored).parent_path())
        throw Error({target.string()}, "is in another folder than " + file.string(),
                    "save it in that folder, where its buffers and textures are");
    if (target.extension() != file.extension())
        throw Error({target.string()},
                    fmt::format("has the extension '{}' instead of '{}'", target.extension().string(),
                                file.extension().string()),
                    "name it *" + file.extension().string());
}

} // namespace

bool is_addable(const scene::Light& light) {
    return std::visit(
        []<class L>(const L& l) {
            if constexpr (requires { l.profile; })
                return l.profile < 0;
            else if constexpr (
                requires { l.map; } && requires { l.half_u; })
                return !l.map.is_present();
            else
                return std::is_same_v<
                           L,
                           scene::
                               SpotLight> || std::is_same_v<L, scene::DirectionalLight> || std::is_same_v<L, scene::SphereLight> || std::is_same_v<L, scene::TubeLight>;
        },
        light);
}

void write_edited_copy(const fs::path& file, const Edits& edits, const fs::path& target) {
    check_target(file, target);
    const std::vector<std::uint8_t> bytes = read_file(file, file.string());
    const Container container = split_container(bytes, file.string());
    const EditedJson edited(parse_ordered(container, file.string()), edits);
    if (container.is_glb())
        return image::write_whole(target, build_glb(edited.json().dump(), container.chunks));
    const std::string text = edited.json().dump(2) + "\n";
    image::write_whole(target, {reinterpret_cast<const std::uint8_t*>(text.data()), text.size()});
}

} // namespace sr::gltf
