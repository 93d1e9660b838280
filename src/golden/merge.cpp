#include "golden/merge.hpp"

#include "core/error.hpp"

#include <algorithm>
#include <fmt/format.h>
#include <map>

namespace sr::golden {
namespace {

namespace fs = std::filesystem;
using nlohmann::ordered_json;

/// Copies a file from one output folder to another. @throws Error
void copy_into(const fs::path& output, const std::string& file, const fs::path& from) {
    std::error_code failure;
    fs::create_directories((output / file).parent_path(), failure);
    fs::copy_file(from / file, output / file, fs::copy_options::overwrite_existing, failure);
    if (failure)
        throw Error({(from / file).string()}, "cannot be copied: " + failure.message(),
                    "upload the whole output folder of each shard");
}

/// @throws Error for a file that a run would not have written there
void require_own_file(const std::string& file, const std::string& beginning, const fs::path& folder) {
    const bool is_plain = file.find('/', beginning.size()) == std::string::npos;
    if (!file.starts_with(beginning) || !is_plain)
        throw Error({results_file(folder).string()}, fmt::format("\"{}\" is no file of a run", file),
                    "merge what steradian golden run wrote");
}

/// @throws Error for a picture that a run would not have written there
void require_own_files(const TestResult& test, const fs::path& folder) {
    const std::string name = file_name_of(test.name);
    if (!test.candidate.empty()) require_own_file(test.candidate, "candidates/" + name, folder);
    for (const Attempt& attempt : test.attempts)
        if (!attempt.candidate.empty()) require_own_file(attempt.candidate, "attempts/" + name, folder);
}

/// Copies the pictures and the log of a test.
void copy_files(const TestResult& test, const fs::path& from, const fs::path& output) {
    if (!test.candidate.empty()) copy_into(output, test.candidate, from);
    for (const Attempt& attempt : test.attempts)
        if (!attempt.candidate.empty()) copy_into(output, attempt.candidate, from);
    const std::string log = "logs/" + file_name_of(test.name) + ".txt";
    std::error_code ignored;
    if (fs::is_regular_file(from / log, ignored)) copy_into(output, log, from);
}

/// Puts shards together. All is read and checked before anything is written.
class Merger {
public:
    explicit Merger(const Suite& suite) : suite_(suite) {}

    /// @throws Error
    void add(const fs::path& folder) {
        std::error_code ignored;
        if (!fs::exists(results_file(folder), ignored)) {
            merged_.remarks.push_back(
                fmt::format("{}: no results: the shard was not run to its end", folder.string()));
            return;
        }
        const RunResult shard = read_results(folder);
        if (shard.suite != suite_.name)
            throw Error({folder.string()}, fmt::format("results of the suite \"{}\"", shard.suite),
                        fmt::format("merge shards of \"{}\"", suite_.name));
        if (shard.suite_sha256 != suite_.sha256)
            throw Error({folder.string()},
                        fmt::format("{} was another file when the shard was run", suite_.file.string()),
                        "merge with the suite that was run, as it was then");
        for (const TestResult& test : shard.tests)
            if (!test.is_earlier) add(test, folder);
        add_record(folder);
        ++count_;
    }

    /// @throws Error if no folder had results
    void require_results() const {
        if (count_ == 0)
            throw Error({suite_.file.string()},
                        "none of the folders has results of a run; nothing was changed",
                        "name the output folders of the shards");
    }

    /// Copies the pictures and logs of all tests. @throws Error
    void copy_to(const fs::path& output) const {
        for (const auto& [name, found] : tests_) copy_files(found.second, found.first, output);
    }

    /// The chosen tests in the suite's order.
    MergedRun take(const std::vector<GoldenTest>& chosen) {
        std::vector<TestResult> tests;
        for (const GoldenTest& test : chosen) {
            const auto found = tests_.find(test.name);
            if (found != tests_.end()) {
                tests.push_back(std::move(found->second.second));
                continue;
            }
            TestResult lost;
            lost.name = test.name;
            lost.description = test.description;
            lost.tags = test.tags;
            lost.message = "no shard has run it: a shard is missing, or was not run to its end";
            tests.push_back(std::move(lost));
        }
        merged_.result = result_of(suite_, std::move(tests));
        return std::move(merged_);
    }

private:
    void add(const TestResult& test, const fs::path& folder) {
        if (std::ranges::find(suite_.tests, test.name, &GoldenTest::name) == suite_.tests.end())
            throw Error({folder.string()}, fmt::format("the suite has no test {}", test.name),
                        "merge with the suite that was run");
        const auto [place, is_new] = tests_.try_emplace(test.name, folder, test);
        if (!is_new)
            throw Error({folder.string()},
                        fmt::format("the test {} is in {}, too", test.name, place->second.first.string()),
                        "merge each shard once");
        require_own_files(test, folder);
    }

    void add_record(const fs::path& folder) {
        const auto record = read_record(folder);
        if (!record) return;
        RunRecord& all = merged_.record;
        if (!all.commit.empty() && !record->commit.empty() && all.commit != record->commit)
            throw Error({folder.string()},
                        fmt::format("a shard of commit {}, others are of {}", record->commit, all.commit),
                        "merge shards of one commit");
        std::map<std::string, double> seconds = all.seconds;
        seconds.insert(record->seconds.begin(), record->seconds.end());
        if (all.began.empty() || record->began < all.began) all = *record;
        all.seconds = std::move(seconds);
    }

