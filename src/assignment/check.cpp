#include "assignment/check.hpp"

#include "assignment/confinement.hpp"
#include "assignment/mark.hpp"
#include "assignment/tick.hpp"
#include "core/error.hpp"
#include "core/file.hpp"
#include "core/limits.hpp"
#include "core/program.hpp"
#include "core/text.hpp"
#include "gl/context.hpp"
#include "golden/process.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdlib>
#include <fmt/format.h>
#include <fstream>
#include <iterator>
#include <nlohmann/json.hpp>
#include <unistd.h>
#include <utility>

namespace sr::assignment {
namespace {

using nlohmann::ordered_json;

namespace fs = std::filesystem;

/// The path of the submission in texts becomes its name, or nothing before a file in it.
void leave_out_path(ordered_json& json, const std::string& path, const std::string& name) {
    if (json.is_structured()) {
        for (ordered_json& part : json) leave_out_path(part, path, name);
    } else if (json.is_string()) {
        auto text = json.get<std::string>();
        for (std::size_t at = 0; (at = text.find(path, at)) != std::string::npos;) {
            const bool is_file_within = text[at + path.size()] == '/';
            text.replace(at, path.size() + (is_file_within ? 1 : 0), is_file_within ? "" : name);
        }
        json = text;
    }
}

/// The results of all children.
struct Marked {
    ordered_json tasks = ordered_json::array();
    ordered_json intake = ordered_json::object();
};

/// The results that a child has written so far.
class Results {
public:
    Results(fs::path file, fs::path submission, const CheckOptions& options, Marked& marked)
        : file_(std::move(file)), submission_(std::move(submission)), options_(options), marked_(marked) {}

    /// Takes what is new. Whether nothing new has come for longer than a task may take.
    bool is_standing_still() {
        const std::size_t before = taken_;
        take();
        const auto now = std::chrono::steady_clock::now();
        if (taken_ > before) since_ = now;
        return std::chrono::duration<double>(now - since_).count() > options_.time_limit;
    }

