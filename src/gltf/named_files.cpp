#include "gltf/named_files.hpp"

#include "core/error.hpp"
#include "core/file.hpp"
#include "gltf/json.hpp"
#include "gltf/uri.hpp"

namespace sr::gltf {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;

void collect(const json& value, const fs::path& folder, std::vector<fs::path>& files) {
    if (value.is_object())
        for (const char* key : {"uri", "file"}) // "file": extras.steradian of a material
            if (const auto uri = value.find(key); uri != value.end() && uri->is_string())
                for (fs::path& file : files_named(uri->get_ref<const std::string&>(), folder))
                    files.push_back(std::move(file));
    if (value.is_structured())
        for (const json& part : value) collect(part, folder, files);
}

} // namespace

std::vector<fs::path> named_files(const fs::path& file) {
    std::vector<fs::path> files;
    try {
        const std::vector<std::uint8_t> bytes = read_file(file, file.string());
        collect(parse(split(bytes, file.string()), file.string()), file.parent_path(), files);
    } catch (const Error&) {
        return {};
    }
    return files;
}

} // namespace sr::gltf
