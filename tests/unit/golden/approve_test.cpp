#include "core/error.hpp"
#include "golden/approve.hpp"
#include "image/file.hpp"
#include "support/address.hpp"
#include "support/models.hpp"
#include "unit/golden/suite_support.hpp"

#include <limits>

using namespace sr;
using namespace sr::testing;
using golden::Outcome;
using sr::testing::Test;
namespace fs = std::filesystem;

namespace {

constexpr const char* laws_xml = R"(<?xml version="1.0"?><!-- <testcase name="law.no"/> -->
<testsuite name="x"><testcase name="law.good" status="run"><system-out>&lt;failure <![CDATA[<failure/>]]></system-out></testcase>
<testcase name="law.b&quot;ad" classname="c" status="fail"><failure message="a > b"/></testcase>
<testcase classname='c' name='truth.cornell.sampled'><error/></testcase>
<testcase name="analytic.gone" status="notrun"/></testsuite>)";

golden::ApprovalPlan plan(const golden::Suite& suite, const fs::path& output,
                          std::vector<std::string> names = {}) {
    golden::ApproveOptions options;
    options.output = output;
    options.names = std::move(names);
    return golden::plan_approval(suite, options);
}

/// The reasons of the first test, in one text.
std::string refusals(const golden::ApprovalPlan& plan) {
    std::string text;
    for (const auto& refusal : plan.approvals.at(0).refusals) text += refusal.reason + "; ";
    return text;
}

const Test approves("unit.golden.approve.the_next_run_passes", [] {
    const auto folder = scratch_folder("approve");
    const auto suite = copying_suite(folder, {"a", "b"});
    run_and_keep(suite, folder / "out");
    const auto only_a = plan(suite, folder / "out", {"a"});
    EXPECT_EQ(only_a.approvals.at(0).change, "new");
    EXPECT_FALSE(fs::exists(suite.goldens)) << "a plan writes nothing";
    golden::carry_out(only_a);
    const auto result = run_and_keep(suite, folder / "out");
    EXPECT_EQ(result.tests.at(0).outcome, Outcome::passed);
    EXPECT_EQ(result.tests.at(1).outcome, Outcome::missing) << "it was not named";
    EXPECT_EQ(plan(suite, folder / "out").approvals.size(), 1u) << "what passed needs no approval";
    EXPECT_EQ(plan(suite, folder / "out", {"a"}).approvals.at(0).change, "equal");
});

const Test only_last_run("unit.golden.approve.takes_only_what_was_just_compared", [] {
    const auto folder = scratch_folder("approve_last");
    const auto suite = copying_suite(folder, {"a"});
    EXPECT_NE(error_of([&] { plan(suite, folder / "out"); }).find("no results of a run"), std::string::npos);
    run_and_keep(suite, folder / "out");
    EXPECT_NE(error_of([&] { plan(suite, folder / "out", {"b"}); }).find("no test b"), std::string::npos);
    image::write(plain(0.6f), folder / "out/candidates/a.exr", image::SampleType::floating);
    const auto changed = plan(suite, folder / "out");
    EXPECT_NE(refusals(changed).find("not the one that the last run compared"), std::string::npos);
    EXPECT_FALSE(changed.is_allowed(true)) << "force does not make it the right file";
    fs::remove(folder / "out/candidates/a.exr");
    EXPECT_FALSE(plan(suite, folder / "out").is_allowed(true));
});

const Test nonfinite("unit.golden.approve.refuses_pixels_that_are_not_finite", [] {
    const auto folder = scratch_folder("approve_nan");
    const auto suite = copying_suite(folder, {"a"});
    image::Image nan = plain(0.5f);
    nan.pixels[7] = std::numeric_limits<float>::quiet_NaN();
    image::write(nan, folder / "a-source.exr", image::SampleType::floating);
    run_and_keep(suite, folder / "out");
    EXPECT_NE(refusals(plan(suite, folder / "out")).find("1 of its values are not finite"),
              std::string::npos);
    EXPECT_FALSE(plan(suite, folder / "out").is_allowed(true));
});

