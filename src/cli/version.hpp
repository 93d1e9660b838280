#pragma once
// The program's name, version and commit.
#include <string>

namespace sr::cli {

/// Returns "Steradian 0.1.0 (commit 0123456789ab)", or without the commit where the build was not of a git
/// checkout.
std::string name_and_version();

} // namespace sr::cli
