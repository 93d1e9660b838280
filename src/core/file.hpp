#pragma once
// Files that are read whole, and a folder for temporary ones. Only regular files are read: a FIFO or a device
// may block for ever or never end.
#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace sr {

/// The bytes of a regular file. `name` is what errors call it, followed by `problem_prefix` where the caller
/// needs context.
/// @throws Error if it is missing, no regular file, unreadable, or larger than the limit file-bytes
std::vector<std::uint8_t> read_file(const std::filesystem::path& file, const std::string& name,
                                    const std::string& problem_prefix = "");

/// The same as text. Errors call it as it is named.
std::string read_text(const std::filesystem::path& file);

/// @throws Error as read_file() does, for a file that a library will open by its path
void require_regular_file(const std::filesystem::path& file);

/// A folder for temporary files, for this user alone. It is removed with everything in it.
class ScratchFolder {
public:
    /// @param name part of the folder's name
    /// @throws Error if it cannot be made
    explicit ScratchFolder(std::string_view name);
    ~ScratchFolder();
    ScratchFolder(const ScratchFolder&) = delete;
    ScratchFolder& operator=(const ScratchFolder&) = delete;

    const std::filesystem::path& path() const { return path_; }

private:
    std::filesystem::path path_;
};

} // namespace sr
