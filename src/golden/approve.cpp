#include "golden/approve.hpp"

#include "core/error.hpp"
#include "core/file.hpp"
#include "core/json.hpp"
#include "golden/run.hpp"
#include "image/file.hpp"
#include "image/header.hpp"
#include "image/whole_file.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <optional>
#include <string_view>

namespace sr::golden {
namespace {

/// A start, end or empty tag of an XML text, without its angle brackets.
struct Tag {
    std::string_view name;
    std::string_view attributes;
    bool is_end = false;
};

/// The tags of an XML text in turn; comments, CDATA, declarations and text are passed over.
class Tags {
public:
    explicit Tags(std::string_view xml) : rest_(xml) {}

    bool next(Tag& tag) {
        while (true) {
            const auto open = rest_.find('<');
            if (open == std::string_view::npos) return false;
            rest_.remove_prefix(open);
            if (rest_.starts_with("<!--"))
                skip_behind("-->");
            else if (rest_.starts_with("<![CDATA["))
                skip_behind("]]>");
            else if (rest_.starts_with("<!") || rest_.starts_with("<?"))
                skip_behind(">");
            else
                return read(tag);
        }
    }

private:
    void skip_behind(std::string_view mark) {
        const auto end = rest_.find(mark);
        rest_.remove_prefix(end == std::string_view::npos ? rest_.size() : end + mark.size());
    }

    bool read(Tag& tag) {
        std::size_t end = 1;
        for (char quote = 0; end < rest_.size() && (quote != 0 || rest_[end] != '>'); ++end) {
            const char c = rest_[end];
            if (quote == 0 && (c == '"' || c == '\''))
                quote = c;
            else if (c == quote)
                quote = 0;
        }
        std::string_view inside = rest_.substr(1, end - 1);
        rest_.remove_prefix(std::min(end + 1, rest_.size()));
        tag.is_end = inside.starts_with('/');
        if (tag.is_end) inside.remove_prefix(1);
        const auto name_end = std::min(inside.find_first_of(" \t\r\n/"), inside.size());
        tag.name = inside.substr(0, name_end);
        tag.attributes = inside.substr(name_end);
        return true;
    }

