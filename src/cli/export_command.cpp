#include "cli/arguments.hpp"
#include "cli/commands.hpp"
#include "core/output.hpp"
#include "gltf/asset.hpp"
#include "mitsuba/write.hpp"
#include "picture/open_scene.hpp"
#include "scene/prepare.hpp"

#include <CLI/CLI.hpp>
#include <fmt/format.h>
#include <memory>

namespace sr::cli {
namespace {

struct ExportCommand {
    RenderSettings settings;
    std::string to;
    std::string folder;
};

/// Prepares the scene as `render` does, without the surfaces that `render` gives to lights.
scene::RenderScene staged(const RenderSettings& settings, scene::Scene&& scene) {
    scene::PrepareOptions options{settings.camera, settings.rig};
    options.environment = picture::read_environment_light(settings);
    if (const auto& size = settings.size)
        options.aspect_ratio = static_cast<float>(size->width) / static_cast<float>(size->height);
    const std::size_t instances = scene.instances.size(), emitters = scene::emitters_of(scene).size();
    scene::RenderScene stage = scene::prepare_scene(std::move(scene), settings.scene, options);
    stage.scene.instances.resize(instances);
    const auto rig =
        stage.lights.begin() + static_cast<std::ptrdiff_t>(emitters); // behind what emits by itself
    stage.scene.lights.insert(stage.scene.lights.end(), rig, stage.lights.end());
    return stage;
}

void export_scene(const ExportCommand& command) {
    const RenderSettings& settings = command.settings;
    gltf::Loaded loaded = gltf::load(settings.scene, {.scene = settings.scene_index,
                                                      .at = settings.at,
                                                      .animation = settings.animation,
                                                      .variant = settings.variant,
                                                      .is_strict = settings.is_strict});
    for (const std::string& warning : loaded.warnings) write_remark(warning);
    const scene::RenderScene stage = staged(settings, std::move(loaded.scene));
    for (const std::string& remark : stage.remarks) write_remark(remark);
    const Size size = settings.size.value_or(picture::picture_size(stage.camera.aspect_ratio()));
    const auto warnings =
        mitsuba::write({stage.scene, stage.camera, size.width, size.height}, command.folder);
    for (const std::string& warning : warnings) print_remark("{}: {}", settings.scene, warning);
}

} // namespace

void add_export_command(CLI::App& app) {
    const auto options = std::make_shared<ExportCommand>();
    CLI::App* command = app.add_subcommand("export", "write a scene for another renderer, to compare with");
    command->add_option("SCENE", options->settings.scene, "a .gltf or .glb file")->required();
    command->add_option("--to", options->to, "for which renderer")
        ->required()
        ->check(CLI::IsMember({"mitsuba"}));
    command
        ->add_option("DIR", options->folder,
                     "a folder that is new, empty, or an earlier export, which is replaced")
        ->required();
    declare(*command, settings::by_export, options->settings);
    command->footer("Examples:\n"
                    "  steradian export scene.glb --to mitsuba scene_for_mitsuba --size 640x360\n"
                    "  python scene_for_mitsuba/render.py -o truth.exr --spp 1024    (pip install mitsuba)\n"
                    "  steradian render scene.glb -o ours.exr --size 640x360 --samples 1024\n"
                    "  steradian compare ours.exr truth.exr");
    command->callback([options] { export_scene(*options); });
}

} // namespace sr::cli