const Test renderer("unit.golden.approve.refuses_another_renderer_unless_forced", [] {
    const auto folder = scratch_folder("approve_renderer");
    const auto suite =
        copying_suite(folder, {"a"}, R"("renderer": {"GL_RENDERER": "llvmpipe", "GL_VERSION": "4.5"},)");
    run_and_keep(suite, folder / "out");
    EXPECT_TRUE(plan(suite, folder / "out").is_allowed(false)) << refusals(plan(suite, folder / "out"));
    image::write(plain(0.5f, "NVIDIA"), folder / "a-source.exr", image::SampleType::floating);
    run_and_keep(suite, folder / "out");
    const auto other = plan(suite, folder / "out");
    EXPECT_NE(refusals(other).find("reference renderer is llvmpipe"), std::string::npos) << refusals(other);
    EXPECT_FALSE(other.is_allowed(false));
    EXPECT_TRUE(other.is_allowed(true));
});

const Test golden_renderer("unit.golden.approve.without_a_reference_the_goldens_renderer_counts", [] {
    const auto folder = scratch_folder("approve_golden_renderer");
    const auto suite = copying_suite(folder, {"a"});
    fs::create_directories(suite.goldens);
    image::write(plain(0.9f, "NVIDIA"), suite.golden_of(suite.tests[0]), image::SampleType::floating);
    run_and_keep(suite, folder / "out");
    EXPECT_NE(refusals(plan(suite, folder / "out")).find("its golden by NVIDIA"), std::string::npos);
});

const Test laws("unit.golden.approve.refuses_while_a_law_fails", [] {
    const auto folder = scratch_folder("approve_laws");
    const auto suite = copying_suite(folder, {"a"}, R"("laws": "laws.xml",)");
    run_and_keep(suite, folder / "out");
    const auto unrecorded = plan(suite, folder / "out");
    EXPECT_TRUE(unrecorded.is_allowed(false));
    EXPECT_EQ(unrecorded.remarks.size(), 1u) << "that nothing is recorded is said";
    written(folder / "laws.xml", laws_xml);
    const auto recorded = plan(suite, folder / "out");
    EXPECT_EQ(refusals(recorded), "law.b\"ad fails; ");
    EXPECT_FALSE(recorded.is_allowed(false));
    EXPECT_TRUE(recorded.is_allowed(true));
});

const Test record("unit.golden.laws.reads_junit_of_any_program", [] {
    const auto folder = scratch_folder("laws");
    const auto found = golden::read_law_record(written(folder / "l.xml", laws_xml));
    EXPECT_EQ(found.tests, 4);
    EXPECT_EQ(found.failed,
              (std::vector<std::string>{"law.b\"ad", "truth.cornell.sampled", "analytic.gone"}));
    const std::vector<std::string> guards{"truth.cornell", "analytic.other"};
    EXPECT_EQ(found.failed_among(guards), (std::vector<std::string>{"truth.cornell.sampled"}));
    EXPECT_THROW(golden::read_law_record(written(folder / "e.xml", "<a/>")), Error);
    for (std::size_t length = 0; length < std::string_view(laws_xml).size(); ++length)
        error_of([&] { golden::read_law_record(written(folder / "t.xml", std::string(laws_xml, length))); });
});

const Test sidecar("unit.golden.approve.a_png_has_alternates_by_the_file_beside_it", [] {
    const auto folder = scratch_folder("approve_sidecar");
    const auto show = [&](float value, const std::string& driver) {
        image::Image picture = plain(value);
        picture.attributes.clear();
        image::write(picture, folder / "s.png", image::SampleType::integer8);
        written(folder / "s.json", R"({"renderer": ")" + driver + R"(", "version": "1"})");
    };
    const auto suite =
        golden::load_suite(written(folder / "suite.json", R"({"tests": [{"name": "a", "format": "png",
        "command": ["sh", "-c", "cp s.png $0; cp s.json $0.json", "{out}"]}]})"));
    const auto run = [&] { return run_and_keep(suite, folder / "out").tests.at(0); };
    show(0.5f, "one");
    EXPECT_EQ(run().candidate_renderer, "one, 1");
    golden::carry_out(plan(suite, folder / "out"));
    EXPECT_EQ(run().golden_renderer, "one, 1");
    EXPECT_TRUE(golden::orphans_of(suite).empty());
    show(0.7f, "two");
    EXPECT_EQ(run().outcome, Outcome::differs);
    golden::ApproveOptions options;
    options.output = folder / "out";
    options.alternate = "two";
    const auto alternate = golden::plan_approval(suite, options);
    EXPECT_TRUE(alternate.is_allowed(false)) << refusals(alternate);
    golden::carry_out(alternate);
    EXPECT_EQ(run().alternate, "two");
    show(0.7f, "one"); // the golden's own renderer has no alternate
    EXPECT_EQ(run().outcome, Outcome::differs);
    written(folder / "s.json", "{\"GPU\": 1}");
    EXPECT_NE(run().message.find("GPU"), std::string::npos) << run().message;
});