    void take() {
        std::error_code ignored;
        if (!fs::is_regular_file(fs::symlink_status(file_, ignored))) return; // a pipe would block
        std::ifstream stream(file_, std::ios::binary);
        stream.seekg(static_cast<std::streamoff>(taken_));
        for (std::string line;
             std::getline(stream, line) && !stream.eof();) { // a last line may be half there
            taken_ += line.size() + 1;
            auto found = ordered_json::parse(line, nullptr, false);
            if (found.is_discarded()) continue;
            if (options_.grading) // messages show names as terminals may
                for (const bool is_shown : {false, true})
                    leave_out_path(found, is_shown ? shown(submission_.string()) : submission_.string(),
                                   shown(submission_.filename().string()));
            if (found.contains("intake")) {
                marked_.intake = std::move(found["intake"]);
                continue;
            }
            if (options_.on_task) options_.on_task(found);
            marked_.tasks.push_back(std::move(found));
        }
    }

private:
    fs::path file_;
    fs::path submission_;
    const CheckOptions& options_;
    Marked& marked_;
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
Marked marked_by_children(const Assignment& assignment, const fs::path& submission,
                          const CheckOptions& options) {
    const ScratchFolder scratch("check");
    const fs::path results = scratch.path() / "results"; // children write here and nowhere else
    fs::create_directory(results);
    Marked marked;
    ordered_json& tasks = marked.tasks;
    while (tasks.size() < assignment.tasks.size() && !options.stop.stop_requested()) {
        const fs::path log = scratch.path() / "log";
        MarkRequest request{fs::absolute(submission),
                            results / fmt::format("{}.jsonl", tasks.size()),
                            {},
                            options.keeps_pictures,
                            options.grading};
        for (std::size_t i = tasks.size(); i < assignment.tasks.size(); ++i)
            request.tasks.push_back(assignment.tasks[i].id);
        request.processor_seconds =
            static_cast<int>(std::ceil(4.0 * options.time_limit * static_cast<double>(request.tasks.size())));
        std::vector<std::string> words{options.program.string()};
        std::ranges::copy(words_of(request), std::back_inserter(words));
        Results found(request.results, request.submission, options, marked);
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
        const bool has_failed = end.way == golden::ProcessEnd::Way::exited; // at a file of the assignment
        if (has_failed && !options.grading) throw Error(first_line(log), "see the assignment's own files");
        // In a class one submission must not end the others', and the log has paths that no student is to
        // see.
        const std::string why =
            end.way == golden::ProcessEnd::Way::stopped
                ? fmt::format("its checks took longer than {:g} s and were ended", options.time_limit)
            : has_failed ? "with it, files of the assignment are at fault (an include cycle, perhaps)"
                         : "its checks " + end.text();
        tasks.push_back(ended_early(assignment.tasks[tasks.size()], why));
        if (options.on_task) options.on_task(tasks.back());
    }
    return marked;
}

/// The assignment with the checks that are hidden.
Assignment graded_assignment(const Grading& grading) {
    Assignment assignment = load(grading.assignment);
    if (!grading.hidden.empty()) add_hidden_checks(assignment, grading.hidden);
    return assignment;
}

} // namespace

std::optional<ordered_json> check_submission(const fs::path& submission, const CheckOptions& options) {
    FolderLabel label;
    if (!options.grading) label = label_of(submission);
    const Assignment assignment =
        options.grading ? graded_assignment(*options.grading) : load(assignment_of(label));
    const Marked marked = marked_by_children(assignment, submission, options);
    if (marked.tasks.size() < assignment.tasks.size()) return std::nullopt;
    if (!options.grading) return sum_of(assignment, label.student, marked.tasks);
    // A child that ended before it had read the submission says nothing.
    const ordered_json nothing = ordered_json::array();
    ordered_json sum =
        sum_of(assignment, marked.intake.value("student", options.grading->student), marked.tasks);
    for (const char* key : {"refused", "lacking"}) sum[key] = marked.intake.value(key, nothing);
    for (const char* key : {"label", "label_student"}) sum[key] = marked.intake.value(key, "");
    return sum;
}

std::vector<std::string> words_of(const MarkRequest& request) {
    std::vector<std::string> words{"assignment", "mark", request.submission.string(),
                                   request.results.string()};
    std::ranges::copy(request.tasks, std::back_inserter(words));
    if (request.keeps_pictures) words.emplace_back("--pictures");
    if (!request.grading) return words;
    if (request.tick_seed) words.push_back("--tick=" + *request.tick_seed);
    for (const auto& [option, value] : {std::pair{"--assignment", request.grading->assignment.string()},
                                        {"--hidden", request.grading->hidden.string()},
                                        {"--student", request.grading->student},
                                        {"--memory", std::to_string(request.grading->memory)},
                                        {"--values", request.grading->values.file.string()},
                                        {"--digest", request.grading->values.digest},
                                        {"--seconds", std::to_string(request.processor_seconds)}})
        if (!value.empty()) words.push_back(fmt::format("{}={}", option, value));
    return words;
}

namespace {

/// Lists what a confined process reads besides the system's folders.
std::vector<fs::path> readable_folders(const MarkRequest& request) {
    fs::path program = program_file().parent_path();
    if (program.filename() == "bin") program = program.parent_path();
    return {program, request.grading->assignment, request.grading->hidden, request.submission,
            request.grading->values.file};
}

/// A teacher's reading of a submission: whatever is wrong with it costs its points alone.
struct Intake {
    std::string student;              // whose numbers it is marked with
    std::string label, label_student; // what its label says
    std::vector<std::string> refused;
    Submission submission;
};

Intake taken_in(const Assignment& assignment, const MarkRequest& request) {
    Intake intake{request.grading->student, "", "", {}, {}};
    const auto refuse = [&](const Error& error) { intake.refused.emplace_back(error.what()); };
    try {
        const SubmittedFiles files(request.submission);
        intake.refused = files.refused();
        intake.submission = read_submission(assignment, files);
        if (files.has("assignment.json")) try {
                const FolderLabel label = label_of(files);
                intake.label = label.assignment;
                intake.label_student = label.student;
                if (intake.student.empty()) intake.student = label.student;
            } catch (const Error& error) {
                refuse(error);
            }
    } catch (const Error& error) {
        refuse(error);
        for (const Task& task : assignment.tasks) intake.submission.faults[task.id] = error.what();
    }
    return intake;
}

void write_line(std::ostream& stream, const ordered_json& json) {
    stream << json.dump(-1, ' ', false, ordered_json::error_handler_t::replace) << std::endl;
}

void mark_all(const Assignment& assignment, const std::string& student, const Submission& submission,
              const MarkRequest& request, std::ostream& stream) {
    ReferenceValues known;
    if (request.grading && !request.grading->values.file.empty())
        known.load(request.grading->values.file, request.grading->values.digest);
    Marker marker(assignment, student, request.keeps_pictures, std::move(known));
    for (const std::string& task : request.tasks)
        write_line(stream, marker.mark(assignment.task(task), submission));
}

} // namespace

void mark_tasks(const MarkRequest& request) {
    std::vector<std::string> lacking;
    if (request.grading)
        lacking = confine_files(
            {readable_folders(request), request.results.parent_path(), request.processor_seconds});
    std::ofstream stream(request.results, std::ios::app);
    const auto context = gl::open_context({gl::Backend::automatic, false});
    if (!request.grading) {
        const SubmittedFiles files(request.submission);
        const FolderLabel label = label_of(files);
        const Assignment assignment = load(assignment_of(label));
        const MemoryWatch watch(std::uint64_t{4} << 30); // a student's code may ask for any amount
        return mark_all(assignment, label.student, read_submission(assignment, files), request, stream);
    }
    const Assignment assignment = graded_assignment(*request.grading);
    const MemoryWatch watch(request.grading->memory);
    std::ranges::copy(confine_calls(), std::back_inserter(lacking));
    const Intake intake = taken_in(assignment, request);
    write_line(stream, {{"intake",
                         {{"student", intake.student},
                          {"label", intake.label},
                          {"label_student", intake.label_student},
                          {"refused", intake.refused},
                          {"lacking", lacking}}}});
    if (request.tick_seed)
        return write_questions(assignment, intake.submission, intake.student, request.tasks,
                               *request.tick_seed, stream);
    mark_all(assignment, intake.student, intake.submission, request, stream);
}

std::vector<std::string> words_of_references(const Grading& grading, const fs::path& file, bool mistakes) {
    std::vector<std::string> words{"assignment", "references", grading.assignment.string(), file.string()};
    if (!grading.hidden.empty()) words.push_back("--hidden=" + grading.hidden.string());
    if (mistakes) words.emplace_back("--mistakes");
    return words;
}

void compute_references(const Grading& grading, const fs::path& file, bool mistakes) {
    const auto context = gl::open_context({gl::Backend::automatic, false});
    const Assignment assignment = graded_assignment(grading);
    Marker(assignment, grading.student).compute_references(mistakes).save(file);
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
