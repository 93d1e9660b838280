#pragma once
// A file that is written whole or not at all.
#include <cstdint>
#include <filesystem>
#include <span>

namespace sr::image {

/// Writes the bytes to a temporary file in the same folder, then renames it to `file`. Whatever fails, the
/// temporary is removed and a file that was there before is left as it was.
/// @throws Error that names the cause: folder missing, no permission, disk full, …
void write_whole(const std::filesystem::path& file, std::span<const std::uint8_t> bytes);

} // namespace sr::image
