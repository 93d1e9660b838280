#include "core/error.hpp"
#include "core/file.hpp"
#include "golden/report.hpp"
#include "image/file.hpp"
#include "support/address.hpp"
#include "support/models.hpp"
#include "unit/golden/suite_support.hpp"

#include <chrono>
#include <fstream>
#include <limits>
#include <thread>

using namespace sr;
using namespace sr::testing;
using golden::Outcome;
using sr::testing::Test;
namespace fs = std::filesystem;
using Clock = std::chrono::steady_clock;

namespace {

golden::Suite suite_of(const fs::path& folder, const std::string& tests) {
    return golden::load_suite(written(folder / "suite.json", "{\"tests\": [" + tests + "]}"));
}

double seconds_since(Clock::time_point begin) {
    return std::chrono::duration<double>(Clock::now() - begin).count();
}

const Test missing("unit.golden.run.a_missing_golden_fails_and_leaves_the_candidate", [] {
    const auto folder = scratch_folder("run_missing");
    const auto result = run_and_keep(copying_suite(folder, {"a"}), folder / "out");
    EXPECT_EQ(result.tests.at(0).outcome, Outcome::missing);
    EXPECT_FALSE(result.passed());
    EXPECT_TRUE(fs::exists(folder / "out/candidates/a.exr"));
    EXPECT_FALSE(fs::exists(folder / "goldens")) << "a golden appeared by itself";
});

const Test outcomes("unit.golden.run.each_outcome", [] {
    const auto folder = scratch_folder("run_outcomes");
    const auto suite = copying_suite(folder, {"same", "other", "nan"});
    fs::create_directories(suite.goldens);
    for (const auto& test : suite.tests)
        image::write(plain(0.5f), suite.golden_of(test), image::SampleType::floating);
    image::write(plain(0.5f * 3.14159265f), folder / "other-source.exr", image::SampleType::floating);
    image::Image nan = plain(0.5f);
    nan.pixels[7] = std::numeric_limits<float>::quiet_NaN();
    image::write(nan, folder / "nan-source.exr", image::SampleType::floating);
    const auto result = run_and_keep(suite, folder / "out");
    EXPECT_EQ(result.tests.at(0).outcome, Outcome::passed) << result.tests.at(0).message;
    EXPECT_EQ(result.tests.at(1).outcome, Outcome::differs);
    EXPECT_EQ(result.tests.at(2).outcome, Outcome::differs);
    const auto back = golden::read_results(folder / "out");
    EXPECT_EQ(back.tests.at(1).message, result.tests.at(1).message);
    EXPECT_EQ(back.count(Outcome::differs), 2);
});

const Test bad_children("unit.golden.run.a_child_that_crashes_or_hangs_is_one_failed_line", [] {
    const auto folder = scratch_folder("run_bad");
    const auto suite = suite_of(folder, R"(
        {"name": "status", "command": ["sh", "-c", "echo half > $0; echo boom >&2; exit 5", "{out}"]},
        {"name": "crash", "command": ["sh", "-c", "kill -SEGV $$", "{out}"]},
        {"name": "hang", "command": ["sh", "-c", "echo half > $0; sleep 60 & sleep 60", "{out}"], "time_limit": 0.3},
        {"name": "deaf", "command": ["sh", "-c", "trap '' TERM; sleep 60 & wait; sleep 60", "{out}"], "time_limit": 0.3},
        {"name": "nothing", "command": ["true", "{out}"]},
        {"name": "absent", "command": ["./no-such-program", "{out}"]},
        {"name": "garbage", "command": ["sh", "-c", "echo no image > $0", "{out}"]})");
    const auto begin = Clock::now();
    const auto result = run_and_keep(suite, folder / "out");
    EXPECT_LT(seconds_since(begin), 10.0);
    EXPECT_EQ(result.count(Outcome::broken), 6);
    EXPECT_EQ(result.count(Outcome::unreadable), 1);
    const auto said = [&](std::size_t i, const char* what) {
        EXPECT_NE(result.tests.at(i).message.find(what), std::string::npos) << result.tests.at(i).message;
        EXPECT_EQ(result.tests.at(i).message.find('\n'), std::string::npos);
        EXPECT_TRUE(result.tests.at(i).candidate.empty());
    };
    said(0, "exit status 5: boom");
    said(1, "signal 11");
    said(2, "killed at its time limit of 0.3 s");
    said(3, "killed at its time limit of 0.3 s");
    said(4, "wrote no image");
    said(5, "did not start");
    EXPECT_FALSE(fs::exists(folder / "out/candidates/status.exr"))
        << "a failed command's file is no candidate";
    EXPECT_FALSE(fs::exists(folder / "out/candidates/hang.exr"));
});

const Test jobs("unit.golden.run.any_number_of_jobs_gives_the_same_results", [] {
    const auto folder = scratch_folder("run_jobs");
    const auto suite = copying_suite(folder, {"a", "b", "c", "d", "e", "f"});
    std::vector<std::string> files, orders;
    for (const int count : {1, 2, 6, 6}) {
        std::string order;
        auto options = run_options(folder / "out", count);
        options.on_result = [&](const golden::TestResult& test) { order += test.name; };
        golden::write_results(golden::run(suite, options).value(), folder / "out");
        files.push_back(read_text(golden::results_file(folder / "out")));
        orders.push_back(order);
    }
    for (std::size_t i = 0; i < files.size(); ++i) {
        EXPECT_EQ(files[i], files[0]);
        EXPECT_EQ(orders[i], "abcdef");
    }
});

const Test seed("unit.golden.run.a_command_gets_the_seed_of_runs", [] {
    const auto folder = scratch_folder("run_seed");
    image::write(plain(0.5f), folder / "picture0.exr", image::SampleType::floating);
    const auto suite = suite_of(folder, R"({"name": "a", "command": ["cp", "picture{seed}.exr", "{out}"]})");
    const auto result = run_and_keep(suite, folder / "out");
    EXPECT_EQ(result.tests.at(0).outcome, Outcome::missing) << result.tests.at(0).message;
    EXPECT_EQ(result.tests.at(0).command.find("{seed}"), std::string::npos) << result.tests.at(0).command;
});

const Test interrupted("unit.golden.run.an_interruption_kills_children_and_leaves_no_results", [] {
    const auto folder = scratch_folder("run_interrupted");
    const auto suite = suite_of(folder, R"(
        {"name": "a", "command": ["sh", "-c", "sleep 60", "{out}"]}, {"name": "b", "command": ["sh", "-c", "sleep 60", "{out}"]})");
    fs::create_directories(folder / "out");
    written(golden::results_file(folder / "out"), "of an earlier run");
    auto options = run_options(folder / "out");
    const auto begin = Clock::now();
    std::stop_source stop;
    options.stop = stop.get_token();
    const std::jthread interruption([&] {
        std::this_thread::sleep_for(std::chrono::milliseconds(200));
        stop.request_stop();
    });
    EXPECT_FALSE(golden::run(suite, options).has_value());
    EXPECT_LT(seconds_since(begin), 5.0);
    EXPECT_FALSE(fs::exists(golden::results_file(folder / "out")))
        << "an old result could be taken for this run's";
});

const Test choice("unit.golden.run.filters_choose_by_name_and_tag", [] {
    const auto suite = suite_of(scratch_folder("run_choice"), R"(
        {"name": "box_a", "command": ["{out}"], "tags": ["slow"]}, {"name": "box_b", "command": ["{out}"]},
        {"name": "ball", "command": ["{out}"], "tags": ["slow"]})");
    golden::RunOptions options;
    options.filters = {"box*"};
    EXPECT_EQ(golden::chosen_tests(suite, options).size(), 2u);
    options.tags = {"slow"};
    ASSERT_EQ(golden::chosen_tests(suite, options).size(), 1u);
    EXPECT_EQ(golden::chosen_tests(suite, options).at(0).name, "box_a");
    EXPECT_TRUE(golden::matches("a[1]*", "a[1]*")) << "a name is no pattern of itself";
    options.filters = {"nothing"};
    EXPECT_THROW(golden::chosen_tests(suite, options), Error);
});

const Test known_pixels("unit.golden.run.a_wrong_known_pixel_fails_in_spite_of_its_golden", [] {
    const auto folder = scratch_folder("run_known");
    image::write(plain(0.5f), folder / "s.exr", image::SampleType::floating);
    const auto suite = suite_of(folder, R"(
        {"name": "right", "command": ["cp", "s.exr", "{out}"], "pixels": [{"at": [3, 2], "radiance": [0.5, 0.5, 0.5]}]},
        {"name": "wrong", "command": ["cp", "s.exr", "{out}"], "pixels": [{"at": [0, 0], "radiance": [0.5, 0.5, 0.6]}]},
        {"name": "outside", "command": ["cp", "s.exr", "{out}"], "pixels": [{"at": [4, 0], "radiance": [0.5, 0.5, 0.5]}]})");
    fs::create_directories(suite.goldens);
    for (const auto& test : suite.tests)
        image::write(plain(0.5f), suite.golden_of(test), image::SampleType::floating);
    const auto result = run_and_keep(suite, folder / "out");
    EXPECT_EQ(result.tests.at(0).outcome, Outcome::passed) << result.tests.at(0).message;
    EXPECT_EQ(result.tests.at(1).outcome, Outcome::differs);
    EXPECT_NE(result.tests.at(1).message.find("in closed form"), std::string::npos);
    EXPECT_EQ(result.tests.at(2).outcome, Outcome::differs);
});

const Test junit("unit.golden.junit.counts_and_escapes", [] {
    golden::RunResult run{"s<&>", "s.json", {}};
    for (const auto outcome : {Outcome::passed, Outcome::differs, Outcome::missing, Outcome::broken}) {
        golden::TestResult test;
        test.name = "a\"<" + std::string(golden::name_of(outcome));
        test.outcome = outcome;
        test.message = "x < y \x01\xff";
        run.tests.push_back(test);
    }
    const std::string xml = golden::junit_xml(run);
    EXPECT_NE(xml.find("tests=\"4\" failures=\"2\" errors=\"1\""), std::string::npos) << xml;
    EXPECT_NE(xml.find("name=\"a&quot;&lt;differs\""), std::string::npos) << xml;
    EXPECT_EQ(xml.find('\x01'), std::string::npos);
    EXPECT_EQ(xml.find('\xff'), std::string::npos);
});

} // namespace
