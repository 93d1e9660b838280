#include "glsl/root.hpp"

#include "core/error.hpp"
#include "core/file.hpp"

#include <fmt/format.h>

namespace sr::glsl {

namespace fs = std::filesystem;

Root::Root(std::string label, std::variant<fs::path, Files> place)
    : label_(std::move(label)), place_(std::move(place)) {}

Root Root::folder(const fs::path& folder) {
    std::error_code ignored;
    if (!fs::is_directory(folder, ignored))
        throw Error({folder.string()}, "no such folder of shaders", "name a folder that lies like shaders/");
    return {folder.string(), folder};
}

Root Root::memory(std::string label, Files files) { return {std::move(label), std::move(files)}; }

Root Root::single(std::string place, std::string name, std::string text) {
    Root root = memory(std::move(place), {{std::move(name), std::move(text)}});
    root.is_single_ = true;
    return root;
}

std::optional<std::string> Root::text_of(std::string_view name) const {
    if (const Files* files = std::get_if<Files>(&place_)) {
        const auto found = files->find(name);
        return found == files->end() ? std::nullopt : std::optional(found->second);
    }
    const fs::path file = std::get<fs::path>(place_) / name;
    std::error_code ignored;
    // A link that leads nowhere, or a folder that may not be read, is no absence: reading says what is wrong.
    const fs::file_type type = fs::status(file, ignored).type();
    const bool is_link = fs::is_symlink(fs::symlink_status(file, ignored));
    if (type == fs::file_type::not_found && !is_link) return std::nullopt;
    return read_text(file);
}

std::vector<std::string> Root::names() const {
    std::vector<std::string> names;
    if (const Files* files = std::get_if<Files>(&place_))
        for (const auto& [name, text] : *files) names.push_back(name);
    return names;
}

std::string Root::place_of(std::string_view name) const {
    if (const fs::path* folder = std::get_if<fs::path>(&place_)) return (*folder / name).string();
    return is_single_ ? label_ : fmt::format("{}/{}", label_, name);
}

} // namespace sr::glsl
