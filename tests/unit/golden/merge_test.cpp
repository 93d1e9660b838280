#include "golden/merge.hpp"

#include "core/error.hpp"
#include "core/file.hpp"
#include "golden/report.hpp"
#include "image/file.hpp"
#include "support/address.hpp"
#include "support/models.hpp"
#include "unit/golden/suite_support.hpp"

#include <cstdlib>

using namespace sr;
using namespace sr::testing;
using golden::Outcome;
using sr::testing::Test;
namespace fs = std::filesystem;

namespace {

/// Runs a part of a suite into FOLDER/shardK and keeps its results.
fs::path run_shard(const golden::Suite& suite, int index, int count) {
    auto options = run_options(suite.folder / fmt::format("shard{}", index));
    options.shard = golden::Shard{index, count};
    golden::write_results(golden::run(suite, options).value(), options.output);
    return options.output;
}

/// A suite of one test that runs a shell script.
golden::Suite script_suite(const fs::path& folder, const std::string& script) {
    image::write(plain(0.5f), folder / "s.exr", image::SampleType::floating);
    return golden::load_suite(written(
        folder / "suite.json",
        fmt::format(R"({{"tests": [{{"name": "a", "command": ["sh", "-c", "{}", "{{out}}"]}}]}})", script)));
}

const Test parts("unit.golden.shard.each_test_is_in_one_shard", [] {
    EXPECT_EQ(golden::parsed_shard("2/8"), (golden::Shard{2, 8}));
    for (const char* text : {"", "2", "/", "0/3", "4/3", "-1/3", "1/3x", "1/", "1/99999", "1/99999999999"})
        EXPECT_FALSE(golden::parsed_shard(text)) << text;
    const auto suite = copying_suite(scratch_folder("shard_parts"), {"a", "b", "c", "d", "e"});
    for (int count = 1; count <= 7; ++count) {
        std::map<std::string, int> seen;
        for (int index = 1; index <= count; ++index) {
            golden::RunOptions options;
            options.shard = golden::Shard{index, count};
            for (const auto& test : golden::chosen_tests(suite, options)) ++seen[test.name];
        }
        EXPECT_EQ(seen.size(), 5u);
        for (const auto& [name, times] : seen) EXPECT_EQ(times, 1) << name << " of " << count;
    }
});

const Test merged("unit.golden.merge.equals_a_run_of_the_whole_suite", [] {
    const auto folder = scratch_folder("merge");
    const auto suite = copying_suite(folder, {"a", "b:c", "d"});
    run_and_keep(suite, folder / "whole");
    auto options = run_options(folder / "merged");
    const auto merged = golden::merge_shards(
        suite,
        {run_shard(suite, 1, 4), run_shard(suite, 2, 4), run_shard(suite, 3, 4), run_shard(suite, 4, 4)},
        options);
    golden::write_results(merged.result, options.output);
    EXPECT_EQ(read_text(golden::results_file(options.output)),
              read_text(golden::results_file(folder / "whole")));
    golden::ApproveOptions approval;
    approval.output = options.output;
    const auto plan = golden::plan_approval(suite, approval);
    EXPECT_EQ(plan.approvals.size(), 3u);
    EXPECT_TRUE(plan.is_allowed(false)) << "the pictures did not come along";
});

const Test balanced("unit.golden.shard.durations_balance_the_shards", [] {
    const auto suite = copying_suite(scratch_folder("shard_balance"), {"a", "b", "c", "d", "e", "f"});
    const auto shard = [&](int index) {
        golden::RunOptions options;
        options.shard = golden::Shard{index, 2};
        options.seconds = {{"a", 9.0}, {"b", 1.0}, {"c", 2.0},
                           {"d", 3.0}, {"e", 4.0}, {"of another suite", 1.0}};
        std::string names;
        for (const auto& test : golden::chosen_tests(suite, options)) names += test.name;
        return names;
    };
    // The longest first: a (9) | e (4), f (unknown: the mean, 3.3), d (3) | c (2), then b (1) to the emptier
    // one.
    EXPECT_EQ(shard(1), "ac");
    EXPECT_EQ(shard(2), "bdef");
    const auto folder = scratch_folder("shard_times");
    golden::RunRecord record;
    record.seconds = {{"a", 2.5}};
    golden::write_record(record, folder);
    EXPECT_EQ(golden::read_durations(golden::record_file(folder)), record.seconds);
    EXPECT_NE(
        error_of([&] { golden::read_durations(written(folder / "x.json", "[]")); }).find("no durations"),
        std::string::npos);
});

const Test untouched("unit.golden.merge.a_refusal_changes_nothing", [] {
    const auto folder = scratch_folder("merge_untouched");
    const auto suite = copying_suite(folder, {"a", "b"});
    const auto output = folder / "merged";
    run_and_keep(suite, output);
    const std::string before = read_text(golden::results_file(output));
    const auto refusal = [&](const std::vector<fs::path>& folders) {
        const std::string text = error_of([&] { golden::merge_shards(suite, folders, run_options(output)); });
        EXPECT_EQ(read_text(golden::results_file(output)), before) << text;
        EXPECT_TRUE(fs::exists(output / "candidates/a.exr")) << text;
        return text;
    };
    fs::create_directories(folder / "empty");
    EXPECT_NE(refusal({folder / "empty"}).find("nothing was changed"), std::string::npos);
    const auto first = run_shard(suite, 1, 2);
    EXPECT_NE(refusal({first, first}).find("is in"), std::string::npos);
    fs::create_directories(folder / "other"); // another suite of the same name, "suite", with the same tests
    const auto other = copying_suite(folder / "other", {"a", "b"}, R"("laws": "laws.xml",)");
    EXPECT_NE(refusal({run_shard(other, 1, 1)}).find("was another file"), std::string::npos);
});

const Test unreadable("unit.golden.run.an_unreadable_file_stays_visible", [] {
    const auto folder = scratch_folder("run_unreadable");
    const auto suite = copying_suite(folder, {"candidate", "golden", "good"});
    fs::create_directories(suite.goldens);
    for (const auto& test : suite.tests)
        image::write(plain(0.5f), suite.golden_of(test), image::SampleType::floating);
    written(folder / "candidate-source.exr", "no image");
    written(suite.golden_of(suite.tests[1]), "no image");
    const auto options = run_options(folder / "merged");
    const auto merged =
        golden::merge_shards(suite, {run_shard(suite, 1, 2), run_shard(suite, 2, 2)}, options);
    golden::write_results(merged.result, options.output);
    const auto result = golden::read_results(options.output);
    EXPECT_EQ(result.count(Outcome::unreadable), 2) << golden::count_text(result);
    EXPECT_EQ(golden::count_text(result), "1 of 3 passed, 2 unreadable");
    EXPECT_FALSE(result.tests.at(1).candidate.empty()) << "the picture itself is there";
    EXPECT_NE(golden::junit_xml(result).find("failures=\"0\" errors=\"2\""), std::string::npos);
});

const Test commit("unit.golden.run.a_warning_of_git_is_no_commit", [] {
    const auto folder = scratch_folder("run_commit");
    fs::create_directories(folder / "bin");
    const std::string name(40, 'a');
    const auto git = written(folder / "bin/git", "#!/bin/sh\necho warning: odd >&2\necho " + name
                                                     + "\necho 'warning: unable' >&2\n");
    fs::permissions(git, fs::perms::owner_all);
    const std::string path = std::getenv("PATH");
    for (const char* variable : {"GITHUB_SHA", "CI_COMMIT_SHA", "GIT_COMMIT"}) unsetenv(variable);
    setenv("PATH", ((folder / "bin").string() + ":" + path).c_str(), 1);
    EXPECT_EQ(golden::begun_record(folder, folder / "out").commit, name);
    written(git, "#!/bin/sh\necho warning: odd\n");
    EXPECT_EQ(golden::begun_record(folder, folder / "out").commit, "");
    setenv("PATH", path.c_str(), 1);
});

const Test lost("unit.golden.merge.a_lost_shard_fails", [] {
    const auto folder = scratch_folder("merge_lost");
    const auto suite = copying_suite(folder, {"a", "b", "c"});
    const auto first = run_shard(suite, 1, 2);
    fs::create_directories(folder / "shard2"); // which was not run to its end
    const auto merged =
        golden::merge_shards(suite, {first, folder / "shard2"}, run_options(folder / "merged"));
    ASSERT_EQ(merged.result.tests.size(), 3u);
    EXPECT_EQ(merged.result.tests[1].outcome, Outcome::broken);
    EXPECT_NE(merged.result.tests[1].message.find("no shard"), std::string::npos);
    EXPECT_EQ(merged.remarks.size(), 1u);
    EXPECT_NE(error_of([&] {
                  golden::merge_shards(suite, {folder / "shard2"}, run_options(folder / "merged"));
              }).find("none of the folders"),
              std::string::npos);
});

const Test refused("unit.golden.merge.refuses_what_does_not_belong_together", [] {
    const auto folder = scratch_folder("merge_refused");
    const auto suite = copying_suite(folder, {"a", "b"});
    const auto first = run_shard(suite, 1, 2), second = run_shard(suite, 2, 2);
    const auto refusal = [&](std::vector<fs::path> folders) {
        return error_of([&] { golden::merge_shards(suite, folders, run_options(folder / "merged")); });
    };
    fs::copy(first, folder / "again", fs::copy_options::recursive);
    EXPECT_NE(refusal({first, folder / "again"}).find("the test a is in"), std::string::npos);
    fs::create_directories(folder / "merged");
    written(golden::results_file(folder / "merged"), "{}");
    EXPECT_NE(refusal({folder / "merged"}).find("output folder, too"), std::string::npos);
    EXPECT_TRUE(fs::exists(golden::results_file(folder / "merged")));
    golden::RunRecord record;
    record.commit = "1111";
    golden::write_record(record, first);
    record.commit = "2222";
    golden::write_record(record, second);
    EXPECT_NE(refusal({first, second}).find("one commit"), std::string::npos);
    std::string text = read_text(golden::results_file(first));
    const auto place = text.find("candidates/a");
    ASSERT_NE(place, std::string::npos);
    written(golden::results_file(first), text.replace(place, 12, "candidates/a/../../../s"));
    EXPECT_NE(refusal({first}).find("no file of a run"), std::string::npos);
    const auto other = copying_suite(scratch_folder("merge_other"), {"x"}, R"("name": "other",)");
    EXPECT_NE(refusal({run_shard(other, 1, 1)}).find("the suite \"other\""), std::string::npos);
});

const Test flaky("unit.golden.run.a_test_that_passes_when_tried_again_is_flaky", [] {
    const auto folder = scratch_folder("run_flaky");
    const auto suite = script_suite(
        folder, "if test -e tried; then cp s.exr $0; else touch tried; echo boom >&2; exit 5; fi");
    fs::create_directories(suite.goldens);
    image::write(plain(0.5f), suite.golden_of(suite.tests[0]), image::SampleType::floating);
    auto options = run_options(folder / "out");
    options.retries = 2;
    auto result = golden::run(suite, options).value();
    ASSERT_EQ(result.tests.at(0).outcome, Outcome::flaky) << result.tests.at(0).message;
    EXPECT_FALSE(result.passed()) << "a retry hid the failure";
    ASSERT_EQ(result.tests.at(0).attempts.size(), 1u);
    EXPECT_NE(result.tests.at(0).attempts[0].message.find("boom"), std::string::npos);
    golden::write_results(result, options.output);
    EXPECT_EQ(golden::read_results(options.output).tests.at(0).attempts.size(), 1u);
    const std::string junit = golden::junit_xml(result);
    EXPECT_NE(junit.find("<flakyFailure"), std::string::npos) << junit;
    EXPECT_NE(junit.find("failures=\"0\" errors=\"0\""), std::string::npos) << junit;
    EXPECT_EQ(golden::count_text(result), "0 of 1 passed, 1 flaky");
});

const Test attempts("unit.golden.run.keeps_the_picture_of_each_failed_attempt", [] {
    const auto folder = scratch_folder("run_attempts");
    const auto suite = script_suite(folder, "cp s.exr $0");
    fs::create_directories(suite.goldens);
    image::write(plain(0.9f), suite.golden_of(suite.tests[0]), image::SampleType::floating);
    auto options = run_options(folder / "out");
    options.retries = 2;
    const auto test = golden::run(suite, options).value().tests.at(0);
    EXPECT_EQ(test.outcome, Outcome::differs);
    ASSERT_EQ(test.attempts.size(), 2u);
    for (const auto& attempt : test.attempts) EXPECT_TRUE(fs::exists(folder / "out" / attempt.candidate));
    EXPECT_TRUE(fs::exists(folder / "out" / test.candidate));
});

const Test kept("unit.golden.run.a_filter_keeps_the_results_of_other_tests", [] {
    const auto folder = scratch_folder("run_kept");
    const auto suite = copying_suite(folder, {"a", "b", "c"});
    run_and_keep(suite, folder / "out");
    auto options = run_options(folder / "out");
    options.filters = {"b"};
    const auto result = golden::run(suite, options).value();
    ASSERT_EQ(result.tests.size(), 3u);
    EXPECT_TRUE(result.tests[0].is_earlier);
    EXPECT_FALSE(result.tests[1].is_earlier);
    EXPECT_EQ(result.of_this_run().tests.size(), 1u);
    golden::write_results(result, options.output);
    EXPECT_TRUE(golden::read_results(options.output).tests.at(2).is_earlier);
    EXPECT_EQ(run_and_keep(suite, folder / "out").of_this_run().tests.size(), 3u);
    fs::create_directories(folder / "other"); // another suite, with the same default name
    const auto other = copying_suite(folder / "other", {"a", "b"});
    EXPECT_EQ(golden::run(other, options).value().tests.size(), 1u) << "results of another suite were kept";
});

const Test names("unit.golden.files.names_that_every_artifact_store_takes", [] {
    EXPECT_EQ(golden::file_name_of("zoo_spot-1.2 é"), "zoo_spot-1.2 é");
    EXPECT_EQ(golden::file_name_of("a:b\"<|>*?%"), "a%3Ab%22%3C%7C%3E%2A%3F%25");
    const std::string marks(120, ':');
    EXPECT_LT(golden::file_name_of(marks).size(), 200u);
    EXPECT_NE(golden::file_name_of(marks), golden::file_name_of(marks.substr(1)));
});

const Test orphans("unit.golden.list.finds_goldens_of_no_test", [] {
    const auto folder = scratch_folder("orphans");
    const auto suite = copying_suite(folder, {"a"});
    EXPECT_TRUE(golden::orphans_of(suite).empty()) << "there is no folder";
    fs::create_directories(suite.goldens / "alternates/nvidia");
    for (const char* file :
         {"a.exr", "gone.exr", ".gitattributes", "alternates/nvidia/a.exr", "alternates/nvidia/gone.exr"})
        written(suite.goldens / file, "");
    EXPECT_EQ(golden::orphans_of(suite), (std::vector<fs::path>{suite.goldens / "alternates/nvidia/gone.exr",
                                                                suite.goldens / "gone.exr"}));
});

const Test history("unit.golden.history.shows_outcomes_from_the_earliest_run", [] {
    const auto folder = scratch_folder("history");
    const auto write = [&](const std::string& name, const std::string& began, std::vector<Outcome> outcomes) {
        golden::RunResult run{"s", "s.json", {}};
        golden::RunRecord record;
        record.began = began;
        for (std::size_t i = 0; i < outcomes.size(); ++i) {
            run.tests.emplace_back().name = std::string(1, static_cast<char>('a' + i));
            run.tests.back().outcome = outcomes[i];
            record.seconds[run.tests.back().name] = 1.0;
        }
        fs::create_directories(folder / name);
        golden::write_results(run, folder / name);
        golden::write_record(record, folder / name);
        return folder / name;
    };
    const auto late = write("late", "2024-02-02", {Outcome::flaky, Outcome::missing});
    const auto early = write("early", "2024-01-01", {Outcome::passed});
    const auto runs = golden::read_history({late, early});
    EXPECT_EQ(golden::history_text(runs), fmt::format("{:<28} .~  1 of 2 passed, 1 flaky  1.00 s\n"
                                                      "{:<28} -M  0 of 1 passed  1.00 s\n",
                                                      "a", "b"));
    EXPECT_EQ(golden::history_json(runs)["tests"][1]["outcomes"].dump(), "[null,\"missing\"]");
    golden::RunResult filtered{"s", "s.json", {}};
    filtered.tests.emplace_back().name = "a";
    filtered.tests.back().is_earlier = true;
    fs::create_directories(folder / "filtered");
    golden::write_results(filtered, folder / "filtered");
    EXPECT_EQ(golden::history_text(golden::read_history({folder / "filtered"})),
              fmt::format("{:<28} -  not run\n", "a"));
});

const Test summary("unit.golden.summary.escapes_and_stays_short", [] {
    golden::RunResult run{"s", "s.json", {}};
    for (int i = 0; i < 1000; ++i) {
        run.tests.emplace_back().name = "a|<b>";
        run.tests.back().message = std::string(500, '|') + "\n";
    }
    const std::string text = golden::summary_markdown(run, std::nullopt);
    EXPECT_LT(text.size(), 60000u);
    EXPECT_NE(text.find("| broken | a\\|&lt;b&gt; |"), std::string::npos) << text.substr(0, 300);
    EXPECT_NE(text.find("further tests"), std::string::npos);
});

} // namespace
