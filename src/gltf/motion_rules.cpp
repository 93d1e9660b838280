#include "gltf/motion_rules.hpp"

namespace sr::gltf {
namespace {

using Kind = Rule::Kind;

// All in one function-local static: rules.cpp points here before main.
struct MotionRules {
    Rule boolean{.kind = Kind::boolean};
    Rule text{.kind = Kind::text};
    Rule whole{.kind = Kind::whole, .largest = 0x7FFFFFFF}; // where tinygltf stores an int
    Rule buffer{.kind = Kind::index, .pool = "/buffers"};
    Rule packed_mode{.kind = Kind::text, .words = {"ATTRIBUTES", "TRIANGLES", "INDICES"}};
    Rule packed_filter{.kind = Kind::text,
                       .words = {"NONE", "OCTAHEDRAL", "QUATERNION", "EXPONENTIAL", "COLOR"}};
    Rule accessor{.kind = Kind::index, .pool = "/accessors"};
    Rule view{.kind = Kind::index, .pool = "/bufferViews"};
    Rule node_index{.kind = Kind::index, .pool = "/nodes"};
    Rule material{.kind = Kind::index, .pool = "/materials"};
    Rule variant_index{.kind = Kind::index, .pool = "/extensions/KHR_materials_variants/variants"};
    Rule joints{.kind = Kind::list, .element = &node_index};
    Rule attributes{.kind = Kind::dictionary, .element = &accessor};
    Rule attribute_ids{.kind = Kind::dictionary, .element = &whole};
    Rule interpolation{.kind = Kind::text, .words = {"LINEAR", "STEP", "CUBICSPLINE"}};

    // clang-format off
    Rule skin{.kind = Kind::record, .properties = {
        {"joints", &joints, true}, {"inverseBindMatrices", &accessor}, {"skeleton", &node_index}, {"name", &text}}};

    Rule sampler{.kind = Kind::record, .properties = {
        {"input", &accessor, true}, {"output", &accessor, true}, {"interpolation", &interpolation}},
        .loss = "what it moves stays as it is", .stand_in = "{}"};
    Rule pointer{.kind = Kind::record, .properties = {{"pointer", &text, true}}};
    Rule target_extensions{.kind = Kind::record, .properties = {{"KHR_animation_pointer", &pointer}}};
    Rule target{.kind = Kind::record, .properties = {
        {"node", &node_index}, {"path", &text, true}, {"extensions", &target_extensions}}};
    Rule channel{.kind = Kind::record, .properties = {{"sampler", &whole, true}, {"target", &target, true}},
        .loss = "that channel is left out"};
    Rule samplers{.kind = Kind::list, .element = &sampler};
    Rule channels{.kind = Kind::list, .element = &channel};
    Rule animation{.kind = Kind::record, .properties = {
        {"samplers", &samplers, true}, {"channels", &channels, true}, {"name", &text}},
        .loss = "that animation moves nothing", .stand_in = R"({"samplers": [], "channels": []})"};

    Rule visibility{.kind = Kind::record, .properties = {{"visible", &boolean}}};
    Rule instancing{.kind = Kind::record, .properties = {{"attributes", &attributes, true}}};

    Rule variant{.kind = Kind::record, .properties = {{"name", &text, true}}};
    Rule variant_list{.kind = Kind::list, .element = &variant};
    Rule variants{.kind = Kind::record, .properties = {{"variants", &variant_list, true}}};
    Rule variant_indices{.kind = Kind::list, .element = &variant_index};
    Rule mapping{.kind = Kind::record, .properties = {
        {"material", &material, true}, {"variants", &variant_indices, true}}};
    Rule mapping_list{.kind = Kind::list, .element = &mapping};
    Rule mappings{.kind = Kind::record, .properties = {{"mappings", &mapping_list, true}}};
    Rule draco{.kind = Kind::record, .properties = {{"bufferView", &view, true}, {"attributes", &attribute_ids, true}}};
    Rule meshopt{.kind = Kind::record, .properties = {
        {"buffer", &buffer, true}, {"byteOffset", &whole}, {"byteLength", &whole, true}, {"byteStride", &whole, true},
        {"count", &whole, true}, {"mode", &packed_mode, true}, {"filter", &packed_filter}}};
    Rule view_extensions{.kind = Kind::record, .properties = {{"EXT_meshopt_compression", &meshopt}, {"KHR_meshopt_compression", &meshopt}}};
    Rule primitive_extensions{.kind = Kind::record, .properties = {
        {"KHR_materials_variants", &mappings}, {"KHR_draco_mesh_compression", &draco}}};
    // clang-format on

    MotionRules() = default;
    MotionRules(const MotionRules&) = delete; // they point at one another
    MotionRules& operator=(const MotionRules&) = delete;
};

const MotionRules& motion_rules() {
    static const MotionRules all;
    return all;
}

} // namespace

const Rule& skin_rule() { return motion_rules().skin; }
const Rule& animation_rule() { return motion_rules().animation; }
const Rule& visibility_rule() { return motion_rules().visibility; }
const Rule& instancing_rule() { return motion_rules().instancing; }
const Rule& variants_rule() { return motion_rules().variants; }
const Rule& view_extensions_rule() { return motion_rules().view_extensions; }
const Rule& primitive_extensions_rule() { return motion_rules().primitive_extensions; }

} // namespace sr::gltf
