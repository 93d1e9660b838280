// `assignment grade`: a class at once.
#include "assignment/grade.hpp"
#include "cli/arguments.hpp"
#include "cli/commands.hpp"
#include "cli/interruption.hpp"
#include "cli/progress.hpp"
#include "cli/version.hpp"
#include "core/error.hpp"
#include "core/output.hpp"
#include "core/text.hpp"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cerrno>
#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <fmt/format.h>
#include <memory>
#include <nlohmann/json.hpp>
#include <thread>
#include <unistd.h>
#include <vector>

namespace sr::cli {
namespace {

using nlohmann::ordered_json;

struct GradeArguments {
    std::string assignment, submissions, output, hidden;
    int jobs = 0;             // 0: one for each processor
    double time_limit = 20.0; // [s] of one task
    int memory = 2048;        // [MiB]
    std::string dask;         // address of a scheduler; empty: this machine alone
    bool lists = false;       // what is not graded yet
};

assignment::GradeOptions options_of(const GradeArguments& arguments) {
    assignment::GradeOptions options;
    options.submissions = arguments.submissions;
    options.output = arguments.output;
    options.check.program = running_program();
    options.check.time_limit = arguments.time_limit;
    assignment::Grading grading;
    grading.assignment = std::filesystem::absolute(assignment::assignment_named(arguments.assignment));
    if (!arguments.hidden.empty()) grading.hidden = std::filesystem::absolute(arguments.hidden);
    grading.memory = static_cast<std::uint64_t>(arguments.memory) << 20;
    options.check.grading = grading;
    return options;
}

/// Prints what a cluster needs to know of each submission that is not graded yet.
void list_ungraded(const GradeArguments& arguments) {
    const assignment::GradeOptions options = options_of(arguments);
    ordered_json list = ordered_json::array();
    for (const auto& [submission, fingerprint] : assignment::ungraded(options))
        list.push_back({{"key", submission.key},
                        {"name", submission.name},
                        {"id", submission.id},
                        {"path", std::filesystem::absolute(submission.path).string()},
                        {"fingerprint", fingerprint}});
    const ordered_json all{{"assignment", options.check.grading->assignment.string()}, {"ungraded", list}};
    print_data("{}\n", shown_json(all.dump(-1, ' ', false, ordered_json::error_handler_t::replace)));
}

/// Replaces this process by the Python program that grades on a cluster. @throws Error if it cannot
[[noreturn]] void run_on_cluster(const GradeArguments& arguments) {
    std::vector<std::string> words{"python3",       cluster_folder().string(),
                                   "grade",         arguments.assignment,
                                   "--submissions", arguments.submissions,
                                   "--out",         arguments.output,
                                   "--scheduler",   arguments.dask,
                                   "--program",     running_program().string(),
                                   "--time-limit",  fmt::format("{}", arguments.time_limit),
                                   "--memory",      fmt::format("{}", arguments.memory)};
    if (!arguments.hidden.empty()) words.insert(words.end(), {"--hidden", arguments.hidden});
    std::vector<char*> pointers;
    for (std::string& word : words) pointers.push_back(word.data());
    pointers.push_back(nullptr);
    flush_output();
    execvp(pointers[0], pointers.data());
    throw Error({"python3"}, fmt::format("cannot be run ({})", std::strerror(errno)), "install Python 3");
}

ExitStatus grade(const GradeArguments& arguments) {
    if (arguments.lists) return list_ungraded(arguments), done;
    if (!arguments.dask.empty()) run_on_cluster(arguments);
    const Interruption interruption;
    assignment::GradeOptions options = options_of(arguments);
    const auto processors = std::max(1u, std::thread::hardware_concurrency());
    options.jobs = arguments.jobs > 0 ? arguments.jobs : static_cast<int>(processors);
    // Processors are shared by the children, not fought for. llvmpipe reads this.
    setenv("LP_NUM_THREADS",
           std::to_string(std::max(1u, processors / static_cast<unsigned>(options.jobs))).c_str(), 0);
    options.check.stop = interruption.token();
    Progress progress("grading");
    std::size_t count_done = 0;
    options.on_done = [&](std::size_t count, std::size_t all, const ordered_json& result) {
        count_done = count;
        progress.update(static_cast<double>(count) / static_cast<double>(all),
                        fmt::format("{} of {}, {}", count, all, result["key"].get<std::string>()));
    };
    options.on_remark = [](const std::string& line) { write_remark(line); };
    const auto results = assignment::grade_class(options);
    if (!results) {
        print_remark("{}: {} graded; the same command goes on from there", arguments.output, count_done);
        return interrupted;
    }
    for (const ordered_json& result : *results) {
        print_data("{} {:g}/{:g}\n", result["key"].get<std::string>(), result["points"].get<double>(),
                   result["of"].get<double>());
        for (const ordered_json& line : result["refused"])
            print_remark("{}: {}", result["key"].get<std::string>(), line.get<std::string>());
    }
    print_data("{}\n", (std::filesystem::path(arguments.output) / "overview.html").string());
    return ExitStatus::done;
}

/// The hidden command that workers of a cluster run.
void add_grading_of_one(CLI::App& app) {
    const auto arguments = std::make_shared<GradeArguments>();
    const auto one = std::make_shared<assignment::UngradedSubmission>();
    const auto values = std::make_shared<assignment::ReferenceFile>();
    CLI::App* command = app.add_subcommand("grade-one", "what workers of a cluster run")->group("");
    command->add_option("NAME", arguments->assignment)->required();
    command->add_option("SUBMISSION", one->submission.path)->required();
    command->add_option("--key", one->submission.key)->required();
    command->add_option("--name", one->submission.name);
    command->add_option("--id", one->submission.id);
    command->add_option("--fingerprint", one->fingerprint)->required();
    command->add_option("--out", arguments->output)->required();
    command->add_option("--hidden", arguments->hidden);
    command->add_option("--time-limit", arguments->time_limit);
    command->add_option("--memory", arguments->memory);
    command->add_option("--values", values->file);
    command->callback([=] {
        const Interruption interruption;
        assignment::CheckOptions check = options_of(*arguments).check;
        check.stop = interruption.token();
        if (!values->file.empty())
            check.grading->values = {std::filesystem::absolute(values->file),
                                     assignment::digest_of(values->file)};
        if (!assignment::grade_one(*one, check, arguments->output)) throw CLI::RuntimeError(interrupted);
    });
}

} // namespace

void add_grade_command(CLI::App& app) {
    const auto arguments = std::make_shared<GradeArguments>();
    CLI::App* command = app.add_subcommand(
        "grade", "for teachers: mark a class, each submission confined in a process of its own");
    command->add_option("NAME", arguments->assignment, "an assignment (a3, a3-brdf) or its folder")
        ->required();
    command
        ->add_option("--submissions", arguments->submissions,
                     "folder of the submissions: folders or zip files, as Moodle or Gradescope download them")
        ->required()
        ->type_name("DIR");
    command
        ->add_option("--out", arguments->output,
                     "folder for marks.csv, overview.html, students/, gradescope/ and junit.xml; what it "
                     "holds is not graded again")
        ->required()
        ->type_name("DIR");
    command
        ->add_option("--hidden", arguments->hidden,
                     "folder with hidden.json: checks of which students learn only whether they pass")
        ->type_name("DIR");
    command->add_option("--jobs", arguments->jobs, "submissions at a time (default: one for each processor)")
        ->check(CLI::Range(1, 256));
    command->add_option("--time-limit", arguments->time_limit, "of one task [s]")
        ->check(refusal_of_number)
        ->check(CLI::Range(0.1, 3600.0))
        ->capture_default_str();
    command->add_option("--memory", arguments->memory, "of one submission [MiB]")
        ->check(CLI::Range(64, 65536))
        ->capture_default_str();
    command
        ->add_option(
            "--dask", arguments->dask,
            "grade on the workers of this Dask scheduler, e.g. tcp://host:8786 (Python package distributed)")
        ->type_name("ADDRESS");
    command->add_flag("--list", arguments->lists, "print what is not graded yet as JSON, and grade nothing");
    add_grading_of_one(app);
    command->footer(
        "After Ctrl-C, or if it was killed, the same command goes on with what is not graded yet.\n\n"
        "Example:\n  steradian assignment grade a3 --submissions downloads --out marks --hidden secret "
        "--jobs 2");
    command->callback([arguments] {
        if (const ExitStatus status = grade(*arguments); status != done) throw CLI::RuntimeError(status);
    });
}

} // namespace sr::cli
