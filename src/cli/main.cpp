#include "cli/commands.hpp"
#include "cli/version.hpp"
#include "core/error.hpp"
#include "core/limits.hpp"
#include "core/output.hpp"

#include <CLI/CLI.hpp>
#include <csignal>
#include <cstdlib>
#include <exception>
#include <new>
#include <sstream>
#include <system_error>
#include <unistd.h>
#include <vector>

namespace sr::cli {
namespace {

constexpr const char* out_of_memory = "out of memory: choose a smaller --size or a smaller scene";

/// One line on stderr about the exception that is being handled.
void report_exception() {
    try {
        throw;
    } catch (const Error& error) {
        write_remark(error.what());
    } catch (const std::bad_alloc&) {
        write_remark(out_of_memory);
    } catch (const std::system_error& error) { // such as a thread that does not start
        print_remark("the system refuses what is needed ({}): raise its limits on memory and processes",
                     error.what());
    } catch (const std::exception& error) {
        print_remark("an error without a remedy ({}): please report it with the file that causes it",
                     error.what());
    } catch (...) {
        write_remark("an unknown error: please report it with the file that causes it");
    }
}

/// The end of a program whose exception left a thread, or came while another was on its way.
[[noreturn]] void end_by_exception() {
    if (std::current_exception())
        report_exception();
    else
        write_remark("the program cannot go on: please report it with the file that causes it");
    std::_Exit(worlds_fault);
}

std::string limits_help() {
    std::string text = "Limits on what a file may ask for, which --limit NAME=VALUE changes:\n";
    for (const LimitDescription& limit : all_limits)
        text += fmt::format("  {:<12} {:>11}  {}\n", limit.name, limit.value, limit.what);
    return text + "\n";
}

void declare_commands(CLI::App& app) {
    app.set_version_flag("--version", name_and_version());
    app.require_subcommand(1);
    app.add_option_function<std::vector<std::string>>(
           "--limit",
           [](const std::vector<std::string>& texts) {
               for (const std::string& text : texts)
                   if (const std::string problem = set_limit(text); !problem.empty())
                       throw CLI::ValidationError("--limit", problem);
           },
           "allow a file to ask for more, or for less (repeatable; the environment variable STERADIAN_LIMITS "
           "takes the same, separated by commas)")
        ->type_name("NAME=VALUE")
        ->allow_extra_args(false);
    app.fallthrough(); // every command takes it
    app.footer("Examples:\n"
               "  steradian view scene.glb                         a window to look around in\n"
               "  steradian render scene.glb -o picture.png        a picture with automatic exposure\n"
               "  steradian render scene.glb -o radiance.exr       the same, as radiance in cd/m²\n"
               "  steradian probe scene.glb --pixel 640,360        the equation at a pixel, term by term\n"
               "  steradian samples                                bundled scenes to try\n"
               "  steradian doctor                                 whether this machine can render\n"
               "  steradian render --help                          everything that render can do\n\n"
               + limits_help()
               + "Exit status: 0 done, 1 a difference or a failed check, 2 usage, 3 a file, shader or driver "
                 "is at fault.");
    add_view_command(app);
    add_render_command(app);
    add_probe_command(app);
    add_illuminance_command(app);
    add_info_command(app);
    add_doctor_command(app);
    add_expand_command(app);
    add_compare_command(app);
    add_golden_command(app);
    add_export_command(app);
    add_brdf_command(app);
    add_assignment_command(app);
    add_samples_command(app);
    add_completion_command(app);
    add_manual_command(app);
    add_trial_command(app);
}

/// Runs the command that the words name. @return the exit status
int run(int argc, char** argv) {
    CLI::App app{"Steradian: a real-time renderer for direct illumination in physical units.\n"
                 "Every pixel is L_o = L_e + Σ ∫ f_r L_e V cosθ dω, in cd/m²."};
    declare_commands(app);
    try {
        set_limits_from_environment();
        app.parse(argc, argv);
        return done;
    } catch (const CLI::RuntimeError& ended) { // a command's own exit status
        return ended.get_exit_code();
    } catch (const CLI::ParseError& error) {
        std::ostringstream help, complaint;
        if (app.exit(error, help, complaint) == 0) {
            write_output(help.str());
            return done;
        }
        write_remark(error.what());
        write_remark("Run with --help for more information.");
        return usage;
    }
}

} // namespace
} // namespace sr::cli

int main(int argc, char** argv) {
    using namespace sr::cli;
    sr::occupy_standard_streams();
    sr::silence_libraries();
    std::signal(SIGPIPE,
                SIG_IGN); // a reader that leaves is an error of write(), and no reason to lose a picture
    std::set_terminate(end_by_exception);
    int status = worlds_fault;
    try {
        if (argc == 1 && isatty(STDOUT_FILENO)) {
            print_welcome();
            status = done;
        } else {
            status = run(argc, argv);
        }
    } catch (...) {
        report_exception();
    }
    try {
        sr::flush_output();
    } catch (...) {
        if (status != worlds_fault) report_exception();
        status = worlds_fault;
    }
    return status;
}
