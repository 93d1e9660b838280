#include "cli/version.hpp"

#include "core/program.hpp"

#include "commit.hpp"
#include "core/error.hpp"

namespace sr::cli {

std::string name_and_version() {
    const std::string commit = STERADIAN_COMMIT;
    return "Steradian " STERADIAN_VERSION + (commit.empty() ? "" : " (commit " + commit + ")");
}

std::filesystem::path running_program() {
    const std::filesystem::path program = program_file();
    return program.empty() ? "steradian" : program;
}

std::filesystem::path cluster_folder() {
    namespace fs = std::filesystem;
    const fs::path folder = running_program().parent_path();
    for (const fs::path& place : {folder / "cluster", folder / "../share/steradian/cluster"}) {
        std::error_code ignored;
        if (fs::is_regular_file(place / "__main__.py", ignored)) return place.lexically_normal();
    }
    throw Error({(folder / "cluster").string()}, "no folder", "install Steradian again");
}

} // namespace sr::cli
