#include "assignment/evaluation.hpp"
#include "assignment/submission.hpp"
#include "cli/arguments.hpp"
#include "cli/commands.hpp"
#include "cli/interruption.hpp"
#include "cli/samples.hpp"
#include "cli/version.hpp"
#include "core/error.hpp"
#include "core/output.hpp"
#include "gl/window.hpp"
#include "picture/open_scene.hpp"
#include "viewer/app.hpp"
#include "viewer/keymap.hpp"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fmt/format.h>
#include <memory>
#include <nlohmann/json.hpp>

namespace sr::cli {
namespace {

using nlohmann::ordered_json;

struct ViewCommand {
    RenderSettings rendering;
    std::string submission; // a student's folder
    bool is_examined = false;
    bool plays = false;
    bool is_fullscreen = false;
    bool has_inertia = false;
    bool is_verbose = false;
    bool json = false;
    bool prints_keys = false;
};

viewer::Options viewer_options(const ViewCommand& command) {
    const RenderSettings& r = command.rendering;
    viewer::Options options;
    static_cast<RenderSettings&>(options) = r;
    options.environment_light = picture::read_environment_light(r);
    options.plays = command.plays;
    options.rendering.shader_path =
        picture::shader_path(r.shaders, r.is_untrusted); // says now what is wrong with the folders
    if (!r.shaders.empty())
        options.rendering.trial = std::make_shared<gl::TrialCompiler>(gl::Backend::window);
    options.is_fullscreen = command.is_fullscreen;
    options.has_inertia = command.has_inertia;
    options.is_verbose = command.is_verbose;
    return options;
}

/// The scene, the shaders and the reference of a student's folder. @throws Error
void take_assignment(viewer::Options& options, const std::string& submission) {
    const assignment::FolderLabel label = assignment::label_of(submission);
    const auto assignment = assignment::load(assignment::assignment_of(label));
    const std::filesystem::path folder = submission;
    if (options.scene.empty()) {
        if (assignment.scene.empty())
            throw Error({submission}, "its assignment has no scene", "name one before --assignment");
        options.scene = (folder / assignment.scene).string();
    }
    options.submission = submission;
    options.program = running_program();
    options.shaders.push_back(submission);
    if (std::filesystem::is_directory(assignment.folder / "overlay"))
        options.shaders.push_back((assignment.folder / "overlay").string());
    options.reference_path =
        assignment::shader_path(assignment, assignment::parameters_of(assignment, label.student), {});
}

ordered_json summary(const viewer::Statistics& statistics) {
    ordered_json start;
    for (const auto& [part, seconds] : statistics.start) start[part] = seconds;
    ordered_json json{{"GL_RENDERER", statistics.renderer},
                      {"start [s]", start},
                      {"drawn_frames", statistics.drawn_frames},
                      {"reloads", statistics.reloads},
                      {"moving_frames", statistics.moving_frames.size()}};
    const auto quantile = [](std::vector<double> values, double share) {
        std::ranges::sort(values);
        return values[static_cast<std::size_t>(share * static_cast<double>(values.size()))];
    };
    if (statistics.moving_frames.empty()) return json;
    json["moving_scale_median"] = quantile(statistics.moving_scales, 0.5);
    json["moving_frame_median [s]"] = quantile(statistics.moving_frames, 0.5);
    json["moving_sample_median [s]"] = quantile(statistics.moving_samples, 0.5);
    json["moving_frame_p95 [s]"] = quantile(statistics.moving_frames, 0.95);
    json["moving_frame_processor_median [s]"] = quantile(statistics.moving_cpu, 0.5);
    return json;
}

/// Default stopping rule of the viewer.
void converge_by_default(render::StopRule& stop) {
    stop.samples = stop.asks_for_error() ? render::max_samples : 256;
    if (!stop.asks_for_error()) stop.error = 0.005;
}

/// Prints the keys in use. @throws Error if the file of keys is wrong
void print_keys() { write_json(viewer::Keymap::in_use().json()); }

void view(const ViewCommand& command) {
    if (command.prints_keys) return print_keys();
    const Interruption interruption;
    viewer::Options options = viewer_options(command);
    if (!command.submission.empty()) take_assignment(options, command.submission);
    options.is_examined = command.is_examined;
    if (options.scene.empty()) options.samples = sample_scenes();
    viewer::App app(std::move(options));
    gl::when_display_is_lost([] {
        write_remark(
            "window: lost the connection to the display: start again with a DISPLAY that can be reached");
        std::_Exit(worlds_fault);
    });
    app.run(interruption.token());
    if (command.json) write_json(summary(app.statistics()).dump(2));
}

} // namespace

void add_view_command(CLI::App& app) {
    const auto options = std::make_shared<ViewCommand>();
    CLI::App* command = app.add_subcommand("view", "show a scene in a window");
    command->add_option("SCENE", options->rendering.scene,
                        "a .gltf or .glb file; without one, a page to choose from");
    declare(*command, settings::by_view, options->rendering);
    const auto assignment = command->add_option(
        "--assignment", options->submission,
        "a student's folder: renders its scene with its shaders, shows marks and the reference");
    command
        ->add_flag("--tick", options->is_examined,
                   "for teachers: show the questions of `assignment tick`; J, U and I go on, answer and try")
        ->needs(assignment);
    command->add_flag("--play", options->plays, "play the animation, starting at --at or at its beginning");
    command->add_flag("--inertia", options->has_inertia, "let the view glide on after a drag");
    command->add_flag("--fullscreen", options->is_fullscreen, "fill the screen (F11)");
    command->add_flag("-v,--verbose", options->is_verbose, "print messages to stderr, too");
    command->add_flag("--json", options->json, "print timings as JSON at the end");
    command->add_flag("--print-keys", options->prints_keys,
                      "print all commands with their keys as JSON, and open no window");
    command->footer(
        "F1 or ? in the window shows all keys. $XDG_CONFIG_HOME/steradian/keys.json (or ~/.config/steradian) "
        "gives\n"
        "commands other keys: {\"Frame all\": \"Ctrl Home\", \"Write a turntable\": []}. --print-keys says "
        "what is wrong "
        "with it.\n\n"
        "Examples:\n"
        "  steradian view scene.glb\n"
        "  steradian view                                     (a page of recent files and bundled scenes)\n"
        "  steradian view scene.glb --shaders my_shaders      (saved changes show at once)\n"
        "  steradian view dancer.glb --animation Walk --play\n"
        "  steradian view scene.glb --camera 1 --exposure 9 --tone-curve agx --samples 1024\n"
        "  steradian view --assignment my-a3                  (live, with marks; B compares with the "
        "reference)\n"
        "  steradian view --assignment my-a3 --tick           (the questions of an oral examination)\n"
        "  steradian view scene.glb --error 0.1%              (until its error is that small)");
    command->callback([options, command] {
        if (command->count("--samples") == 0) converge_by_default(options->rendering.stop);
        view(*options);
    });
}

} // namespace sr::cli
