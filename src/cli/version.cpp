#include "cli/version.hpp"

#include "commit.hpp"

namespace sr::cli {

std::string name_and_version() {
    const std::string commit = STERADIAN_COMMIT;
    return "Steradian " STERADIAN_VERSION + (commit.empty() ? "" : " (commit " + commit + ")");
}

std::filesystem::path running_program() {
    std::error_code failure;
    const std::filesystem::path program = std::filesystem::read_symlink("/proc/self/exe", failure);
    return failure ? "steradian" : program;
}

} // namespace sr::cli
