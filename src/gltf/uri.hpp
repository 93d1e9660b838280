#pragma once
// What a glTF's `uri` stands for: bytes within the URI itself (RFC 2397), or a file beside the glTF.
#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace sr::gltf {

/// Where a URI stands, for errors.
struct UriPlace {
    std::string file;    // the glTF
    std::string pointer; // "/buffers/0/uri"
};

/// The bytes of a data URI (base64 or percent-encoded), or of the file that a relative URI names in `folder`.
/// Percent-encoding is undone. A URI that leaves the folder or names a network address is refused; a symbolic
/// link inside the folder is the user's own doing and is followed.
/// @throws Error
std::vector<std::uint8_t> read_uri(std::string_view uri, const std::filesystem::path& folder,
                                   const UriPlace& place);

} // namespace sr::gltf
