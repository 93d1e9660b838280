#include "viewer/saved_gltf.hpp"

#include "core/error.hpp"
#include "image/whole_file.hpp"
#include "scene/lights/light.hpp"
#include "viewer/gltf_text.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <fmt/format.h>
#include <glm/gtc/matrix_transform.hpp>

namespace sr::viewer {
namespace {

using nlohmann::ordered_json;

constexpr std::array light_extensions{"KHR_lights_punctual", "EXT_lights_area", "EXT_lights_ies"};

ordered_json numbers_of(vec3 v) { return {v.x, v.y, v.z}; }

/// States a quantity and a colour in an object of extras.steradian, in the place of what it said of them.
void state(ordered_json& steradian, double value, std::string_view unit, vec3 rgb) {
    if (!steradian.is_object()) steradian = ordered_json::object();
    for (const char* key : {"quantity", "color", "temperature", "spectrum"}) steradian.erase(key);
    steradian["quantity"] = {{"value", value}, {"unit", unit}};
    if (value > 0.0) steradian["color"] = numbers_of(scene::with_unit_luminance(glm::dvec3(rgb)));
}

void state(ordered_json& steradian, const scene::Light& light, bool is_on, const scene::Scene& scene) {
    const vec3 quantity = is_on ? quantity_of(light) : vec3(0.0f);
    if (!has_profile(light))
        return state(steradian, scene::luminance(quantity), scene::name_of({quantity_kind_of(light), scene.units}),
                     quantity);
    const double flux = is_on ? scene::luminance(*scene::flux_of(light, scene.profiles)) : 0.0;
    state(steradian, flux, scene::name_of({scene::Quantity::flux, scene.units}), quantity);
}

bool is_scaled(const mat4& by) {
    constexpr float rounding = 1e-4f; // of a few turns
    return std::abs(glm::determinant(mat3(by)) - 1.0f) > rounding;
}

/// A node that shines along -Z like a flat light whose plane has these axes.
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

/// Writes the edits of one file.
class Saving {
public:
    Saving(const LoadedScene& loaded, const Lighting& lighting)
        : loaded_(loaded),
          scene_(loaded.stage.scene),
          file_(lighting.file()),
          adds_or_removes_(lighting.adds_or_removes()),
          now_(lighting.state()),
          gltf_(read_gltf(loaded.file)) {}

    void save_lights() {
        for (const int number : now_.removed) take_light(node_of(number));
        for (std::size_t i = 0; i < now_.lights.size(); ++i)
            if (now_.origins[i] >= 0) save_light(i);
        for (std::size_t i = 0; i < now_.lights.size(); ++i)
            if (now_.origins[i] < 0) add_light(now_.lights[i], now_.lights_on[i]);
        for (std::size_t i = 0; adds_or_removes_ && i < now_.softboxes.size(); ++i)
            add_light(now_.softboxes[i], now_.softboxes_on[i]);
    }

    void save_materials() {
        for (std::size_t m = 0; m < now_.emission.size(); ++m) {
            const int number = file_.materials[m];
            const vec3 emission = now_.emission_on[m] ? now_.emission[m] : vec3(0.0f);
            if (number < 0 || (now_.emission_on[m] && !now_.emission_given[m])) continue;
            ordered_json& material = json()["materials"][static_cast<std::size_t>(number)];
            state(material["extras"]["steradian"], scene::luminance(emission),
                  scene::radiance_unit(scene_.units), emission);
        }
    }

    void add_camera(const scene::Camera& view) {
        ordered_json camera;
        if (const auto* p = std::get_if<scene::Perspective>(&view.projection)) {
            ordered_json lens{{"yfov", p->yfov}, {"znear", p->znear}};
            if (p->zfar) lens["zfar"] = *p->zfar;
            camera = {{"name", "view"}, {"type", "perspective"}, {"perspective", lens}};
        } else {
            const auto& o = std::get<scene::Orthographic>(view.projection);
            camera = {
                {"name", "view"},
                {"type", "orthographic"},
                {"orthographic",
                 {{"xmag", o.xmag}, {"ymag", o.ymag}, {"znear", std::max(0.0f, o.znear)}, {"zfar", o.zfar}}}};
        }
        json()["cameras"].push_back(camera);
        const std::size_t node =
            append_node(json(), {{"name", "view"},
                                 {"camera", json()["cameras"].size() - 1},
                                 {"matrix", matrix_json(in_file(glm::dmat4(view.world_from_camera)))}});
        add_root(json(), node, loaded_.scene_index, true);
    }

    std::vector<std::uint8_t> bytes() const { return bytes_of(gltf_); }

private:
    ordered_json& json() { return gltf_.json; }

    // The scene is told from Scene::origin, the file from its own.
    glm::dmat4 in_file(const glm::dmat4& placed) const {
        return glm::translate(glm::dmat4(1.0), scene_.origin) * placed;
    }
    glm::dmat4 motion_in_file(const glm::dmat4& motion) const {
        return in_file(glm::translate(motion, -scene_.origin));
    }
    ordered_json place_in_file(vec3 place) const {
        if (scene_.origin == glm::dvec3(0.0)) return numbers_of(place);
        const glm::dvec3 p = scene_.origin + glm::dvec3(place);
        return {p.x, p.y, p.z};
    }

    /// @throws Error if the node carries another light, which would have to say something else
    std::size_t node_of(int number) const {
        if (file_.shares_its_node(number))
            throw Error(
                {loaded_.file},
                fmt::format("/nodes/{} carries two lights, one of which was edited", file_.node_of(number)),
                "give each a node of its own");
        return static_cast<std::size_t>(file_.node_of(number));
    }