    std::string_view rest_;
};

std::string unescaped(std::string_view text) {
    constexpr std::array<std::pair<std::string_view, char>, 5> entities{
        {{"&lt;", '<'}, {"&gt;", '>'}, {"&quot;", '"'}, {"&apos;", '\''}, {"&amp;", '&'}}};
    std::string result;
    while (!text.empty()) {
        const auto found =
            std::ranges::find_if(entities, [&](const auto& e) { return text.starts_with(e.first); });
        result += found == entities.end() ? text.front() : found->second;
        text.remove_prefix(found == entities.end() ? 1 : found->first.size());
    }
    return result;
}

std::string attribute(const Tag& tag, std::string_view name) {
    const std::string key = " " + std::string(name) + "=";
    const auto at = tag.attributes.find(key);
    if (at == std::string_view::npos || at + key.size() >= tag.attributes.size()) return {};
    const std::string_view rest = tag.attributes.substr(at + key.size());
    const auto end = rest.find(rest.front(), 1);
    return end == std::string_view::npos ? std::string() : unescaped(rest.substr(1, end - 1));
}

} // namespace

std::vector<std::string> LawRecord::failed_among(std::span<const std::string> guards) const {
    std::vector<std::string> names;
    for (const std::string& name : failed)
        if (std::ranges::any_of(guards, [&](const std::string& guard) { return name.starts_with(guard); }))
            names.push_back(name);
    return names;
}

LawRecord read_law_record(const std::filesystem::path& file) {
    const std::string xml = read_text(file);
    LawRecord record;
    std::string open_case;
    const auto fail_open_case = [&] {
        if (!open_case.empty() && (record.failed.empty() || record.failed.back() != open_case))
            record.failed.push_back(open_case);
    };
    Tags tags(xml);
    for (Tag tag; tags.next(tag);) {
        if (tag.name == "testcase" && !tag.is_end) {
            ++record.tests;
            open_case = attribute(tag, "name");
            const std::string status = attribute(tag, "status"); // as CTest writes it
            if (status == "fail" || status == "notrun") fail_open_case();
        } else if (!tag.is_end && (tag.name == "failure" || tag.name == "error")) {
            fail_open_case();
        }
    }
    if (record.tests == 0)
        throw Error({file.string()}, "no <testcase> in it", "record laws with ctest --output-junit FILE");
    return record;
}

namespace {

std::vector<ReviewedTest> reviewed_tests(const JsonObject& root, const char* key,
                                         std::vector<std::string>& decided) {
    std::vector<ReviewedTest> tests;
    for (const JsonObject& entry : root.objects(key)) {
        tests.push_back({entry.required_text("name"), entry.required_text("candidate_sha256")});
        const std::string& name = tests.back().name;
        if (std::ranges::find(decided, name) != decided.end())
            entry.fail_at("name", fmt::format("the test \"{}\" is decided twice", name), "decide it once");
        decided.push_back(name);
    }
    return tests;
}

} // namespace

Review read_review(const std::filesystem::path& file) {
    const JsonFile text(file);
    const JsonObject root(text, JsonObject::Pointer(""));
    if (!root.has("steradian_golden_review"))
        root.fail("this is no review of a run", "export one from report.html");
    root.integer("steradian_golden_review", 1, 1, 1);
    Review review;
    review.suite = root.required_text("suite");
    std::vector<std::string> decided;
    review.approved = reviewed_tests(root, "approved", decided);
    review.rejected = reviewed_tests(root, "rejected", decided);
    return review;
}

namespace {

namespace fs = std::filesystem;

/// True if a golden holds the picture with this fingerprint; a broken one holds none.
bool holds(const fs::path& golden, const std::string& picture) {
    try {
        return fingerprint(image::read(golden)) == picture;
    } catch (const Error&) {
        return false;
    }
}

bool is_among(const std::vector<std::string>& patterns, const std::string& name) {
    return std::ranges::any_of(patterns, [&](const std::string& pattern) { return matches(pattern, name); });
}

/// @throws Error for a pattern that fits no test of the run
void require_tests(const RunResult& run, const std::vector<std::string>& patterns) {
    for (const std::string& pattern : patterns)
        if (std::ranges::none_of(run.tests,
                                 [&](const TestResult& test) { return matches(pattern, test.name); }))
            throw Error(fmt::format("the last run has no test {}", pattern),
                        "run it with steradian golden run, then approve it");
}

/// The test as a review approved it; null if it did not.
const ReviewedTest* approved_in(const Review& review, const std::string& name) {
    const auto found = std::ranges::find(review.approved, name, &ReviewedTest::name);
    return found == review.approved.end() ? nullptr : &*found;
}

std::vector<TestResult> choose(const RunResult& run, const ApproveOptions& options,
                               const std::optional<Review>& review) {
    require_tests(run, options.names);
    require_tests(run, options.except);
    if (review)
        for (const ReviewedTest& test : review->approved)
            if (std::ranges::find(run.tests, test.name, &TestResult::name) == run.tests.end())
                throw Error({options.review.string()}, fmt::format("the last run has no test {}", test.name),
                            "name the output folder of the run that was reviewed with --output");
    std::vector<TestResult> tests;
    for (const TestResult& test : run.tests) {
        const bool is_chosen = review ? approved_in(*review, test.name) != nullptr
                               : options.names.empty()
                                   ? test.outcome != Outcome::passed && test.outcome != Outcome::flaky
                                   : is_among(options.names, test.name);
        if (is_chosen && !is_among(options.except, test.name)) tests.push_back(test);
    }
    return tests;
}

std::size_t nonfinite_count(const image::Image& image) {
    return static_cast<std::size_t>(
        std::ranges::count_if(image.pixels, [](float v) { return !std::isfinite(v); }));
}

/// Refuses a renderer that may not make goldens here.
std::optional<Refusal> renderer_refusal(const Suite& suite, const TestResult& test,
                                        const GoldenTest& golden) {
    const std::string& found = test.candidate_renderer;
    if (golden.scene.empty() && found.empty())
        return std::nullopt; // an external command's image need not say who made it
    if (!golden.renderer.empty() && found.starts_with(golden.renderer)) return std::nullopt;
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

/// Refuses a candidate that may not be an alternate.
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

/// Inspects the candidate itself.
void inspect(Approval& approval, const TestResult& result, const GoldenTest& test) {
    std::error_code ignored;
    if (result.candidate.empty() || !fs::exists(approval.candidate, ignored)) {
        approval.refusals.push_back(
            {"there is no candidate: " + (result.message.empty() ? "run it again" : result.message)});
        return;
    }
    approval.bytes = read_text(approval.candidate);
    const image::Image image = image::read(approval.candidate);
    if (fingerprint(image) != result.candidate_sha256) {
        approval.refusals.push_back(
            {"the candidate is not the one that the last run compared: run it again"});
        return;
    }
    if (const std::size_t count = nonfinite_count(image); count > 0 && !test.allow_nonfinite)
        approval.refusals.push_back({fmt::format("{} of its values are not finite", count)});
    if (result.fails_known_pixel) approval.refusals.push_back({result.message, true});
    if (const std::string& renderer = result.candidate_renderer;
        !renderer.empty() && renderer_of(image).empty())
        approval.sidecar = nlohmann::ordered_json{{"renderer", renderer}}.dump(1) + "\n";
    if (image::is_lfs_pointer(approval.golden))
        approval.refusals.push_back({"its golden is a Git LFS pointer: fetch it with git lfs pull"});
    else if (!fs::exists(approval.golden, ignored))
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

/// The decisions of a person, if the options name them. Rejected tests are remarks.
std::optional<Review> review_of(const RunResult& run, const ApproveOptions& options,
                                std::vector<std::string>& remarks) {
    if (options.review.empty()) return std::nullopt;
    Review review = read_review(options.review);
    if (review.suite != run.suite)
        throw Error({options.review.string()},
                    fmt::format("this is a review of the suite \"{}\"", review.suite),
                    fmt::format("take one of \"{}\"", run.suite));
    for (const ReviewedTest& test : review.rejected)
        remarks.push_back(fmt::format("rejected: {}", test.name));
    return review;
}

std::span<const std::uint8_t> bytes_of(const std::string& text) {
    return {reinterpret_cast<const std::uint8_t*>(text.data()), text.size()};
}

} // namespace

bool ApprovalPlan::is_allowed(bool force) const {
    return std::ranges::all_of(approvals, [&](const Approval& approval) {
        return std::ranges::all_of(approval.refusals,
                                   [&](const Refusal& r) { return force && r.yields_to_force; });
    });
}

ApprovalPlan plan_approval(const Suite& suite, const ApproveOptions& options) {
    const RunResult all = read_results(options.output), run = all.of_this_run();
    if (!are_of(all, options.output, suite))
        throw Error({results_file(options.output).string()},
                    fmt::format("the last run there was of {}", run.suite_file),
                    "run this suite, or name its output folder with --output");
    if (!options.alternate.empty()) check_label(options.alternate);
    ApprovalPlan plan;
    if (const auto earlier = all.tests.size() - run.tests.size())
        plan.remarks.push_back(
            fmt::format("{} tests of an earlier run are left out: the last one did not run them", earlier));
    const auto laws = law_record(suite, options, plan.remarks);
    const std::optional<Review> review = review_of(run, options, plan.remarks);
    for (const TestResult& result : choose(run, options, review)) {
        Approval approval{result.name, options.output / result.candidate, {}, {}, {}, {}, {}};
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
        if (review && approved_in(*review, result.name)->candidate_sha256 != result.candidate_sha256)
            approval.refusals.push_back({"its picture is not the one that was reviewed: review it again"});
        if (laws)
            for (const std::string& law : laws->failed_among(test->guards))
                approval.refusals.push_back({fmt::format("{} fails", law), true});
        if (!approval.bytes.empty())
            if (auto refusal = is_alternate ? alternate_refusal(suite, result, *test)
                                            : renderer_refusal(suite, result, *test))
                approval.refusals.push_back(std::move(*refusal));
        plan.approvals.push_back(std::move(approval));
    }
    return plan;
}

void carry_out(const ApprovalPlan& plan) {
    image::WholeFiles goldens;
    for (const Approval& approval : plan.approvals) {
        if (approval.change == "equal") continue;
        std::error_code failure;
        fs::create_directories(approval.golden.parent_path(), failure);
        goldens.add(approval.golden, bytes_of(approval.bytes));
        if (!approval.sidecar.empty()) goldens.add(sidecar_of(approval.golden), bytes_of(approval.sidecar));
    }
    goldens.put_in_place();
    for (const Approval& approval : plan.approvals) // of the golden before
        if (approval.change != "equal" && approval.sidecar.empty()) {
            std::error_code ignored;
            fs::remove(sidecar_of(approval.golden), ignored);
        }
}

} // namespace sr::golden
