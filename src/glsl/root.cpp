#include "glsl/root.hpp"

#include "core/error.hpp"
#include "core/file.hpp"
#include "glsl/untrusted.hpp"

#include <algorithm>
#include <cstdint>
#include <fmt/format.h>
#include <numeric>
#include <string_view>
#include <utility>
#include <vector>

namespace sr::glsl {

namespace fs = std::filesystem;

Root::Root(std::string label, Place place) : label_(std::move(label)), place_(std::move(place)) {}

Root Root::folder(const fs::path& folder) {
    std::error_code ignored;
    if (!fs::is_directory(folder, ignored))
        throw Error({folder.string()}, "no such folder of shaders", "name a folder that lies like shaders/");
    return {folder.string(), folder};
}

Root Root::memory(std::string label, Files files) {
    return {std::move(label), std::make_shared<const Files>(std::move(files))};
}

Root Root::single(std::string place, std::string name, std::string text) {
    Root root = memory(std::move(place), {{std::move(name), std::move(text)}});
    root.is_single_ = true;
    return root;
}

Root Root::untrusted(std::vector<std::string> permitted) const {
    Root root = *this;
    root.permitted_ = std::move(permitted);
    return root;
}

namespace {

/// @throws Error for a file of an untrusted folder that is reached by a link, is no regular file or too large
void require_own_file(const fs::path& folder, std::string_view name) {
    std::error_code ignored;
    fs::path file = folder;
    for (const fs::path& part : fs::path(name)) {
        file /= part;
        if (fs::is_symlink(fs::symlink_status(file, ignored)))
            throw Error({file.string()}, "a link", "put the file itself there");
    }
    if (fs::exists(file, ignored) && !fs::is_regular_file(file, ignored))
        throw Error({file.string()}, "no regular file", "put a file there");
    if (fs::is_regular_file(file, ignored) && fs::file_size(file, ignored) > max_untrusted_bytes)
        throw Error({file.string()}, "larger than 256 KiB", "write less");
}

} // namespace

const Files* Root::in_memory() const {
    const auto* files = std::get_if<std::shared_ptr<const Files>>(&place_);
    return files ? files->get() : nullptr;
}

std::optional<std::string> Root::text_of(std::string_view name) const {
    if (is_untrusted() && !name.ends_with(".glsl")) return std::nullopt;
    if (const Files* files = in_memory()) {
        const auto found = files->find(name);
        return found == files->end() ? std::nullopt : std::optional(found->second);
    }
    const fs::path file = std::get<fs::path>(place_) / name;
    std::error_code ignored;
    if (is_untrusted()) require_own_file(std::get<fs::path>(place_), name);
    // A link that leads nowhere, or a folder that may not be read, is no absence: reading says what is wrong.
    const fs::file_type type = fs::status(file, ignored).type();
    const bool is_link = fs::is_symlink(fs::symlink_status(file, ignored));
    if (type == fs::file_type::not_found && !is_link) return std::nullopt;
    return read_text(file);
}

std::vector<std::string> Root::names() const {
    std::vector<std::string> names;
    if (const Files* files = in_memory())
        for (const auto& [name, text] : *files) names.push_back(name);
    return names;
}

std::string Root::place_of(std::string_view name) const {
    if (const fs::path* folder = std::get_if<fs::path>(&place_)) return (*folder / name).string();
    return is_single_ ? label_ : fmt::format("{}/{}", label_, name);
}

namespace {

/// The number of characters to insert, remove or replace (Wagner & Fischer 1974).
std::size_t edit_distance(std::string_view a, std::string_view b) {
    std::vector<std::size_t> row(b.size() + 1);
    std::iota(row.begin(), row.end(), std::size_t{0});
    for (std::size_t i = 0; i < a.size(); ++i) {
        std::size_t diagonal = std::exchange(row[0], i + 1);
        for (std::size_t j = 0; j < b.size(); ++j) {
            const std::size_t replaced = diagonal + (a[i] != b[j]);
            diagonal = std::exchange(row[j + 1], std::min({row[j] + 1, row[j + 1] + 1, replaced}));
        }
    }
    return row.back();
}

std::string_view last_part(std::string_view name) { return name.substr(name.rfind('/') + 1); }

/// A file in the wrong folder is nearer than one with another name.
std::size_t distance(std::string_view name, std::string_view ours) {
    return std::min(edit_distance(name, ours), 2 * edit_distance(last_part(name), last_part(ours)) + 1);
}

/// Some names below a folder, relative to it.
std::vector<std::string> names_in(const fs::path& folder) {
    constexpr std::size_t max_names = 1000, max_length = 200;
    std::vector<std::string> names;
    std::error_code failure;
    fs::recursive_directory_iterator entry(folder, fs::directory_options::skip_permission_denied, failure),
        end;
    for (; !failure && entry != end && names.size() < max_names; entry.increment(failure)) {
        std::error_code ignored;
        if (entry->is_directory(ignored)) continue;
        std::string name = entry->path().lexically_relative(folder).generic_string();
        if (name.size() < max_length) names.push_back(std::move(name));
    }
    return names;
}

/// Returns whether a file in another of the folders includes one of these files of `folder`.
bool is_included(const fs::path& folder, const std::vector<std::string>& names,
                 const std::vector<std::string>& all) {
    constexpr std::uintmax_t max_bytes = 1 << 20;
    for (const std::string& other : all) {
        if (fs::path(other) == folder) continue;
        for (const std::string& includer : names_in(other)) {
            const fs::path file = fs::path(other) / includer;
            std::error_code failure;
            if (!fs::is_regular_file(file, failure) || fs::file_size(file, failure) > max_bytes) continue;
            const std::string text = read_text(file);
            if (std::ranges::any_of(names, [&](const std::string& name) {
                    return text.find('"' + name + '"') != std::string::npos;
                }))
                return true;
        }
    }
    return false;
}

} // namespace

std::optional<std::string> remark_on_overlay(const fs::path& folder, const Root& ours,
                                             const std::vector<std::string>& all) {
    const std::vector<std::string> known = ours.names();
    std::error_code ignored;
    for (const std::string& name : known)
        if (fs::symlink_status(folder / name, ignored).type() != fs::file_type::not_found)
            return std::nullopt;
    const std::vector<std::string> names = names_in(folder);
    if (names.empty())
        return fmt::format(
            "{}: the folder holds no files, so no shader is replaced: a file brdf/f_r.glsl in it "
            "would replace the BRDF",
            folder.string());
    if (is_included(folder, names, all)) return std::nullopt;
    std::size_t least = std::string::npos;
    const std::string *nearest = nullptr, *meant = nullptr;
    for (const std::string& name : names)
        for (const std::string& our : known)
            if (const std::size_t d = distance(name, our); d < least) {
                least = d;
                nearest = &name;
                meant = &our;
            }
    return fmt::format("{}: no file in it has the name of a built-in shader, so none is replaced: rename {} "
                       "if {} is meant",
                       folder.string(), *nearest, *meant);
}

} // namespace sr::glsl
