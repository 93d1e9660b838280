#include "gltf/source_file.hpp"

#include "core/file.hpp"

#include <system_error>
#include <utility>

namespace sr::gltf {

namespace fs = std::filesystem;

std::optional<FileStamp> stamp_of(const fs::path& file) {
    std::error_code failure, other;
    const FileStamp stamp{fs::last_write_time(file, failure), fs::file_size(file, other)};
    return failure || other ? std::nullopt : std::optional(stamp);
}

SourceFile read_source(const fs::path& file) {
    SourceFile source;
    source.path = file;
    source.stamp = stamp_of(file); // before it is read, so that a change while it is read is noticed
    source.bytes = std::make_shared<const std::vector<std::uint8_t>>(read_file(file, file.string()));
    return source;
}

} // namespace sr::gltf
