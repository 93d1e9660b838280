#include "cli/commands.hpp"
#include "cli/interruption.hpp"
#include "cli/version.hpp"
#include "core/error.hpp"
#include "core/output.hpp"
#include "core/text.hpp"
#include "golden/approve.hpp"
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
    bool dry_run = false;
    int seeds = 12;
};

void print_line(const golden::TestResult& test) {
    const bool passed = test.outcome == golden::Outcome::passed;
    print_data("{:<8} {:<28} {:6.2f} s{}{}\n", passed ? "ok" : golden::name_of(test.outcome), test.name,
               test.seconds, test.message.empty() ? "" : "  ", shown(test.message));
    flush_output();
}

std::string summary(const golden::RunResult& result) {
    using golden::Outcome;
    std::string text = fmt::format("{} of {} passed", result.count(Outcome::passed), result.tests.size());
    if (const int n = result.passed_by_alternates()) text += fmt::format(" ({} as an alternate)", n);
    if (const int n = result.count(Outcome::differs)) text += fmt::format(", {} differ", n);
    if (const int n = result.count(Outcome::missing)) text += fmt::format(", {} without a golden", n);
    if (const int n = result.count(Outcome::broken)) text += fmt::format(", {} broken", n);
    return text;
}

void write_report(const golden::RunResult& result, const golden::Suite& suite, const fs::path& output) {
    image::write_text(golden::report_file(output), golden::report_html(result, suite, output));
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
    const auto result = golden::run(suite, options);
    if (!result) {
        print_remark("interrupted: no results were written");
        return interrupted;
    }
    golden::write_results(*result, options.output);
    image::write_text(golden::junit_file(options.output), golden::junit_xml(*result));
    write_report(*result, suite, options.output);
    const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
    print_data("{} in {:.1f} s; {}\n", summary(*result), seconds,
               shown(golden::report_file(options.output).string()));
    if (std::ranges::any_of(result->tests, &golden::TestResult::has_unreadable_file)) return worlds_fault;
    return result->passed() ? done : failed_check;
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

void list(const GoldenArguments& arguments) {
    const golden::Suite suite = golden::load_suite(arguments.suite);
    for (const golden::GoldenTest& test : golden::chosen_tests(suite, arguments.run))
        print_data("{}{}{}\n", test.name, test.tags.empty() ? "" : "  ",
                   shown(fmt::format("{}", fmt::join(test.tags, " "))));
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
    command->footer(
        "Writes results.json, junit.xml and report.html. Exit status 0 if every test passed,\n"
        "1 if one did not, 3 if a candidate or golden is no image that can be read.\n"
        "Examples:\n  steradian golden run suite.json\n  steradian golden run suite.json -j 4 --filter "
        "'cornell*' -o out");
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

} // namespace

void add_golden_command(CLI::App& app) {
    const auto arguments = std::make_shared<GoldenArguments>();
    CLI::App* command = app.add_subcommand("golden", "golden-image tests: run, approve, report");
    command->require_subcommand(1);
    add_run(*command, arguments);
    add_approve(*command, arguments);
    add_noise(*command, arguments);
    CLI::App* report = subcommand(*command, *arguments, "report", "write the last run's report.html again");
    add_output(*report, *arguments);
    report->callback([arguments] {
        const golden::Suite suite = golden::load_suite(arguments->suite);
        write_report(golden::read_results(arguments->output), suite, arguments->output);
    });
    CLI::App* listing = subcommand(*command, *arguments, "list", "print the names and tags of the tests");
    add_choice(*listing, arguments->run);
    listing->callback([arguments] { list(*arguments); });
    command->footer("Examples:\n  steradian golden run suite.json --jobs 2\n  steradian golden approve "
                    "suite.json cornell");
}

} // namespace sr::cli
