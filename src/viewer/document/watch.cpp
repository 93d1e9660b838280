#include "viewer/document/watch.hpp"

namespace sr::viewer {

namespace fs = std::filesystem;

void Watch::set(std::vector<fs::path> places) {
    places_ = std::move(places);
    seen_ = look();
}

Watch::Stamps Watch::look() const {
    Stamps stamps;
    const auto stamp = [&](const fs::path& file, bool is_folder) {
        std::error_code ignored;
        const fs::file_status own = fs::symlink_status(file, ignored);
        if (!fs::exists(own)) return;
        Stamp now{{}, 0, own.type(), fs::status(file, ignored).permissions()};
        if (!is_folder) now.time = fs::last_write_time(file, ignored);
        if (!is_folder) now.size = fs::file_size(file, ignored);
        stamps.emplace(file, now);
    };
    for (const fs::path& place : places_) {
        std::error_code failure;
        const bool is_folder = fs::is_directory(place, failure);
        stamp(place, is_folder);
        if (!is_folder) continue;
        fs::recursive_directory_iterator entry(place, fs::directory_options::skip_permission_denied, failure);
        for (; !failure && entry != fs::recursive_directory_iterator(); entry.increment(failure))
            if (entry->is_regular_file(failure)) stamp(entry->path(), false);
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

} // namespace sr::viewer
