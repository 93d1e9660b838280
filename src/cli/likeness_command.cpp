// `assignment likeness`: pairs of submissions that a person should look at.
#include "assignment/likeness.hpp"
#include "assignment/submission.hpp"
#include "cli/arguments.hpp"
#include "cli/commands.hpp"
#include "cli/interruption.hpp"
#include "core/output.hpp"
#include "image/whole_file.hpp"

#include <CLI/CLI.hpp>
#include <memory>

namespace sr::cli {
namespace {

struct LikenessArguments {
    std::string assignment, output = "likeness.html";
    assignment::LikenessOptions options;
};

ExitStatus compare_class(const LikenessArguments& arguments) {
    image::require_writable(arguments.output);
    const Interruption interruption;
    assignment::LikenessOptions options = arguments.options;
    options.stop = interruption.token();
    const auto likeness = assignment::likeness_of(
        assignment::load(assignment::assignment_named(arguments.assignment)), options);
    if (!likeness) return interrupted;
    for (const std::string& remark : likeness->remarks) write_remark(remark);
    for (const assignment::AlikePair& pair : likeness->pairs)
        print_data("{} {:.0f} %  {} {:.0f} %\n", likeness->codes[pair.a].key, 100.0 * pair.share_a,
                   likeness->codes[pair.b].key, 100.0 * pair.share_b);
    image::write_text(arguments.output, assignment::likeness_html(*likeness));
    print_data("{}: {} pairs of {} submissions to look at\n", arguments.output, likeness->pairs.size(),
               likeness->codes.size());
    return done;
}

} // namespace

void add_likeness_command(CLI::App& app) {
    const auto arguments = std::make_shared<LikenessArguments>();
    CLI::App* command = app.add_subcommand(
        "likeness", "for teachers: list submissions of a class that are alike, to be looked at");
    command->add_option("NAME", arguments->assignment, "an assignment (a3, a3-brdf) or its folder")
        ->required();
    command->add_option("--submissions", arguments->options.submissions, "a folder, as `grade` takes it")
        ->type_name("DIR")
        ->required();
    command->add_option("-o,--output", arguments->output, "the HTML page")->capture_default_str();
    command
        ->add_option("--least", arguments->options.least,
                     "the share of a code that another has, from which a pair is listed")
        ->check(refusal_of_number)
        ->check(CLI::Range(0.0, 1.0))
        ->capture_default_str();
    command->add_option("--python", arguments->options.python, "a Python that has the package copydetect")
        ->capture_default_str();
    command->footer("It compares code without the template, whatever its variables are called. Whether "
                    "anybody copied is for you to find out.\n"
                    "It needs the Python package copydetect: python3 -m pip install copydetect\n\nExamples:\n"
                    "  steradian assignment likeness a3 --submissions downloads -o likeness.html\n"
                    "  steradian assignment likeness a3 --submissions downloads --least 0.8");
    command->callback([arguments] {
        if (const ExitStatus status = compare_class(*arguments); status != done)
            throw CLI::RuntimeError(status);
    });
}

} // namespace sr::cli
