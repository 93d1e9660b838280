#include "golden/init.hpp"

#include "core/error.hpp"
#include "golden/page.hpp"
#include "golden/templates.hpp"
#include "image/whole_file.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <fmt/format.h>
#include <nlohmann/json.hpp>
#include <set>
#include <span>

namespace sr::golden {
namespace {

namespace fs = std::filesystem;
using nlohmann::ordered_json;

constexpr std::array scene_formats{"gltf", "glb"};
constexpr std::array picture_formats{"exr", "hdr", "png", "jpg", "jpeg", "tif", "tiff"};

/// The extension in lower case, without the dot.
std::string format_of_name(const fs::path& file) {
    std::string extension = file.extension().string();
    if (!extension.empty()) extension.erase(0, 1);
    for (char& c : extension) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
    return extension;
}

bool has_format(const fs::path& file, std::span<const char* const> formats) {
    return std::ranges::find(formats, format_of_name(file)) != formats.end();
}

/// A file that becomes a test, and the folder that it was found in.
struct Source {
    fs::path file;
    fs::path folder;
};

/// True for a folder whose pictures are goldens or candidates: that of a suite, or of a run.
bool is_of_goldens(const fs::path& folder) {
    std::error_code ignored;
    const bool is_of_run =
        fs::exists(folder / "results.json", ignored) && fs::exists(folder / "candidates", ignored);
    return is_of_run
           || (folder.filename() == "goldens" && fs::exists(folder.parent_path() / "suite.json", ignored));
}

std::vector<Source> sources_in(const fs::path& place) {
    std::error_code failure;
    if (fs::is_regular_file(place, failure)) return {{place, place.parent_path()}};
    if (!fs::is_directory(place, failure))
        throw Error({place.string()}, "there is no such file or folder",
                    "name scenes, pictures or a folder of them");
    std::vector<Source> found;
    for (auto entry = fs::recursive_directory_iterator(place, failure); entry != fs::end(entry); ++entry) {
        if (entry->path().filename().string().starts_with('.') || is_of_goldens(entry->path())) {
            entry.disable_recursion_pending();
            continue;
        }
        if (entry->is_regular_file(failure)) found.push_back({entry->path(), place});
    }
    std::ranges::sort(found, {}, &Source::file);
    return found;
}

/// A name for a test from the file's path in its folder: letters, digits, '-', '_' and '.', none used twice.
std::string test_name(const Source& source, std::set<std::string>& used) {
    constexpr std::size_t max_size = 100;
    fs::path relative = source.file.lexically_relative(source.folder);
    if (source.folder.empty() || relative.empty()) relative = source.file.filename();
    std::string name;
    for (const char c : relative.replace_extension().generic_string()) {
        const bool is_plain = std::isalnum(static_cast<unsigned char>(c)) || c == '-' || c == '_' || c == '.';
        name += is_plain ? c : '_';
    }
    name = name.substr(0, max_size);
    if (name.empty() || name.front() == '.' || name.front() == '-') name.insert(0, "t");
    std::string unused = name;
    for (int number = 2; !used.insert(unused).second; ++number) unused = fmt::format("{}_{}", name, number);
    return unused;
}

ordered_json test_json(const Source& source, bool is_scene, const fs::path& output,
                       std::set<std::string>& used) {
    const std::string file = fs::absolute(source.file)
                                 .lexically_normal()
                                 .lexically_relative(fs::absolute(output).lexically_normal())
                                 .generic_string();
    ordered_json json{{"name", test_name(source, used)}};
    if (is_scene) {
        json["scene"] = file;
    } else {
        json["command"] = {"cp", file, "{out}"};
        json["format"] = format_of_name(source.file);
    }
    return json;
}

/// Each file once, however it was named.
std::vector<Source> without_repetitions(std::vector<Source> sources) {
    std::set<fs::path> seen;
    std::erase_if(sources, [&](const Source& source) {
        return !seen.insert(fs::weakly_canonical(source.file)).second;
    });
    return sources;
}

/// The suite's path in the Git repository that holds it, where a CI system starts its commands; as given
/// where there is none.
fs::path path_in_repository(const fs::path& suite) {
    const fs::path file = fs::weakly_canonical(fs::absolute(suite));
    std::error_code ignored;
    for (fs::path folder = file.parent_path(); folder != folder.root_path(); folder = folder.parent_path())
        if (fs::exists(folder / ".git", ignored)) return file.lexically_relative(folder);
    return suite;
}

/// @throws Error for a path that a shell or YAML reads otherwise than it is written
void require_plain(const fs::path& suite) {
    const std::string path = suite.generic_string();
    if (shell_line({path}) != path || path.front() == '-')
        throw Error({path}, "the files for CI systems cannot name this suite without quotes",
                    "choose a folder of letters, digits, '-', '_', '.' and '/' with --output");
}

/// The sources that have one of these formats.
std::vector<Source> of_formats(const std::vector<Source>& sources, std::span<const char* const> formats) {
    std::vector<Source> chosen;
    std::ranges::copy_if(sources, std::back_inserter(chosen),
                         [&](const Source& source) { return has_format(source.file, formats); });
    return chosen;
}

std::string filled(std::string_view text, const fs::path& suite) {
    std::string result(text);
    const std::array<std::pair<std::string_view, std::string>, 2> values{
        {{"@suite@", suite.generic_string()}, {"@folder@", suite.parent_path().generic_string()}}};
    for (const auto& [placeholder, value] : values)
        for (auto at = result.find(placeholder); at != std::string::npos; at = result.find(placeholder, at))
            result.replace(at, placeholder.size(), value);
    return result;
}

std::string suite_text(const std::vector<Source>& sources, bool is_scenes, const fs::path& output) {
    std::set<std::string> used;
    ordered_json tests = ordered_json::array();
    for (const Source& source : sources) tests.push_back(test_json(source, is_scenes, output, used));
    const std::string name = fs::absolute(output).lexically_normal().filename().string();
    ordered_json suite{{"name", name.empty() ? "golden" : name}, {"goldens", "goldens"}};
    if (is_scenes) suite["defaults"] = {{"size", "256x256"}, {"samples", 64}, {"exr_type", "half"}};
    suite["tests"] = std::move(tests);
    return suite.dump(1, ' ', false, ordered_json::error_handler_t::replace) + "\n";
}

} // namespace

InitResult write_first_suite(const InitOptions& options) {
    constexpr std::size_t max_tests = 1000;
    std::vector<Source> all;
    for (const fs::path& source : options.sources)
        std::ranges::move(sources_in(source), std::back_inserter(all));
    all = without_repetitions(std::move(all));
    std::vector<Source> chosen = of_formats(all, scene_formats);
    const bool is_scenes = !chosen.empty();
    if (!is_scenes) chosen = of_formats(all, picture_formats); // beside scenes, pictures are textures
    const std::string place = options.sources.empty() ? "." : options.sources.front().string();
    if (chosen.empty())
        throw Error({place}, "neither a scene nor a picture",
                    "name files or folders of .gltf, .glb, .exr, .hdr, .png, .jpg or .tif");
    if (chosen.size() > max_tests)
        throw Error({place}, fmt::format("{} files are too many for a first suite", chosen.size()),
                    fmt::format("name at most {}", max_tests));
    const fs::path suite = options.output / "suite.json", named = path_in_repository(suite);
    require_plain(named);
    const std::array<std::pair<fs::path, std::string>, 4> files{
        {{suite, suite_text(chosen, is_scenes, options.output)},
         {options.output / ".gitattributes", "goldens/** filter=lfs diff=lfs merge=lfs -text\n"},
         {options.output / "github-actions.yml", filled(github_template, named)},
         {options.output / "gitlab-ci.yml", filled(gitlab_template, named)}}};
    std::error_code failure;
    for (const auto& [file, text] : files)
        if (fs::exists(fs::symlink_status(file, failure)))
            throw Error({file.string()}, "the file is there already", "choose another folder with --output");
    fs::create_directories(options.output, failure);
    image::WholeFiles written;
    for (const auto& [file, text] : files)
        written.add(file, {reinterpret_cast<const std::uint8_t*>(text.data()), text.size()});
    written.put_in_place();
    return {suite, static_cast<int>(chosen.size()), !is_scenes};
}

} // namespace sr::golden
