#include "assignment/check.hpp"

#include "assignment/mark.hpp"
#include "core/error.hpp"
#include "core/limits.hpp"
#include "gl/context.hpp"
#include "golden/process.hpp"

#include <algorithm>
#include <chrono>
#include <cstdlib>
#include <fmt/format.h>
#include <fstream>
#include <nlohmann/json.hpp>
#include <unistd.h>

namespace sr::assignment {
namespace {

using nlohmann::ordered_json;

} // namespace

namespace {

namespace fs = std::filesystem;

/// A folder for the results of children, which goes with it.
struct ResultsFolder {
    fs::path path;

    ResultsFolder() {
        std::string name = (fs::temp_directory_path() / "steradian-check-XXXXXX").string();
        if (!mkdtemp(name.data()))
            throw Error({name}, "cannot be made", "name a folder that can be written in $TMPDIR");
        path = name;
    }
    ~ResultsFolder() {
        std::error_code ignored;
        fs::remove_all(path, ignored);
    }
    ResultsFolder(const ResultsFolder&) = delete;
    ResultsFolder& operator=(const ResultsFolder&) = delete;
};

/// The results that a child has written so far.
class Results {
public:
    Results(fs::path file, const CheckOptions& options, ordered_json& tasks)
        : file_(std::move(file)), options_(options), tasks_(tasks) {}

    /// Takes what is new. Whether nothing new has come for longer than a task may take.
    bool is_standing_still() {
        const std::size_t before = tasks_.size();
        take();
        const auto now = std::chrono::steady_clock::now();
        if (tasks_.size() > before) since_ = now;
        return std::chrono::duration<double>(now - since_).count() > options_.time_limit;
    }

