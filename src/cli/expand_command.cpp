#include "cli/arguments.hpp"
#include "cli/commands.hpp"
#include "core/output.hpp"
#include "glsl/source.hpp"
#include "picture/open_scene.hpp"
#include "render/gpu/shader_library.hpp"

#include <CLI/CLI.hpp>
#include <cstdio>
#include <memory>
#include <string>
#include <vector>

namespace sr::cli {

void add_expand_command(CLI::App& app) {
    struct Arguments {
        std::string file;
        std::vector<std::string> shaders;
        bool is_untrusted = false;
    };
    const auto arguments = std::make_shared<Arguments>();
    CLI::App* command =
        app.add_subcommand("expand", "print a shader as the driver sees it, its includes expanded");
    command->add_option("FILE", arguments->file, "a shader of the shader path, such as forward.frag")
        ->required();
    command->add_option("--shaders", arguments->shaders, "look for shaders in this folder first (repeatable)")
        ->type_name("DIR")
        ->allow_extra_args(false);
    command->add_flag("--untrusted", arguments->is_untrusted,
                      "refuse in these folders what is no plain GLSL, and bound their loops");
    command->footer(
        "Examples:\n  steradian expand forward.frag\n  steradian expand brdf/f_r.glsl --shaders my_shaders");
    command->callback([arguments] {
        std::vector<glsl::Root> path = picture::shader_path(arguments->shaders, arguments->is_untrusted);
        path.insert(path.end() - 1,
                    glsl::Root::memory("glTF's own material",
                                       render::brdf_files(scene::Model::metallic_roughness, path)));
        write_output(glsl::expand(path, arguments->file).text);
    });
}

} // namespace sr::cli