    const Suite& suite_;
    MergedRun merged_;
    std::map<std::string, std::pair<fs::path, TestResult>> tests_; // with the folder of each
    int count_ = 0;
};

} // namespace

MergedRun merge_shards(const Suite& suite, const std::vector<fs::path>& folders, const RunOptions& options) {
    const std::vector<GoldenTest> chosen = chosen_tests(suite, options);
    std::error_code ignored;
    Merger merger(suite);
    for (const fs::path& folder : folders) {
        if (fs::equivalent(folder, options.output, ignored))
            throw Error({folder.string()}, "this is the output folder, too",
                        "merge into a folder of its own");
        merger.add(folder);
    }
    merger.require_results();
    prepare_output(options.output);
    merger.copy_to(options.output);
    return merger.take(chosen);
}

std::vector<PastRun> read_history(const std::vector<fs::path>& folders) {
    std::vector<PastRun> runs;
    for (const fs::path& folder : folders) {
        runs.push_back({folder, read_results(folder), read_record(folder)});
        if (runs.back().result.suite != runs.front().result.suite)
            throw Error({folder.string()},
                        fmt::format("results of the suite \"{}\"", runs.back().result.suite),
                        fmt::format("name runs of \"{}\" alone", runs.front().result.suite));
    }
    std::ranges::stable_sort(runs, {},
                             [](const PastRun& run) { return run.record ? run.record->began : ""; });
    return runs;
}

namespace {

/// A test in all runs; nothing where it was not run.
struct TestHistory {
    std::string name;
    std::vector<const TestResult*> results;
    std::vector<double> seconds; // of the runs that know it, sorted

    int count(Outcome outcome) const {
        return static_cast<int>(std::ranges::count_if(
            results, [&](const TestResult* result) { return result && result->outcome == outcome; }));
    }
    int run_count() const { return static_cast<int>(results.size() - std::ranges::count(results, nullptr)); }
    double median_seconds() const { return seconds.empty() ? 0.0 : seconds[seconds.size() / 2]; }
};

/// In the order of the last run that has a test.
std::vector<TestHistory> histories(const std::vector<PastRun>& runs) {
    std::vector<TestHistory> tests;
    for (auto run = runs.rbegin(); run != runs.rend(); ++run)
        for (const TestResult& test : run->result.tests)
            if (std::ranges::find(tests, test.name, &TestHistory::name) == tests.end())
                tests.push_back({test.name, {}, {}});
    for (TestHistory& test : tests) {
        for (const PastRun& run : runs) {
            const auto found = std::ranges::find(run.result.tests, test.name, &TestResult::name);
            const bool is_run = found != run.result.tests.end() && !found->is_earlier;
            test.results.push_back(is_run ? &*found : nullptr);
            if (!is_run || !run.record) continue;
            const auto seconds = run.record->seconds.find(test.name);
            if (seconds != run.record->seconds.end()) test.seconds.push_back(seconds->second);
        }
        std::ranges::sort(test.seconds);
    }
    return tests;
}

char letter_of(const TestResult* result) {
    if (!result) return '-';
    switch (result->outcome) {
    case Outcome::passed: return '.';
    case Outcome::differs: return 'F';
    case Outcome::missing: return 'M';
    case Outcome::unreadable: return 'U';
    case Outcome::broken: return 'B';
    case Outcome::flaky: return '~';
    }
    return '?';
}

} // namespace

std::string history_text(const std::vector<PastRun>& runs) {
    std::string text;
    for (const TestHistory& test : histories(runs)) {
        std::string letters;
        for (const TestResult* result : test.results) letters += letter_of(result);
        text += fmt::format("{:<28} {}  ", test.name, letters);
        text += test.run_count() == 0
                    ? "not run" // a filter left it out
                    : fmt::format("{} of {} passed", test.count(Outcome::passed), test.run_count());
        if (const int n = test.count(Outcome::flaky)) text += fmt::format(", {} flaky", n);
        if (!test.seconds.empty()) text += fmt::format("  {:.2f} s", test.median_seconds());
        text += '\n';
    }
    return text;
}

ordered_json history_json(const std::vector<PastRun>& runs) {
    ordered_json json{{"runs", ordered_json::array()}, {"tests", ordered_json::array()}};
    for (const PastRun& run : runs) {
        const RunRecord record = run.record.value_or(RunRecord{});
        json["runs"].push_back({{"folder", run.folder.string()},
                                {"began", record.began},
                                {"commit", record.commit},
                                {"branch", record.branch},
                                {"link", record.link}});
    }
    for (const TestHistory& test : histories(runs)) {
        ordered_json outcomes = ordered_json::array();
        for (const TestResult* result : test.results)
            outcomes.push_back(result ? ordered_json(name_of(result->outcome)) : ordered_json());
        json["tests"].push_back({{"name", test.name},
                                 {"outcomes", std::move(outcomes)},
                                 {"passed", test.count(Outcome::passed)},
                                 {"flaky", test.count(Outcome::flaky)},
                                 {"runs", test.run_count()},
                                 {"median_seconds", test.median_seconds()}});
    }
    return json;
}

} // namespace sr::golden
