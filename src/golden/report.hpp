#pragma once
// Reports of a run: an HTML page for people, JUnit XML for CI systems.
#include "golden/result.hpp"

namespace sr::golden {

/// The largest size of the pixels in a report [bytes of text]; images beyond it are left out. Failures come
/// first.
inline constexpr std::size_t max_pixel_text = 64u << 20;

/// One HTML file that needs nothing from outside (page.hpp). Where no script may run it shows a table. Equal
/// runs give equal pages, but for their records (run.json).
/// @throws Error if a candidate or golden cannot be read.
std::string report_html(const RunResult& result, const Suite& suite, const std::filesystem::path& output);

/// The run as Markdown, for the summary of a job or a comment at a pull request: the counts, and a table of
/// the tests that did not pass. At most 60000 bytes, which GitHub takes as a comment.
std::string summary_markdown(const RunResult& result, const std::optional<RunRecord>& record);

/// The counts in a sentence: "18 of 20 passed (2 as an alternate), 1 differs, 1 flaky".
std::string count_text(const RunResult& result);

/// The run as JUnit XML: a test that differs or has no golden is a <failure>, one that made no image is an
/// <error>. The attempts before the last are <flakyFailure> and <rerunFailure>, as Maven Surefire writes
/// them.
std::string junit_xml(const RunResult& result);

} // namespace sr::golden
