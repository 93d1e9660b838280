// Writes every mutant as two image files, and what it must get and gets here as JSON, for
// tools/golden/others.py. With sizes, the mutants of the three bases at each of them; with --verdicts no
// files.
#include "compare/align.hpp"
#include "compare/planes.hpp"
#include "core/error.hpp"
#include "golden_mutants/recipes.hpp"
#include "image/file.hpp"

#include <cmath>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <nlohmann/json.hpp>

namespace {

using sr::testing::Mutant;

/// R, G and B, finite; grey becomes R, G and B.
sr::image::Image colors_of(const sr::image::Image& image) {
    std::vector<int> channels;
    for (const std::size_t channel : sr::compare::color_channels(image))
        channels.push_back(static_cast<int>(channel));
    sr::image::Image colors = sr::compare::extract(image, channels);
    for (float& value : colors.pixels)
        if (!std::isfinite(value)) value = 0.0f;
    return colors;
}

void write_files(const Mutant& mutant, const std::filesystem::path& folder, const std::string& name) {
    const auto write = [&](const sr::image::Image& image, const char* role) {
        sr::image::write(image, folder / (name + role), sr::image::SampleType::floating);
    };
    write(mutant.test, ".test.exr");
    write(mutant.reference, ".reference.exr");
    const bool is_light = mutant.options.encoding == sr::compare::Encoding::scene_referred;
    const auto test = colors_of(mutant.test), reference = colors_of(mutant.reference);
    const auto shown = sr::compare::display(test, reference, is_light); // each at the reference's exposure
    sr::image::write(shown.test, folder / (name + ".test.png"), sr::image::SampleType::integer8);
    sr::image::write(shown.reference, folder / (name + ".reference.png"), sr::image::SampleType::integer8);
}

nlohmann::ordered_json row_of(const Mutant& mutant, const std::string& name) {
    sr::compare::CompareOptions options = mutant.options;
    options.measures_appearance = false;
    const auto comparison = sr::compare::compare(mutant.test, mutant.reference, options);
    std::string why;
    for (const auto& verdict : comparison.verdicts)
        if (!verdict.passed && why.empty()) why = verdict.line;
    return {{"name", name},
            {"passes", mutant.passes},
            {"are_codes", mutant.options.encoding == sr::compare::Encoding::display_referred},
            {"steradian", comparison.passed},
            {"why", why},
            {"wanted_diagnosis", mutant.diagnosis},
            {"diagnosis", comparison.diagnosis ? comparison.diagnosis->name : ""},
            {"layer", comparison.diagnosis ? comparison.diagnosis->layer : ""},
            {"residual", comparison.diagnosis ? comparison.diagnosis->residual : 1.0}};
}

} // namespace

int main(int argc, char** argv) {
    if (argc < 2) {
        std::fputs("usage: golden_mutants FOLDER|--verdicts [WIDTHxHEIGHT…] > mutants.json\n", stderr);
        return 2;
    }
    try {
        const bool writes = std::strcmp(argv[1], "--verdicts") != 0;
        if (writes) std::filesystem::create_directories(argv[1]);
        nlohmann::ordered_json rows = nlohmann::ordered_json::array();
        const auto add = [&](const Mutant& mutant, const std::string& name) {
            if (writes) write_files(mutant, argv[1], name);
            rows.push_back(row_of(mutant, name));
        };
        if (argc == 2)
            for (const Mutant& mutant : sr::testing::mutants()) add(mutant, mutant.name);
        for (int i = 2; i < argc; ++i) {
            sr::testing::Extent size;
            if (std::sscanf(argv[i], "%dx%d", &size.width, &size.height) != 2) return 2;
            for (const sr::testing::Recipe& recipe : sr::testing::recipes()) {
                const Mutant mutant = sr::testing::made(recipe, size);
                add(mutant, argv[i] + ("." + mutant.name));
            }
        }
        std::printf("%s\n", rows.dump(1).c_str());
        return 0;
    } catch (const sr::Error& error) {
        std::fprintf(stderr, "%s\n", error.what());
        return 3;
    }
}
