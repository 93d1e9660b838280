#include "golden/run.hpp"

#include "core/error.hpp"
#include "core/parallel.hpp"
#include "golden/run_test.hpp"

#include <algorithm>
#include <atomic>
#include <fmt/format.h>
#include <fnmatch.h>
#include <mutex>

namespace sr::golden {
namespace {

namespace fs = std::filesystem;

bool is_chosen(const GoldenTest& test, const RunOptions& options) {
    const auto fits = [&](const std::string& pattern) { return is_meant(pattern, test.name); };
    const auto has = [&](const std::string& tag) {
        return std::ranges::find(test.tags, tag) != test.tags.end();
    };
    return (options.filters.empty() || std::ranges::any_of(options.filters, fits))
           && (options.tags.empty() || std::ranges::any_of(options.tags, has));
}

void prepare(const fs::path& output) {
    std::error_code failure;
    for (const char* folder : {"candidates", "logs"}) {
        fs::create_directories(output / folder, failure);
        if (failure)
            throw Error({output.string()}, "cannot be made: " + failure.message(),
                        "choose another folder with --output");
    }
    for (const fs::path& file : {results_file(output), junit_file(output), report_file(output)})
        fs::remove(file, failure);
}

/// Hands results on in the suite's order, however they come in.
class InOrder {
public:
    InOrder(std::size_t count, const std::function<void(const TestResult&)>& hand_on)
        : results_(count), is_done_(count, false), hand_on_(hand_on) {}

    void put(std::size_t index, TestResult result) {
        const std::lock_guard lock(mutex_);
        results_[index] = std::move(result);
        is_done_[index] = true;
        for (; next_ < is_done_.size() && is_done_[next_]; ++next_)
            if (hand_on_) hand_on_(results_[next_]);
    }

    std::vector<TestResult> take() { return std::move(results_); }

private:
    std::mutex mutex_;
    std::vector<TestResult> results_;
    std::vector<bool> is_done_;
    std::size_t next_ = 0;
    const std::function<void(const TestResult&)>& hand_on_;
};

} // namespace

bool is_meant(const std::string& pattern, const std::string& name) {
    return pattern == name || fnmatch(pattern.c_str(), name.c_str(), 0) == 0;
}

std::vector<GoldenTest> chosen_tests(const Suite& suite, const RunOptions& options) {
    std::vector<GoldenTest> tests;
    for (const GoldenTest& test : suite.tests)
        if (is_chosen(test, options)) tests.push_back(test);
    if (tests.empty())
        throw Error({suite.file.string()}, "no test fits the filter",
                    "see the names with steradian golden list");
    return tests;
}

std::optional<RunResult> run(const Suite& suite, const RunOptions& options) {
    const std::vector<GoldenTest> tests = chosen_tests(suite, options);
    prepare(options.output);
    const auto is_interrupted = [&] { return options.is_interrupted && options.is_interrupted(); };
    InOrder results(tests.size(), options.on_result);
    std::atomic<std::size_t> next{0};
    const auto work = [&] {
        for (std::size_t i = next++; i < tests.size() && !is_interrupted(); i = next++) {
            TestResult result = run_test(suite, tests[i], options);
            if (!is_interrupted()) results.put(i, std::move(result));
        }
    };
    on_threads(std::clamp(options.jobs, 1, static_cast<int>(tests.size())), work);
    if (is_interrupted()) return std::nullopt;
    return RunResult{suite.name, suite.file.string(), results.take()};
}

} // namespace sr::golden
