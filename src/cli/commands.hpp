#pragma once
// The program's commands. Each adds itself to the command line, and runs when it is parsed there.
// stdout carries data only; progress and remarks go to stderr.
namespace CLI {
class App;
}

namespace sr::cli {

/// Exit status of a command: 0 done, 1 a difference or a failed check, 2 usage, 3 a file, shader or driver is
/// at fault (an Error), 4 a test passed, but only when it was tried again.
enum ExitStatus : int {
    done = 0,
    failed_check = 1,
    usage = 2,
    worlds_fault = 3,
    flaky = 4,
    interrupted = 130
};

void add_view_command(CLI::App& app);
void add_render_command(CLI::App& app);
void add_probe_command(CLI::App& app);
void add_illuminance_command(CLI::App& app);
void add_info_command(CLI::App& app);
void add_doctor_command(CLI::App& app);
void add_expand_command(CLI::App& app);
void add_compare_command(CLI::App& app);
void add_golden_command(CLI::App& app);
void add_export_command(CLI::App& app);
void add_brdf_command(CLI::App& app);
void add_assignment_command(CLI::App& app);
void add_grade_command(CLI::App& app);    // of `assignment`
void add_tick_command(CLI::App& app);     // likewise
void add_likeness_command(CLI::App& app); // likewise
void add_samples_command(CLI::App& app);
void add_completion_command(CLI::App& app);
void add_manual_command(CLI::App& app);
void add_trial_command(CLI::App& app); // hidden: the process of gl::TrialCompiler

/// Prints the answer to `steradian` alone: what it is, first commands, where the bundled scenes are.
void print_welcome();

} // namespace sr::cli
