#include "assignment/grade.hpp"

#include "assignment/class_report.hpp"
#include "assignment/mark.hpp"
#include "core/error.hpp"
#include "core/file.hpp"
#include "golden/process.hpp"
#include "golden/sha256.hpp"
#include "image/whole_file.hpp"

#include <algorithm>
#include <atomic>
#include <cerrno>
#include <exception>
#include <fcntl.h>
#include <fmt/format.h>
#include <functional>
#include <iterator>
#include <map>
#include <mutex>
#include <nlohmann/json.hpp>
#include <set>
#include <stop_token>
#include <sys/file.h>
#include <thread>
#include <unistd.h>

namespace sr::assignment {
namespace {

namespace fs = std::filesystem;
using nlohmann::ordered_json;

constexpr std::ptrdiff_t min_pending = 3; // submissions, for which values are computed beforehand
constexpr std::ptrdiff_t min_pending_for_mistakes = 16; // and those of all typical mistakes
constexpr double max_seconds = 600.0;                   // for that

/// A folder into which one process at a time grades.
class Lock {
public:
    explicit Lock(const fs::path& folder)
        : file_(open((folder / ".lock").c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0666)) {
        if (file_ < 0) throw Error({folder.string()}, "cannot be written", "name another folder with --out");
        if (flock(file_, LOCK_EX | LOCK_NB) == 0) return;
        close(file_);
        throw Error({folder.string()}, "another process grades into this folder",
                    "wait for it, or name another folder");
    }
    ~Lock() { close(file_); }
    Lock(const Lock&) = delete;
    Lock& operator=(const Lock&) = delete;

private:
    int file_;
};

std::string basis_of(const GradeOptions& options) {
    return fingerprint_of(options.check.grading->assignment) + fingerprint_of(options.check.grading->hidden);
}

std::string fingerprint_with(const std::string& basis, const HandedIn& submission,
                             const CheckOptions& check) {
    const std::string text =
        fmt::format("{} {} {} {} {} {} {}", basis, submission.key, submission.name, submission.id,
                    check.time_limit, check.grading->memory, fingerprint_of(submission.path));
    return golden::sha256_text(text);
}

/// A result that stands in the folder already, of the same files and the same checks.
ordered_json earlier_result(const fs::path& output, const std::string& key, const std::string& fingerprint) {
    const fs::path file = output / "results" / (key + ".json");
    std::error_code ignored;
    if (!fs::is_regular_file(file, ignored)) return {};
    auto result = ordered_json::parse(read_text(file), nullptr, false);
    const bool is_same = result.is_object() && result.value("fingerprint", "") == fingerprint;
    return is_same ? result : ordered_json();
}

std::string lines_of_json(const ordered_json& json) {
    return json.dump(1, ' ', false, ordered_json::error_handler_t::replace) + "\n";
}

class Grader {
public:
    explicit Grader(const GradeOptions& options)
        : options_(options),
          submissions_(class_folder(options.submissions)),
          basis_(basis_of(options)),
          results_(submissions_.submissions.size()) {}

    std::optional<std::vector<ordered_json>> run() {
        for (const std::string& remark : submissions_.remarks) options_.on_remark(remark);
        take_earlier_results();
        compute_values();
        {
            std::vector<std::jthread> threads;
            for (int i = 0; i < options_.jobs; ++i) threads.emplace_back([this] { work(); });
        }
        if (failure_) std::rethrow_exception(failure_);
        if (options_.check.stop.stop_requested()) return std::nullopt;
        return results_;
    }

private:
    std::string fingerprint(const HandedIn& submission) const {
        return fingerprint_with(basis_, submission, options_.check);
    }

    void take_earlier_results() {
        for (std::size_t i = 0; i < results_.size(); ++i) {
            const HandedIn& submission = submissions_.submissions[i];
            results_[i] = earlier_result(options_.output, submission.key, fingerprint(submission));
            if (!results_[i].is_null()) finish(i);
        }
    }

    /// Computes what all submissions are compared with. It is only faster, so a failure is of no account.
    void compute_values() {
        const auto pending =
            std::ranges::count_if(results_, [](const ordered_json& r) { return r.is_null(); });
        if (pending < min_pending) return;
        const fs::path file = fs::absolute(options_.output / ".values");
        std::vector<std::string> words{options_.check.program.string()};
        std::ranges::copy(
            words_of_references(*options_.check.grading, file, pending >= min_pending_for_mistakes),
            std::back_inserter(words));
        const auto end = golden::run_process(
            {words, fs::current_path(), options_.output / ".values.log", max_seconds, options_.check.stop});
        if (end.is_success()) values_ = {file, digest_of(file)};
    }

