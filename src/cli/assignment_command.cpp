#include "assignment/check.hpp"
#include "assignment/class_report.hpp"
#include "assignment/mark.hpp"
#include "cli/arguments.hpp"
#include "cli/commands.hpp"
#include "cli/interruption.hpp"
#include "cli/version.hpp"
#include "core/error.hpp"
#include "core/output.hpp"
#include "core/text.hpp"
#include "gl/context.hpp"
#include "image/whole_file.hpp"
#include "viewer/document/watch.hpp"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cctype>
#include <fmt/format.h>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>
#include <stop_token>
#include <thread>

namespace sr::cli {
namespace {

namespace fs = std::filesystem;
using nlohmann::ordered_json;
constexpr auto replace = ordered_json::error_handler_t::replace;

struct AssignmentArguments {
    std::string name;   // of an assignment, or its folder
    std::string folder; // a student's
    std::string student;
    std::string output;       // of `pack`; empty: named by assignment and student
    std::string report;       // HTML; empty: none
    std::string graded_as;    // an assignment; empty: the one that the folder's label names
    std::string hidden;       // folder of hidden checks; empty: none
    std::string gradescope;   // results.json; empty: none
    std::string junit;        // XML; empty: none
    double vpl = 0.0;         // the highest grade; 0: a table is printed
    double time_limit = 20.0; // [s] of one task
    bool json = false;
    bool watch = false;
};

void list_assignments() {
    std::vector<fs::path> folders;
    for (const auto& entry : fs::directory_iterator(assignment::assignments_folder()))
        if (fs::exists(entry.path() / "assignment.json")) folders.push_back(entry.path());
    std::ranges::sort(folders);
    for (const fs::path& folder : folders) {
        const assignment::Assignment a = assignment::load(folder);
        print_data("{:<16} {:3g} points  {}: {}\n", a.id, a.points(), a.title, a.summary);
    }
}

void make_new(const AssignmentArguments& arguments) {
    const auto assignment = assignment::load(assignment::assignment_named(arguments.name));
    assignment::make_folder(assignment, arguments.folder, arguments.student);
    print_remark("{}: read README.md, edit the .glsl files, then: steradian assignment check {}",
                 arguments.folder, arguments.folder);
}

assignment::CheckOptions options_of(const AssignmentArguments& arguments) {
    assignment::CheckOptions options;
    options.program = running_program();
    options.time_limit = arguments.time_limit;
    options.keeps_pictures = !arguments.report.empty() || !arguments.gradescope.empty();
    if (arguments.graded_as.empty()) return options;
    assignment::Grading grading;
    grading.assignment = fs::absolute(assignment::assignment_named(arguments.graded_as));
    if (!arguments.hidden.empty()) grading.hidden = fs::absolute(arguments.hidden);
    grading.student = arguments.student;
    options.grading = grading;
    return options;
}

void write_gradescope(const std::string& file, const ordered_json& result) {
    image::write_text(file, assignment::gradescope_of(result).dump(1, ' ', false, replace) + "\n");
}

/// Writes the tasks that are marked so far whenever one is, so that a run that is ended leaves a result.
void write_partial_results(assignment::CheckOptions& options, const std::string& file) {
    const auto partial = std::make_shared<ordered_json>(
        ordered_json{{"points", 0.0}, {"of", 0.0}, {"tasks", ordered_json::array()}});
    options.on_task = [partial, file](const ordered_json& task) {
        (*partial)["tasks"].push_back(task);
        (*partial)["points"] = (*partial)["points"].get<double>() + task["points"].get<double>();
        if (!task["extra"].get<bool>())
            (*partial)["of"] = (*partial)["of"].get<double>() + task["of"].get<double>();
        write_gradescope(file, *partial);
    };
}

/// Prints a result and writes the report. Whether every task that is not extra has all its points.
bool show(const ordered_json& result, const AssignmentArguments& arguments) {
    const ordered_json bare = assignment::without_pictures(result);
    if (arguments.vpl > 0.0)
        print_data("{}", assignment::vpl_of(bare, arguments.vpl));
    else if (arguments.json)
        print_data("{}\n", shown_json(bare.dump(arguments.watch ? -1 : 2, ' ', false, replace)));
    else
        print_data("{}", shown_lines(assignment::table_of(bare))); // it quotes the student's lines
    flush_output();
    if (!arguments.report.empty()) image::write_text(arguments.report, assignment::report_html(result));
    if (!arguments.junit.empty()) image::write_text(arguments.junit, assignment::junit_of({bare}));
    if (!arguments.gradescope.empty()) write_gradescope(arguments.gradescope, result);
    return std::ranges::all_of(result["tasks"], [](const ordered_json& task) {
        return task["extra"].get<bool>() || task["status"] == "passed";
    });
}

ExitStatus check_once(const AssignmentArguments& arguments) {
    const Interruption interruption;
    assignment::CheckOptions options = options_of(arguments);
    options.stop = interruption.token();
    if (!arguments.gradescope.empty()) write_partial_results(options, arguments.gradescope);
    const auto result = assignment::check_submission(arguments.folder, options);
    if (!result) return interrupted;
    for (const ordered_json& line : result->value("refused", ordered_json::array()))
        write_remark(line.get<std::string>());
    return show(*result, arguments) ? done : failed_check;
}

/// Checks again whenever the student saves, until Ctrl-C. A save during a check restarts it.
ExitStatus check_and_watch(const AssignmentArguments& arguments) {
    const Interruption interruption;
    viewer::Watch saves;
    saves.set(assignment::files_of(arguments.folder));
    assignment::CheckOptions options = options_of(arguments);
    options.on_task = [](const ordered_json& task) {
        print_remark("  {} {:g}/{:g} {}", task["id"].get<std::string>(), task["points"].get<double>(),
                     task["of"].get<double>(), task["status"].get<std::string>());
    };
    while (!interruption.has_come()) {
        std::stop_source ending; // of this check, by a save or by Ctrl-C
        const std::stop_callback on_interruption(interruption.token(), [&] { ending.request_stop(); });
        const std::jthread watching([&](const std::stop_token& end) {
            while (!end.stop_requested() && !ending.stop_requested()) {
                std::this_thread::sleep_for(std::chrono::milliseconds(50));
                if (saves.has_changed()) ending.request_stop();
            }
        });
        options.stop = ending.get_token();
        print_remark("checking {}", arguments.folder);
        if (const auto result = assignment::check_submission(arguments.folder, options)) {
            show(*result, arguments);
            print_remark("saving a file checks again; Ctrl-C ends");
        }
        while (!ending.stop_requested()) std::this_thread::sleep_for(std::chrono::milliseconds(50));
    }
    return done;
}

/// "a3-brdf-12345.zip"; what no file name should have becomes "_".
std::string archive_name(const assignment::FolderLabel& label) {
    std::string name = label.assignment + (label.student.empty() ? "" : "-" + label.student);
    for (char& c : name)
        if (!std::isalnum(static_cast<unsigned char>(c)) && c != '-' && c != '.' && c != '_') c = '_';
    return name + ".zip";
}

/// Returns the result of the student's own check; absent, with a remark, where it cannot run.
std::optional<ordered_json> own_result(const AssignmentArguments& arguments) {
    try {
        return assignment::check_submission(arguments.folder, options_of(arguments));
    } catch (const Error& error) {
        print_remark("packed without a check: {}", error.what());
        return std::nullopt;
    }
}

void pack(const AssignmentArguments& arguments) {
    const assignment::FolderLabel label = assignment::label_of(arguments.folder);
    const std::string archive = arguments.output.empty() ? archive_name(label) : arguments.output;
    const auto result = own_result(arguments);
    assignment::pack(arguments.folder, result ? result->dump(2, ' ', false, replace) + "\n" : "", archive);
    if (!result) return print_data("{}\n", archive);
    for (const ordered_json& task : (*result)["tasks"])
        print_data("{} {:g}/{:g} {}\n", task["id"].get<std::string>(), task["points"].get<double>(),
                   task["of"].get<double>(), task["status"].get<std::string>());
    print_data("{}: {:g} of {:g} points\n", archive, (*result)["points"].get<double>(),
               (*result)["of"].get<double>());
}

ExitStatus prove(const AssignmentArguments& arguments) {
    const auto assignment = assignment::load(assignment::assignment_named(arguments.name));
    const auto context = gl::open_context({gl::Backend::automatic, true});
    const auto proofs = assignment::proofs_of(assignment);
    context->require_silence();
    print_data("| task | submission | must get | gets | |\n|---|---|---|---|---|\n");
    for (const assignment::Proof& proof : proofs)
        print_data("| {} | {} | {} | {} | {} |\n", proof.task, proof.name, proof.must, proof.got,
                   proof.holds ? "ok" : "**WRONG**");
    const auto shortages = assignment::shortages(assignment);
    for (const std::string& line : shortages) print_remark("{}: {}", assignment.id, line);
    return shortages.empty() && std::ranges::all_of(proofs, &assignment::Proof::holds) ? done : failed_check;
}

void build(const AssignmentArguments& arguments) {
    const auto assignment = assignment::load(assignment::assignment_named(arguments.name));
    for (const auto& [name, text] : assignment.files) assignment::student_version(assignment, name);
    assignment::make_folder(assignment, arguments.folder, "");
}

/// Runs what gives an exit status, and ends the program with it unless it is 0.
void end_with(ExitStatus status) {
    if (status != done) throw CLI::RuntimeError(status);
}

void add_name(CLI::App& command, AssignmentArguments& arguments) {
    command.add_option("NAME", arguments.name, "an assignment (a3, a3-brdf) or its folder")->required();
}

/// The hidden command that `check` and `grade` run as a child.
void add_marking(CLI::App& app) {
    const auto request = std::make_shared<assignment::MarkRequest>();
    const auto grading = std::make_shared<assignment::Grading>();
    CLI::App* marking = app.add_subcommand("mark", "what `check` runs as a child")->group("");
    marking->add_option("DIR", request->submission)->required();
    marking->add_option("RESULTS", request->results)->required();
    marking->add_option("TASKS", request->tasks)->required();
    marking->add_flag("--pictures", request->keeps_pictures);
    const CLI::Option* graded = marking->add_option("--assignment", grading->assignment);
    marking->add_option("--hidden", grading->hidden);
    marking->add_option("--student", grading->student);
    marking->add_option("--memory", grading->memory);
    marking->add_option("--values", grading->values.file);
    marking->add_option("--digest", grading->values.digest);
    marking->add_option("--seconds", request->processor_seconds);
    const auto seed = std::make_shared<std::string>();
    const CLI::Option* examined = marking->add_option("--tick", *seed);
    marking->callback([=] {
        if (examined->count() > 0) request->tick_seed = *seed;
        if (graded->count() > 0) request->grading = *grading;
        assignment::mark_tasks(*request);
    });
}

/// The hidden command that `grade` runs before all submissions.
void add_references(CLI::App& app) {
    const auto grading = std::make_shared<assignment::Grading>();
    const auto file = std::make_shared<std::filesystem::path>();
    CLI::App* command = app.add_subcommand("references", "what `grade` runs first")->group("");
    command->add_option("DIR", grading->assignment)->required();
    command->add_option("FILE", *file)->required();
    command->add_option("--hidden", grading->hidden);
    const CLI::Option* mistakes = command->add_flag("--mistakes");
    command->callback([=] { assignment::compute_references(*grading, *file, mistakes->count() > 0); });
}

void add_check(CLI::App& app, const std::shared_ptr<AssignmentArguments>& arguments) {
    CLI::App* command = app.add_subcommand("check", "check a student's folder: marks, what is wrong, hints");
    command->add_option("DIR", arguments->folder, "a folder that `new` made, or a file that `pack` made")
        ->required();
    command->add_option("--time-limit", arguments->time_limit, "of one task [s]")
        ->check(refusal_of_number)
        ->check(CLI::Range(0.1, 3600.0))
        ->capture_default_str();
    command->add_flag("--json", arguments->json,
                      "print JSON (its schema is assets/assignment_result.schema.json)");
    command->add_option("--report", arguments->report, "write an HTML page with pictures to this file");
    command->add_flag("--watch", arguments->watch,
                      "check again whenever a file is saved, until Ctrl-C; JSON is one line a check");
    const auto assignment = command->add_option(
        "--assignment", arguments->graded_as,
        "for teachers: mark it as this assignment, whatever it says that it is, confined as by `grade`");
    command
        ->add_option("--hidden", arguments->hidden,
                     "folder with hidden.json: checks that show only whether they pass")
        ->type_name("DIR")
        ->needs(assignment);
    command->add_option("--student", arguments->student, "id of a student whose folder has none")
        ->needs(assignment);
    command->add_option("--gradescope", arguments->gradescope,
                        "write Gradescope's results.json to this file, after each task");
    command->add_option("--junit", arguments->junit, "write JUnit XML to this file");
    command
        ->add_option("--vpl", arguments->vpl,
                     "print comments and a grade up to this one, as Moodle's VPL reads them")
        ->check(CLI::Range(0.01, 1e6));
    command->footer("Exit status 0 only if every task that is not extra has all its points.");
    command->callback(
        [arguments] { end_with(arguments->watch ? check_and_watch(*arguments) : check_once(*arguments)); });
}

} // namespace

void add_assignment_command(CLI::App& app) {
    const auto arguments = std::make_shared<AssignmentArguments>();
    CLI::App* command =
        app.add_subcommand("assignment", "take or run the course: tasks in GLSL, with checks");
    command->require_subcommand(1);
    command->add_subcommand("list", "list the assignments")->callback(list_assignments);
    CLI::App* making = command->add_subcommand("new", "make a student's folder");
    add_name(*making, *arguments);
    making->add_option("DIR", arguments->folder, "a new folder")->required();
    making->add_option("--student", arguments->student,
                       "the student's id, which chooses this student's numbers");
    making->callback([arguments] { make_new(*arguments); });
    add_check(*command, arguments);
    CLI::App* packing = command->add_subcommand("pack", "make the file to hand in, and print its points");
    packing->add_option("DIR", arguments->folder, "a folder that `new` made")->required();
    packing->add_option("-o,--output", arguments->output,
                        "a .zip file (default: ASSIGNMENT-STUDENT.zip here)");
    packing->callback([arguments] { pack(*arguments); });
    CLI::App* building =
        command->add_subcommand("build", "for teachers: cut the student's version, without an id");
    add_name(*building, *arguments);
    building->add_option("OUT", arguments->folder, "a new folder")->required();
    building->callback([arguments] { build(*arguments); });
    CLI::App* testing = command->add_subcommand(
        "test", "for teachers: prove that the reference gets 100 %, nothing 0 %, and mistakes their names");
    add_name(*testing, *arguments);
    testing->callback([arguments] { end_with(prove(*arguments)); });
    add_marking(*command);
    add_references(*command);
    add_grade_command(*command);
    add_tick_command(*command);
    add_likeness_command(*command);
    command->footer(
        "Examples:\n  steradian assignment list\n  steradian assignment new a3 my-a3 --student 12345\n"
        "  steradian assignment check my-a3 --watch\n  steradian assignment pack my-a3");
}

} // namespace sr::cli
