#pragma once
// Files that are read whole. Only regular files are: a FIFO or a device may block for ever or never end.
#include <cstdint>
#include <filesystem>
#include <string>
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

} // namespace sr
