#include "golden/noise.hpp"

#include "compare/noise_of_seeds.hpp"
#include "core/error.hpp"
#include "golden/process.hpp"
#include "image/file.hpp"

#include <algorithm>
#include <fmt/format.h>

namespace sr::golden {
namespace {

namespace fs = std::filesystem;

/// The command of a test with this seed.
std::vector<std::string> words_with_seed(const GoldenTest& test, const Suite& suite,
                                         const RunOptions& options, const std::string& out,
                                         const std::string& seed) {
    std::vector<std::string> words = command_words(test, options, options.program.string(), out, seed);
    if (!test.scene.empty()) {
        const auto option = std::ranges::find(words, "--seed");
        if (option != words.end() && option + 1 != words.end())
            option[1] = seed;
        else
            words.insert(words.end(), {"--seed", seed});
        return words;
    }
    if (std::ranges::none_of(test.command,
                             [](const std::string& word) { return word.find("{seed}") != word.npos; }))
        throw Error({suite.file.string()}, fmt::format("the command of test '{}' has no {{seed}}", test.name),
                    "write {seed} where its seed belongs");
    return words;
}

/// Renders one seed. @return absent if it was interrupted
std::optional<image::Image> picture_of(const GoldenTest& test, const Suite& suite, const RunOptions& options,
                                       int seed) {
    const fs::path out =
        fs::absolute(options.output / "candidates"
                     / fmt::format("{}.seed{}{}", file_name_of(test.name), seed, test.extension));
    ProcessOptions process;
    process.words = words_with_seed(test, suite, options, out.string(), std::to_string(seed));
    process.folder = fs::absolute(suite.folder);
    process.log = fs::absolute(options.output / "logs" / (file_name_of(test.name) + ".noise.txt"));
    process.time_limit = test.time_limit;
    process.stop = options.stop;
    const ProcessEnd end = run_process(process);
    if (options.stop.stop_requested()) return std::nullopt;
    if (!end.is_success())
        throw Error({process.log.string()}, fmt::format("the command of test '{}' {}", test.name, end.text()),
                    "read this log");
    image::Image picture = image::read(out);
    std::error_code ignored;
    fs::remove(out, ignored);
    return picture;
}

} // namespace

std::optional<std::vector<MadeNoise>> make_noise(const Suite& suite, const RunOptions& options, int seeds) {
    std::vector<MadeNoise> made;
    for (const char* folder : {"candidates", "logs"}) fs::create_directories(options.output / folder);
    for (const GoldenTest& test : chosen_tests(suite, options)) {
        if (test.noise.empty()) continue;
        compare::NoiseOfSeeds noise;
        for (int seed = 1; seed <= seeds; ++seed) {
            const auto picture = picture_of(test, suite, options, seed);
            if (!picture) return std::nullopt;
            noise.add(*picture);
        }
        image::write(noise.errors(), test.noise.front(), image::SampleType::floating);
        made.push_back({test.name, test.noise.front()});
    }
    if (made.empty())
        throw Error({suite.file.string()}, "no chosen test names noise",
                    "add \"noise\": \"FILE.exr\" to a test whose picture is noisy");
    return made;
}

} // namespace sr::golden
