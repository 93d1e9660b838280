#include "assignment/mark.hpp"
#include "assignment/self_test.hpp"
#include "cli/arguments.hpp"
#include "cli/commands.hpp"
#include "core/error.hpp"
#include "core/output.hpp"
#include "gl/context.hpp"
#include "golden/bytes_of_file.hpp"
#include "golden/child.hpp"
#include "image/file.hpp"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <chrono>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <fstream>
#include <iterator>
#include <memory>
#include <nlohmann/json.hpp>
#include <unistd.h>

namespace sr::cli {
namespace {

namespace fs = std::filesystem;
using nlohmann::ordered_json;
constexpr auto replace = ordered_json::error_handler_t::replace;

struct AssignmentArguments {
    std::string name;   // of an assignment, or its folder
    std::string folder; // a student's
    std::string student;
    std::string results; // of a child: where its tasks' results go, one line each
    std::vector<std::string> tasks;
    double time_limit = 20.0; // [s] of one task
    bool json = false;
};

fs::path running_program() {
    std::error_code failure;
    const fs::path program = fs::read_symlink("/proc/self/exe", failure);
    return failure ? fs::path("steradian") : program; // else as it is found in PATH
}

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

/// The whole of a check in this process: each task's result goes to a line of `results` as soon as it is
/// there.
void mark_here(const AssignmentArguments& arguments) {
    const assignment::FolderLabel label = assignment::label_of(arguments.folder);
    const auto assignment = assignment::load(assignment::assignment_named(label.assignment));
    const auto submission = assignment::read_submission(assignment, arguments.folder);
    const auto context = gl::open_context({gl::Backend::automatic, false});
    assignment::Marker marker(assignment, label.student);
    std::ofstream results(arguments.results, std::ios::app);
    for (const std::string& task : arguments.tasks)
        results << marker.mark(assignment.task(task), submission).dump(-1, ' ', false, replace) << std::endl;
}

/// Says so once a file has not grown for as long as a task may take.
class Standstill {
public:
    Standstill(fs::path file, double limit) : file_(std::move(file)), limit_(limit) {}

    bool operator()() {
        std::error_code failure;
        const std::uintmax_t size = fs::file_size(file_, failure);
        const auto now = std::chrono::steady_clock::now();
        if (!failure && size != size_) {
            size_ = size;
            since_ = now;
        }
        return std::chrono::duration<double>(now - since_).count() > limit_;
    }

private:
    fs::path file_;
    double limit_;
    std::uintmax_t size_ = 0;
    std::chrono::steady_clock::time_point since_ = std::chrono::steady_clock::now();
};

/// A folder for the results of children, which goes with it.
struct ResultsFolder {
    fs::path path = fs::temp_directory_path() / fmt::format("steradian-check-{}", getpid());

