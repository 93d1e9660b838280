#include "viewer/document/watch.hpp"

namespace sr::viewer {

namespace fs = std::filesystem;

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

} // namespace sr::viewer
