#include "cli/commands.hpp"
#include "cli/interruption.hpp"
#include "cli/version.hpp"
#include "core/error.hpp"
#include "core/output.hpp"
#include "core/text.hpp"
#include "golden/approve.hpp"
#include "golden/init.hpp"
#include "golden/merge.hpp"
#include "golden/noise.hpp"
#include "golden/report.hpp"
#include "golden/run.hpp"
#include "image/whole_file.hpp"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <chrono>
#include <cstdio>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <memory>
#include <thread>

namespace sr::cli {
namespace {

namespace fs = std::filesystem;

struct GoldenArguments {
    std::string suite;
    std::string output = "golden-results";
    golden::RunOptions run;
    golden::ApproveOptions approve;
    golden::InitOptions init;
    std::vector<fs::path> folders; // of shards or of past runs
    bool allows_flaky = false;
    bool lists_orphans = false;
    bool json = false;
    bool dry_run = false;
    int seeds = 12;
};

void print_line(const golden::TestResult& test) {
    const bool passed = test.outcome == golden::Outcome::passed;
    print_data("{:<8} {:<28} {:6.2f} s{}{}\n", passed ? "ok" : golden::name_of(test.outcome), test.name,
               test.seconds, test.message.empty() ? "" : "  ", shown(test.message));
    flush_output();
}

void write_report(const golden::RunResult& result, const golden::Suite& suite, const fs::path& output) {
    image::write_text(golden::report_file(output), golden::report_html(result, suite, output));
}

/// Writes the files of a run, prints its counts and returns its exit status. Results that an earlier run left
/// do not count.
ExitStatus conclude(const golden::RunResult& result, const golden::RunRecord& record,
                    const golden::Suite& suite, const GoldenArguments& arguments, double seconds) {
    const fs::path& output = arguments.run.output;
    const golden::RunResult ran = result.of_this_run();
    golden::write_results(result, output);
    golden::write_record(record, output);
    image::write_text(golden::junit_file(output), golden::junit_xml(ran));
    image::write_text(golden::summary_file(output), golden::summary_markdown(ran, record));
    write_report(result, suite, output);
    print_data("{} in {:.1f} s; {}\n", golden::count_text(ran), seconds,
               shown(golden::report_file(output).string()));
    if (ran.count(golden::Outcome::unreadable) > 0) return worlds_fault;
    if (ran.passed()) return done;
    const auto good = ran.count(golden::Outcome::passed) + ran.count(golden::Outcome::flaky);
    if (good < static_cast<int>(ran.tests.size())) return failed_check;
    return arguments.allows_flaky ? done : flaky;
}

ExitStatus run_suite(GoldenArguments& arguments) {
    const golden::Suite suite = golden::load_suite(arguments.suite);
    const Interruption interruption;
    golden::RunOptions& options = arguments.run;
    options.program = running_program();
    options.output = arguments.output;
    options.on_result = print_line;
    options.stop = interruption.token();
    const auto begin = std::chrono::steady_clock::now();
    golden::RunRecord record = golden::begun_record(suite.folder, options.output);
    const auto result = golden::run(suite, options);
    if (!result) {
        print_remark("interrupted: no results were written");
        return interrupted;
    }
    for (const golden::TestResult& test : result->tests)
        if (!test.is_earlier) record.seconds[test.name] = test.seconds;
    const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
    return conclude(*result, record, suite, arguments, seconds);
}

ExitStatus merge(GoldenArguments& arguments) {
    const golden::Suite suite = golden::load_suite(arguments.suite);
    golden::RunOptions& options = arguments.run;
    options.output = arguments.output;
    golden::MergedRun merged = golden::merge_shards(suite, arguments.folders, options);
    for (const std::string& remark : merged.remarks) write_remark(remark);
    for (golden::TestResult& test : merged.result.tests) {
        const auto seconds = merged.record.seconds.find(test.name);
        if (seconds != merged.record.seconds.end()) test.seconds = seconds->second;
        if (test.outcome != golden::Outcome::passed) print_line(test);
    }
    return conclude(merged.result, merged.record, suite, arguments, merged.record.total_seconds());
}

void print_plan(const golden::ApprovalPlan& plan, bool force) {
    for (const std::string& remark : plan.remarks) write_remark(remark);
    for (const golden::Approval& approval : plan.approvals) {
        const char* what = approval.change == "new" ? "add" : approval.change == "equal" ? "keep" : "replace";
        print_data("{:<8} {}{}{}\n", approval.bytes.empty() ? "-" : what, shown(approval.golden.string()),
                   approval.change.empty() ? "" : ": ", approval.change);
        for (const golden::Refusal& refusal : approval.refusals)
            print_data("  {}: {}\n", force && refusal.yields_to_force ? "forced" : "refused",
                       shown(refusal.reason));
    }
}

ExitStatus approve(GoldenArguments& arguments) {
    const golden::Suite suite = golden::load_suite(arguments.suite);
    golden::ApproveOptions& options = arguments.approve;
    options.output = arguments.output;
    const golden::ApprovalPlan plan = golden::plan_approval(suite, options);
    print_plan(plan, options.force);
    if (plan.approvals.empty()) print_data("nothing to approve: no test of the last run was chosen\n");
    if (!plan.is_allowed(options.force)) {
        print_remark("nothing was approved: correct the refused tests, or name the others{}",
                     options.force ? "" : ", or use --force where you know better");
        return failed_check;
    }
    if (!arguments.dry_run) golden::carry_out(plan);
    return done;
}

ExitStatus make_noise(GoldenArguments& arguments) {
    const golden::Suite suite = golden::load_suite(arguments.suite);
    const Interruption interruption;
    golden::RunOptions& options = arguments.run;
    options.program = running_program();
    options.output = arguments.output;
    options.stop = interruption.token();
    const auto made = golden::make_noise(suite, options, arguments.seeds);
    if (!made) {
        print_remark("interrupted: the noise of further tests was not written");
        return interrupted;
    }
    for (const golden::MadeNoise& noise : *made)
        print_data("{:<28} {}\n", noise.test, shown(noise.file.string()));
    return done;
}

/// The tests as JSON, with where their goldens lie and which files no test names.
nlohmann::ordered_json listing_json(const golden::Suite& suite,
                                    const std::vector<golden::GoldenTest>& tests) {
    nlohmann::ordered_json json{{"suite", suite.name}, {"tests", nlohmann::ordered_json::array()}};
    std::error_code ignored;
    for (const golden::GoldenTest& test : tests)
        json["tests"].push_back({{"name", test.name},
                                 {"description", test.description},
                                 {"tags", test.tags},
                                 {"scene", test.scene},
                                 {"command", test.command},
                                 {"golden", suite.golden_of(test).generic_string()},
                                 {"has_golden", fs::exists(suite.golden_of(test), ignored)},
                                 {"alternates", golden::alternates_of(suite, test)}});
    json["orphans"] = nlohmann::ordered_json::array();
    for (const fs::path& orphan : golden::orphans_of(suite))
        json["orphans"].push_back(orphan.generic_string());
    return json;
}

void list(const GoldenArguments& arguments) {
    const golden::Suite suite = golden::load_suite(arguments.suite);
    if (arguments.lists_orphans) {
        for (const fs::path& orphan : golden::orphans_of(suite)) print_data("{}\n", shown(orphan.string()));
        return;
    }
    const std::vector<golden::GoldenTest> tests = golden::chosen_tests(suite, arguments.run);
    if (arguments.json) {
        write_json(listing_json(suite, tests).dump(1));
        return;
    }
    for (const golden::GoldenTest& test : tests)
        print_data("{}{}{}\n", test.name, test.tags.empty() ? "" : "  ",
                   shown(fmt::format("{}", fmt::join(test.tags, " "))));
}

void init(const golden::InitOptions& options) {
    const golden::InitResult made = golden::write_first_suite(options);
    const std::string suite = made.suite.string(), folder = made.suite.parent_path().string();
    print_data("{}: {} tests\n", shown(suite), made.tests);
    if (made.is_of_pictures)
        print_data("run your program before the suite: it takes the pictures as they are then\n");
    print_data(
        "next:\n  steradian golden run {0}\n  look at golden-results/report.html\n"
        "  steradian golden approve {0}\n  put {1}/github-actions.yml into .github/workflows/, or include "
        "{1}/gitlab-ci.yml in .gitlab-ci.yml\n",
        shown(suite), shown(folder));
}

CLI::App* subcommand(CLI::App& app, GoldenArguments& arguments, const char* name, const char* help) {
    CLI::App* command = app.add_subcommand(name, help);
    command
        ->add_option("SUITE", arguments.suite,
                     "a suite of tests (.json; its schema is assets/golden_suite.schema.json)")
        ->required();
    return command;
}

void add_output(CLI::App& command, GoldenArguments& arguments) {
    command.add_option("-o,--output", arguments.output, "folder for results, candidates and the report")
        ->type_name("DIR")
        ->capture_default_str();
}

void add_choice(CLI::App& command, golden::RunOptions& run) {
    command
        .add_option("--filter", run.filters,
                    "only tests whose name fits the pattern, e.g. 'cornell*' (repeatable)")
        ->allow_extra_args(false)
        ->type_name("PATTERN");
    command.add_option("--tag", run.tags, "only tests with this tag (repeatable)")
        ->allow_extra_args(false)
        ->type_name("TAG");
}

void add_allow_flaky(CLI::App& command, GoldenArguments& arguments) {
    command.add_flag("--allow-flaky", arguments.allows_flaky,
                     "exit status 0 instead of 4 if all tests passed, some only when tried again");
}

void add_run(CLI::App& app, const std::shared_ptr<GoldenArguments>& arguments) {
    CLI::App* command = subcommand(app, *arguments, "run", "make each image and compare it with its golden");
    add_output(*command, *arguments);
    add_choice(*command, arguments->run);
    command->add_option("-j,--jobs", arguments->run.jobs, "tests at the same time")
        ->check(CLI::Range(1, 256))
        ->capture_default_str();
    command
        ->add_option("--shaders", arguments->run.shaders,
                     "look for shaders in this folder first (repeatable)")
        ->allow_extra_args(false)
        ->type_name("DIR");
    command
        ->add_option("--retries", arguments->run.retries,
                     "try a test that fails again, so often at most; if it passes then, it is flaky")
        ->check(CLI::Range(0, 10))
        ->capture_default_str();
    add_allow_flaky(*command, *arguments);
    CLI::Option* shard = command->add_option_function<std::string>(
        "--shard",
        [arguments](const std::string& text) {
            arguments->run.shard = golden::parsed_shard(text);
            if (!arguments->run.shard)
                throw CLI::ValidationError("--shard", "write K/N, such as 2/8, with K from 1 to N");
        },
        "only part K of N of the tests; golden merge puts the parts together");
    shard->type_name("K/N");
    command
        ->add_option_function<std::string>(
            "--times",
            [arguments](const std::string& file) { arguments->run.seconds = golden::read_durations(file); },
            "balance the shards by durations: the run.json of an earlier run")
        ->needs(shard)
        ->type_name("FILE");
    command->footer(
        "Writes results.json, run.json, junit.xml, summary.md and report.html. With --filter or --tag, the\n"
        "results of other tests that an earlier run left in DIR stay in results.json and report.html, "
        "marked.\n"
        "Exit status 0 if every test passed, 1 if one did not, 3 if a candidate or golden is unreadable (no "
        "image),\n"
        "4 if every test passed, but some only when they were tried again.\n"
        "Examples:\n  steradian golden run suite.json\n  steradian golden run suite.json -j 4 --filter "
        "'cornell*' -o out\n  steradian golden run suite.json --shard 2/8 --times merged/run.json --retries "
        "1 -o shard-2");
    command->callback([arguments] {
        if (const ExitStatus status = run_suite(*arguments); status != done) throw CLI::RuntimeError(status);
    });
}

void add_approve(CLI::App& app, const std::shared_ptr<GoldenArguments>& arguments) {
    CLI::App* command = subcommand(app, *arguments, "approve", "make candidates of the last run the goldens");
    golden::ApproveOptions& options = arguments->approve;
    CLI::Option* names = command->add_option("NAMES", options.names,
                                             "tests, by name or pattern (default: all that did not pass)");
    add_output(*command, *arguments);
    command->add_option("--except", options.except, "leave this test as it is (name or pattern; repeatable)")
        ->allow_extra_args(false)
        ->type_name("NAME");
    command
        ->add_option("--failed-as-reviewed", options.review,
                     "approve what a person approved in report.html: the file that it exports")
        ->type_name("FILE")
        ->excludes(names);
    command
        ->add_option("--laws", options.laws,
                     "JUnit XML of law and truth tests (ctest --output-junit); a failing one refuses")
        ->type_name("FILE");
    command
        ->add_option(
            "--alternate", options.alternate,
            "keep the candidates beside the goldens, for this driver alone; each run counts and names them")
        ->type_name("LABEL");
    command->add_flag("--dry-run", arguments->dry_run, "print what would be done, and write nothing");
    command->add_flag("--force", options.force,
                      "approve although laws fail, or although another renderer made the candidate");
    command->footer("All or nothing: if one test is refused or the disk is full, no golden is written.\n"
                    "Examples:\n  steradian golden approve suite.json --dry-run\n  steradian golden approve "
                    "suite.json cornell 'zoo*' --except zoo_spot\n  steradian golden approve suite.json "
                    "--failed-as-reviewed review.json");
    command->callback([arguments] {
        if (const ExitStatus status = approve(*arguments); status != done) throw CLI::RuntimeError(status);
    });
}

void add_noise(CLI::App& app, const std::shared_ptr<GoldenArguments>& arguments) {
    CLI::App* command =
        subcommand(app, *arguments, "noise", "make the noise images that tests name, from several seeds");
    add_output(*command, *arguments);
    add_choice(*command, arguments->run);
    command->add_option("--seeds", arguments->seeds, "pictures of each test")
        ->check(CLI::Range(2, 1000))
        ->capture_default_str();
    command->footer(
        "Writes the standard errors of one picture: of its pixels, of blocks of 16x16 and of the whole.\n"
        "Example:\n  steradian golden noise suite.json --filter cornell --seeds 12");
    command->callback([arguments] {
        if (const ExitStatus status = make_noise(*arguments); status != done) throw CLI::RuntimeError(status);
    });
}

void add_merge(CLI::App& app, const std::shared_ptr<GoldenArguments>& arguments) {
    CLI::App* command = subcommand(app, *arguments, "merge", "make one run of the runs of shards");
    command->add_option("DIRS", arguments->folders, "output folders of golden run --shard")->required();
    add_output(*command, *arguments);
    add_choice(*command, arguments->run);
    add_allow_flaky(*command, *arguments);
    command->footer(
        "Writes what golden run writes, and returns its exit status. A test that no shard has run is "
        "broken.\n"
        "Example:\n  steradian golden merge suite.json shard-1 shard-2 -o merged");
    command->callback([arguments] {
        if (const ExitStatus status = merge(*arguments); status != done) throw CLI::RuntimeError(status);
    });
}

void add_history(CLI::App& app, const std::shared_ptr<GoldenArguments>& arguments) {
    CLI::App* command = app.add_subcommand("history", "print the outcomes of each test in several runs");
    command->add_option("DIRS", arguments->folders, "output folders of golden run and golden merge")
        ->required();
    command->add_flag("--json", arguments->json, "print JSON");
    command->footer("The earliest run comes first: . passed, F differs, M missing, B broken, U unreadable, ~ "
                    "flaky, - not "
                    "run.\n"
                    "Example:\n  steradian golden history artifacts/*");
    command->callback([arguments] {
        const auto runs = golden::read_history(arguments->folders);
        if (arguments->json)
            write_json(golden::history_json(runs).dump(1));
        else
            print_data("{}", golden::history_text(runs));
    });
}

void add_init(CLI::App& app, const std::shared_ptr<GoldenArguments>& arguments) {
    CLI::App* command =
        app.add_subcommand("init", "write a first suite, and files for GitHub Actions and GitLab CI");
    command->add_option("SOURCES", arguments->init.sources, "scenes or pictures, or folders of them")
        ->required();
    command->add_option("-o,--output", arguments->init.output, "folder of the suite")
        ->type_name("DIR")
        ->capture_default_str();
    command->footer(
        "Each scene becomes a test that renders it. Where there are only pictures, each becomes a test that\n"
        "takes the picture as your own program writes it. Nothing that is there is overwritten.\n"
        "Examples:\n  steradian golden init scenes\n  steradian golden init build/pictures -o tests/golden");
    command->callback([arguments] { init(arguments->init); });
}

void add_list(CLI::App& app, const std::shared_ptr<GoldenArguments>& arguments) {
    CLI::App* command = subcommand(app, *arguments, "list", "print the names and tags of the tests");
    add_choice(*command, arguments->run);
    command->add_flag("--json", arguments->json, "print the tests and the orphans as JSON");
    command->add_flag("--orphans", arguments->lists_orphans,
                      "print the files in the folder of the goldens that no test of the suite names");
    command->callback([arguments] { list(*arguments); });
}

} // namespace

void add_golden_command(CLI::App& app) {
    const auto arguments = std::make_shared<GoldenArguments>();
    CLI::App* command = app.add_subcommand("golden", "golden-image tests: init, run, approve, report");
    command->require_subcommand(1);
    add_init(*command, arguments);
    add_run(*command, arguments);
    add_approve(*command, arguments);
    add_noise(*command, arguments);
    CLI::App* report = subcommand(*command, *arguments, "report", "write the last run's report.html again");
    add_output(*report, *arguments);
    report->callback([arguments] {
        const golden::Suite suite = golden::load_suite(arguments->suite);
        write_report(golden::read_results(arguments->output), suite, arguments->output);
    });
    add_list(*command, arguments);
    add_merge(*command, arguments);
    add_history(*command, arguments);
    command->footer("Examples:\n  steradian golden run suite.json --jobs 2\n  steradian golden approve "
                    "suite.json cornell");
}

} // namespace sr::cli
