#pragma once
// The program's name, version and commit, and its file.
#include <filesystem>
#include <string>

namespace sr::cli {

/// Returns "Steradian 0.1.0 (commit 0123456789ab)", or without the commit where the build was not of a git
/// checkout.
std::string name_and_version();

/// The running program, for child processes; "steradian" where the system does not tell.
std::filesystem::path running_program();

/// The Python program that runs commands on a cluster (src/python/steradian/cluster/): beside the program in
/// a build folder, or ../share/steradian/cluster where it is installed. @throws Error if neither is there
std::filesystem::path cluster_folder();

} // namespace sr::cli