    void save_light(std::size_t i) {
        const bool is_resized = now_.resized[i] || is_scaled(now_.moved[i]);
        // A flux makes another radiance of another size.
        const bool is_restated = now_.lights_given[i] || !now_.lights_on[i] || is_resized;
        const bool has_moved = now_.moved[i] != mat4(1.0f);
        if (!is_restated && !has_moved) return;
        const std::size_t node = node_of(now_.origins[i]);
        if (is_restated)
            state(json()["nodes"][node]["extras"]["steradian"], now_.lights[i], now_.lights_on[i], scene_);
        if (now_.resized[i]) resize(node, now_.lights[i], now_.moved[i]);
        if (has_moved) move(node, motion_in_file(glm::dmat4(now_.moved[i])));
    }

    /// States a light's sizes at its node, which will have moved by `by`: sizes scale by the largest of its
    /// axes.
    void resize(std::size_t index, const scene::Light& light, const mat4& by) {
        const glm::dmat3 world(glm::dmat4(by) * world_from_node(json(), index));
        const double scale = std::max({glm::length(world[0]), glm::length(world[1]), glm::length(world[2])});
        ordered_json& node = json()["nodes"][index];
        if (node.contains("extensions") && node["extensions"].contains("EXT_lights_area"))
            return resize_area(node["extensions"]["EXT_lights_area"]["light"], light, scale);
        constexpr double rounding = 1e-6;
        for (const scene::LightSize& extent : scene::sizes_of(light)) {
            ordered_json& stated = node["extras"]["steradian"][extent.key];
            const double size = extent.size / scale;
            if (!stated.is_number() || std::abs(stated.get<double>() - size) > rounding * size) stated = size;
        }
    }

    /// A light of EXT_lights_area can be at several nodes: this one's becomes another.
    void resize_area(ordered_json& reference, const scene::Light& light, double scale) {
        ordered_json& lights = json()["extensions"]["EXT_lights_area"]["lights"];
        ordered_json other = lights[reference.get<std::size_t>()];
        const std::vector<scene::LightSize> extents = scene::sizes_of(light);
        if (extents.size() == 1) {
            other["size"] = 2.0 * extents[0].size / scale; // across a disk
        } else {
            other["size"] = extents[1].size / scale;
            other["rect"]["aspect"] = extents[0].size / extents[1].size;
        }
        reference = lights.size();
        lights.push_back(std::move(other));
    }

    /// Takes what makes a light off a node. @return it, as a node
    ordered_json take_light(std::size_t index) {
        ordered_json& node = json()["nodes"][index];
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

    /// The light goes to a new child, so that nothing else of its node moves.
    void move(std::size_t index, const glm::dmat4& by) {
        const glm::dmat4 world = world_from_node(json(), index);
        ordered_json child = take_light(index);
        child["name"] = json()["nodes"][index].value("name", "light");
        child["matrix"] = matrix_json(glm::inverse(world) * by * world);
        const std::size_t node = append_node(json(), std::move(child));
        json()["nodes"][index]["children"].push_back(node);
    }

    /// A light that the file did not have: a rectangle, a sphere or a point.
    void add_light(const scene::Light& light, bool is_on) {
        if (std::holds_alternative<scene::EnvironmentLight>(light))
            return; // the studio comes by itself, where it is due
        ordered_json node{{"name", scene::name_of(light)}};
        ordered_json steradian;
        if (const auto* flat = std::get_if<scene::RectangleLight>(&light)) {
            node["matrix"] = matrix_json(in_file(frame_of(flat->center, flat->half_u, flat->half_v)));
            steradian = {{"shape", "rectangle"},
                         {"width", 2.0f * glm::length(flat->half_u)},
                         {"height", 2.0f * glm::length(flat->half_v)}};
            if (!flat->is_visible) steradian["visible"] = false;
        } else if (const auto* sphere = std::get_if<scene::SphereLight>(&light)) {
            node["translation"] = place_in_file(sphere->center);
            steradian = {{"shape", "sphere"}, {"radius", sphere->radius}};
        } else {
            node["translation"] = place_in_file(std::get<scene::PointLight>(light).position);
            ordered_json& lights = json()["extensions"]["KHR_lights_punctual"]["lights"];
            lights.push_back({{"type", "point"}, {"intensity", 1.0}});
            node["extensions"]["KHR_lights_punctual"]["light"] = lights.size() - 1;
            ordered_json& used = json()["extensionsUsed"];
            if (used.is_null() || std::ranges::find(used, "KHR_lights_punctual") == used.end())
                used.push_back("KHR_lights_punctual");
        }
        state(steradian, light, is_on, scene_);
        node["extras"]["steradian"] = steradian;
        add_root(json(), append_node(json(), std::move(node)), loaded_.scene_index, false);
    }

    const LoadedScene& loaded_;
    const scene::Scene& scene_;
    const FileLights& file_;
    bool adds_or_removes_;
    const LightingState& now_;
    GltfText gltf_;
};

} // namespace

void save(const LoadedScene& loaded, const Lighting& lighting, const scene::Camera* view,
          const std::string& to) {
    namespace fs = std::filesystem;
    const fs::path from(loaded.file), target(to);
    std::error_code ignored;
    if (fs::weakly_canonical(target, ignored).parent_path()
        != fs::weakly_canonical(from, ignored).parent_path())
        throw Error({to}, "is in another folder than " + loaded.file,
                    "save it beside that file, from where its buffers and textures are found");
    if (target.extension() != from.extension())
        throw Error({to}, "ends otherwise than " + loaded.file, "call it *" + from.extension().string());
    Saving saving(loaded, lighting);
    saving.save_lights();
    saving.save_materials();
    if (view) saving.add_camera(*view);
    image::write_whole(target, saving.bytes());
}

} // namespace sr::viewer