const Test all_or_nothing("unit.golden.approve.writes_all_goldens_or_none", [] {
    const auto folder = scratch_folder("approve_all");
    const auto suite = copying_suite(folder, {"a", "b"});
    run_and_keep(suite, folder / "out");
    fs::create_directories(suite.golden_of(suite.tests[1])); // a folder in the place of the second golden
    EXPECT_NE(error_of([&] { golden::carry_out(plan(suite, folder / "out")); }).find("this is a folder"),
              std::string::npos);
    EXPECT_EQ(std::distance(fs::directory_iterator(suite.goldens), fs::directory_iterator()), 1)
        << "the first golden, or a temporary file, was left";
});

const Test lfs("unit.golden.approve.refuses_a_git_lfs_pointer", [] {
    const char* pointer = "version https://git-lfs.github.com/spec/v1\noid sha256:4d7a\nsize 12345\n";
    const auto folder = scratch_folder("approve_lfs");
    const auto suite = copying_suite(folder, {"a"});
    run_and_keep(suite, folder / "out");
    fs::create_directories(suite.goldens);
    written(suite.golden_of(suite.tests[0]), pointer);
    const auto with_golden = plan(suite, folder / "out");
    EXPECT_NE(refusals(with_golden).find("git lfs pull"), std::string::npos) << refusals(with_golden);
    EXPECT_FALSE(with_golden.is_allowed(true));
    const auto result = run_and_keep(suite, folder / "out").tests.at(0);
    EXPECT_NE(result.message.find("git lfs pull"), std::string::npos) << result.message;
    fs::remove(suite.golden_of(suite.tests[0]));
    written(folder / "a-source.exr", pointer); // the candidate is one
    run_and_keep(suite, folder / "out");
    const auto with_candidate = plan(suite, folder / "out");
    EXPECT_NE(refusals(with_candidate).find("git lfs pull"), std::string::npos) << refusals(with_candidate);
});

const Test except("unit.golden.approve.leaves_the_excepted_tests", [] {
    const auto folder = scratch_folder("approve_except");
    const auto suite = copying_suite(folder, {"a", "b", "c"});
    run_and_keep(suite, folder / "out");
    golden::ApproveOptions options;
    options.output = folder / "out";
    options.except = {"b"};
    const auto found = golden::plan_approval(suite, options);
    ASSERT_EQ(found.approvals.size(), 2u);
    EXPECT_EQ(found.approvals[1].name, "c");
    options.except = {"d"};
    EXPECT_NE(error_of([&] { golden::plan_approval(suite, options); }).find("no test d"), std::string::npos);
});

const Test last_run("unit.golden.approve.takes_only_tests_of_the_last_run", [] {
    const auto folder = scratch_folder("approve_earlier");
    const auto suite = copying_suite(folder, {"a", "b"});
    run_and_keep(suite, folder / "out");
    auto options = run_options(folder / "out");
    options.filters = {"b"};
    golden::write_results(golden::run(suite, options).value(), options.output);
    const auto found = plan(suite, folder / "out");
    ASSERT_EQ(found.approvals.size(), 1u);
    EXPECT_EQ(found.approvals[0].name, "b");
    ASSERT_EQ(found.remarks.size(), 1u);
    EXPECT_NE(found.remarks[0].find("1 tests of an earlier run"), std::string::npos) << found.remarks[0];
    EXPECT_NE(error_of([&] { plan(suite, folder / "out", {"a"}); }).find("no test a"), std::string::npos);
});

