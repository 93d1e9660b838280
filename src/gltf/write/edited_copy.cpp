#include "gltf/write/edited_copy.hpp"

#include "core/error.hpp"
#include "gltf/container.hpp"
#include "gltf/write/embedded_files.hpp"
#include "gltf/write/light_json.hpp"
#include "image/whole_file.hpp"

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

/// The JSON of a glTF file, and its edits.
class EditedJson {
public:
    EditedJson(ordered_json gltf, const Edits& edits) : gltf_(std::move(gltf)), edits_(edits) {
        for (const NodeLightEdit& edit : edits.lights)
            if (edit.is_removed) take_light(static_cast<std::size_t>(edit.node));
        for (const NodeLightEdit& edit : edits.lights)
            if (!edit.is_removed) write(edit);
        for (const AddedLight& added : edits.added_lights)
            add_root(light_node(added, edits.origin, gltf_), false);
        for (const MaterialEdit& edit : edits.materials) write(edit);
        if (edits.first_camera) add_camera(*edits.first_camera);
    }

    const ordered_json& json() const { return gltf_; }

private:
    glm::dmat4 file_from_scene() const { return glm::translate(glm::dmat4(1.0), edits_.origin); }

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
        if (edit.emission) state_emission(gltf_["nodes"][node]["extras"]["steradian"], *edit.emission);
        if (!edit.sizes.empty()) resize(node, edit);
        if (edit.name) rename(node, *edit.name);
        if (edit.motion != mat4(1.0f)) move(node, edit.motion);
    }

    void write(const MaterialEdit& edit) {
        ordered_json& material = gltf_["materials"][static_cast<std::size_t>(edit.material)];
        if (edit.emission) state_emission(material["extras"]["steradian"], *edit.emission);
        const bool is_glossy = edit.is_specular_glossiness;
        const auto set = [&](const char* core, const char* glossy, auto value) {
            if (!is_glossy)
                material["pbrMetallicRoughness"][core] = value;
            else if (*glossy)
                material["extensions"]["KHR_materials_pbrSpecularGlossiness"][glossy] = value;
        };
        if (edit.base_color) {
            const vec4 c = *edit.base_color;
            set("baseColorFactor", "diffuseFactor", ordered_json{c.x, c.y, c.z, c.w});
        }
        if (edit.metallic) set("metallicFactor", "", *edit.metallic);
        if (edit.roughness)
            set("roughnessFactor", "glossinessFactor", is_glossy ? 1.0f - *edit.roughness : *edit.roughness);
        for (const auto& [index, value] : edit.others) write(material, editable_factors[index], value);
    }

    /// Writes a factor, and names its extension among those in use.
    void write(ordered_json& material, const EditableFactor& factor, vec3 value) {
        const ordered_json::json_pointer pointer{std::string(factor.pointer)};
        const bool is_number = std::holds_alternative<float scene::Material::*>(factor.member);
        material[pointer] = is_number ? ordered_json(value.x) : ordered_json{value.x, value.y, value.z};
        constexpr std::string_view extensions = "/extensions/";
        if (!factor.pointer.starts_with(extensions)) return;
        const std::string_view rest = factor.pointer.substr(extensions.size());
        const std::string name(rest.substr(0, rest.find('/')));
        ordered_json& used = gltf_["extensionsUsed"];
        if (used.is_null()) used = ordered_json::array();
        if (std::ranges::find(used, ordered_json(name)) == used.end()) used.push_back(name);
    }

    /// A light of an extension can be at several nodes, so this node gets a copy of it. @return null: the
    /// node has no such light
    ordered_json* own_light(ordered_json& node, std::string_view extension) {
        const std::string name(extension);
        if (!node.contains("extensions") || !node["extensions"].contains(name)) return nullptr;
        ordered_json& reference = node["extensions"][name]["light"];
        ordered_json& lights = gltf_["extensions"][name]["lights"];
        ordered_json copy = lights[reference.get<std::size_t>()];
        reference = lights.size();
        lights.push_back(std::move(copy));
        return &lights.back();
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
            const auto number = node[pointer].get<std::size_t>();
            if (lights[number].value("name", "").empty()) continue;
            const auto has_it = [&](const ordered_json& other) {
                return other.contains(pointer) && other[pointer] == number;
            };
            const bool is_shared = std::ranges::count_if(gltf_["nodes"], has_it) > 1;
            (is_shared ? *own_light(node, extension) : lights[number])["name"] = name;
        }
    }

    /// States the sizes of a light at its node. They scale by the longest axis of the node.
    void resize(std::size_t index, const NodeLightEdit& edit) {
        const glm::dmat3 world(glm::dmat4(edit.motion) * world_from_node(gltf_, index));
        const double scale = std::max({glm::length(world[0]), glm::length(world[1]), glm::length(world[2])});
        ordered_json& node = gltf_["nodes"][index];
        if (ordered_json* area = own_light(node, "EXT_lights_area"))
            return resize_area(*area, edit.sizes, scale);
        constexpr double rounding = 1e-6;
        for (const scene::LightSize& size : edit.sizes) {
            ordered_json& stated = node["extras"]["steradian"][std::string(size.key)];
            const double value = size.size / scale;
            if (!stated.is_number() || std::abs(stated.get<double>() - value) > rounding * value)
                stated = value;
        }
    }

    static void resize_area(ordered_json& light, const std::vector<scene::LightSize>& sizes, double scale) {
        if (sizes.size() == 1) {
            light["size"] = 2.0 * sizes[0].size / scale; // the diameter of a disk
        } else {
            light["size"] = sizes[1].size / scale;
            light["rect"]["aspect"] = sizes[0].size / sizes[1].size;
        }
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

/// True if both are in one folder, so that the URIs of one lead from the other to the same files.
bool is_beside(const fs::path& file, const fs::path& target) {
    std::error_code ignored;
    return fs::weakly_canonical(target, ignored).parent_path()
           == fs::weakly_canonical(file, ignored).parent_path();
}

/// True if a target of this name is a GLB. @throws Error if it is no glTF
bool is_to_be_glb(const fs::path& file, bool file_is_glb, const fs::path& target) {
    if (target.extension() == file.extension()) return file_is_glb;
    if (target.extension() == ".glb") return true;
    if (target.extension() == ".gltf") return false;
    throw Error({target.string()}, fmt::format("has the extension '{}'", target.extension().string()),
                "name it *.gltf or *.glb");
}

/// Says which of the files that the original refers to, besides buffers, are not those that were read.
std::vector<std::string> changed_files(const SourceFile& source, const fs::path& target) {
    std::vector<std::string> sentences;
    for (const auto& [path, named] : source.named) {
        const std::optional<FileStamp> now = stamp_of(path);
        if (named.bytes || !named.stamp || now == named.stamp) continue;
        const std::string name = path.lexically_relative(source.path.parent_path()).string();
        sentences.push_back(now ? fmt::format("{} has changed since it was read.", name)
                                : fmt::format("{} is gone: put it beside {}.", name, target.string()));
    }
    return sentences;
}

} // namespace

bool is_addable(const scene::Light& light) { return !scene::needs_its_scene(light); }

std::vector<std::string> write_edited_copy(const SourceFile& source, const Edits& edits,
                                           const fs::path& target) {
    require(source.bytes != nullptr, "the file has been read");
    const fs::path& file = source.path;
    const Container container = split_container(*source.bytes, file.string());
    const bool is_glb = is_to_be_glb(file, container.is_glb(), target);
    ordered_json json = EditedJson(parse_ordered(container, file.string()), edits).json();
    embed_lost_buffers(json, source);
    if (!is_beside(file, target)) embed_files(json, source);
    if (is_glb) {
        image::write_whole(target, build_glb(json.dump(), container.chunks));
    } else {
        if (container.bin) embed_buffer(json, *container.bin);
        const std::string text = json.dump(2) + "\n";
        image::write_whole(target, {reinterpret_cast<const std::uint8_t*>(text.data()), text.size()});
    }
    return changed_files(source, target);
}

} // namespace sr::gltf
