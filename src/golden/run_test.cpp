#include "golden/run_test.hpp"

#include "compare/compare.hpp"
#include "core/error.hpp"
#include "golden/alternate.hpp"
#include "golden/bytes_of_file.hpp"
#include "golden/child.hpp"
#include "golden/escape.hpp"
#include "golden/fingerprint.hpp"
#include "golden/known_pixels.hpp"
#include "image/file.hpp"

#include <algorithm>
#include <fmt/format.h>

namespace sr::golden {
namespace {

namespace fs = std::filesystem;

std::string replaced(std::string word, std::string_view placeholder, std::string_view value) {
    for (auto at = word.find(placeholder); at != std::string::npos;
         at = word.find(placeholder, at + value.size()))
        word.replace(at, placeholder.size(), value);
    return word;
}

/// Where a file lies, as seen from the suite; as it is named where that has no answer.
std::string seen_from(const Suite& suite, const fs::path& file) {
    std::error_code failure;
    const fs::path relative = fs::relative(file, suite.folder, failure);
    return (failure ? file : relative).generic_string();
}

constexpr int first_option = 5; // of {steradian} render SCENE -o {out} …

std::vector<std::string> command_words(const GoldenTest& test, const RunOptions& options,
                                       std::string_view program, std::string_view out) {
    std::vector<std::string> words;
    for (const std::string& word : test.command)
        words.push_back(replaced(replaced(word, "{steradian}", program), "{out}", out));
    if (!test.scene.empty())
        for (auto folder = options.shaders.rbegin(); folder != options.shaders.rend(); ++folder)
            words.insert(words.begin() + first_option, {"--shaders", fs::absolute(*folder).string()});
    return words;
}

/// The last lines of a log: at most 4000 bytes.
std::string tail_of(const fs::path& log) {
    constexpr std::size_t most = 4000;
    std::error_code failure;
    if (!fs::exists(log, failure)) return {};
    std::string text = bytes_of_file(log);
    if (text.size() <= most) return text;
    const auto line = text.find('\n', text.size() - most);
    return "…\n" + text.substr(line == std::string::npos ? text.size() - most : line + 1);
}

/// The last line that says something; a usage error ends with a hint that does not.
std::string last_line(std::string_view text) {
    std::string last;
    for (std::size_t begin = 0; begin < text.size();) {
        const auto end = std::min(text.find('\n', begin), text.size());
        const std::string_view line = text.substr(begin, end - begin);
        if (!line.empty() && !line.starts_with("Run with --help")) last = line;
        begin = end + 1;
    }
    return last;
}

std::string renderer_of(const image::Image& image) {
    std::string text;
    for (const char* key : {"steradian:GL_RENDERER", "steradian:GL_VERSION"}) {
        const auto found = std::ranges::find(image.attributes, key, &image::Attribute::name);
        if (found == image.attributes.end()) continue;
        text += fmt::format("{}{}", text.empty() ? "" : ", ", found->value);
    }
    return text;
}

compare::CompareOptions compare_options(const GoldenTest& test) {
    compare::CompareOptions options;
    options.tolerances = test.tolerances;
    options.allow_nonfinite = test.allow_nonfinite;
    options.region = test.region;
    options.encoding =
        test.extension == ".png" ? compare::Encoding::display_referred : compare::Encoding::scene_referred;
    if (!test.mask.empty()) options.mask = image::read(test.mask);
    for (const fs::path& file : test.noise) options.noise.push_back(image::read(file));
    return options;
}

/// What failed first, and the diagnosis if there is one.
std::string summary(const compare::Comparison& comparison) {
    const auto failed = std::ranges::find(comparison.verdicts, false, &compare::Verdict::passed);
    std::string text = failed == comparison.verdicts.end() ? "differs from its golden" : failed->line;
    if (comparison.diagnosis)
        text += fmt::format(" [{}: {}]", comparison.diagnosis->name, comparison.diagnosis->statement);
    return text;
}

/// GL_RENDERER of what renderer_of() says.
std::string_view driver_of(std::string_view renderer) { return renderer.substr(0, renderer.rfind(", ")); }

/// Judges by an alternate that the candidate's renderer made, if one passes. @return whether one does
bool passes_alternate(TestResult& result, const image::Image& candidate, const Suite& suite,
                      const GoldenTest& test) {
    for (const std::string& label : alternates_of(suite, test)) {
        const fs::path file = alternate_of(suite, test, label);
        const image::Image reference = image::read(file);
        const std::string renderer = renderer_of(reference);
        if (renderer.empty() || driver_of(renderer) != driver_of(result.candidate_renderer)) continue;
        const compare::Comparison comparison = compare::compare(candidate, reference, compare_options(test));
        if (!comparison.passed) continue;
        result.alternate = label;
        result.golden = seen_from(suite, file);
        result.golden_renderer = renderer;
        result.comparison = compare::json_of(comparison);
        return true;
    }
    return false;
}

/// Judges the candidate; the pixels known in closed form first, since they need no golden.
void judge(TestResult& result, const image::Image& candidate, const Suite& suite, const GoldenTest& test) {
    const std::string wrong = wrong_known_pixels(candidate, test.pixels);
    result.fails_known_pixel = !wrong.empty();
    const fs::path golden = suite.golden_of(test);
    std::error_code ignored;
    if (!fs::exists(golden, ignored)) {
        result.outcome = Outcome::missing;
        result.message = "there is no golden: look at the candidate, then approve it"
                         + (wrong.empty() ? "" : "; " + wrong);
        return;
    }
    const image::Image reference = image::read(golden);
    result.golden_renderer = renderer_of(reference);
    const compare::Comparison comparison = compare::compare(candidate, reference, compare_options(test));
    result.comparison = compare::json_of(comparison);
    const bool agrees = comparison.passed || passes_alternate(result, candidate, suite, test);
    result.outcome = agrees && wrong.empty() ? Outcome::passed : Outcome::differs;
    if (!agrees) result.message = summary(comparison);
    if (!result.alternate.empty()) result.message = fmt::format("as the alternate '{}'", result.alternate);
    if (!wrong.empty()) result.message += (result.message.empty() ? "" : "; ") + wrong;
}

/// Runs the command. @return whether there is an image to judge.
bool made_image(TestResult& result, const Suite& suite, const GoldenTest& test, const RunOptions& options,
                const fs::path& candidate) {
    const fs::path log = fs::absolute(options.output / "logs" / (test.name + ".txt"));
    std::error_code ignored;
    fs::remove(candidate, ignored);
    fs::remove(log, ignored); // whatever it is: a FIFO would not open
    ChildOptions child;
    child.words = command_words(test, options, options.program.string(), fs::absolute(candidate).string());
    child.folder = fs::absolute(suite.folder);
    child.log = log;
    child.time_limit = test.time_limit;
    child.is_stopped = options.is_interrupted;
    const ChildEnd end = run_child(child);
    result.seconds = end.seconds;
    result.log = tail_of(log);
    if (end.is_success() && fs::exists(fs::symlink_status(candidate, ignored))) return true;
    fs::remove(candidate, ignored); // what a failed command leaves is no candidate
    result.message = end.is_success() ? "the command wrote no image" : "the command " + end.text();
    if (end.way == ChildEnd::Way::timed_out) result.message += fmt::format(" of {} s", test.time_limit);
    if (const std::string line = last_line(result.log); !line.empty()) result.message += ": " + line;
    return false;
}

} // namespace

TestResult run_test(const Suite& suite, const GoldenTest& test, const RunOptions& options) {
    TestResult result;
    result.name = test.name;
    result.description = test.description;
    result.tags = test.tags;
    result.golden = seen_from(suite, suite.golden_of(test));
    result.command = shell_line(command_words(test, options, "steradian", test.name + test.extension));
    try {
        const std::string file = "candidates/" + test.name + test.extension;
        const fs::path candidate = options.output / file;
        if (!made_image(result, suite, test, options, candidate)) return result;
        const image::Image image = image::read(candidate);
        result.candidate = file;
        result.candidate_sha256 = fingerprint(image);
        result.candidate_renderer = renderer_of(image);
        judge(result, image, suite, test);
    } catch (const std::exception& error) { // an Error, or what memory and the file system refuse
        result.outcome = Outcome::broken;
        result.has_unreadable_file = true;
        result.message = error.what();
    }
    return result;
}

} // namespace sr::golden
