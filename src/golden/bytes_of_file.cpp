#include "golden/bytes_of_file.hpp"

#include "core/file.hpp"
#include "image/whole_file.hpp"

namespace sr::golden {

namespace fs = std::filesystem;

std::string bytes_of_file(const fs::path& file) { return read_text(file); }

void write_text(const fs::path& file, std::string_view text) {
    image::write_whole(file, {reinterpret_cast<const std::uint8_t*>(text.data()), text.size()});
}

} // namespace sr::golden
