#pragma once
// Small glTF files made within a test: JSON in hand, numbers appended to one buffer.
#include <cstdint>
#include <cstring>
#include <filesystem>
#include <map>
#include <nlohmann/json.hpp>
#include <string>
#include <string_view>
#include <vector>

namespace sr::testing {

using nlohmann::json;

std::string base64(const std::vector<std::uint8_t>& bytes);

/// A one-pixel PNG as a data URI.
std::string png_uri();

class MadeGltf {
public:
    /// A file with an asset and nothing else.
    MadeGltf();
    /// One triangle (0,0,0) (1,0,0) (0,1,0) of mesh 0 at node 0; no normals, no indices, no material.
    static MadeGltf triangle();

    /// Appends the numbers to the buffer, a bufferView and an accessor for them. @return the accessor's index
    template<typename T>
    int accessor(const std::vector<T>& numbers, const std::string& type, int component_type) {
        const int view = this->view(numbers.data(), numbers.size() * sizeof(T));
        static const std::map<std::string, std::size_t> components{
            {"SCALAR", 1}, {"VEC2", 2}, {"VEC3", 3}, {"VEC4", 4}, {"MAT4", 16}};
        root["accessors"].push_back({{"bufferView", view},
                                     {"componentType", component_type},
                                     {"count", numbers.size() / components.at(type)},
                                     {"type", type}});
        return static_cast<int>(root["accessors"].size()) - 1;
    }
    int floats(const std::vector<float>& numbers, const std::string& type) {
        return accessor(numbers, type, 5126);
    }
    int shorts(const std::vector<std::uint16_t>& numbers, const std::string& type = "SCALAR") {
        return accessor(numbers, type, 5123);
    }

    json& primitive() { return root["meshes"][0]["primitives"][0]; }
    json& attributes() { return primitive()["attributes"]; }

    /// The JSON with its buffer as a data URI.
    std::string gltf() const;
    /// The same as a GLB.
    std::vector<std::uint8_t> glb() const;

    json root;
    std::vector<std::uint8_t> bytes;

private:
    int view(const void* data, std::size_t size);
};

void write_text(const std::filesystem::path& file, std::string_view text);
void write_bytes(const std::filesystem::path& file, const std::vector<std::uint8_t>& bytes);

} // namespace sr::testing