    void take() {
        std::ifstream stream(file_, std::ios::binary);
        stream.seekg(static_cast<std::streamoff>(taken_));
        for (std::string line;
             std::getline(stream, line) && !stream.eof();) { // a last line may be half there
            taken_ += line.size() + 1;
            auto task = ordered_json::parse(line, nullptr, false);
            if (task.is_discarded()) continue;
            if (options_.on_task) options_.on_task(task);
            tasks_.push_back(std::move(task));
        }
    }

private:
    fs::path file_;
    const CheckOptions& options_;
    ordered_json& tasks_;
    std::size_t taken_ = 0;
    std::chrono::steady_clock::time_point since_ = std::chrono::steady_clock::now();
};

std::string first_line(const fs::path& file) {
    std::ifstream stream(file);
    std::string line;
    std::getline(stream, line);
    return line;
}

/// All tasks, or fewer if the check was stopped.
ordered_json marked_by_children(const Assignment& assignment, const fs::path& submission,
                                const CheckOptions& options) {
    const ResultsFolder scratch;
    ordered_json tasks = ordered_json::array();
    while (tasks.size() < assignment.tasks.size() && !options.stop.stop_requested()) {
        const fs::path results = scratch.path / fmt::format("{}.jsonl", tasks.size()),
                       log = scratch.path / "log";
        std::vector<std::string> words{options.program.string(), "assignment", "mark",
                                       fs::absolute(submission).string(), results.string()};
        for (std::size_t i = tasks.size(); i < assignment.tasks.size(); ++i)
            words.push_back(assignment.tasks[i].id);
        if (options.keeps_pictures) words.emplace_back("--pictures");
        Results found(results, options, tasks);
        std::stop_source ending; // of this child
        const std::stop_callback ending_with_check(options.stop, [&] { ending.request_stop(); });
        const auto end =
            golden::run_process({words, fs::current_path(), log, 3600.0, ending.get_token(), [&] {
                                     if (found.is_standing_still()) ending.request_stop();
                                 }});
        found.take();
        if (tasks.size() == assignment.tasks.size() || options.stop.stop_requested()) break;
        if (end.way == golden::ProcessEnd::Way::not_started)
            throw Error("the process that checks " + end.text(), "raise the system's limits on processes");
        if (end.way == golden::ProcessEnd::Way::exited)
            throw Error(first_line(log), "see the assignment's own files");
        const std::string why =
            end.way == golden::ProcessEnd::Way::stopped
                ? fmt::format("its checks took longer than {:g} s and were ended", options.time_limit)
                : "its checks " + end.text();
        tasks.push_back(ended_early(assignment.tasks[tasks.size()], why));
        if (options.on_task) options.on_task(tasks.back());
    }
    return tasks;
}

} // namespace

std::optional<ordered_json> check_submission(const fs::path& submission, const CheckOptions& options) {
    const FolderLabel label = label_of(submission);
    const Assignment assignment = load(assignment_of(label));
    const ordered_json tasks = marked_by_children(assignment, submission, options);
    if (tasks.size() < assignment.tasks.size()) return std::nullopt;
    return sum_of(assignment, label.student, tasks);
}

void mark_tasks(const fs::path& submission, const std::vector<std::string>& tasks, const fs::path& results,
                bool keeps_pictures) {
    const FolderLabel label = label_of(submission);
    const Assignment assignment = load(assignment_of(label));
    const Submission handed_in = read_submission(assignment, submission);
    const auto context = gl::open_context({gl::Backend::automatic, false});
    const MemoryWatch watch(std::uint64_t{4} << 30); // a student's code may ask for any amount
    Marker marker(assignment, label.student, keeps_pictures);
    std::ofstream stream(results, std::ios::app);
    for (const std::string& task : tasks)
        stream << marker.mark(assignment.task(task), handed_in)
                      .dump(-1, ' ', false, ordered_json::error_handler_t::replace)
               << std::endl;
}

namespace {

constexpr int min_mistakes = 6, min_solutions = 2; // of a task

/// Summarises a task's result in one line.
std::string summary(const ordered_json& task) {
    std::string names;
    for (const ordered_json& check : task["checks"])
        if (!check["diagnosis"].is_null() && names.find(check["diagnosis"]["name"]) == std::string::npos)
            names += (names.empty() ? " " : ", ") + check["diagnosis"]["name"].get<std::string>();
    for (const ordered_json& problem : task["problems"]) names += " " + problem["text"].get<std::string>();
    return fmt::format("{:.0f} %{}", 100.0 * task["points"].get<double>() / task["of"].get<double>(), names);
}

Proof proof_of(const Task& task, const Variant& variant, Marker& marker) {
    Submission submission;
    submission.codes[task.id] = {task.variants_place, variant.line, variant.text};
    const ordered_json result = marker.mark(task, submission);
    const bool is_whole = result["status"] == "passed";
    Proof proof{task.id, variant.name, variant.is_mistake ? "loses points, named" : "100 %", summary(result),
                is_whole};
    if (variant.is_mistake) {
        bool is_named = false;
        for (const ordered_json& check : result["checks"])
            if (!check["diagnosis"].is_null()) {
                is_named = check["diagnosis"]["name"] == variant.name;
                break;
            }
        proof.holds = !is_whole && result["problems"].empty() && is_named;
    }
    return proof;
}

} // namespace

std::vector<Proof> proofs_of(const Assignment& assignment) {
    std::vector<Proof> proofs;
    Marker marker(assignment, "reference");
    const Submission empty = empty_submission(assignment);
    Submission reference;
    for (const auto& [name, text] : assignment.files)
        for (const Region& region : regions_of(text, assignment.place_of(name)))
            reference.codes[region.name] = {assignment.place_of(name), region.begin_line + 1, region.text};
    for (const Task& task : assignment.tasks) {
        const ordered_json whole = marker.mark(task, reference), none = marker.mark(task, empty);
        proofs.push_back({task.id, "reference", "100 %", summary(whole), whole["status"] == "passed"});
        proofs.push_back({task.id, "empty", "0 %, not implemented",
                          summary(none) + ", " + none["status"].get<std::string>(),
                          none["status"] == "not implemented"});
        for (const Variant& variant : task.variants) proofs.push_back(proof_of(task, variant, marker));
    }
    return proofs;
}

std::vector<std::string> shortages(const Assignment& assignment) {
    std::vector<std::string> lines;
    for (const Task& task : assignment.tasks) {
        const auto mistakes = std::ranges::count(task.variants, true, &Variant::is_mistake);
        const auto solutions = std::ssize(task.variants) - mistakes;
        if (mistakes < min_mistakes || solutions < min_solutions)
            lines.push_back(fmt::format("{}: {} mistakes and {} other solutions, expected at least {} and {}",
                                        task.id, mistakes, solutions, min_mistakes, min_solutions));
    }
    return lines;
}

} // namespace sr::assignment
