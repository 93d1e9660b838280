// tinygltf's writers use file streams even where its own file system is left out.
#include <fstream>
#include <vector>

#include "gltf/tinygltf.hpp"

#include "core/error.hpp"

#include <algorithm>
#include <limits>

namespace sr::gltf {
namespace {

using nlohmann::json;

// tinygltf 2.7 refuses index accessors without a buffer view, which the specification allows (zeros, usually
// with sparse values). They get a buffer view that does not exist, and lose it again after the parse.
int lend_buffer_view(json& root, std::vector<std::size_t>& borrowers) {
    if (!root.contains("accessors") || !root.contains("meshes")) return -1;
    json& views = root["bufferViews"];
    const auto lent = views.size();
    for (const json& mesh : root["meshes"])
        for (const json& primitive : mesh.at("primitives"))
            if (const auto indices = primitive.find("indices"); indices != primitive.end()) {
                const auto index = indices->get<std::size_t>();
                json& accessor = root["accessors"][index];
                if (accessor.contains("bufferView")) continue;
                accessor["bufferView"] = lent;
                borrowers.push_back(index);
            }
    views.push_back({{"buffer", 0}, {"byteLength", 1}});
    return static_cast<int>(lent);
}

} // namespace

std::shared_ptr<tinygltf::Model> parse_geometry(const json& root, const std::string& name) {
    json geometry{{"asset", {{"version", "2.0"}}}};
    for (const char* list : {"accessors", "bufferViews", "meshes"})
        if (root.contains(list)) geometry[list] = root[list];
    std::vector<std::size_t> borrowers;
    const int lent = lend_buffer_view(geometry, borrowers);
    const std::string text = geometry.dump();

    tinygltf::TinyGLTF loader;
    const auto model = std::make_shared<tinygltf::Model>();
    std::string errors;
    std::string warnings;
    if (!loader.LoadASCIIFromString(model.get(), &errors, &warnings, text.data(),
                                    static_cast<unsigned>(text.size()), "", tinygltf::NO_REQUIRE)) {
        std::replace(errors.begin(), errors.end(), '\n', ' ');
        throw Error({name}, "this is not valid glTF (" + errors + ")",
                    "correct it, or export the file again");
    }
    for (const std::size_t borrower : borrowers) model->accessors[borrower].bufferView = -1;
    if (lent >= 0) model->bufferViews.pop_back();
    return model;
}

std::string base64(Bytes bytes) {
    require(bytes.size() <= std::numeric_limits<unsigned>::max(), "tinygltf counts the bytes in 32 bits");
    return tinygltf::base64_encode(bytes.data(), static_cast<unsigned>(bytes.size()));
}

} // namespace sr::gltf
