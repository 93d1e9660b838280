#include "gltf/write/embedded_files.hpp"

#include "core/error.hpp"
#include "gltf/tinygltf.hpp"
#include "gltf/uri.hpp"

#include <algorithm>
#include <cctype>
#include <fmt/format.h>

namespace sr::gltf {
namespace {

namespace fs = std::filesystem;
using nlohmann::ordered_json;

std::string data_uri(std::string_view media_type, Bytes bytes) {
    return fmt::format("data:{};base64,{}", media_type, base64(bytes));
}

/// glTF 2.0, section 3.8.4: a reader may tell an image's format by its media type.
std::string_view media_type_of(const fs::path& file) {
    std::string extension = file.extension().string();
    std::ranges::transform(extension, extension.begin(), [](unsigned char c) { return std::tolower(c); });
    if (extension == ".png") return "image/png";
    if (extension == ".jpg" || extension == ".jpeg") return "image/jpeg";
    if (extension == ".webp") return "image/webp";
    if (extension == ".ktx2") return "image/ktx2";
    return "application/octet-stream";
}

/// The bytes of the buffer behind a URI as they were read, if its file has changed since or is gone; or null.
SharedBytes lost_bytes(const std::string& uri, const SourceFile& source) {
    for (const fs::path& file : candidate_files(uri, source.path.parent_path())) {
        const auto named = source.named.find(file);
        if (named != source.named.end() && named->second.bytes)
            return stamp_of(file) == named->second.stamp ? nullptr : named->second.bytes;
    }
    return nullptr;
}

class Embedding {
public:
    explicit Embedding(const fs::path& file) : file_(file) {}

    void embed(ordered_json& value, const std::string& pointer) const {
        if (value.is_object())
            if (const auto uri = value.find("uri"); uri != value.end() && uri->is_string())
                embed_uri(*uri, pointer + "/uri");
        if (!value.is_structured()) return;
        for (auto& [key, part] : value.items()) {
            if (key == "steradian" && part.is_object()) refuse_files_of(part, pointer + "/steradian");
            embed(part, pointer + "/" + key);
        }
    }

private:
    void embed_uri(ordered_json& uri, const std::string& pointer) const {
        const std::string& text = uri.get_ref<const std::string&>();
        if (is_data_uri(text)) return;
        const UriPlace place{file_.string(), pointer};
        std::vector<std::uint8_t> bytes;
        try {
            bytes = read_uri(text, file_.parent_path(), place);
        } catch (const Error&) {
            return; // the copy lacks what the file lacks, and says so when it is read
        }
        uri = data_uri(media_type_of(text), bytes);
    }

    /// "file" is a key of environments and of measured BRDFs.
    void refuse_files_of(const ordered_json& stated, const std::string& pointer) const {
        const auto check = [&](const ordered_json& object) {
            if (const auto named = object.find("file"); named != object.end() && named->is_string())
                throw Error({file_.string()},
                            fmt::format("{} names the file {}, which cannot be within a glTF", pointer,
                                        named->get<std::string>()),
                            "save the copy in the folder of the file");
        };
        check(stated);
        for (const auto& part : stated)
            if (part.is_object()) check(part);
    }

    fs::path file_;
};

} // namespace

void embed_files(ordered_json& gltf, const SourceFile& source) { Embedding(source.path).embed(gltf, ""); }

void embed_lost_buffers(ordered_json& gltf, const SourceFile& source) {
    if (!gltf.contains("buffers")) return;
    for (ordered_json& buffer : gltf["buffers"]) {
        const auto uri = buffer.find("uri");
        if (uri == buffer.end()) continue;
        if (const SharedBytes bytes = lost_bytes(uri->get_ref<const std::string&>(), source))
            *uri = data_uri("application/octet-stream", *bytes);
    }
}

void embed_buffer(ordered_json& gltf, Bytes buffer) {
    const auto buffers = gltf.find("buffers");
    if (buffers == gltf.end() || buffers->empty() || (*buffers)[0].contains("uri")) return;
    (*buffers)[0]["uri"] = data_uri("application/octet-stream", buffer);
}

} // namespace sr::gltf
