#pragma once
// The report's style and script, as they are in report/.
#include <string>

namespace sr::golden {

struct ReportPage {
    std::string style;
    std::string script;
};

/// The files of report/ as they were when the program was built: style is page.css, script all *.js, in the
/// order of their names.
ReportPage report_page();

} // namespace sr::golden