    ResultsFolder() { fs::create_directories(path); }
    ~ResultsFolder() {
        std::error_code ignored;
        fs::remove_all(path, ignored);
    }
    ResultsFolder(const ResultsFolder&) = delete;
    ResultsFolder& operator=(const ResultsFolder&) = delete;
};

ordered_json results_in(const fs::path& file) {
    ordered_json tasks = ordered_json::array();
    std::ifstream stream(file);
    for (std::string line; std::getline(stream, line);)
        if (auto task = ordered_json::parse(line, nullptr, false); !task.is_discarded())
            tasks.push_back(std::move(task));
    return tasks;
}

/// Marks in child processes: a shader that hangs or kills the driver costs its own task.
ordered_json marked_by_children(const AssignmentArguments& arguments,
                                const assignment::Assignment& assignment) {
    const ResultsFolder scratch;
    ordered_json tasks = ordered_json::array();
    while (tasks.size() < assignment.tasks.size()) {
        const fs::path results = scratch.path / fmt::format("{}.jsonl", tasks.size()),
                       log = scratch.path / "log";
        std::vector<std::string> words{running_program().string(), "assignment", "mark",
                                       fs::absolute(arguments.folder).string(), results.string()};
        for (std::size_t i = tasks.size(); i < assignment.tasks.size(); ++i)
            words.push_back(assignment.tasks[i].id);
        const auto end = golden::run_child(
            {words, fs::current_path(), log, 3600.0, Standstill(results, arguments.time_limit)});
        for (ordered_json& task : results_in(results)) tasks.push_back(std::move(task));
        if (end.is_success()) break;
        if (end.way == golden::ChildEnd::Way::exited) {
            std::ifstream stream(log);
            std::string line;
            std::getline(stream, line);
            throw Error(line, "see the assignment's own files");
        }
        if (tasks.size() == assignment.tasks.size()) break;
        const std::string why =
            end.way == golden::ChildEnd::Way::stopped
                ? fmt::format("its checks took longer than {:g} s and were ended", arguments.time_limit)
                : "its checks " + end.text();
        tasks.push_back(assignment::ended_early(assignment.tasks[tasks.size()], why));
    }
    return tasks;
}

ExitStatus check(const AssignmentArguments& arguments) {
    const assignment::FolderLabel label = assignment::label_of(arguments.folder);
    const auto assignment = assignment::load(assignment::assignment_named(label.assignment));
    const ordered_json result =
        assignment::summed(assignment, label.student, marked_by_children(arguments, assignment));
    print_data("{}",
               arguments.json ? result.dump(2, ' ', false, replace) + "\n" : assignment::table_of(result));
    const bool is_whole = std::ranges::all_of(result["tasks"], [](const ordered_json& task) {
        return task["extra"].get<bool>() || task["status"] == "passed";
    });
    return is_whole ? done : failed_check;
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

void add_check(CLI::App& app, const std::shared_ptr<AssignmentArguments>& arguments) {
    CLI::App* command = app.add_subcommand("check", "check a student's folder: marks, what is wrong, hints");
    command->add_option("DIR", arguments->folder, "a folder that `new` made")->required();
    command->add_option("--time-limit", arguments->time_limit, "of one task [s]")
        ->check(refusal_of_number)
        ->check(CLI::Range(0.1, 3600.0))
        ->capture_default_str();
    command->add_flag("--json", arguments->json,
                      "print JSON (its schema is assets/assignment_result.schema.json)");
    command->footer("Exit status 0 only if every task that is not extra has all its points.");
    command->callback([arguments] { end_with(check(*arguments)); });
}

} // namespace

void add_assignment_command(CLI::App& app) {
    const auto arguments = std::make_shared<AssignmentArguments>();
    CLI::App* command = app.add_subcommand("assignment", "the equation as a course: tasks in GLSL, checked");
    command->require_subcommand(1);
    command->add_subcommand("list", "the assignments there are")->callback(list_assignments);
    CLI::App* making = command->add_subcommand("new", "make a student's folder");
    add_name(*making, *arguments);
    making->add_option("DIR", arguments->folder, "a new folder")->required();
    making->add_option("--student", arguments->student,
                       "the student's id, which chooses the numbers that are theirs");
    making->callback([arguments] { make_new(*arguments); });
    add_check(*command, arguments);
    CLI::App* building =
        command->add_subcommand("build", "for teachers: cut the student's version, without an id");
    add_name(*building, *arguments);
    building->add_option("OUT", arguments->folder, "a new folder")->required();
    building->callback([arguments] { build(*arguments); });
    CLI::App* testing = command->add_subcommand(
        "test", "for teachers: prove that the reference gets 100 %, nothing 0 %, and mistakes their names");
    add_name(*testing, *arguments);
    testing->callback([arguments] { end_with(prove(*arguments)); });
    CLI::App* marking = command->add_subcommand("mark", "what `check` runs as a child")->group("");
    marking->add_option("DIR", arguments->folder)->required();
    marking->add_option("RESULTS", arguments->results)->required();
    marking->add_option("TASKS", arguments->tasks)->required();
    marking->callback([arguments] { mark_here(*arguments); });
    command->footer(
        "Examples:\n  steradian assignment list\n  steradian assignment new a3 my-a3 --student 12345\n"
        "  steradian assignment check my-a3");
}

} // namespace sr::cli
