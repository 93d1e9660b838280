#pragma once
// A glTF file and its buffers as they were read. Copies with edits are made of these bytes: another program
// may change, move or remove the file while it is shown.
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <map>
#include <memory>
#include <optional>
#include <vector>

namespace sr::gltf {

using SharedBytes = std::shared_ptr<const std::vector<std::uint8_t>>;

/// Time and size of a file, by which a change is noticed.
struct FileStamp {
    std::filesystem::file_time_type time{};
    std::uintmax_t size = 0;

    bool operator==(const FileStamp&) const = default;
};

/// Returns the stamp of a file as it is now; absent if it is not there.
std::optional<FileStamp> stamp_of(const std::filesystem::path& file);

/// A file beside the glTF that a URI may name, as it was when the glTF was read.
struct NamedFile {
    std::optional<FileStamp> stamp; // absent: it was not there
    SharedBytes bytes{};            // of a buffer; null: it is another file, or was not there
};

struct SourceFile {
    std::filesystem::path path;
    SharedBytes bytes; // of the .gltf or .glb; null: nothing was read
    std::optional<FileStamp> stamp;
    std::size_t json_hash = 0;                          // tells files with other nodes or materials apart
    std::map<std::filesystem::path, NamedFile> named{}; // what its URIs may name, there or not (uri.hpp)

    /// True if the file is there as it was read.
    bool is_unchanged() const { return stamp && stamp_of(path) == stamp; }
};

/// Reads the bytes of a .gltf or .glb; the members that its JSON tells are empty yet. @throws Error as
/// read_file() does
SourceFile read_source(const std::filesystem::path& file);

} // namespace sr::gltf
