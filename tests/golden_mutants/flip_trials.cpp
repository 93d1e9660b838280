#include "golden_mutants/flip_trials.hpp"

#include "golden_mutants/flips.hpp"
#include "golden_mutants/recipes.hpp"

namespace sr::testing {
namespace {

/// Why the picture fails; empty if it passes.
std::string failure_of(const Mutant& base, int count, std::uint32_t seed, bool are_along_rows) {
    image::Image test = base.reference;
    (are_along_rows ? flip_edges_along_rows(test, count, seed) : flip_edges(test, count, seed));
    compare::CompareOptions options = base.options;
    options.measures_appearance = options.diagnoses = false;
    const compare::Comparison comparison = compare::compare(test, base.reference, options);
    for (const compare::Verdict& verdict : comparison.verdicts)
        if (!verdict.passed) return verdict.line;
    return {};
}

} // namespace

nlohmann::ordered_json flip_trials(Extent size, int seeds) {
    nlohmann::ordered_json rows = nlohmann::ordered_json::array();
    for (const Base base : {Base::render, Base::photo, Base::interface}) {
        const Mutant mutant = made({base, "", true, [](Mutant&) {}, ""}, size);
        for (const int count : {3, 6, 12, 24})
            for (const bool are_along_rows : {false, true}) {
                nlohmann::ordered_json failures = nlohmann::ordered_json::array();
                for (int seed = 0; seed < seeds; ++seed)
                    if (const std::string why = failure_of(
                            mutant, count, 1000 + static_cast<std::uint32_t>(seed), are_along_rows);
                        !why.empty())
                        failures.push_back(why);
                rows.push_back({{"base", name_of(base)},
                                {"pixels", count},
                                {"edges", are_along_rows ? "horizontal" : "vertical"},
                                {"pictures", seeds},
                                {"failures", failures}});
            }
    }
    return rows;
}

} // namespace sr::testing
