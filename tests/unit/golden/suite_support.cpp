#include "unit/golden/suite_support.hpp"

#include "image/file.hpp"
#include "image/whole_file.hpp"

#include <algorithm>
#include <fmt/format.h>

namespace sr::testing {

namespace fs = std::filesystem;

fs::path written(const fs::path& file, const std::string& text) {
    image::write_text(file, text);
    return file;
}

image::Image plain(float value, const std::string& renderer) {
    image::Image image(4, 3, 3);
    std::ranges::fill(image.pixels, value);
    image.attributes = {{"steradian:GL_RENDERER", renderer}, {"steradian:GL_VERSION", "4.5 Mesa"}};
    return image;
}

golden::Suite copying_suite(const fs::path& folder, const std::vector<std::string>& names,
                            const std::string& rest) {
    std::string tests;
    for (const std::string& name : names) {
        image::write(plain(0.5f), folder / (name + "-source.exr"), image::SampleType::floating);
        tests += fmt::format(
            R"({}{{"name": "{}", "command": ["cp", "{}-source.exr", "{{out}}"], "guards": ["law."]}})",
            tests.empty() ? "" : ",\n", name, name);
    }
    return golden::load_suite(
        written(folder / "suite.json", fmt::format("{{{}\n\"tests\": [\n{}]}}\n", rest, tests)));
}

golden::RunOptions run_options(const fs::path& output, int jobs) {
    golden::RunOptions options;
    options.output = output;
    options.jobs = jobs;
    return options;
}

golden::RunResult run_and_keep(const golden::Suite& suite, const fs::path& output) {
    auto result = golden::run(suite, run_options(output)).value();
    golden::write_results(result, output);
    return result;
}

} // namespace sr::testing
