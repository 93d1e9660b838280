#include "cli/version.hpp"

#include "commit.hpp" // written by cmake/Commit.cmake

namespace sr::cli {

std::string name_and_version() {
    const std::string commit = STERADIAN_COMMIT;
    return "Steradian " STERADIAN_VERSION + (commit.empty() ? "" : " (commit " + commit + ")");
}

} // namespace sr::cli
