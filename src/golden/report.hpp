#pragma once
// The page on which a person sees what a run found.
#include "golden/result.hpp"

namespace sr::golden {

/// How much text of pixels a report carries before it leaves images out [bytes]. Failures come first.
inline constexpr std::size_t most_pixel_text = 64u << 20;

/// One HTML file that needs nothing else (report_page.hpp). Where no script may run it still shows a table.
/// Equal runs give equal pages.
/// @throws Error if a candidate or golden cannot be read.
std::string report_html(const RunResult& result, const Suite& suite, const std::filesystem::path& output);

} // namespace sr::golden
