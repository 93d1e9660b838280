#include "cli/commands.hpp"
#include "cli/doctor_trials.hpp"
#include "cli/version.hpp"
#include "core/error.hpp"
#include "core/file.hpp"
#include "core/output.hpp"
#include "core/piped_program.hpp"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fmt/format.h>
#include <memory>
#include <nlohmann/json.hpp>
#include <string>
#include <string_view>
#include <thread>
#include <utility>
#include <vector>

namespace sr::cli {
namespace {

namespace fs = std::filesystem;
using nlohmann::ordered_json;

constexpr std::array<const char*, 3> backends{"egl", "osmesa", "window"}; // as --backend auto tries them

/// A program that Steradian does without.
struct OptionalProgram {
    std::string_view name;
    std::array<std::string_view, 3> files; // sought in PATH; the first is taken
    std::string_view purpose;
    std::string_view install; // the command
};

constexpr std::array<OptionalProgram, 7> optional_programs{{
    {"oiiotool", {"oiiotool"}, "looks into EXR files", "sudo apt-get install openimageio-tools"},
    {"Chromium",
     {"chromium", "chromium-browser", "google-chrome"},
     "tests the reports as people see them",
     "sudo apt-get install chromium"},
    {"Xvfb", {"Xvfb"}, "gives `steradian view` a display where there is none", "sudo apt-get install xvfb"},
    {"ffmpeg",
     {"ffmpeg"},
     "encodes the videos of `render -o NAME.mp4` and of the viewer",
     "sudo apt-get install ffmpeg"},
    {"xclip",
     {"xclip", "wl-copy"},
     "puts the viewer's picture on the clipboard",
     "sudo apt-get install xclip, or wl-clipboard for Wayland"},
    {"pandoc", {"pandoc"}, "makes the handouts of assignments", "sudo apt-get install pandoc"},
    {"Mitsuba 3", {"mitsuba"}, "renders what `steradian export` writes", "pip install mitsuba"},
}};

/// A library that a build does without.
struct OptionalLibrary {
    std::string_view name;
    std::string_view purpose;
    std::string_view package;
};

constexpr std::array<OptionalLibrary, 4> optional_libraries{{
    {"meshoptimizer", "reads glTF's EXT_meshopt_compression", "libmeshoptimizer-dev"},
    {"Draco", "reads glTF's KHR_draco_mesh_compression", "libdraco-dev"},
    {"libwebp", "reads glTF's EXT_texture_webp", "libwebp-dev"},
    {"libseccomp", "confines students' code", "libseccomp-dev"},
}};

ordered_json optional_programs_json() {
    ordered_json list = ordered_json::array();
    for (const OptionalProgram& program : optional_programs) {
        std::string file;
        for (const std::string_view name : program.files)
            if (file.empty()) file = program_in_path(name).string();
        ordered_json entry{{"name", program.name}, {"found", !file.empty()}, {"purpose", program.purpose}};
        if (file.empty())
            entry["install"] = program.install;
        else
            entry["file"] = file;
        list.push_back(std::move(entry));
    }
    return list;
}

/// Returns the name and version of each library that this program was built with.
ordered_json libraries_json() {
    ordered_json json = ordered_json::object();
    for (const std::string& library : CLI::detail::split(STERADIAN_LIBRARIES, ',')) {
        const std::size_t space = library.rfind(' ');
        json[library.substr(0, space)] = library.substr(space + 1);
    }
    return json;
}

ordered_json missing_libraries_json(const ordered_json& libraries) {
    ordered_json list = ordered_json::array();
    for (const OptionalLibrary& library : optional_libraries)
        if (!libraries.contains(library.name))
            list.push_back(
                {{"name", library.name},
                 {"purpose", library.purpose},
                 {"install", fmt::format("sudo apt-get install {}, then build again", library.package)}});
    return list;
}

/// Returns a font file of the system, which browsers use for reports; empty if there is none. The viewer has
/// a font of its own.
std::string system_font() {
    const char* home = std::getenv("HOME");
    for (const fs::path& folder : {fs::path("/usr/share/fonts"), fs::path("/usr/local/share/fonts"),
                                   fs::path(home ? home : "/") / ".local/share/fonts"}) {
        std::error_code failure;
        fs::recursive_directory_iterator entry(folder, fs::directory_options::skip_permission_denied,
                                               failure);
        for (; !failure && entry != fs::recursive_directory_iterator(); entry.increment(failure))
            if (const fs::path extension = entry->path().extension();
                extension == ".ttf" || extension == ".otf" || extension == ".ttc")
                return entry->path().string();
    }
    return "";
}

ordered_json diagnosis() {
    const ScratchFolder scratch("doctor");
    ordered_json tried = ordered_json::array();
    for (const char* name : backends) {
        ordered_json entry{{"name", name}};
        entry.update(result_of_trial(name, scratch.path()));
        tried.push_back(std::move(entry));
    }
    const ordered_json libraries = libraries_json();
    const bool can_render = std::ranges::any_of(tried, [](const auto& entry) { return entry["works"]; });
    return {{"version", name_and_version()},
            {"cores", std::thread::hardware_concurrency()},
            {"backends", std::move(tried)},
            {"exr", result_of_trial("exr", scratch.path())},
            {"hdr", result_of_trial("hdr", scratch.path())},
            {"confinement", result_of_trial("confinement", scratch.path())},
            {"font", system_font()},
            {"libraries", libraries},
            {"missing_libraries", missing_libraries_json(libraries)},
            {"optional_programs", optional_programs_json()},
            {"can_render", can_render}};
}

std::string text(const ordered_json& json, const char* key) { return json.value(key, std::string()); }

void print_backend(const ordered_json& backend) {
    const std::string name = text(backend, "name");
    if (backend.contains("GL_RENDERER"))
        print_data("  {:<13} {}, OpenGL {}, GLSL {} ({}{})\n", name, text(backend, "GL_RENDERER"),
                   text(backend, "GL_VERSION"), text(backend, "GLSL_VERSION"), text(backend, "kind"),
                   backend["software"] ? ", on the CPU" : "");
    else
        print_data("  {:<13} does not work here: {}\n", name, text(backend, "failure"));
    if (backend.contains("picture")) {
        const ordered_json& picture = backend["picture"];
        print_data("  {:<13} a Lambert plane under a point light: expected {:.6f} cd/m², measured {:.6f}, at "
                   "most {:.1e} off: {}\n",
                   "", picture["expected [cd/m^2]"].get<double>(), picture["measured [cd/m^2]"].get<double>(),
                   picture["max_relative_error"].is_null() ? INFINITY
                                                           : picture["max_relative_error"].get<double>(),
                   picture["right"] ? "right" : "WRONG");
    }
    if (backend.contains("remark")) print_data("  {:<13} {}\n", "", text(backend, "remark"));
}

void print_system(const ordered_json& json) {
    print_data("\nSystem\n  {:<13} {}\n", "CPU cores", json["cores"].dump());
    for (const auto& [key, what] : {std::pair("exr", "EXR files"), std::pair("hdr", ".hdr files")})
        print_data("  {:<13} {}\n", what,
                   json[key]["works"] ? "written and read back"
                                      : "do not work here: " + text(json[key], "failure"));
    const ordered_json& confinement = json["confinement"];
    std::string lacking = text(confinement, "failure");
    for (const auto& protection : confinement.value("lacking", ordered_json::array()))
        lacking += (lacking.empty() ? "" : ", ") + protection.get<std::string>();
    print_data("  {:<13} {}\n", "confinement",
               confinement["works"] ? "of students' code is complete" : "of students' code lacks " + lacking);
    const std::string font = text(json, "font");
    print_data("  {:<13} the viewer has its own; reports use the browser's, {}\n", "fonts",
               font.empty() ? "of which the system has none: sudo apt-get install fonts-dejavu-core"
                            : "such as " + font);
}

void print_diagnosis(const ordered_json& json) {
    print_data("{}\n\nOpenGL backends, in the order in which --backend auto tries them\n",
               text(json, "version"));
    for (const auto& backend : json["backends"]) print_backend(backend);
    print_system(json);
    print_data("\nLibraries that it was built with\n");
    for (const auto& [name, version] : json["libraries"].items())
        print_data("  {:<20} {}\n", name, version.get<std::string>());
    for (const auto& missing : json["missing_libraries"])
        print_data("  {:<20} none ({}): {}\n", text(missing, "name"), text(missing, "purpose"),
                   text(missing, "install"));
    print_data("\nOptional programs\n");
    for (const auto& program : json["optional_programs"])
        print_data("  {:<13} {}\n", text(program, "name"),
                   program["found"]
                       ? text(program, "file")
                       : fmt::format("none ({}): {}", text(program, "purpose"), text(program, "install")));
    if (json["can_render"]) print_data("\nSteradian can render here.\n");
}

} // namespace

void add_doctor_command(CLI::App& app) {
    struct Arguments {
        bool json = false;
        std::vector<std::string> trial; // its name and the file for its result
    };
    const auto arguments = std::make_shared<Arguments>();
    CLI::App* command = app.add_subcommand(
        "doctor", "find out whether this machine can render, what is missing and what installs it");
    command->add_flag("--json", arguments->json, "print JSON");
    command->add_option("--trial", arguments->trial)->expected(2)->group(""); // in a child process
    command->footer("Each backend renders a picture whose every pixel has a closed form, in a process of its "
                    "own.\n\n"
                    "Examples:\n"
                    "  steradian doctor\n"
                    "  steradian doctor --json | jq .can_render\n\n"
                    "Exit status: 0 if a backend makes the right picture, 3 otherwise.");
    command->callback([arguments] {
        if (!arguments->trial.empty()) return run_doctor_trial(arguments->trial[0], arguments->trial[1]);
        const ordered_json json = diagnosis();
        if (arguments->json)
            write_json(json.dump(2, ' ', false, ordered_json::error_handler_t::replace));
        else
            print_diagnosis(json);
        if (!json["can_render"])
            throw Error("no OpenGL backend makes a right picture here",
                        "install a driver, e.g. sudo apt-get install libegl1 libgl1-mesa-dri");
    });
}

} // namespace sr::cli
