// The JSON schema of glTF 2.0, for the parts that are read, and of the extensions that are supported.
#include "gltf/extensions.hpp"
#include "gltf/schema.hpp"

namespace sr::gltf {
namespace {

using namespace schemas;

constexpr std::uint64_t max_int = 0x7FFFFFFF; // where tinygltf stores an int
constexpr std::string_view without_texture = "the material is shown without that texture";
constexpr std::string_view without_lamp = "that lamp is off";

Schema numbers(std::size_t length = 0) { return array(number(), length); }
Schema accessor_index() { return index("/accessors"); }
Schema view_index() { return index("/bufferViews"); }
Schema attributes() { return dictionary(accessor_index()); }

// Bytes.

Schema buffer() { return object({{"uri", string()}, {"byteLength", integer(), true}, {"name", string()}}); }

Schema image() {
    return thing(
        object({{"uri", string()}, {"bufferView", view_index()}, {"mimeType", string()}, {"name", string()}}),
        "materials are shown without textures of it", "{}");
}

Schema buffer_view() {
    const Schema meshopt =
        object({{"buffer", index("/buffers"), true},
                {"byteOffset", integer(max_int)},
                {"byteLength", integer(max_int), true},
                {"byteStride", integer(max_int), true},
                {"count", integer(max_int), true},
                {"mode", string({"ATTRIBUTES", "TRIANGLES", "INDICES"}), true},
                {"filter", string({"NONE", "OCTAHEDRAL", "QUATERNION", "EXPONENTIAL", "COLOR"})}});
    return object({{"buffer", index("/buffers"), true},
                   {"byteOffset", integer()},
                   {"byteLength", integer(), true},
                   {"byteStride", integer()},
                   {"target", integer()},
                   {"name", string()},
                   {"extensions",
                    object({{"EXT_meshopt_compression", meshopt}, {"KHR_meshopt_compression", meshopt}})}});
}

Schema accessor() {
    const Schema indices = object({{"bufferView", view_index(), true},
                                   {"byteOffset", integer(max_int)},
                                   {"componentType", enum_integer({5121, 5123, 5125}), true}});
    const Schema values = object({{"bufferView", view_index(), true}, {"byteOffset", integer(max_int)}});
    // BYTE, UNSIGNED_BYTE, SHORT, UNSIGNED_SHORT, UNSIGNED_INT, FLOAT
    const Schema component_type = enum_integer({5120, 5121, 5122, 5123, 5125, 5126});
    return object(
        {{"bufferView", view_index()},
         {"byteOffset", integer()},
         {"componentType", component_type, true},
         {"normalized", boolean()},
         {"count", integer(), true},
         {"type", string({"SCALAR", "VEC2", "VEC3", "VEC4", "MAT2", "MAT3", "MAT4"}), true},
         {"min", numbers()},
         {"max", numbers()},
         {"sparse",
          object({{"count", integer(max_int), true}, {"indices", indices, true}, {"values", values, true}})},
         {"name", string()},
         {"extensions", object()}});
}

// Meshes.

Schema primitive() {
    const Schema mapping =
        object({{"material", index("/materials"), true},
                {"variants", array(index("/extensions/KHR_materials_variants/variants")), true}});
    const Schema draco =
        object({{"bufferView", view_index(), true}, {"attributes", dictionary(integer(max_int)), true}});
    return object(
        {{"attributes", attributes(), true},
         {"indices", accessor_index()},
         {"material", index("/materials")},
         {"mode", enum_integer({0, 1, 2, 3, 4, 5, 6})},
         {"targets", array(attributes())},
         {"extensions", object({{"KHR_materials_variants", object({{"mappings", array(mapping), true}})},
                                {"KHR_draco_mesh_compression", draco}})}});
}

Schema mesh() {
    return object({{"primitives", array(primitive()), true},
                   {"weights", numbers()},
                   {"name", string()},
                   {"extensions", object()}});
}

Schema skin() {
    return object({{"joints", array(index("/nodes")), true},
                   {"inverseBindMatrices", accessor_index()},
                   {"skeleton", index("/nodes")},
                   {"name", string()}});
}

// Materials.

Schema material_extensions() {
    std::vector<PropertySchema> extensions;
    for (const Extension& extension : known_extensions())
        if (extension.of_material) extensions.emplace_back(extension.name, extension.of_material());
    return object(std::move(extensions));
}

Schema material() {
    const Schema texture = texture_info_schema();
    return object({{"name", string()},
                   {"pbrMetallicRoughness", object({{"baseColorFactor", numbers(4)},
                                                    {"baseColorTexture", texture},
                                                    {"metallicFactor", number()},
                                                    {"roughnessFactor", number()},
                                                    {"metallicRoughnessTexture", texture},
                                                    {"extensions", object()}})},
                   {"normalTexture", texture},
                   {"occlusionTexture", texture},
                   {"emissiveTexture", texture},
                   {"emissiveFactor", numbers(3)},
                   {"alphaMode", string({"OPAQUE", "MASK", "BLEND"})},
                   {"alphaCutoff", number()},
                   {"doubleSided", boolean()},
                   {"extensions", material_extensions()},
                   {"extras", material_extras_schema()}});
}

Schema sampler() {
    const Schema wrap = enum_integer({33071, 33648, 10497});
    return thing(object({{"magFilter", enum_integer({9728, 9729})},
                         {"minFilter", enum_integer({9728, 9729, 9984, 9985, 9986, 9987})},
                         {"wrapS", wrap},
                         {"wrapT", wrap},
                         {"name", string()}}),
                 "textures are read with the default sampler in its place", "{}");
}

// read/texture.cpp checks that its image is there.
Schema texture() {
    return thing(
        object(
            {{"source", integer(max_int)},
             {"sampler", thing(index("/samplers"), "the texture is read with the default sampler")},
             {"name", string()},
             {"extensions", object({{"EXT_texture_webp", object({{"source", integer(max_int), true}})}})}}),
        without_texture, "{}");
}

// Cameras and lights.

Schema camera() {
    return thing(object({{"type", string({"perspective", "orthographic"}), true},
                         {"perspective", object({{"yfov", number(), true},
                                                 {"aspectRatio", number()},
                                                 {"znear", number(), true},
                                                 {"zfar", number()}})},
                         {"orthographic", object({{"xmag", number(), true},
                                                  {"ymag", number(), true},
                                                  {"znear", number(), true},
                                                  {"zfar", number(), true}})},
                         {"name", string()},
                         {"extensions", object()}}),
                 "that camera is left out",
                 R"({"type": "perspective", "perspective": {"yfov": 1, "znear": 1}})");
}

Schema root_extensions() {
    const Schema punctual =
        thing(object({{"type", string({"point", "spot", "directional"}), true},
                      {"spot", object({{"innerConeAngle", number()}, {"outerConeAngle", number()}})},
                      {"name", string()},
                      {"color", numbers(3)},
                      {"intensity", number()},
                      {"range", number()},
                      {"extras", light_extras_schema()}}),
              without_lamp, R"({"type": "point"})");
    const Schema area = thing(object({{"type", string()},
                                      {"shape", string()},
                                      {"name", string()},
                                      {"color", numbers(3)},
                                      {"intensity", number()},
                                      {"size", number()},
                                      {"rect", object({{"aspect", number()}})}}),
                              without_lamp, "{}");
    const Schema ies = thing(
        object({{"uri", string()}, {"bufferView", view_index()}, {"mimeType", string()}, {"name", string()}}),
        without_lamp, "{}");
    const Schema variant = object({{"name", string(), true}});
    return object({{"KHR_lights_punctual", object({{"lights", array(punctual)}})},
                   {"EXT_lights_area", object({{"lights", array(area)}})},
                   {"EXT_lights_ies", object({{"lights", array(ies), true}})},
                   {"KHR_materials_variants", object({{"variants", array(variant), true}})}});
}

// Nodes and what moves them.

Schema node_extensions() {
    const auto light = [](std::string_view pointer) { return PropertySchema("light", index(pointer), true); };
    const Schema ies =
        object({light("/extensions/EXT_lights_ies/lights"), {"multiplier", number()}, {"color", numbers(3)}});
    return object(
        {{"KHR_lights_punctual",
          thing(object({light("/extensions/KHR_lights_punctual/lights")}), without_lamp)},
         {"EXT_lights_area", thing(object({light("/extensions/EXT_lights_area/lights")}), without_lamp)},
         {"EXT_lights_ies", thing(ies, without_lamp)},
         {"EXT_mesh_gpu_instancing", object({{"attributes", attributes(), true}})},
         {"KHR_node_visibility", object({{"visible", boolean()}})}});
}

Schema node() {
    return object({{"name", string()},
                   {"children", array(index("/nodes"))},
                   {"mesh", index("/meshes")},
                   {"skin", index("/skins")},
                   {"camera", thing(index("/cameras"), "the node has no camera")},
                   {"matrix", numbers(16)},
                   {"translation", numbers(3)},
                   {"rotation", numbers(4)},
                   {"scale", numbers(3)},
                   {"weights", numbers()},
                   {"extensions", node_extensions()},
                   {"extras", node_extras_schema()}});
}

Schema scene() {
    return object({{"nodes", array(index("/nodes"))},
                   {"name", string()},
                   {"extensions", object()},
                   {"extras", scene_extras_schema()}});
}

Schema animation() {
    const Schema sampler = thing(object({{"input", accessor_index(), true},
                                         {"output", accessor_index(), true},
                                         {"interpolation", string({"LINEAR", "STEP", "CUBICSPLINE"})}}),
                                 "what it moves stays as it is", "{}");
    const Schema pointer = object({{"KHR_animation_pointer", object({{"pointer", string(), true}})}});
    const Schema target =
        object({{"node", index("/nodes")}, {"path", string(), true}, {"extensions", pointer}});
    const Schema channel = thing(object({{"sampler", integer(max_int), true}, {"target", target, true}}),
                                 "that channel is left out");
    return thing(
        object({{"samplers", array(sampler), true}, {"channels", array(channel), true}, {"name", string()}}),
        "that animation moves nothing", R"({"samplers": [], "channels": []})");
}

Schema asset() {
    return object({{"version", string(), true},
                   {"minVersion", string()},
                   {"generator", string()},
                   {"copyright", string()},
                   {"extras", asset_extras_schema()}});
}

} // namespace

Schema texture_info_schema() {
    const Schema transform = object({{"offset", numbers(2)},
                                     {"rotation", number()},
                                     {"scale", numbers(2)},
                                     {"texCoord", integer(max_int)}});
    return thing(object({{"index", index("/textures"), true},
                         {"texCoord", integer(max_int)},
                         {"scale", number()},
                         {"strength", number()},
                         {"extensions", object({{"KHR_texture_transform", transform}})}}),
                 without_texture);
}

const Schema& gltf_schema() {
    static const Schema root = object({{"asset", asset(), true},
                                       {"extensionsUsed", array(string())},
                                       {"extensionsRequired", array(string())},
                                       {"buffers", array(buffer())},
                                       {"bufferViews", array(buffer_view())},
                                       {"accessors", array(accessor())},
                                       {"meshes", array(mesh())},
                                       {"materials", array(material())},
                                       {"samplers", array(sampler())},
                                       {"images", array(image())},
                                       {"textures", array(texture())},
                                       {"cameras", array(camera())},
                                       {"nodes", array(node())},
                                       {"scenes", array(scene())},
                                       {"scene", index("/scenes")},
                                       {"skins", array(skin())},
                                       {"animations", array(animation())},
                                       {"extensions", root_extensions()}});
    return root;
}

} // namespace sr::gltf
