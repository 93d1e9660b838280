#include "golden_mutants/flip_trials.hpp"
#include "golden_mutants/recipes.hpp"
#include "support/address.hpp"

#include <algorithm>
#include <cstdlib>

using namespace sr::compare;
using sr::testing::Mutant;
using sr::testing::Test;

namespace {

std::string text(const Comparison& comparison) {
    std::string lines;
    for (const Verdict& verdict : comparison.verdicts)
        lines += std::string(verdict.passed ? "\n  ok   " : "\n  FAIL ") + verdict.line;
    if (comparison.diagnosis)
        lines +=
            "\n  " + comparison.diagnosis->statement + " " + std::to_string(comparison.diagnosis->residual);
    return lines;
}

void expect_as_they_must_be(const std::vector<Mutant>& mutants) {
    for (const Mutant& mutant : mutants) {
        CompareOptions options = mutant.options;
        options.measures_appearance = false; // no mutant limits it
        options.diagnoses = mutant.diagnosis != sr::testing::any_diagnosis;
        const Comparison comparison = compare(mutant.test, mutant.reference, options);
        EXPECT_EQ(comparison.passed, mutant.passes) << mutant.name << text(comparison);
        if (mutant.diagnosis == sr::testing::any_diagnosis) continue;
        EXPECT_EQ(comparison.diagnosis ? comparison.diagnosis->name : "", mutant.diagnosis)
            << mutant.name << text(comparison);
        if (mutant.layer.empty() && !mutant.diagnosis.empty()) continue;
        EXPECT_EQ(comparison.diagnosis ? comparison.diagnosis->layer : "", mutant.layer)
            << mutant.name << text(comparison);
    }
}

/// Small enough for a test; `golden_mutants --verdicts` takes any size.
void expect_of_base(sr::testing::Base base) {
    for (const sr::testing::Recipe& recipe : sr::testing::recipes())
        if (recipe.base == base) expect_as_they_must_be({sr::testing::made(recipe, {256, 256})});
}

const Test there_are_enough("unit.golden.mutants.there_are_enough",
                            [] { EXPECT_GE(sr::testing::mutants().size(), 60u); });
const Test harmless("unit.golden.mutants.harmless", [] { expect_as_they_must_be(sr::testing::harmless()); });
const Test wrong_values("unit.golden.mutants.wrong_values",
                        [] { expect_as_they_must_be(sr::testing::wrong_values()); });
const Test wrong_places("unit.golden.mutants.wrong_places",
                        [] { expect_as_they_must_be(sr::testing::wrong_places()); });
const Test wrong_lights("unit.golden.mutants.wrong_lights",
                        [] { expect_as_they_must_be(sr::testing::wrong_lights()); });
const Test wrong_otherwise("unit.golden.mutants.wrong_otherwise",
                           [] { expect_as_they_must_be(sr::testing::wrong_otherwise()); });
const Test render_base("unit.golden.mutants.render", [] { expect_of_base(sr::testing::Base::render); });
const Test photo_base("unit.golden.mutants.photo", [] { expect_of_base(sr::testing::Base::photo); });
const Test interface_base("unit.golden.mutants.interface",
                          [] { expect_of_base(sr::testing::Base::interface); });
// Three to 24 pixels, in each base and direction. Chance puts those of one picture in a hundred into a
// rhythm. Sanitizers need one seed: the others walk the same code.
const Test edge_pixels("unit.golden.mutants.edge_pixels_of_many_seeds", [] {
    const char* scenes = std::getenv("STERADIAN_SCENES");
    const int seeds = scenes ? std::max(1, std::atoi(scenes)) : 10;
    std::size_t pictures = 0, failed = 0;
    std::string why;
    for (const auto& row : sr::testing::flip_trials({256, 256}, seeds)) {
        pictures += row.at("pictures").get<std::size_t>();
        failed += row.at("failures").size();
        if (!row.at("failures").empty()) why += row.dump() + "\n";
    }
    EXPECT_EQ(pictures, 24u * static_cast<unsigned>(seeds));
    EXPECT_LE(failed, pictures / 100) << why;
});

} // namespace
