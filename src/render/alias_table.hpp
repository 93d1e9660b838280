#pragma once
// Choosing one of n things by weight in constant time.
#include <span>
#include <vector>

namespace sr::render {

/// One entry of an alias table: of all that fall on entry i, the share `keep` stays and the rest goes to
/// `alias`.
struct AliasEntry {
    float keep = 1.0f;
    int alias = 0;
    float probability = 0.0f; // of i being chosen in all
};

/// Vose 1991's construction. Weights are finite and not negative; all zero: every entry is as likely.
std::vector<AliasEntry> alias_table(std::span<const double> weights);

} // namespace sr::render
