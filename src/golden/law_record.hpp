#pragma once
// What law and truth tests said last, as JUnit XML: ctest -L 'law|analytic|truth' --output-junit laws.xml
// writes it.
#include <filesystem>
#include <span>
#include <string>
#include <vector>

namespace sr::golden {

struct LawRecord {
    int tests = 0;
    std::vector<std::string> failed; // names; a test that could not be run counts as failed

    /// Those whose names begin with one of `guards`.
    std::vector<std::string> failed_among(std::span<const std::string> guards) const;
};

/// Reads the JUnit XML of any program (CTest, GoogleTest, pytest). @throws Error if the file is missing or
/// holds no <testcase> at all.
LawRecord read_law_record(const std::filesystem::path& file);

} // namespace sr::golden
