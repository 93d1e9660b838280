#pragma once
// A glTF file and everything it refers to, checked and in memory, before anything is made of it.
#include "core/limits.hpp"
#include "gltf/container.hpp"
#include "gltf/tinygltf.hpp"
#include "gltf/warnings.hpp"

#include <filesystem>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

namespace sr::gltf {

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
    /// Every index in it is in range (schema.hpp). Its own buffers and images are empty: they are here.
    tinygltf::Model model;
    std::vector<BufferSource> buffers;
    std::vector<ImageSource> images;
    std::vector<SkinSource> skins;
    std::vector<AnimationSource> animations;
    std::vector<std::string> extensions_required;
    /// JSON pointers of the things that were broken and were warned of: they are absent, or have a stand-in.
    std::set<std::string> lost;
    std::vector<std::unique_ptr<const std::vector<std::uint8_t>>> storage; // what `buffers` look into
    std::unique_ptr<Tally> values_read; // from accessors, which may share their bytes

    /// The bytes of a buffer view. `pointer` ("/images/0") says in errors who wants them.
    /// @throws Error if it reaches beyond its buffer, or its buffer has no bytes
    Bytes view(int buffer_view, std::string_view pointer) const;

    /// Keeps the bytes as another buffer. @return its index
    int add_buffer(std::vector<std::uint8_t> bytes);

    bool is_lost(const std::string& pointer) const { return lost.contains(pointer); }
    /// Returns whether it or anything in it is lost.
    bool has_lost(const std::string& pointer) const {
        const auto first = lost.lower_bound(pointer + "/");
        return is_lost(pointer) || (first != lost.end() && first->starts_with(pointer + "/"));
    }

    [[noreturn]] void fail(std::string_view what, std::string_view what_to_do) const;
};

/// Reads, parses and checks a .gltf or .glb and its buffers; images are read when they are decoded
/// (texture.hpp).
/// @throws Error
Document read_document(const std::filesystem::path& file, Warnings& warnings);

} // namespace sr::gltf
