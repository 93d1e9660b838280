#include "golden/approve.hpp"

#include "core/error.hpp"
#include "golden/alternate.hpp"
#include "golden/bytes_of_file.hpp"
#include "golden/fingerprint.hpp"
#include "golden/law_record.hpp"
#include "golden/run.hpp"
#include "image/file.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <optional>

namespace sr::golden {
namespace {

namespace fs = std::filesystem;

/// Whether a golden holds the picture with this fingerprint; a broken one holds none.
bool holds(const fs::path& golden, const std::string& picture) {
    try {
        return fingerprint(image::read(golden)) == picture;
    } catch (const Error&) {
        return false;
    }
}

std::vector<TestResult> chosen(const RunResult& run, const std::vector<std::string>& names) {
    std::vector<TestResult> tests;
    for (const TestResult& test : run.tests) {
        const auto fits = [&](const std::string& name) { return is_meant(name, test.name); };
        if (names.empty() ? test.outcome != Outcome::passed : std::ranges::any_of(names, fits))
            tests.push_back(test);
    }
    for (const std::string& name : names)
        if (std::ranges::none_of(run.tests,
                                 [&](const TestResult& test) { return is_meant(name, test.name); }))
            throw Error(fmt::format("the last run has no test {}", name),
                        "run it with steradian golden run, then approve it");
    return tests;
}

std::size_t nonfinite_count(const image::Image& image) {
    return static_cast<std::size_t>(
        std::ranges::count_if(image.pixels, [](float v) { return !std::isfinite(v); }));
}

/// Whether the candidate's renderer may make goldens here.
std::optional<Refusal> renderer_refusal(const Suite& suite, const TestResult& test, bool is_scene) {
    const std::string& found = test.candidate_renderer;
    if (!is_scene && found.empty())
        return std::nullopt; // an external command's image need not say who made it
    if (suite.renderer) {
        const auto comma = found.rfind(", ");
        const std::string version = comma == std::string::npos ? "" : found.substr(comma + 2);
        if (found.starts_with(suite.renderer->gl_renderer) && version.starts_with(suite.renderer->gl_version))
            return std::nullopt;
        return Refusal{fmt::format("it was rendered by {}, the suite's reference renderer is {} {}",
                                   found.empty() ? "an unknown renderer" : found, suite.renderer->gl_renderer,
                                   suite.renderer->gl_version),
                       true};
    }
    if (test.golden_renderer.empty() || test.golden_renderer == found) return std::nullopt;
    return Refusal{fmt::format("it was rendered by {}, its golden by {}",
                               found.empty() ? "an unknown renderer" : found, test.golden_renderer),
                   true};
}

/// Whether the candidate may stand beside the golden.
std::optional<Refusal> alternate_refusal(const Suite& suite, const TestResult& result,
                                         const GoldenTest& test) {
    std::error_code ignored;
    if (!fs::exists(suite.golden_of(test), ignored))
        return Refusal{"there is no golden yet: an alternate stands beside one"};
    if (result.candidate_renderer.empty())
        return Refusal{"it does not say who rendered it (steradian:GL_RENDERER)"};
    if (result.candidate_renderer == result.golden_renderer && result.alternate.empty())
        return Refusal{"the golden's own renderer made it: mend it, or approve it as the golden"};
    return std::nullopt;
}

/// What is wrong with the candidate itself.
void inspect(Approval& approval, const TestResult& result, const GoldenTest& test) {
    std::error_code ignored;
    if (result.candidate.empty() || !fs::exists(approval.candidate, ignored)) {
        approval.refusals.push_back(
            {"there is no candidate: " + (result.message.empty() ? "run it again" : result.message)});
        return;
    }
    approval.bytes = bytes_of_file(approval.candidate);
    const image::Image image = image::read(approval.candidate);
    if (fingerprint(image) != result.candidate_sha256) {
        approval.refusals.push_back(
            {"the candidate is not the one that the last run compared: run it again"});
        return;
    }
    if (const std::size_t count = nonfinite_count(image); count > 0 && !test.allow_nonfinite)
        approval.refusals.push_back({fmt::format("{} of its values are not finite", count)});
    if (result.fails_known_pixel) approval.refusals.push_back({result.message, true});
    if (!fs::exists(approval.golden, ignored))
        approval.change = "new";
    else if (holds(approval.golden, result.candidate_sha256))
        approval.change = "equal";
    else
        approval.change = result.message.empty() ? "within the tolerance" : result.message;
}

std::optional<LawRecord> law_record(const Suite& suite, const ApproveOptions& options,
                                    std::vector<std::string>& remarks) {
    std::error_code ignored;
    if (!options.laws.empty()) return read_law_record(options.laws); // asked for: missing is an error
    if (suite.laws.empty()) return std::nullopt;
    if (!fs::exists(suite.laws, ignored)) {
        remarks.push_back(fmt::format("{}: no results of laws are recorded there: record them with ctest -L "
                                      "'law|analytic|truth' --output-junit {}",
                                      suite.laws.string(), suite.laws.string()));
        return std::nullopt;
    }
    if (fs::last_write_time(suite.laws, ignored) < fs::last_write_time(results_file(options.output), ignored))
        remarks.push_back(fmt::format("{}: these law results are older than the run", suite.laws.string()));
    return read_law_record(suite.laws);
}

} // namespace

bool ApprovalPlan::is_allowed(bool force) const {
    return std::ranges::all_of(approvals, [&](const Approval& approval) {
        return std::ranges::all_of(approval.refusals,
                                   [&](const Refusal& r) { return force && r.yields_to_force; });
    });
}

ApprovalPlan plan_approval(const Suite& suite, const ApproveOptions& options) {
    const RunResult run = read_results(options.output);
    std::error_code ignored;
    if (!fs::equivalent(run.suite_file, suite.file, ignored) && run.suite_file != suite.file.string())
        throw Error({results_file(options.output).string()},
                    fmt::format("the last run there was of {}", run.suite_file),
                    "run this suite, or name its output folder with --output");
    if (!options.alternate.empty()) check_label(options.alternate);
    ApprovalPlan plan;
    const auto laws = law_record(suite, options, plan.remarks);
    for (const TestResult& result : chosen(run, options.names)) {
        Approval approval{result.name, options.output / result.candidate, {}, {}, {}, {}};
        const auto test = std::ranges::find(suite.tests, result.name, &GoldenTest::name);
        if (test == suite.tests.end()) {
            approval.refusals.push_back({"the suite has no such test any more"});
            plan.approvals.push_back(std::move(approval));
            continue;
        }
        const bool is_alternate = !options.alternate.empty();
        approval.golden =
            is_alternate ? alternate_of(suite, *test, options.alternate) : suite.golden_of(*test);
        inspect(approval, result, *test);
        if (laws)
            for (const std::string& law : laws->failed_among(test->guards))
                approval.refusals.push_back({fmt::format("{} fails", law), true});
        if (!approval.bytes.empty())
            if (auto refusal = is_alternate ? alternate_refusal(suite, result, *test)
                                            : renderer_refusal(suite, result, !test->scene.empty()))
                approval.refusals.push_back(std::move(*refusal));
        plan.approvals.push_back(std::move(approval));
    }
    return plan;
}

void carry_out(const ApprovalPlan& plan) {
    for (const Approval& approval : plan.approvals) {
        if (approval.change == "equal") continue;
        std::error_code failure;
        fs::create_directories(approval.golden.parent_path(), failure);
        write_text(approval.golden, approval.bytes);
    }
}

} // namespace sr::golden
