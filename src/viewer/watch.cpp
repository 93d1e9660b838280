#include "viewer/watch.hpp"

#include "core/error.hpp"
#include "core/file.hpp"

#include <nlohmann/json.hpp>

namespace sr::viewer {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;

/// %20 and its like.
std::string unescaped(const std::string& uri) {
    std::string text;
    for (std::size_t i = 0; i < uri.size(); ++i) {
        if (uri[i] == '%' && i + 2 < uri.size()) {
            text += static_cast<char>(std::strtol(uri.substr(i + 1, 2).c_str(), nullptr, 16));
            i += 2;
        } else {
            text += uri[i];
        }
    }
    return text;
}

void collect(const json& value, const fs::path& folder, std::vector<fs::path>& files) {
    if (value.is_object()) {
        const auto uri = value.find("uri");
        if (uri != value.end() && uri->is_string()
            && !uri->get_ref<const std::string&>().starts_with("data:"))
            files.push_back(folder / unescaped(uri->get<std::string>()));
    }
    if (value.is_structured())
        for (const json& part : value) collect(part, folder, files);
}

/// The JSON of a .gltf, or the first chunk of a .glb (glTF 2.0, section 4.4).
/// The JSON of a .gltf or .glb; empty if the file cannot be read.
std::string json_of(const fs::path& file) {
    std::string text;
    try {
        text = read_text(file);
    } catch (const Error&) { // it will be read again, and then the user is told
        return {};
    }
    constexpr std::size_t head = 20; // of the GLB and of its first chunk
    if (text.size() < head || !text.starts_with("glTF")) return text;
    std::uint32_t length = 0;
    for (std::size_t i = 0; i < 4; ++i)
        length |= static_cast<std::uint32_t>(static_cast<unsigned char>(text[12 + i])) << (8 * i);
    return text.substr(head, length);
}

} // namespace

void Watch::set(std::vector<fs::path> places) {
    places_ = std::move(places);
    seen_ = look();
}

Watch::Stamps Watch::look() const {
    Stamps stamps;
    const auto stamp = [&](const fs::path& file) {
        std::error_code failure;
        const Stamp now{fs::last_write_time(file, failure), fs::file_size(file, failure)};
        if (!failure) stamps.emplace(file, now);
    };
    for (const fs::path& place : places_) {
        std::error_code failure;
        if (!fs::is_directory(place, failure)) {
            stamp(place);
            continue;
        }
        fs::recursive_directory_iterator entry(place, fs::directory_options::skip_permission_denied, failure);
        for (; !failure && entry != fs::recursive_directory_iterator(); entry.increment(failure))
            if (entry->is_regular_file(failure)) stamp(entry->path());
    }
    return stamps;
}

bool Watch::has_changed() {
    constexpr auto interval = std::chrono::milliseconds(200);
    const auto now = std::chrono::steady_clock::now();
    if (places_.empty() || now - looked_ < interval) return false;
    looked_ = now;
    Stamps stamps = look();
    if (stamps == seen_) return false;
    seen_ = std::move(stamps);
    return true;
}

std::vector<fs::path> files_of(const fs::path& gltf) {
    std::vector<fs::path> files;
    const json document = json::parse(json_of(gltf), nullptr, false);
    if (!document.is_discarded()) collect(document, gltf.parent_path(), files);
    return files;
}

} // namespace sr::viewer
