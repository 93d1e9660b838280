#include "whole_gltf.hpp"

#include "support/draco_stream.hpp"

namespace sr::testing {
namespace {

// A skin, a sparse morph target, instances, a variant, and an animation of each kind.
void add_motion(MadeGltf& made) {
    json bent = made.primitive();
    bent["attributes"]["JOINTS_0"] = made.shorts({0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0}, "VEC4");
    bent["attributes"]["WEIGHTS_0"] = made.floats({1, 0, 0, 0, 1, 0, 0, 0, .5, .5, 0, 0}, "VEC4");
    bent["targets"] = json::array({{{"POSITION", 0}, {"NORMAL", bent["attributes"]["NORMAL"]}}});
    bent["extensions"]["KHR_materials_variants"]["mappings"] =
        json::parse(R"([{"material": 0, "variants": [0]}])");
    made.root["meshes"].push_back({{"primitives", json::array({bent})}, {"weights", {0.5}}});
    made.root["extensions"]["KHR_materials_variants"]["variants"] = json::parse(R"([{"name": "v"}])");
    std::vector<float> matrices(32, 1.0f);
    made.root["skins"] =
        json::array({{{"joints", {0, 1}}, {"inverseBindMatrices", made.accessor(matrices, "MAT4", 5126)}}});
    const int times = made.floats({0, 1}, "SCALAR");
    const int one = made.floats({0, 1}, "SCALAR"), three = made.floats({0, 0, 0, 1, 1, 1}, "VEC3");
    const int cubic = made.floats(std::vector<float>(24, 0.5f), "VEC4");
    made.root["nodes"].push_back({{"mesh", 1}, {"skin", 0}});
    made.root["nodes"].push_back(
        {{"mesh", 0},
         {"extensions",
          {{"EXT_mesh_gpu_instancing", {{"attributes", {{"TRANSLATION", three}, {"SCALE", three}}}}},
           {"KHR_node_visibility", {{"visible", true}}}}}});
    json animation{
        {"samplers", json::array({{{"input", times}, {"output", three}},
                                  {{"input", times}, {"output", cubic}, {"interpolation", "CUBICSPLINE"}},
                                  {{"input", times}, {"output", one}, {"interpolation", "STEP"}}})}};
    for (const char* channel :
         {R"({"sampler": 0, "target": {"node": 1, "path": "translation"}})",
          R"({"sampler": 1, "target": {"node": 1, "path": "rotation"}})",
          R"({"sampler": 2, "target": {"node": 7, "path": "weights"}})",
          R"({"sampler": 2, "target": {"path": "pointer", "extensions": {"KHR_animation_pointer": {"pointer":
              "/extensions/EXT_lights_area/lights/0/intensity"}}}})",
          R"({"sampler": 2, "target": {"path": "pointer", "extensions": {"KHR_animation_pointer": {"pointer":
              "/materials/0/pbrMetallicRoughness/baseColorTexture/extensions/KHR_texture_transform/rotation"}}}})"})
        animation["channels"].push_back(json::parse(channel));
    made.root["animations"] = json::array({animation});
}

// A build without Draco sees zeros.
void add_draco(MadeGltf& made) {
    const int bytes = made.accessor(draco_triangles(), "SCALAR", 5121);
    json& accessors = made.root["accessors"];
    accessors.push_back({{"componentType", 5126}, {"count", 4}, {"type", "VEC3"}});
    const json packed{{"bufferView", accessors[bytes]["bufferView"]}, {"attributes", {{"POSITION", 0}}}};
    made.root["meshes"].push_back(
        {{"primitives", json::array({{{"attributes", {{"POSITION", accessors.size() - 1}}},
                                      {"extensions", {{"KHR_draco_mesh_compression", packed}}}}})}});
    made.root["nodes"].push_back({{"mesh", 2}});
}

} // namespace

