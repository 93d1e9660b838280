#include "cli/commands.hpp"
#include "gl/trial_compiler.hpp"

#include <CLI/CLI.hpp>
#include <memory>
#include <string>

namespace sr::cli {

void add_trial_command(CLI::App& app) {
    const auto backend = std::make_shared<std::string>("auto");
    CLI::App* command =
        app.add_subcommand("compile-trial", "compile shaders from stdin")->group(""); // not listed
    command->add_option("--backend", *backend);
    command->callback(
        [backend] { gl::answer_trials(gl::backend_named(*backend).value_or(gl::Backend::automatic)); });
}

} // namespace sr::cli
