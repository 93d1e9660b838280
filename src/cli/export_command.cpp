#include "cli/arguments.hpp"
#include "cli/commands.hpp"
#include "cli/render_options.hpp"
#include "core/output.hpp"
#include "gltf/asset.hpp"
#include "mitsuba/write.hpp"
#include "scene/prepare.hpp"

#include <CLI/CLI.hpp>
#include <fmt/format.h>
#include <memory>

namespace sr::cli {
namespace {

struct ExportCommand {
    std::string scene;
    std::string to;
    std::string folder;
    std::string camera;
    std::string size;
    std::optional<int> scene_index;
    scene::Rig rig = scene::Rig::automatic;
    EnvironmentArguments environment;
    gltf::LoadOptions moment;
};

/// Prepares the scene as `render` does, without the surfaces that `render` gives to lights.
scene::RenderScene staged(const ExportCommand& command, std::optional<Size> size, scene::Scene&& scene) {
    scene::PrepareOptions options{command.camera, command.rig};
    options.environment = command.environment.light();
    if (size) options.aspect_ratio = static_cast<float>(size->width) / static_cast<float>(size->height);
    const std::size_t instances = scene.instances.size(), emitters = scene::emitters_of(scene).size();
    scene::RenderScene stage = scene::prepare_scene(std::move(scene), command.scene, options);
    stage.scene.instances.resize(instances);
    const auto rig =
        stage.lights.begin() + static_cast<std::ptrdiff_t>(emitters); // behind what emits by itself
    stage.scene.lights.insert(stage.scene.lights.end(), rig, stage.lights.end());
    return stage;
}

void export_scene(const ExportCommand& command) {
    const std::optional<Size> asked = command.size.empty() ? std::nullopt : parsed_size(command.size);
    gltf::LoadOptions options = command.moment;
    options.scene = command.scene_index;
    gltf::Loaded loaded = gltf::load(command.scene, options);
    for (const std::string& warning : loaded.warnings) write_remark(warning);
    const scene::RenderScene stage = staged(command, asked, std::move(loaded.scene));
    for (const std::string& remark : stage.remarks) write_remark(remark);
    const Size size = asked.value_or(picture_size(stage.camera.aspect_ratio()));
    const auto warnings =
        mitsuba::write({stage.scene, stage.camera, size.width, size.height}, command.folder);
    for (const std::string& warning : warnings) print_remark("{}: {}", command.scene, warning);
}

} // namespace

void add_export_command(CLI::App& app) {
    const auto options = std::make_shared<ExportCommand>();
    CLI::App* command = app.add_subcommand("export", "write a scene for another renderer, to compare with");
    command->add_option("SCENE", options->scene, "a .gltf or .glb file")->required();
    command->add_option("--to", options->to, "for which renderer")
        ->required()
        ->check(CLI::IsMember({"mitsuba"}));
    command
        ->add_option("DIR", options->folder,
                     "a folder that is new, empty, or an earlier export, which is replaced")
        ->required();
    command->add_option("--size", options->size, "size of the picture (default: as render's)")
        ->type_name("WIDTHxHEIGHT")
        ->check([](const std::string& text) {
            return parsed_size(text) ? std::string() : "'" + text + "' is not WIDTHxHEIGHT";
        });
    command->add_option("--camera", options->camera,
                        "camera by name or index, or auto (default: the first, or auto)");
    command
        ->add_option("--scene", options->scene_index,
                     "which of the file's scenes (default: the file's choice)")
        ->check(CLI::NonNegativeNumber);
    command
        ->add_option("--at", options->moment.at,
                     "the moment of the animation (default: the file's rest pose)")
        ->type_name("SECONDS")
        ->check(refusal_of_number)
        ->check(CLI::NonNegativeNumber);
    command->add_option("--animation", options->moment.animation,
                        "which one, as render's (default: the first)");
    command->add_option("--variant", options->moment.variant, "which of the file's material variants");
    declare_rig(*command, options->rig, options->environment);
    command->add_flag("--strict", options->moment.is_strict, strict_help);
    command->footer("Examples:\n"
                    "  steradian export scene.glb --to mitsuba scene_for_mitsuba --size 640x360\n"
                    "  python scene_for_mitsuba/render.py -o truth.exr --spp 1024    (pip install mitsuba)\n"
                    "  steradian render scene.glb -o ours.exr --size 640x360 --samples 1024\n"
                    "  steradian compare ours.exr truth.exr");
    command->callback([options] { export_scene(*options); });
}

} // namespace sr::cli
