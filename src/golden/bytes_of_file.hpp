#pragma once
// Whole files in and out.
#include <filesystem>
#include <string>
#include <string_view>

namespace sr::golden {

/// @throws Error if the file is missing or cannot be read.
std::string bytes_of_file(const std::filesystem::path& file);

/// Writes a file whole or not at all. @throws Error with the cause.
void write_text(const std::filesystem::path& file, std::string_view text);

} // namespace sr::golden
