// EXT_lights_ies (Khronos, vendor extension, complete): a point light whose intensities an IES file gives.
//
// Photometric zero is the node's -Z and the horizontal angle turns from its X towards its Y, as the
// extension's "Coordinate System Mapping" has it.
#include "gltf/light.hpp"
#include "gltf/uri.hpp"

#include <cmath>
#include <fmt/format.h>

namespace sr::gltf {
namespace {

using glm::dvec3;
using tinygltf::Value;

constexpr std::string_view ies_takes =
    "an IES light has the intensities of its file: state its flux in lm or W";

// The extension clamps colours to 0..1.
dvec3 tint_of(const Document& document, const Value& instance, const std::string& title) {
    const dvec3 color = glm::min(color_in(instance), dvec3(1.0));
    const double multiplier = number_in(instance, "multiplier", 1.0);
    return emitted_color(document, color, multiplier, title);
}

/// To the world from the axes of a profile: its X is the node's, its -Y is the node's -Z, its Z the node's
/// -Y. A node that mirrors mirrors the profile.
mat3 world_from_profile(const Document& document, const PlacedNode& placed, const LightFrame& frame,
                        const std::string& title) {
    const dvec3 x(placed.world_from_node[0]), y(placed.world_from_node[1]);
    const dvec3 flat_x = x - glm::dot(x, frame.front) * frame.front;
    if (!(glm::length(flat_x) > 0.0))
        document.fail(fmt::format("{} is scaled to nothing", title),
                      "give its node a scale that is not zero");
    const dvec3 right = glm::normalize(flat_x);
    const dvec3 up = glm::cross(right, frame.front);
    return {vec3(right), vec3(-frame.front), vec3(glm::dot(up, y) < 0.0 ? up : -up)};
}

} // namespace

const std::pair<int, scene::IesLuminaire>& LightTable::luminaire(int index, const std::string& title) {
    if (const auto known = luminaires_.find(index); known != luminaires_.end()) return known->second;
    const Value& light = extension(document_.model.extensions, "EXT_lights_ies")->Get("lights").Get(index);
    const std::string pointer = fmt::format("/extensions/EXT_lights_ies/lights/{}", index);
    const std::string uri = text_in(light, "uri");
    const int view = whole_in(light, "bufferView", -1);
    if (uri.empty() == (view < 0))
        document_.fail(fmt::format("{} has not one of uri and bufferView", title),
                       "name where its IES file is");
    const bool is_embedded = uri.empty() || is_data_uri(uri);
    const std::string name =
        is_embedded ? fmt::format("{}({})", document_.name, pointer) : (document_.folder / uri).string();
    std::vector<std::uint8_t> file;
    if (uri.empty()) {
        const Bytes bytes = document_.view(view, pointer);
        file.assign(bytes.begin(), bytes.end());
    } else {
        file = read_uri(uri, document_.folder, {document_.name, pointer + "/uri"});
    }
    const std::string_view text(reinterpret_cast<const char*>(file.data()), file.size());
    const auto entry = luminaires_.emplace(
        index, std::pair(static_cast<int>(profiles_.size()), scene::read_ies(text, name)));
    profiles_.push_back(entry.first->second.second.profile);
    return entry.first->second;
}

void LightTable::append_ies(const PlacedNode& placed, Warnings& warnings) {
    const tinygltf::Node& node = document_.model.nodes[static_cast<std::size_t>(placed.node)];
    const Value* instance = extension(node.extensions, "EXT_lights_ies");
    if (!instance) return;
    const int index = whole_in(*instance, "light", 0);
    if (document_.is_lost(fmt::format("/extensions/EXT_lights_ies/lights/{}", index))) return;
    const Value& from = extension(document_.model.extensions, "EXT_lights_ies")->Get("lights").Get(index);
    const std::string name = text_in(from, "name");
    const std::string title = light_title("EXT_lights_ies", index, name);
    const Value* stated = steradian_in(node.extras);
    if (stated && stated->Has("shape")) stated = nullptr; // that is a light of its own

    LightFrame frame;
    scene::PointLight light;
    dvec3 tint(0.0);
    const bool is_read = warnings.attempt(without_lamp, [&] {
        light.profile = luminaire(index, title).first;
        frame = frame_of(document_, placed, title);
        light.world_from_profile = world_from_profile(document_, placed, frame, title);
        tint = tint_of(document_, *instance, title);
    });
    if (!is_read) return;
    const scene::IesLuminaire& luminaire = luminaires_.at(index).second;
    light.name = name.empty() ? node.name : name;
    light.position = vec3(frame.position);
    light.is_visible = flag_in(stated, "visible", true);
    if (stated && stated->Has("radius"))
        light.radius = scaled_size(document_, number_in(*stated, "radius", 0.0), frame, "radius", title);

    const double from_nadir = std::acos(glm::clamp(-frame.front.y, -1.0, 1.0));
    const double tilt = luminaire.tilt ? scene::tilt_factor(*luminaire.tilt, from_nadir) : 1.0;
    const Statement statement = statement_of(document_, stated, title);
    const double efficacy = statement.color ? statement.color->efficacy : scene::lumens_per_watt;
    const double in_scene =
        scene::converted(tilt, scene::UnitSystem::photometric, unit_system_of(document_), efficacy);
    const double flux = scene::flux_of(luminaire.profile);
    const Conversion conversion = [&](scene::Quantity quantity, double value) {
        const bool is_determined = quantity == scene::Quantity::flux && flux > 0.0;
        return is_determined ? std::optional(value / flux) : std::nullopt;
    };
    light.I = emitted(document_, statement, in_scene * tint, conversion, title, ies_takes);
    lights_.emplace_back(std::move(light));
}

} // namespace sr::gltf
