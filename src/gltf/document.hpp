#pragma once
// A glTF file and everything it refers to, checked and in memory, before anything is made of it.
#include "core/limits.hpp"
#include "gltf/container.hpp"
#include "gltf/source_file.hpp"
#include "gltf/warnings.hpp"

#include <filesystem>
#include <glm/vec3.hpp>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

namespace tinygltf {
class Model;
}

namespace sr::gltf {

using nlohmann::json;

/// The remedy for most broken files.
inline constexpr const char* export_again = "export the file again";

/// The bytes of an entry of the JSON's `buffers`.
struct BufferSource {
    std::optional<Bytes> bytes; // absent: the file says of what size, but not where
    std::optional<Error> fault; // why they could not be read; code that needs them throws it
};

/// An entry of the JSON's `images`: bytes in a buffer view or behind a URI.
struct ImageSource {
    std::string name;
    std::string uri;
    int buffer_view = -1;
};

/// An entry of the JSON's `skins`.
struct SkinSource {
    std::string name;
    std::vector<int> joints;        // nodes
    int inverse_bind_matrices = -1; // an accessor; negative: none
};

/// An entry of the JSON's `animations`.
struct AnimationSource {
    struct Sampler {
        int input = -1;  // an accessor; negative: the sampler is lost
        int output = -1; // an accessor
        std::string interpolation;
    };
    struct Channel {
        std::size_t sampler = 0; // perhaps out of range
        std::string pointer;     // to the property it moves; empty: it moves nothing
    };

    std::string name;
    std::vector<Sampler> samplers;
    std::vector<Channel> channels;
};

struct Document {
    std::string name; // what errors call the file
    std::filesystem::path folder;
    /// The checked JSON (schema.hpp), in which animations set numbers. It lacks what the members below have.
    json root;
    std::shared_ptr<tinygltf::Model> model; // accessors, buffer views and meshes (gltf/tinygltf.hpp)
    std::vector<BufferSource> buffers;
    std::vector<ImageSource> images;
    std::vector<SkinSource> skins;
    std::vector<AnimationSource> animations;
    std::vector<std::string> extensions_used;
    std::vector<std::string> extensions_required;
    /// JSON pointers of the things that were broken and were warned of: they are absent, or have a stand-in.
    std::set<std::string> lost;
    SourceFile source;                  // what was read
    std::vector<SharedBytes> storage;   // what `buffers` look into, besides
    std::unique_ptr<Tally> values_read; // from accessors, which may share their bytes

    /// The bytes of a buffer view. `pointer` ("/images/0") says in errors who wants them.
    /// @throws Error if it reaches beyond its buffer, or its buffer has no bytes
    Bytes view(int buffer_view, std::string_view pointer) const;

    /// Keeps the bytes as another buffer. @return its index
    int add_buffer(std::vector<std::uint8_t> bytes);

    /// An entry of one of the JSON's lists, such as "nodes".
    const json& entry(const char* list, int index) const {
        return root.at(list).at(static_cast<std::size_t>(index));
    }
    /// The number of entries of one of the JSON's lists; 0 where it is absent.
    std::size_t count(const char* list) const;

    bool is_lost(const std::string& pointer) const { return lost.contains(pointer); }
    /// Returns whether it or anything in it is lost.
    bool has_lost(const std::string& pointer) const {
        const auto first = lost.lower_bound(pointer + "/");
        return is_lost(pointer) || (first != lost.end() && first->starts_with(pointer + "/"));
    }

    [[noreturn]] void fail(std::string_view what, std::string_view what_to_do) const;
};

// Values of checked objects. What is absent has the fallback.
double number_in(const json& object, std::string_view key, double fallback);
int integer_in(const json& object, std::string_view key, int fallback);
bool flag_in(const json& object, std::string_view key, bool fallback);
inline bool flag_in(const json* object, std::string_view key, bool fallback) {
    return object ? flag_in(*object, key, fallback) : fallback;
}
std::string text_in(const json& object, std::string_view key);
/// The numbers of an array; empty where it is absent.
std::vector<double> numbers_in(const json& object, std::string_view key);
glm::dvec3 three_in(const json& object, std::string_view key, glm::dvec3 fallback);
/// The object of an extension of a glTF object; null where it is absent.
const json* extension(const json& object, std::string_view name);
/// The object `steradian` in a glTF object's extras; null where it is absent.
const json* steradian_in(const json& object);

/// Parses and checks a .gltf or .glb and reads its buffers; images are read when they are decoded
/// (texture.hpp).
/// @throws Error
Document read_document(const SourceFile& source, Warnings& warnings);

} // namespace sr::gltf
