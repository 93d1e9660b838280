#include "viewer/document/bookmarks.hpp"

#include "core/error.hpp"
#include "core/file.hpp"
#include "viewer/config.hpp"

#include <algorithm>
#include <fmt/format.h>
#include <nlohmann/json.hpp>
#include <utility>

namespace sr::viewer {
namespace {

using nlohmann::ordered_json;

constexpr std::size_t max_files = 200; // that have bookmarks; the oldest goes

/// The bookmarks of all files; an empty object if there are none.
ordered_json read(const std::filesystem::path& store) {
    try {
        ordered_json all = ordered_json::parse(read_text(store));
        if (all.is_object()) return all;
    } catch (const Error&) {                     // there are none yet
    } catch (const nlohmann::json::exception&) { // somebody broke the file
    }
    return ordered_json::object();
}

} // namespace

Bookmarks::Bookmarks(const std::string& scene_file, std::filesystem::path store)
    : scene_file_(scene_file), store_(std::move(store)) {
    std::error_code ignored;
    key_ = std::filesystem::absolute(scene_file, ignored).lexically_normal().string();
    if (store_.empty() && !state_folder().empty()) store_ = state_folder() / "bookmarks.json";
    const ordered_json everything = read(store_);
    if (!everything.contains(key_) || !everything[key_].is_array()) return;
    for (const ordered_json& view : everything[key_])
        if (view.is_object() && view.contains("name") && view["name"].is_string() && view.contains("view")
            && view["view"].is_string())
            all_.push_back({view["name"], view["view"]});
}

const std::string& Bookmarks::keep(const std::string& look_at) {
    const auto name = [](std::size_t number) { return fmt::format("view {}", number); };
    std::size_t number = 1;
    while (std::ranges::find(all_, name(number), &Bookmark::name) != all_.end()) ++number;
    all_.push_back({name(number), look_at});
    write();
    return all_.back().name;
}

void Bookmarks::remove(std::size_t index) {
    all_.erase(all_.begin() + static_cast<std::ptrdiff_t>(index));
    write();
}

/// Reads the others again first: another window may have kept some.
void Bookmarks::write() {
    ordered_json everything = read(store_);
    everything.erase(key_);
    while (everything.size() >= max_files) everything.erase(everything.begin());
    ordered_json mine = ordered_json::array();
    for (const Bookmark& bookmark : all_)
        mine.push_back({{"name", bookmark.name}, {"view", bookmark.look_at}});
    if (!mine.empty()) everything[key_] = mine;
    is_stored_ =
        write_lines(store_, {everything.dump(1, ' ', false, ordered_json::error_handler_t::replace)});
}

} // namespace sr::viewer