MadeGltf whole_gltf() {
    MadeGltf made = MadeGltf::triangle();
    made.attributes()["NORMAL"] = made.floats({0, 0, 1, 0, 0, 1, 0, 0, 1}, "VEC3");
    made.attributes()["TEXCOORD_0"] = made.floats({0, 1, 1, 1, 0, 0}, "VEC2");
    made.attributes()["COLOR_0"] =
        made.accessor<std::uint8_t>({255, 0, 0, 0, 255, 0, 0, 0, 255}, "VEC3", 5121);
    made.primitive()["indices"] = made.shorts({0, 1, 2});
    made.primitive()["material"] = 0;
    json strip = made.primitive();
    strip.update({{"mode", 5}, {"indices", made.accessor<std::uint32_t>({0, 1, 2, 0}, "SCALAR", 5125)}});
    strip["attributes"].erase("NORMAL");
    made.root["meshes"][0]["primitives"].push_back(strip);
    made.root["accessors"].back().erase("bufferView"); // zeros
    const int places = made.accessor<std::uint32_t>({2}, "SCALAR", 5125);
    const int values = made.floats({0, 5, 0}, "VEC3");
    made.root["accessors"][0]["sparse"] = {
        {"count", 1},
        {"indices", {{"bufferView", made.root["accessors"][places]["bufferView"]}, {"componentType", 5125}}},
        {"values", {{"bufferView", made.root["accessors"][values]["bufferView"]}}}};
    made.root.update(json::parse(R"({
        "materials": [{"name": "m", "normalTexture": {"index": 0}, "emissiveFactor": [1, 1, 1],
            "pbrMetallicRoughness": {"baseColorFactor": [1, 1, 1, 1], "baseColorTexture": {"index": 0, "extensions":
                {"KHR_texture_transform": {"offset": [0, 1], "rotation": 1, "scale": [1, 2], "texCoord": 0}}}},
            "extensions": {"KHR_materials_specular": {"specularTexture": {"index": 0}}, "KHR_materials_ior": {"ior": 1.4}}}],
        "samplers": [{"magFilter": 9728, "minFilter": 9987}],
        "textures": [{"source": 0, "sampler": 0}],
        "cameras": [{"type": "perspective", "perspective": {"yfov": 1, "znear": 1}}],
        "extensions": {"KHR_lights_punctual": {"lights": [{"type": "spot", "spot": {"outerConeAngle": 0.5}}]},
                       "EXT_lights_area": {"lights": [{"type": "rect", "size": 2, "rect": {"aspect": 2}}]}},
        "nodes": [{"mesh": 0, "children": [1, 2]}, {"camera": 0, "translation": [1, 2, 3], "rotation": [0, 0, 0, 1]},
            {"matrix": [1,0,0,0, 0,1,0,0, 0,0,1,0, 0,0,0,1], "mesh": 0, "children": [3]},
            {"extensions": {"KHR_lights_punctual": {"light": 0}, "EXT_lights_area": {"light": 0}}, "scale": [1, 2, 3]}],
        "scene": 0})"));
    made.root["nodes"].push_back(
        json::parse(R"({"extras": {"steradian": {"shape": "disk", "radius": 1, "texture": 0,
        "temperature": 3000, "quantity": {"value": 9, "unit": "lm"}}}})"));
    made.root["nodes"].push_back(json::parse(R"({"extras": {"steradian": {"shape": "polygon", "corners":
        [[0, 0, 0], [1, 0, 0], [0, 1, 0]], "spectrum": [[400, 1], [700, 2]], "quantity": {"value": 9, "unit": "W"}}}})"));
    made.root["extensions"]["EXT_lights_ies"]["lights"] = json::parse(R"([{"uri":
        "data:,TILT=NONE%0A1 -1 1 2 1 1 2 0 0 0 1 1 1 0 90 0 9 8"}])");
    made.root["nodes"].push_back(json::parse(R"({"extensions": {"EXT_lights_ies": {"light": 0}}})"));
    made.root["images"] = json::array({{{"uri", png_uri()}}});
    add_motion(made);
    add_draco(made);
    return made;
}

} // namespace sr::testing
