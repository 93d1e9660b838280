#include "cli/commands.hpp"
#include "cli/samples.hpp"
#include "cli/version.hpp"
#include "core/error.hpp"
#include "core/output.hpp"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <array>
#include <filesystem>
#include <fmt/format.h>
#include <memory>
#include <nlohmann/json.hpp>
#include <string>
#include <string_view>
#include <unistd.h>
#include <utility>
#include <vector>

namespace sr::cli {
namespace {

namespace fs = std::filesystem;

struct Sample {
    std::string_view name;
    std::string_view what; // it shows
};

/// The files of assets/scenes, in the order in which people look at them.
constexpr std::array<Sample, 10> samples{{
    {"default", "a robot with a lantern among five materials, under neon tubes and two area lights"},
    {"cornell", "the Cornell box from its measurements: Lambert's surfaces under one lamp of 800 lm"},
    {"spheres", "dielectric, half metallic and metallic balls of roughness 0.05 to 1"},
    {"brdfs", "fifteen balls: Lambert, Oren–Nayar, Phong, a mirror, metals, clearcoat, sheen, thin films"},
    {"veach", "four glossy plates that mirror four lights of equal power"},
    {"glass", "coloured panes, a bottle, a block that attenuates and leaves lit from behind"},
    {"zoo", "one light of each kind that glTF has, over the same ball, block and cone"},
    {"emitters", "disk, sphere, tube, polygon, a picture that emits and a lamp with an IES profile"},
    {"office", "four desks under six panels of 3600 lm, to measure with steradian illuminance"},
    {"motion", "skins, morph targets, moving lights and a variant, in 2 s of animation"},
}};

/// Returns the folder of the scenes: beside the program in a build folder, or where they are installed.
fs::path samples_folder() {
    const fs::path program = running_program();
    for (const char* place : {"scenes", "../share/steradian/scenes"}) {
        std::error_code ignored;
        const fs::path folder = fs::canonical(program.parent_path() / place, ignored);
        if (!ignored && fs::is_regular_file(folder / "default.gltf")) return folder;
    }
    throw Error(fmt::format("no sample scenes lie beside {} or in ../share/steradian/scenes from there",
                            program.string()),
                "install Steradian whole: cmake --install BUILD_FOLDER");
}

std::string path_of(const Sample& sample) {
    return (samples_folder() / fmt::format("{}.gltf", sample.name)).string();
}

const Sample& sample_named(std::string name) {
    if (name.ends_with(".gltf")) name.resize(name.size() - 5);
    const auto found = std::ranges::find(samples, name, &Sample::name);
    if (found != samples.end()) return *found;
    std::string known;
    for (const Sample& sample : samples) known += fmt::format("{}{}", known.empty() ? "" : ", ", sample.name);
    throw Error(fmt::format("there is no sample scene '{}'", name), "choose one of " + known);
}

/// Replaces this process by `steradian view SCENE`.
[[noreturn]] void open_in_window(std::string scene) {
    std::string program = running_program().string(), command = "view";
    std::array<char*, 4> words{program.data(), command.data(), scene.data(), nullptr};
    flush_output();
    execvp(program.c_str(), words.data());
    throw Error({program}, "cannot be started again", "run steradian view " + scene);
}

void list_samples(bool as_json) {
    nlohmann::ordered_json list = nlohmann::ordered_json::array();
    for (const Sample& sample : samples) {
        if (as_json)
            list.push_back({{"name", sample.name}, {"what", sample.what}, {"file", path_of(sample)}});
        else
            print_data("{:<9} {}\n", sample.name, sample.what);
    }
    if (as_json)
        write_json(list.dump(2));
    else
        print_data("\nThey lie in {}\n", samples_folder().string());
}

} // namespace

std::vector<viewer::SampleScene> sample_scenes() {
    std::vector<viewer::SampleScene> scenes;
    try {
        for (const Sample& sample : samples)
            scenes.push_back({std::string(sample.name), std::string(sample.what), path_of(sample)});
    } catch (const Error&) { // a program without its scenes opens others
        scenes.clear();
    }
    return scenes;
}

void print_welcome() {
    print_data(
        "{}: a real-time renderer for direct illumination in physical units.\n"
        "Every pixel is a radiance in cd/m², and can be checked against the equation that it evaluates.\n"
        "\n"
        "  steradian samples --open default          look at a bundled scene in a window\n"
        "  steradian render SCENE -o picture.png     make a picture of a .gltf or .glb file\n"
        "  steradian probe SCENE --pixel 640,360     print the equation at one pixel, term by term\n"
        "  steradian compare TEST REFERENCE          find out whether two pictures agree\n"
        "  steradian doctor                          find out whether this machine can render\n"
        "\n"
        "All commands: steradian --help. Bundled scenes: steradian samples",
        name_and_version());
    try {
        print_data(", in {}\n", samples_folder().string());
    } catch (const Error&) { // a program without its scenes is still worth a welcome
        print_data("\n");
    }
}

void add_samples_command(CLI::App& app) {
    struct Arguments {
        std::string name;
        std::string opened;
        bool json = false;
    };
    const auto arguments = std::make_shared<Arguments>();
    CLI::App* command =
        app.add_subcommand("samples", "list the bundled scenes, print the path of one, or open one");
    command->add_option("NAME", arguments->name, "print the path of this scene");
    command->add_option("--open", arguments->opened, "show this scene in a window")->type_name("NAME");
    command->add_flag("--json", arguments->json, "print the list as JSON");
    command->footer("Examples:\n"
                    "  steradian samples\n"
                    "  steradian samples --open cornell\n"
                    "  steradian render $(steradian samples cornell) -o cornell.png");
    command->callback([arguments] {
        const Arguments& a = *arguments;
        if (!a.name.empty() && !a.opened.empty())
            throw CLI::ValidationError("NAME", "excludes --open: name one scene");
        if (!a.opened.empty()) open_in_window(path_of(sample_named(a.opened)));
        if (a.name.empty())
            list_samples(a.json);
        else
            print_data("{}\n", path_of(sample_named(a.name)));
    });
}

} // namespace sr::cli
