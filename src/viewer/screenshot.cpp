#include "viewer/screenshot.hpp"

#include <filesystem>
#include <fmt/format.h>

namespace sr::viewer {

std::string free_name(const std::string& scene_file, const std::string& extension) {
    const std::string stem = std::filesystem::path(scene_file).stem().string();
    for (int number = 1;; ++number) {
        std::string name = fmt::format("{}-{:03}{}", stem, number, extension);
        std::error_code ignored;
        if (!std::filesystem::exists(name, ignored)) return name;
    }
}

} // namespace sr::viewer
