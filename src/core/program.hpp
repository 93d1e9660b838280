#pragma once
// The program's own file: what lies beside it, and what it starts again as another process.
#include <filesystem>

namespace sr {

/// Returns the file of the running program, or the one that set_program_file() named; empty if the system
/// does not tell.
std::filesystem::path program_file();

/// Returns a path that starts the same program, even where its file was replaced meanwhile.
std::filesystem::path program_to_start();

/// Names the file of `steradian` where another program runs this code: Python. Call it before all else.
void set_program_file(const std::filesystem::path& file);

} // namespace sr
