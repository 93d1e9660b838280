#include "cli/arguments.hpp"
#include "cli/commands.hpp"
#include "core/output.hpp"
#include "glsl/source.hpp"

#include <CLI/CLI.hpp>
#include <cstdio>
#include <memory>

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
    command->add_option("FILE", arguments->file, "a shader of the shader path, e.g. forward.frag")
        ->required();
    command
        ->add_option("--shaders", arguments->shaders,
                     "look in this folder before the built-in shaders (repeatable)")
        ->type_name("DIR")
        ->allow_extra_args(false);
    command->add_flag("--untrusted", arguments->is_untrusted,
                      "refuse in these folders what is no plain GLSL, and bound their loops");
    command->footer(
        "Examples:\n  steradian expand forward.frag\n  steradian expand brdf/f_r.glsl --shaders my_shaders");
    command->callback([arguments] {
        const auto path = shader_path(arguments->shaders, arguments->is_untrusted);
        write_output(glsl::expand(path, arguments->file).text);
    });
}

} // namespace sr::cli
