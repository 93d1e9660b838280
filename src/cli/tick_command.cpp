// `assignment tick`: the sheet of an oral examination.
#include "assignment/tick.hpp"
#include "cli/arguments.hpp"
#include "cli/commands.hpp"
#include "cli/interruption.hpp"
#include "cli/version.hpp"
#include "core/output.hpp"
#include "image/whole_file.hpp"

#include <CLI/CLI.hpp>
#include <fmt/format.h>
#include <memory>
#include <nlohmann/json.hpp>

namespace sr::cli {
namespace {

using nlohmann::ordered_json;

struct TickArguments {
    std::string submission, assignment, seed, student, output;
    double time_limit = 60.0; // [s] of one task, and of one question
    bool json = false;
};

ExitStatus tick(const TickArguments& arguments) {
    const std::string output = arguments.output.empty() ? "tick.html" : arguments.output;
    image::require_writable(output);
    const Interruption interruption;
    const std::string name =
        arguments.assignment.empty()
            ? assignment::assignment_of(assignment::label_of(arguments.submission)).string()
            : assignment::assignment_named(arguments.assignment).string();
    assignment::CheckOptions options;
    options.program = running_program();
    options.time_limit = arguments.time_limit;
    options.stop = interruption.token();
    options.grading.emplace();
    options.grading->assignment = std::filesystem::absolute(name);
    options.grading->student = arguments.student;
    const auto examination = assignment::examine(arguments.submission, options, arguments.seed);
    if (!examination) return interrupted;
    for (const char* key : {"refused", "missing"})
        for (const ordered_json& line : (*examination)[key]) write_remark(line.get<std::string>());
    image::write_text(output, assignment::tick_html(*examination));
    if (arguments.json)
        write_json(examination->dump(2, ' ', false, ordered_json::error_handler_t::replace));
    else
        print_data("{}: {} questions\n", output, (*examination)["questions"].size());
    return done;
}

} // namespace

void add_tick_command(CLI::App& app) {
    const auto arguments = std::make_shared<TickArguments>();
    CLI::App* command = app.add_subcommand("tick", "for teachers: a sheet for an oral examination, with "
                                                   "questions about this submission and their answers");
    command->add_option("DIR", arguments->submission, "a student's folder, or a file that `pack` made")
        ->required();
    command->add_option("-o,--output", arguments->output, "the HTML page (default: tick.html)");
    command->add_option("--seed", arguments->seed,
                        "any text, which chooses the questions (default: the student's id)");
    command->add_option("--assignment", arguments->assignment,
                        "examine it as this assignment, whatever it says that it is");
    command->add_option("--student", arguments->student, "id of a student whose folder has none");
    command->add_option("--time-limit", arguments->time_limit, "of one task, and of one question [s]")
        ->check(refusal_of_number)
        ->check(CLI::Range(0.1, 3600.0))
        ->capture_default_str();
    command->add_flag("--json", arguments->json, "print marks, questions and answers as JSON, too");
    command->footer("The submission runs confined, as with `grade`.\n\nExamples:\n"
                    "  steradian assignment tick my-a3 -o tick.html\n"
                    "  steradian assignment tick my-a3 --seed second-try\n"
                    "  steradian view --assignment my-a3 --tick        (the questions, live)");
    command->callback([arguments] {
        if (const ExitStatus status = tick(*arguments); status != done) throw CLI::RuntimeError(status);
    });
}

} // namespace sr::cli
