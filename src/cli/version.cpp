#include "cli/version.hpp"

#include "core/program.hpp"

#include "commit.hpp"

namespace sr::cli {

std::string name_and_version() {
    const std::string commit = STERADIAN_COMMIT;
    return "Steradian " STERADIAN_VERSION + (commit.empty() ? "" : " (commit " + commit + ")");
}

std::filesystem::path running_program() {
    const std::filesystem::path program = program_file();
    return program.empty() ? "steradian" : program;
}

} // namespace sr::cli
