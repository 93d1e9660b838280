#include "golden/bytes_of_file.hpp"

#include "core/error.hpp"
#include "image/whole_file.hpp"

#include <fstream>
#include <sstream>

namespace sr::golden {

namespace fs = std::filesystem;

std::string bytes_of_file(const fs::path& file) {
    std::error_code ignored;
    if (!fs::exists(file, ignored)) throw Error({file.string()}, "no such file", "check the path");
    std::ifstream stream(file, std::ios::binary);
    std::ostringstream text;
    if (fs::is_directory(file, ignored) || !stream)
        throw Error({file.string()}, "not a readable file", "check its permissions");
    text << stream.rdbuf();
    return text.str();
}

void write_text(const fs::path& file, std::string_view text) {
    image::write_whole(file, {reinterpret_cast<const std::uint8_t*>(text.data()), text.size()});
}

} // namespace sr::golden
