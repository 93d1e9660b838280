#pragma once
// The target of a glTF's `uri`: bytes within the URI itself (RFC 2397), or a file beside the glTF.
#include <cstdint>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>
#include <string_view>
#include <vector>

namespace sr::gltf {

/// Where a URI stands, for errors.
struct UriPlace {
    std::string file;    // the glTF
    std::string pointer; // "/buffers/0/uri"
};

/// Returns whether the scheme is "data", in any case (RFC 3986, section 3.1).
bool is_data_uri(std::string_view uri);

/// The files in `folder` that a relative URI may name: as RFC 3986 reads it first (percent-encoding undone,
/// dot segments removed, without query and fragment), then as exporters write it that do not encode ? # %,
/// and with backslashes for slashes. None for a URI with a scheme. What would leave the folder is not among
/// them.
std::vector<std::filesystem::path> candidate_files(std::string_view uri, const std::filesystem::path& folder);

/// The file in `folder` that a relative URI names: the first of candidate_files() that is there, else the
/// first of them. A URI that leaves the folder or names a network address is refused, and so is a symbolic
/// link that leads out of the folder; one within it is followed.
/// @throws Error
std::filesystem::path resolve_file(std::string_view uri, const std::filesystem::path& folder,
                                   const UriPlace& place);

/// The bytes of a data URI (base64 or percent-encoded), or of resolve_file() a relative one.
/// @throws Error
std::vector<std::uint8_t> read_uri(std::string_view uri, const std::filesystem::path& folder,
                                   const UriPlace& place);

/// The files in `folder` that the URIs of a glTF's JSON may name, whether or not they are there: buffers,
/// images, IES profiles, environments, measured BRDFs.
std::vector<std::filesystem::path> named_files(const nlohmann::json& root,
                                               const std::filesystem::path& folder);

} // namespace sr::gltf
