#pragma once
// Proves an assignment: the reference gets everything, the empty version nothing, each typical mistake its
// name, each other solution everything.
#include "assignment/manifest.hpp"

#include <string>
#include <vector>

namespace sr::assignment {

/// One submission that was tried, and what came of it.
struct Proof {
    std::string task; // empty: all tasks
    std::string name; // "reference", "empty", or the variant's
    std::string must; // "100 %", "0 %, not implemented", "fewer points and its name"
    std::string got;
    bool holds = false;
};

/// Needs a current context. @throws Error where the assignment is at fault
std::vector<Proof> proofs_of(const Assignment& assignment);

/// Fewer mistakes or solutions than an assignment is expected to list, one line a task; empty if there are
/// enough.
std::vector<std::string> shortages(const Assignment& assignment);

} // namespace sr::assignment
