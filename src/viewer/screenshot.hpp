#pragma once
// Pictures of the picture, in files.
#include "image/file.hpp"

#include <string>

namespace sr::viewer {

/// "STEM-001.EXT" in the working directory, or the first number after that is free there.
std::string free_name(const std::string& scene_file, const std::string& extension);

} // namespace sr::viewer
