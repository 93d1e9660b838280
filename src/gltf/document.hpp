#pragma once
// A glTF file and everything it refers to, checked and in memory, before anything is made of it.
#include "gltf/bytes.hpp"
#include "gltf/tinygltf.hpp"

#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace sr::gltf {

/// An entry of the JSON's `images`: bytes in a buffer view or behind a URI.
struct ImageSource {
    std::string name;
    std::string uri;
    int buffer_view = -1;
};

struct Document {
    std::string name; // what errors call the file
    std::filesystem::path folder;
    /// Every index in it is in range (schema.hpp). Its own buffers and images are empty: they are here.
    tinygltf::Model model;
    std::vector<std::optional<Bytes>> buffers; // absent: the file says of what size, but not where
    std::vector<ImageSource> images;
    std::size_t animation_count = 0;                                       // nothing more of them is read yet
    std::vector<std::unique_ptr<const std::vector<std::uint8_t>>> storage; // what `buffers` look into

    /// The bytes of a buffer view. `pointer` ("/images/0") says in errors who wants them.
    /// @throws Error if it reaches beyond its buffer, or its buffer has no bytes
    Bytes view(int buffer_view, std::string_view pointer) const;

    [[noreturn]] void fail(std::string_view what, std::string_view what_to_do) const;
};

/// Reads, parses and checks a .gltf or .glb and its buffers; images are read when they are decoded
/// (texture.hpp).
/// @throws Error
Document read_document(const std::filesystem::path& file);

} // namespace sr::gltf