const Test other_suite("unit.golden.approve.refuses_the_run_of_another_suite_of_the_same_name", [] {
    const auto folder = scratch_folder("approve_other");
    fs::create_directories(folder / "one");
    fs::create_directories(folder / "two");
    const auto one = copying_suite(folder / "one", {"a", "c"}), two = copying_suite(folder / "two", {"a"});
    run_and_keep(one, folder / "out");
    EXPECT_NE(error_of([&] { plan(two, folder / "out"); }).find("the last run there was of"),
              std::string::npos);
    auto edited = copying_suite(folder / "one", {"a", "b", "c"}); // the same suite with one more test
    EXPECT_EQ(plan(edited, folder / "out").approvals.size(), 2u);
    fs::create_directories(folder / "elsewhere");
    fs::copy(folder / "out", folder / "elsewhere/out", fs::copy_options::recursive); // as an artifact of CI
    EXPECT_EQ(plan(copying_suite(folder / "one", {"a", "c"}), folder / "elsewhere/out").approvals.size(), 2u);
});

const Test reviewed("unit.golden.approve.takes_what_was_reviewed", [] {
    const auto folder = scratch_folder("approve_review");
    const auto suite = copying_suite(folder, {"a", "b", "c"});
    const auto run = run_and_keep(suite, folder / "out");
    const auto entry = [&](std::size_t i) {
        return fmt::format(R"({{"name": "{}", "candidate_sha256": "{}"}})", run.tests.at(i).name,
                           run.tests.at(i).candidate_sha256);
    };
    golden::ApproveOptions options;
    options.output = folder / "out";
    const auto plan_review = [&](const std::string& approved, const std::string& rejected) {
        options.review = written(
            folder / "review.json",
            fmt::format(
                R"({{"steradian_golden_review": 1, "suite": "suite", "approved": [{}], "rejected": [{}]}})",
                approved, rejected));
        return golden::plan_approval(suite, options);
    };
    const auto found = plan_review(entry(0), entry(1));
    ASSERT_EQ(found.approvals.size(), 1u);
    EXPECT_EQ(found.approvals[0].name, "a");
    EXPECT_TRUE(found.is_allowed(false)) << refusals(found);
    EXPECT_EQ(found.remarks, std::vector<std::string>{"rejected: b"});
    EXPECT_NE(error_of([&] { plan_review(entry(0), entry(0)); }).find("decided twice"), std::string::npos);
    EXPECT_NE(
        error_of([&] { plan_review(R"({"name": "d", "candidate_sha256": "0"})", ""); }).find("no test d"),
        std::string::npos);
    image::write(plain(0.6f), folder / "a-source.exr", image::SampleType::floating);
    run_and_keep(suite, folder / "out"); // another picture than the reviewed one
    const auto changed = plan_review(entry(0), "");
    EXPECT_NE(refusals(changed).find("not the one that was reviewed"), std::string::npos);
    EXPECT_FALSE(changed.is_allowed(true));
});

const Test alternate("unit.golden.approve.an_alternate_holds_for_its_driver_alone", [] {
    const auto folder = scratch_folder("approve_alternate");
    const auto suite = copying_suite(folder, {"a"});
    const auto source = folder / "a-source.exr";
    const auto plan_alternate = [&](const std::string& label) {
        golden::ApproveOptions options;
        options.output = folder / "out";
        options.alternate = label;
        return golden::plan_approval(suite, options);
    };
    run_and_keep(suite, folder / "out");
    EXPECT_NE(refusals(plan_alternate("nvidia")).find("no golden yet"), std::string::npos);
    golden::carry_out(plan(suite, folder / "out"));

    image::write(plain(0.6f), source, image::SampleType::floating); // a change of the golden's own renderer
    run_and_keep(suite, folder / "out");
    EXPECT_NE(refusals(plan_alternate("llvmpipe")).find("own renderer"), std::string::npos);

    image::write(plain(0.6f, "NVIDIA"), source, image::SampleType::floating);
    EXPECT_EQ(run_and_keep(suite, folder / "out").tests.at(0).outcome, Outcome::differs);
    EXPECT_NE(error_of([&] { plan_alternate("../x"); }).find("cannot name"), std::string::npos);
    const auto allowed = plan_alternate("nvidia");
    EXPECT_TRUE(allowed.is_allowed(false));
    golden::carry_out(allowed);
    const auto result = run_and_keep(suite, folder / "out");
    EXPECT_EQ(result.tests.at(0).outcome, Outcome::passed);
    EXPECT_EQ(result.tests.at(0).alternate, "nvidia");
    EXPECT_EQ(result.passed_by_alternates(), 1);

    image::write(plain(0.6f), source, image::SampleType::floating);
    EXPECT_EQ(run_and_keep(suite, folder / "out").tests.at(0).outcome, Outcome::differs)
        << "another driver hides behind it";
});

} // namespace
