// The rules of glTF 2.0 (its JSON schema) for the parts that are read, and of the extensions that are
// supported.
#include "gltf/extras_rules.hpp"
#include "gltf/motion_rules.hpp"
#include "gltf/schema.hpp"

namespace sr::gltf {
namespace {

using Kind = Rule::Kind;

const Rule anything{};
const Rule boolean{.kind = Kind::boolean};
const Rule text{.kind = Kind::text};
const Rule number{.kind = Kind::number};
const Rule whole{.kind = Kind::whole};
const Rule whole_int{.kind = Kind::whole, .largest = 0x7FFFFFFF}; // where tinygltf stores an int
const Rule numbers{.kind = Kind::list, .element = &number};
const Rule two_numbers{.kind = Kind::list, .element = &number, .length = 2};
const Rule three_numbers{.kind = Kind::list, .element = &number, .length = 3};
const Rule four_numbers{.kind = Kind::list, .element = &number, .length = 4};
const Rule sixteen_numbers{.kind = Kind::list, .element = &number, .length = 16};
const Rule object{.kind = Kind::record};
const Rule texts{.kind = Kind::list, .element = &text};

Rule index_into(std::string_view pointer) { return {.kind = Kind::index, .pool = pointer}; }
Rule list_of(const Rule& element) { return {.kind = Kind::list, .element = &element}; }
Rule record(std::vector<PropertyRule> properties) {
    return {.kind = Kind::record, .properties = std::move(properties)};
}
Rule one_of(std::vector<std::string_view> words) { return {.kind = Kind::text, .words = std::move(words)}; }
Rule number_out_of(std::vector<std::uint64_t> values) {
    return {.kind = Kind::whole, .values = std::move(values)};
}

/// The rule of a thing of the picture (Rule::loss).
Rule thing(Rule rule, std::string_view loss, std::string_view stand_in = {}) {
    rule.loss = loss;
    rule.stand_in = stand_in;
    return rule;
}

constexpr std::string_view without_texture = "the material is shown without that texture";
constexpr std::string_view without_lamp = "that lamp is off";

const Rule buffer_index = index_into("/buffers");
const Rule view_index = index_into("/bufferViews");
const Rule accessor_index = index_into("/accessors");
const Rule sampler_index = thing(index_into("/samplers"), "the texture is read with the default sampler");
const Rule texture_index = index_into("/textures");
const Rule material_index = index_into("/materials");
const Rule mesh_index = index_into("/meshes");
const Rule skin_index = index_into("/skins");
const Rule camera_index = thing(index_into("/cameras"), "the node has no camera");
const Rule node_index = index_into("/nodes");
const Rule scene_index = index_into("/scenes");
const Rule punctual_light_index = index_into("/extensions/KHR_lights_punctual/lights");
const Rule area_light_index = index_into("/extensions/EXT_lights_area/lights");
const Rule ies_light_index = index_into("/extensions/EXT_lights_ies/lights");
const Rule node_indices = list_of(node_index);

// --- bytes
const Rule buffer = record({{"uri", &text}, {"byteLength", &whole, true}, {"name", &text}});
const Rule image =
    thing(record({{"uri", &text}, {"bufferView", &view_index}, {"mimeType", &text}, {"name", &text}}),
          "materials are shown without textures of it", "{}");
const Rule buffer_view = record({{"buffer", &buffer_index, true},
                                 {"byteOffset", &whole},
                                 {"byteLength", &whole, true},
                                 {"byteStride", &whole},
                                 {"target", &whole},
                                 {"name", &text},
                                 {"extensions", &view_extensions_rule()}});
// BYTE, UNSIGNED_BYTE, SHORT, UNSIGNED_SHORT, UNSIGNED_INT, FLOAT
const Rule component_type = number_out_of({5120, 5121, 5122, 5123, 5125, 5126});
const Rule index_component_type = number_out_of({5121, 5123, 5125});
const Rule accessor_type = one_of({"SCALAR", "VEC2", "VEC3", "VEC4", "MAT2", "MAT3", "MAT4"});
const Rule sparse_indices = record({{"bufferView", &view_index, true},
                                    {"byteOffset", &whole_int},
                                    {"componentType", &index_component_type, true}});
const Rule sparse_values = record({{"bufferView", &view_index, true}, {"byteOffset", &whole_int}});
const Rule sparse = record(
    {{"count", &whole_int, true}, {"indices", &sparse_indices, true}, {"values", &sparse_values, true}});
const Rule accessor = record({{"bufferView", &view_index},
                              {"byteOffset", &whole},
                              {"componentType", &component_type, true},
                              {"normalized", &boolean},
                              {"count", &whole, true},
                              {"type", &accessor_type, true},
                              {"min", &numbers},
                              {"max", &numbers},
                              {"sparse", &sparse},
                              {"name", &text},
                              {"extensions", &object}});

// --- meshes
const Rule attributes{.kind = Kind::dictionary, .element = &accessor_index};
const Rule targets = list_of(attributes);
const Rule mode = number_out_of({0, 1, 2, 3, 4, 5, 6});
const Rule primitive = record({{"attributes", &attributes, true},
                               {"indices", &accessor_index},
                               {"material", &material_index},
                               {"mode", &mode},
                               {"targets", &targets},
                               {"extensions", &primitive_extensions_rule()}});
const Rule primitives = list_of(primitive);
const Rule mesh = record(
    {{"primitives", &primitives, true}, {"weights", &numbers}, {"name", &text}, {"extensions", &object}});

// --- materials
const Rule texture_transform = record(
    {{"offset", &two_numbers}, {"rotation", &number}, {"scale", &two_numbers}, {"texCoord", &whole_int}});
const Rule texture_info_extensions = record({{"KHR_texture_transform", &texture_transform}});
const Rule texture_info = thing(record({{"index", &texture_index, true},
                                        {"texCoord", &whole_int},
                                        {"scale", &number},
                                        {"strength", &number},
                                        {"extensions", &texture_info_extensions}}),
                                without_texture);
const Rule metallic_roughness = record({{"baseColorFactor", &four_numbers},
                                        {"baseColorTexture", &texture_info},
                                        {"metallicFactor", &number},
                                        {"roughnessFactor", &number},
                                        {"metallicRoughnessTexture", &texture_info},
                                        {"extensions", &object}});
const Rule emissive_strength = record({{"emissiveStrength", &number}});
const Rule ior = record({{"ior", &number}});
const Rule specular = record({{"specularFactor", &number},
                              {"specularTexture", &texture_info},
                              {"specularColorFactor", &three_numbers},
                              {"specularColorTexture", &texture_info}});
const Rule anisotropy = record(
    {{"anisotropyStrength", &number}, {"anisotropyRotation", &number}, {"anisotropyTexture", &texture_info}});
const Rule clearcoat = record({{"clearcoatFactor", &number},
                               {"clearcoatTexture", &texture_info},
                               {"clearcoatRoughnessFactor", &number},
                               {"clearcoatRoughnessTexture", &texture_info},
                               {"clearcoatNormalTexture", &texture_info}});
const Rule sheen = record({{"sheenColorFactor", &three_numbers},
                           {"sheenColorTexture", &texture_info},
                           {"sheenRoughnessFactor", &number},
                           {"sheenRoughnessTexture", &texture_info}});
const Rule iridescence = record({{"iridescenceFactor", &number},
                                 {"iridescenceTexture", &texture_info},
                                 {"iridescenceIor", &number},
                                 {"iridescenceThicknessMinimum", &number},
                                 {"iridescenceThicknessMaximum", &number},
                                 {"iridescenceThicknessTexture", &texture_info}});
const Rule transmission = record({{"transmissionFactor", &number}, {"transmissionTexture", &texture_info}});
const Rule volume = record({{"thicknessFactor", &number},
                            {"thicknessTexture", &texture_info},
                            {"attenuationDistance", &number},
                            {"attenuationColor", &three_numbers}});
const Rule diffuse_transmission = record({{"diffuseTransmissionFactor", &number},
                                          {"diffuseTransmissionTexture", &texture_info},
                                          {"diffuseTransmissionColorFactor", &three_numbers},
                                          {"diffuseTransmissionColorTexture", &texture_info}});
const Rule specular_glossiness = record({{"diffuseFactor", &four_numbers},
                                         {"diffuseTexture", &texture_info},
                                         {"specularFactor", &three_numbers},
                                         {"glossinessFactor", &number},
                                         {"specularGlossinessTexture", &texture_info}});
const Rule material_extensions = record({{"KHR_materials_pbrSpecularGlossiness", &specular_glossiness},
                                         {"KHR_materials_anisotropy", &anisotropy},
                                         {"KHR_materials_clearcoat", &clearcoat},
                                         {"KHR_materials_sheen", &sheen},
                                         {"KHR_materials_iridescence", &iridescence},
                                         {"KHR_materials_emissive_strength", &emissive_strength},
                                         {"KHR_materials_ior", &ior},
                                         {"KHR_materials_specular", &specular},
                                         {"KHR_materials_transmission", &transmission},
                                         {"KHR_materials_volume", &volume},
                                         {"KHR_materials_diffuse_transmission", &diffuse_transmission},
                                         {"KHR_materials_unlit", &object}});
const Rule alpha_mode = one_of({"OPAQUE", "MASK", "BLEND"});
const Rule material = record({{"name", &text},
                              {"pbrMetallicRoughness", &metallic_roughness},
                              {"normalTexture", &texture_info},
                              {"occlusionTexture", &texture_info},
                              {"emissiveTexture", &texture_info},
                              {"emissiveFactor", &three_numbers},
                              {"alphaMode", &alpha_mode},
                              {"alphaCutoff", &number},
                              {"doubleSided", &boolean},
                              {"extensions", &material_extensions},
                              {"extras", &material_extras_rule()}});
const Rule magnification = number_out_of({9728, 9729});
const Rule minification = number_out_of({9728, 9729, 9984, 9985, 9986, 9987});
const Rule wrap = number_out_of({33071, 33648, 10497});
const Rule sampler = thing(record({{"magFilter", &magnification},
                                   {"minFilter", &minification},
                                   {"wrapS", &wrap},
                                   {"wrapT", &wrap},
                                   {"name", &text}}),
                           "textures are read with the default sampler in its place", "{}");
// texture.cpp checks that there is such an image.
const Rule webp = record({{"source", &whole_int, true}});
const Rule texture_extensions = record({{"EXT_texture_webp", &webp}});
const Rule texture = thing(record({{"source", &whole_int},
                                   {"sampler", &sampler_index},
                                   {"name", &text},
                                   {"extensions", &texture_extensions}}),
                           without_texture, "{}");

// --- cameras and lights
const Rule perspective =
    record({{"yfov", &number, true}, {"aspectRatio", &number}, {"znear", &number, true}, {"zfar", &number}});
const Rule orthographic = record(
    {{"xmag", &number, true}, {"ymag", &number, true}, {"znear", &number, true}, {"zfar", &number, true}});
const Rule camera_type = one_of({"perspective", "orthographic"});
const Rule camera =
    thing(record({{"type", &camera_type, true},
                  {"perspective", &perspective},
                  {"orthographic", &orthographic},
                  {"name", &text},
                  {"extensions", &object}}),
          "that camera is left out", R"({"type": "perspective", "perspective": {"yfov": 1, "znear": 1}})");
const Rule spot = record({{"innerConeAngle", &number}, {"outerConeAngle", &number}});
const Rule punctual_type = one_of({"point", "spot", "directional"});
const Rule punctual_light = thing(record({{"type", &punctual_type, true},
                                          {"spot", &spot},
                                          {"name", &text},
                                          {"color", &three_numbers},
                                          {"intensity", &number},
                                          {"range", &number},
                                          {"extras", &light_extras_rule()}}),
                                  without_lamp, R"({"type": "point"})");
const Rule punctual_lights = list_of(punctual_light);
const Rule punctual = record({{"lights", &punctual_lights}});
const Rule rect = record({{"aspect", &number}});
const Rule area_light = thing(record({{"type", &text},
                                      {"shape", &text},
                                      {"name", &text},
                                      {"color", &three_numbers},
                                      {"intensity", &number},
                                      {"size", &number},
                                      {"rect", &rect}}),
                              without_lamp, "{}");
const Rule area_lights = list_of(area_light);
const Rule area = record({{"lights", &area_lights}});
const Rule ies_light =
    thing(record({{"uri", &text}, {"bufferView", &view_index}, {"mimeType", &text}, {"name", &text}}),
          without_lamp, "{}");
const Rule ies_lights = list_of(ies_light);
const Rule ies = record({{"lights", &ies_lights, true}});
const Rule root_extensions = record({{"KHR_lights_punctual", &punctual},
                                     {"EXT_lights_area", &area},
                                     {"EXT_lights_ies", &ies},
                                     {"KHR_materials_variants", &variants_rule()}});

// --- nodes
const Rule node_punctual = thing(record({{"light", &punctual_light_index, true}}), without_lamp);
const Rule node_area = thing(record({{"light", &area_light_index, true}}), without_lamp);
const Rule node_ies =
    thing(record({{"light", &ies_light_index, true}, {"multiplier", &number}, {"color", &three_numbers}}),
          without_lamp);
const Rule node_extensions = record({{"KHR_lights_punctual", &node_punctual},
                                     {"EXT_lights_area", &node_area},
                                     {"EXT_lights_ies", &node_ies},
                                     {"EXT_mesh_gpu_instancing", &instancing_rule()},
                                     {"KHR_node_visibility", &visibility_rule()}});
const Rule node = record({{"name", &text},
                          {"children", &node_indices},
                          {"mesh", &mesh_index},
                          {"skin", &skin_index},
                          {"camera", &camera_index},
                          {"matrix", &sixteen_numbers},
                          {"translation", &three_numbers},
                          {"rotation", &four_numbers},
                          {"scale", &three_numbers},
                          {"weights", &numbers},
                          {"extensions", &node_extensions},
                          {"extras", &node_extras_rule()}});
const Rule scene = record(
    {{"nodes", &node_indices}, {"name", &text}, {"extensions", &object}, {"extras", &scene_extras_rule()}});

const Rule buffers = list_of(buffer);
const Rule images = list_of(image);
const Rule buffer_views = list_of(buffer_view);
const Rule accessors = list_of(accessor);
const Rule meshes = list_of(mesh);
const Rule materials = list_of(material);
const Rule samplers = list_of(sampler);
const Rule textures = list_of(texture);
const Rule cameras = list_of(camera);
const Rule nodes = list_of(node);
const Rule skins = list_of(skin_rule());
const Rule animations = list_of(animation_rule());
const Rule scenes = list_of(scene);
const Rule asset = record({{"version", &text, true},
                           {"minVersion", &text},
                           {"generator", &text},
                           {"copyright", &text},
                           {"extras", &asset_extras_rule()}});

const Rule root = record({{"asset", &asset, true},
                          {"extensionsUsed", &texts},
                          {"extensionsRequired", &texts},
                          {"buffers", &buffers},
                          {"bufferViews", &buffer_views},
                          {"accessors", &accessors},
                          {"meshes", &meshes},
                          {"materials", &materials},
                          {"samplers", &samplers},
                          {"images", &images},
                          {"textures", &textures},
                          {"cameras", &cameras},
                          {"nodes", &nodes},
                          {"scenes", &scenes},
                          {"scene", &scene_index},
                          {"skins", &skins},
                          {"animations", &animations},
                          {"extensions", &root_extensions},
                          {"extras", &anything}});

} // namespace

const Rule& gltf_rule() { return root; }

} // namespace sr::gltf
