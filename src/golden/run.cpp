#include "golden/run.hpp"

#include "compare/align.hpp"
#include "compare/compare.hpp"
#include "core/error.hpp"
#include "core/file.hpp"
#include "core/json.hpp"
#include "core/parallel.hpp"
#include "golden/page.hpp"
#include "golden/process.hpp"
#include "golden/sha256.hpp"
#include "image/file.hpp"

#include <algorithm>
#include <array>
#include <atomic>
#include <charconv>
#include <cmath>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <fnmatch.h>
#include <mutex>
#include <numeric>
#include <span>
#include <vector>

namespace sr::golden {
namespace {

namespace fs = std::filesystem;

/// The first known pixel with a wrong value, in a sentence with both values; empty if there is none. A pixel
/// outside the image is wrong.
std::string wrong_known_pixels(const image::Image& image, std::span<const KnownPixel> pixels) {
    const auto channels = compare::color_channels(image);
    for (const KnownPixel& pixel : pixels) {
        if (pixel.x >= image.width || pixel.y >= image.height)
            return fmt::format("the known pixel ({}, {}) lies outside the image", pixel.x, pixel.y);
        std::array<double, 3> found{};
        bool is_right = true;
        for (std::size_t c = 0; c < 3; ++c) {
            found[c] = image.at(pixel.x, pixel.y)[channels[c]];
            is_right =
                is_right
                && std::abs(found[c] - pixel.radiance[c]) <= pixel.relative * std::abs(pixel.radiance[c]);
        }
        if (!is_right)
            return fmt::format("pixel ({}, {}) is {:.6g} {:.6g} {:.6g}, in closed form it is {:.6g} {:.6g} "
                               "{:.6g} (± {:g} %)",
                               pixel.x, pixel.y, found[0], found[1], found[2], pixel.radiance[0],
                               pixel.radiance[1], pixel.radiance[2], 100.0 * pixel.relative);
    }
    return {};
}

std::string replace_all(std::string word, std::string_view placeholder, std::string_view value) {
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

/// The last lines of a log: at most 4000 bytes.
std::string tail_of(const fs::path& log) {
    constexpr std::size_t max_size = 4000;
    std::error_code failure;
    if (!fs::exists(log, failure)) return {};
    std::string text = read_text(log);
    if (text.size() <= max_size) return text;
    const auto line = text.find('\n', text.size() - max_size);
    return "…\n" + text.substr(line == std::string::npos ? text.size() - max_size : line + 1);
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

/// The first failure, and the diagnosis if there is one.
std::string summary(const compare::Comparison& comparison) {
    const auto failed = std::ranges::find(comparison.verdicts, false, &compare::Verdict::passed);
    std::string text = failed == comparison.verdicts.end() ? "differs from its golden" : failed->line;
    if (comparison.diagnosis)
        text += fmt::format(" [{}: {}]", comparison.diagnosis->name, comparison.diagnosis->statement);
    return text;
}

/// The largest finite error over its limit of a pixel.
double largest_error(const compare::Comparison& comparison) {
    float largest = 0.0f;
    for (const float error : comparison.error.pixels)
        if (std::isfinite(error)) largest = std::max(largest, error);
    return largest;
}

/// GL_RENDERER of what renderer_of() says.
std::string_view driver_of(std::string_view renderer) { return renderer.substr(0, renderer.rfind(", ")); }

/// Judges by an alternate that the candidate's renderer made, if one passes. @return whether one does
bool passes_alternate(TestResult& result, const image::Image& candidate, const Suite& suite,
                      const GoldenTest& test) {
    for (const std::string& label : alternates_of(suite, test)) {
        const fs::path file = alternate_of(suite, test, label);
        const image::Image reference = image::read(file);
        const std::string renderer = renderer_of(reference, file);
        if (renderer.empty() || driver_of(renderer) != driver_of(result.candidate_renderer)) continue;
        const compare::Comparison comparison =
            compare::compare(candidate, reference, compare_options(test, candidate, reference));
        if (!comparison.passed) continue;
        result.alternate = label;
        result.golden = seen_from(suite, file);
        result.golden_renderer = renderer;
        result.golden_sha256 = fingerprint(reference);
        result.largest_error = largest_error(comparison);
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
    result.golden_renderer = renderer_of(reference, golden);
    result.golden_sha256 = fingerprint(reference);
    const compare::Comparison comparison =
        compare::compare(candidate, reference, compare_options(test, candidate, reference));
    result.largest_error = largest_error(comparison);
    result.comparison = compare::json_of(comparison);
    const bool agrees = comparison.passed || passes_alternate(result, candidate, suite, test);
    result.outcome = agrees && wrong.empty() ? Outcome::passed : Outcome::differs;
    if (!agrees) result.message = summary(comparison);
    if (!result.alternate.empty()) result.message = fmt::format("as the alternate '{}'", result.alternate);
    if (!wrong.empty()) result.message += (result.message.empty() ? "" : "; ") + wrong;
}

/// Runs the command. @return whether there is an image to judge.
bool make_image(TestResult& result, const Suite& suite, const GoldenTest& test, const RunOptions& options,
                const fs::path& candidate) {
    const fs::path log = fs::absolute(options.output / "logs" / (file_name_of(test.name) + ".txt"));
    std::error_code ignored;
    fs::remove(candidate, ignored);
    fs::remove(sidecar_of(candidate), ignored);
    fs::remove(log, ignored); // whatever it is: a FIFO would not open
    ProcessOptions process;
    process.words = command_words(test, options, options.program.string(), fs::absolute(candidate).string());
    process.folder = fs::absolute(suite.folder);
    process.log = log;
    process.time_limit = test.time_limit;
    process.stop = options.stop;
    const ProcessEnd end = run_process(process);
    result.seconds = end.seconds;
    result.log = tail_of(log);
    if (end.is_success() && fs::exists(fs::symlink_status(candidate, ignored))) return true;
    fs::remove(candidate, ignored); // what a failed command leaves is no candidate
    result.message = end.is_success() ? "the command wrote no image" : "the command " + end.text();
    if (end.way == ProcessEnd::Way::timed_out) result.message += fmt::format(" of {} s", test.time_limit);
    if (const std::string line = last_line(result.log); !line.empty()) result.message += ": " + line;
    return false;
}

/// Makes the image of a test and judges it. Whatever goes wrong becomes the result's outcome and message.
TestResult run_test(const Suite& suite, const GoldenTest& test, const RunOptions& options) {
    TestResult result;
    result.name = test.name;
    result.description = test.description;
    result.tags = test.tags;
    result.golden = seen_from(suite, suite.golden_of(test));
    result.command = shell_line(command_words(test, options, "steradian", test.name + test.extension));
    try {
        const std::string file = "candidates/" + file_name_of(test.name) + test.extension;
        const fs::path candidate = options.output / file;
        if (!make_image(result, suite, test, options, candidate)) return result;
        const image::Image image = image::read(candidate);
        result.candidate = file;
        result.candidate_sha256 = fingerprint(image);
        result.candidate_renderer = renderer_of(image, candidate);
        if (result.candidate_renderer.empty()) result.candidate_renderer = test.renderer;
        judge(result, image, suite, test);
    } catch (const std::exception& error) { // an Error, or what memory and the file system refuse
        result.outcome = Outcome::unreadable;
        result.message = error.what();
    }
    return result;
}

/// Keeps the picture of an attempt that failed. @return its file in the output folder; empty if there is none
std::string kept_candidate(const TestResult& result, const GoldenTest& test, std::size_t attempt,
                           const fs::path& output) {
    if (result.candidate.empty()) return {};
    const std::string file =
        fmt::format("attempts/{}.{}{}", file_name_of(test.name), attempt, test.extension);
    std::error_code failure;
    fs::rename(output / result.candidate, output / file, failure);
    return failure ? std::string() : file;
}

/// Runs a test, again if it fails and retries are left.
TestResult run_with_retries(const Suite& suite, const GoldenTest& test, const RunOptions& options) {
    std::vector<Attempt> attempts;
    double seconds = 0.0;
    while (true) {
        TestResult result = run_test(suite, test, options);
        seconds += result.seconds;
        const bool has_failed = result.outcome != Outcome::passed && result.outcome != Outcome::missing;
        const bool is_last =
            static_cast<int>(attempts.size()) >= options.retries || options.stop.stop_requested();
        if (has_failed && !is_last) {
            const std::string file = kept_candidate(result, test, attempts.size() + 1, options.output);
            attempts.push_back({result.outcome, result.message, file});
            continue;
        }
        if (!attempts.empty() && result.outcome == Outcome::passed) {
            result.outcome = Outcome::flaky;
            result.message = fmt::format("passed at attempt {}; the first: {}", attempts.size() + 1,
                                         attempts.front().message);
        }
        result.attempts = std::move(attempts);
        result.seconds = seconds;
        return result;
    }
}

bool is_chosen(const GoldenTest& test, const RunOptions& options) {
    const auto fits = [&](const std::string& pattern) { return matches(pattern, test.name); };
    const auto has = [&](const std::string& tag) {
        return std::ranges::find(test.tags, tag) != test.tags.end();
    };
    return (options.filters.empty() || std::ranges::any_of(options.filters, fits))
           && (options.tags.empty() || std::ranges::any_of(options.tags, has));
}

/// The results of an earlier run of this suite, of the tests that this one leaves out; none if it is of the
/// whole suite or of a shard.
std::vector<TestResult> earlier_results(const Suite& suite, const RunOptions& options,
                                        const std::vector<GoldenTest>& chosen) {
    if (options.shard || (options.filters.empty() && options.tags.empty())) return {};
    std::vector<TestResult> kept;
    try {
        RunResult run = read_results(options.output);
        if (!are_of(run, options.output, suite)) return {};
        for (TestResult& test : run.tests) {
            const bool is_of_suite =
                std::ranges::find(suite.tests, test.name, &GoldenTest::name) != suite.tests.end();
            const bool is_run = std::ranges::find(chosen, test.name, &GoldenTest::name) != chosen.end();
            if (!is_of_suite || is_run) continue;
            test.is_earlier = true;
            kept.push_back(std::move(test));
        }
    } catch (const Error&) { // no earlier run, or one of another version
        return {};
    }
    return kept;
}

/// The results of both, in the suite's order.
std::vector<TestResult> in_order_of(const Suite& suite, std::vector<TestResult> results,
                                    std::vector<TestResult> earlier) {
    std::ranges::move(earlier, std::back_inserter(results));
    std::ranges::stable_sort(results, {}, [&](const TestResult& result) {
        return std::ranges::find(suite.tests, result.name, &GoldenTest::name) - suite.tests.begin();
    });
    return results;
}

/// Passes results on in the suite's order, in whatever order they arrive.
class InOrder {
public:
    InOrder(std::size_t count, const std::function<void(const TestResult&)>& pass_on)
        : results_(count), is_done_(count, false), pass_on_(pass_on) {}

    void put(std::size_t index, TestResult result) {
        const std::lock_guard lock(mutex_);
        results_[index] = std::move(result);
        is_done_[index] = true;
        for (; next_ < is_done_.size() && is_done_[next_]; ++next_)
            if (pass_on_) pass_on_(results_[next_]);
    }

    std::vector<TestResult> take() { return std::move(results_); }

private:
    std::mutex mutex_;
    std::vector<TestResult> results_;
    std::vector<bool> is_done_;
    std::size_t next_ = 0;
    const std::function<void(const TestResult&)>& pass_on_;
};

/// The shard of each test, from 0. Without durations the tests take turns.
std::vector<std::size_t> shards_of(const std::vector<GoldenTest>& tests, const RunOptions& options) {
    const auto count = static_cast<std::size_t>(options.shard->count);
    std::vector<std::size_t> shards(tests.size()), order(tests.size());
    for (std::size_t i = 0; i < tests.size(); ++i) shards[i] = i % count;
    if (options.seconds.empty()) return shards;
    double sum = 0.0;
    for (const auto& [name, seconds] : options.seconds) sum += seconds;
    const double mean = sum / static_cast<double>(options.seconds.size()); // of a test that is not known
    const auto seconds_of = [&](std::size_t i) {
        const auto known = options.seconds.find(tests[i].name);
        return known == options.seconds.end() ? mean : known->second;
    };
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::ranges::stable_sort(order, std::ranges::greater(), seconds_of);
    std::vector<double> loads(count, 0.0);
    for (const std::size_t i : order) {
        const auto least = std::ranges::min_element(loads);
        shards[i] = static_cast<std::size_t>(least - loads.begin());
        *least += seconds_of(i);
    }
    return shards;
}

constexpr int first_option = 5; // of {steradian} render SCENE -o {out} …

} // namespace

std::vector<std::string> command_words(const GoldenTest& test, const RunOptions& options,
                                       std::string_view program, std::string_view out,
                                       std::string_view seed) {
    std::vector<std::string> words;
    for (const std::string& word : test.command)
        words.push_back(replace_all(replace_all(replace_all(word, "{seed}", seed), "{steradian}", program),
                                    "{out}", out));
    if (!test.scene.empty())
        for (auto folder = options.shaders.rbegin(); folder != options.shaders.rend(); ++folder)
            words.insert(words.begin() + first_option, {"--shaders", fs::absolute(*folder).string()});
    return words;
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

std::string renderer_of(const image::Image& image, const fs::path& file) {
    std::string text = renderer_of(image);
    std::error_code ignored;
    if (!text.empty() || !fs::exists(sidecar_of(file), ignored)) return text;
    const JsonFile json(sidecar_of(file));
    const JsonObject root(json, JsonObject::Pointer(""));
    root.allow_only({"renderer", "version"});
    const std::string version = root.text("version", "");
    return root.required_text("renderer") + (version.empty() ? "" : ", " + version);
}

std::string fingerprint(const image::Image& image) {
    const std::string header = fmt::format("{}x{}x{} {}\n", image.width, image.height, image.channels,
                                           fmt::join(image.channel_names, "\n"));
    std::vector<std::uint8_t> bytes(header.begin(), header.end());
    const auto* begin = reinterpret_cast<const std::uint8_t*>(image.pixels.data());
    bytes.insert(bytes.end(), begin, begin + image.pixels.size() * sizeof(float));
    return hexadecimal(sha256(bytes));
}

std::optional<Shard> parsed_shard(std::string_view text) {
    constexpr int max_count = 10000;
    const auto number = [](std::string_view digits) {
        int value = 0;
        const auto [end, failure] = std::from_chars(digits.data(), digits.data() + digits.size(), value);
        return failure == std::errc() && end == digits.data() + digits.size() ? value : 0;
    };
    const auto slash = text.find('/');
    if (slash == std::string_view::npos) return std::nullopt;
    const Shard shard{number(text.substr(0, slash)), number(text.substr(slash + 1))};
    if (shard.index < 1 || shard.index > shard.count || shard.count > max_count) return std::nullopt;
    return shard;
}

void prepare_output(const fs::path& output) {
    std::error_code failure;
    for (const char* folder : {"candidates", "logs"}) {
        fs::create_directories(output / folder, failure);
        if (failure)
            throw Error({output.string()}, "cannot be made: " + failure.message(),
                        "choose another folder with --output");
    }
    for (const fs::path& file : {results_file(output), junit_file(output), report_file(output),
                                 summary_file(output), record_file(output)})
        fs::remove(file, failure);
}

compare::CompareOptions compare_options(const GoldenTest& test, const image::Image& candidate,
                                        const image::Image& reference) {
    compare::CompareOptions options;
    compare::set_encoding(options, candidate, reference);
    options.tolerances = test.tolerances;
    options.allow_nonfinite = test.allow_nonfinite;
    options.region = test.region;
    if (!test.mask.empty()) options.mask = image::read(test.mask);
    for (const fs::path& file : test.noise) options.noise.push_back(image::read(file));
    return options;
}

bool matches(const std::string& pattern, const std::string& name) {
    return pattern == name || fnmatch(pattern.c_str(), name.c_str(), 0) == 0;
}

std::vector<GoldenTest> chosen_tests(const Suite& suite, const RunOptions& options) {
    std::vector<GoldenTest> tests;
    for (const GoldenTest& test : suite.tests)
        if (is_chosen(test, options)) tests.push_back(test);
    if (tests.empty())
        throw Error({suite.file.string()}, "no test fits the filter",
                    "see the names with steradian golden list");
    if (!options.shard) return tests;
    const std::vector<std::size_t> shards = shards_of(tests, options);
    std::vector<GoldenTest> part;
    for (std::size_t i = 0; i < tests.size(); ++i)
        if (shards[i] == static_cast<std::size_t>(options.shard->index) - 1) part.push_back(tests[i]);
    return part;
}

std::optional<RunResult> run(const Suite& suite, const RunOptions& options) {
    const std::vector<GoldenTest> tests = chosen_tests(suite, options);
    std::vector<TestResult> earlier = earlier_results(suite, options, tests);
    prepare_output(options.output);
    if (options.retries > 0) fs::create_directories(options.output / "attempts");
    if (!earlier.empty()) write_results(result_of(suite, earlier), options.output);
    InOrder results(tests.size(), options.on_result);
    std::atomic<std::size_t> next{0};
    const auto work = [&] {
        for (std::size_t i = next++; i < tests.size() && !options.stop.stop_requested(); i = next++) {
            TestResult result = run_with_retries(suite, tests[i], options);
            if (!options.stop.stop_requested()) results.put(i, std::move(result));
        }
    };
    on_threads(std::clamp(options.jobs, 1, std::max(1, static_cast<int>(tests.size()))), work);
    if (options.stop.stop_requested()) return std::nullopt;
    return result_of(suite, in_order_of(suite, results.take(), std::move(earlier)));
}

} // namespace sr::golden
