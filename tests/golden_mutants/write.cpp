// Writes every mutant as two .exr files, and what it must get and gets here as JSON, for
// tools/golden/others.py.
#include "core/error.hpp"
#include "golden_mutants/mutants.hpp"
#include "image/file.hpp"

#include <cstdio>
#include <filesystem>
#include <nlohmann/json.hpp>

int main(int argc, char** argv) {
    if (argc != 2) {
        std::fputs("usage: golden_mutants FOLDER > mutants.json\n", stderr);
        return 2;
    }
    try {
        const std::filesystem::path folder = argv[1];
        std::filesystem::create_directories(folder);
        nlohmann::ordered_json rows = nlohmann::ordered_json::array();
        for (const sr::testing::Mutant& mutant : sr::testing::mutants()) {
            sr::image::write(mutant.test, folder / (mutant.name + ".test.exr"),
                             sr::image::SampleType::floating);
            sr::image::write(mutant.reference, folder / (mutant.name + ".reference.exr"),
                             sr::image::SampleType::floating);
            const auto comparison = sr::compare::compare(mutant.test, mutant.reference, mutant.options);
            const bool are_codes = mutant.options.encoding == sr::compare::Encoding::display_referred;
            rows.push_back({{"name", mutant.name},
                            {"passes", mutant.passes},
                            {"are_codes", are_codes},
                            {"steradian", comparison.passed},
                            {"diagnosis", comparison.diagnosis ? comparison.diagnosis->name : ""},
                            {"layer", comparison.diagnosis ? comparison.diagnosis->layer : ""},
                            {"residual", comparison.diagnosis ? comparison.diagnosis->residual : 1.0}});
        }
        std::printf("%s\n", rows.dump(1).c_str());
        return 0;
    } catch (const sr::Error& error) {
        std::fprintf(stderr, "%s\n", error.what());
        return 3;
    }
}
