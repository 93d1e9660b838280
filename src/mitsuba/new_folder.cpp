#include "mitsuba/new_folder.hpp"

#include "core/error.hpp"

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstring>
#include <fmt/format.h>
#include <fstream>
#include <random>

namespace sr::mitsuba {
namespace {

namespace fs = std::filesystem;

/// Files of an export in its folder, and Python's cache.
constexpr std::array<std::string_view, 9> own_names{
    "scene.xml", "README.md", "render.py", "steradian_mitsuba", "steradian_mitsuba.py",
    "meshes",    "textures",  "measured",  "__pycache__"};

void require_own(const fs::path& place) {
    std::error_code failure;
    if (!fs::exists(place, failure)) return;
    if (!fs::is_directory(place, failure))
        throw Error({place.string()}, "this is a file", "name a folder that is new or empty");
    for (const fs::directory_entry& entry : fs::directory_iterator(place, failure)) {
        const std::string name = entry.path().filename().string();
        if (std::ranges::find(own_names, name) == own_names.end())
            throw Error({place.string()}, fmt::format("this folder holds {}, which no export wrote", name),
                        "name a folder that is new or empty");
    }
    if (failure) throw Error({place.string()}, "cannot be read: " + failure.message(), "name another folder");
}

fs::path beside(const fs::path& place) {
    std::random_device random;
    return place.parent_path() / fmt::format(".steradian-{:08x}{:08x}.tmp", random(), random());
}

} // namespace

void write_text(const fs::path& file, std::string_view text) {
    std::ofstream stream(file, std::ios::binary);
    stream.write(text.data(), static_cast<std::streamsize>(text.size()));
    stream.close();
    if (!stream)
        throw Error({file.string()}, fmt::format("cannot be written ({})", std::strerror(errno)),
                    "free some space, or write to another place");
}

void make_folder(const fs::path& folder) {
    std::error_code failure;
    fs::create_directory(folder, failure);
    if (failure)
        throw Error({folder.string()}, fmt::format("cannot be made ({})", failure.message()),
                    "name a folder whose parent exists and is yours");
}

NewFolder::NewFolder(fs::path place) : place_(std::move(place)) {
    if (!place_.has_filename()) place_ = place_.parent_path(); // "folder/"
    require_own(place_);
    temporary_ = beside(place_);
    make_folder(temporary_);
}

NewFolder::~NewFolder() {
    std::error_code ignored;
    if (!temporary_.empty()) fs::remove_all(temporary_, ignored);
}

void NewFolder::put_in_place() {
    std::error_code failure;
    fs::path old;
    if (fs::exists(place_, failure)) {
        old = beside(place_);
        fs::rename(place_, old, failure);
    }
    if (!failure) fs::rename(temporary_, place_, failure);
    if (failure)
        throw Error({place_.string()}, fmt::format("cannot be replaced ({})", failure.message()),
                    "name another folder");
    temporary_ = old; // to be removed
}

} // namespace sr::mitsuba
