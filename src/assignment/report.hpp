#pragma once
// The page on which a student sees the marks of a check.
#include "golden/page.hpp"

#include <nlohmann/json_fwd.hpp>

namespace sr::assignment {

/// The style and script of report/.
golden::ReportPage marks_page();

/// One HTML file that needs nothing else (golden/page.hpp), of a result with its pictures. Where no
/// script may run it still shows a table.
std::string report_html(const nlohmann::ordered_json& result);

} // namespace sr::assignment