    void finish(std::size_t i) {
        const std::lock_guard lock(mutex_);
        ++done_;
        for (const auto& line : results_[i]["lacking"])
            if (lacking_.insert(line.get<std::string>()).second)
                options_.on_remark(fmt::format("submissions run without {}", line.get<std::string>()));
        if (options_.on_done) options_.on_done(done_, results_.size(), results_[i]);
    }

    void work() {
        for (std::size_t i = next_++; i < results_.size(); i = next_++) {
            if (!results_[i].is_null()) continue;
            try {
                if (!grade(i)) return;
            } catch (...) {
                const std::lock_guard lock(mutex_);
                if (!failure_) failure_ = std::current_exception();
                over_.request_stop();
                return;
            }
        }
    }

    /// @return whether it came to its end
    bool grade(std::size_t i) {
        const HandedIn& submission = submissions_.submissions[i];
        CheckOptions check = options_.check;
        check.grading->values = values_;
        check.stop = over_.get_token();
        auto graded = grade_one({submission, fingerprint(submission)}, check, options_.output);
        if (!graded) return false;
        results_[i] = std::move(*graded);
        finish(i);
        return true;
    }

    const GradeOptions& options_;
    ClassFolder submissions_;
    std::string basis_; // of all fingerprints: the assignment's files
    std::vector<ordered_json> results_;
    ReferenceFile values_;
    std::set<std::string> lacking_;
    std::atomic<std::size_t> next_ = 0;
    std::stop_source over_; // stopped by the caller, or by a failure
    std::stop_callback<std::function<void()>> over_with_caller_{options_.check.stop,
                                                                [this] { over_.request_stop(); }};
    std::mutex mutex_; // of what follows, and of on_done
    std::size_t done_ = 0;
    std::exception_ptr failure_;
};

/// Names in each result the others of the same student.
void add_duplicates(std::vector<ordered_json>& results) {
    std::map<std::string, std::vector<std::string>> keys;
    for (const ordered_json& result : results) keys[result["student"]].push_back(result["key"]);
    for (ordered_json& result : results)
        for (const std::string& key : keys.at(result["student"]))
            if (key != result["key"].get<std::string>() && !result["student"].get<std::string>().empty())
                result["same_student"].push_back(key);
}

} // namespace

std::vector<UngradedSubmission> ungraded(const GradeOptions& options) {
    const std::string basis = basis_of(options);
    std::vector<UngradedSubmission> found;
    for (const HandedIn& submission : class_folder(options.submissions).submissions) {
        const std::string fingerprint = fingerprint_with(basis, submission, options.check);
        if (earlier_result(options.output, submission.key, fingerprint).is_null())
            found.push_back({submission, fingerprint});
    }
    return found;
}

std::optional<ordered_json> grade_one(const UngradedSubmission& one, CheckOptions check,
                                      const fs::path& output) {
    const auto& [submission, fingerprint] = one;
    for (const char* part : {"results", "students", "gradescope"}) fs::create_directories(output / part);
    check.keeps_pictures = true;
    check.grading->student = submission.id;
    const auto result = check_submission(submission.path, check);
    if (!result) return std::nullopt;
    ordered_json graded{{"key", submission.key},
                        {"name", submission.name},
                        {"id", submission.id},
                        {"fingerprint", fingerprint}};
    graded.update(without_pictures(*result));
    image::write_text(output / "students" / (submission.key + ".html"), report_html(*result));
    image::write_text(output / "gradescope" / (submission.key + ".json"),
                      lines_of_json(gradescope_of(*result)));
    image::write_text(output / "results" / (submission.key + ".json"), lines_of_json(graded));
    return graded;
}

std::optional<std::vector<ordered_json>> grade_class(const GradeOptions& options) {
    std::error_code failure;
    fs::create_directories(options.output, failure);
    if (failure) throw Error({options.output.string()}, failure.message(), "name another folder with --out");
    const Lock lock(options.output);
    auto results = Grader(options).run();
    for (const char* file : {".values", ".values.log"}) fs::remove(options.output / file, failure);
    if (!results) return std::nullopt;
    add_duplicates(*results); // for the teacher alone
    image::write_text(options.output / "marks.csv", csv_of(*results));
    image::write_text(options.output / "junit.xml", junit_of(*results));
    image::write_text(options.output / "overview.html", overview_html(*results));
    return results;
}

} // namespace sr::assignment
