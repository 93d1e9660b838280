#pragma once
// Files that are written whole or not at all.
#include "image/file.hpp"

#include <cstdint>
#include <filesystem>
#include <memory>
#include <span>
#include <string_view>
#include <vector>

namespace sr::image {

/// Several files, all of which are written or none. Each is a temporary file beside its target until
/// put_in_place() renames it; what was not put in place is removed. A file that was there before keeps its
/// mode, and a symbolic link stays and leads to the new file.
class WholeFiles {
public:
    WholeFiles();
    ~WholeFiles();
    WholeFiles(const WholeFiles&) = delete;
    WholeFiles& operator=(const WholeFiles&) = delete;

    /// @throws Error that names the cause: folder missing, no permission, disk full, …
    void add(const std::filesystem::path& file, std::span<const std::uint8_t> bytes);
    /// The same for an image, as write() has it.
    void add(const Image& image, const std::filesystem::path& file, SampleType type);

    /// Makes an empty temporary file for `file`, which another program writes. @return its path; @throws
    /// Error
    std::filesystem::path reserve(const std::filesystem::path& file);

    /// @throws Error if a file cannot be renamed; those before it are in place then
    void put_in_place();

private:
    class Temporary;

    std::vector<std::unique_ptr<Temporary>> temporaries_;
};

/// One file as WholeFiles writes it. @throws Error
void write_whole(const std::filesystem::path& file, std::span<const std::uint8_t> bytes);

/// The same for text. @throws Error
void write_text(const std::filesystem::path& file, std::string_view text);

/// @throws Error if it can be seen already that `file` cannot be written: a missing folder, a folder or a
/// device in its place, no permission. Nothing is written.
void require_writable(const std::filesystem::path& file);

} // namespace sr::image
