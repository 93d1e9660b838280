#pragma once
// Suites of external commands, which need no renderer.
#include "golden/approve.hpp"
#include "golden/run.hpp"

// Before any `using namespace sr`: fmt 9 calls a friend `compare` that it does not declare, and a compiler
// that reads several test files as one would find the namespace sr::compare.
#include <fmt/format.h>

namespace sr::testing {

/// Writes `text` as a file and returns its path.
std::filesystem::path written(const std::filesystem::path& file, const std::string& text);

/// A 4×3 picture of one colour, with who rendered it.
image::Image plain(float value, const std::string& renderer = "llvmpipe");

/// A suite of tests that copy an image: FOLDER/suite.json, whose test NAME copies FOLDER/NAME-source.exr.
/// `rest` is put into the suite, e.g. "\"laws\": \"laws.xml\",".
golden::Suite copying_suite(const std::filesystem::path& folder, const std::vector<std::string>& names,
                            const std::string& rest = "");

golden::RunOptions run_options(const std::filesystem::path& output, int jobs = 1);

/// Runs the suite into FOLDER/out and keeps its results, as `steradian golden run` does.
golden::RunResult run_and_keep(const golden::Suite& suite, const std::filesystem::path& output);

/// The message of the Error that the function throws.
template<class Function>
std::string error_of(Function function) {
    try {
        function();
    } catch (const std::exception& error) {
        return error.what();
    }
    return "no error";
}

} // namespace sr::testing
