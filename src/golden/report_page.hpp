#pragma once
// A page that needs nothing else: the style and scripts that every report has, and one file of them all.
#include <string>

namespace sr::golden {

/// The *.css and *.js files of a folder, as they were when the program was built, in the order of their
/// names.
struct ReportPage {
    std::string style;
    std::string script;
};

/// The look of reports, pixels, and the viewer of pictures (report/).
ReportPage report_base();

/// The page of a suite's run (report/suite/).
ReportPage suite_page();

/// One HTML file whose script element "data" holds the JSON text `data`. `page` comes after report_base().
/// Its Content-Security-Policy allows that one style and that one script by their SHA-256 and nothing from
/// anywhere. `plain` is markup, seen where the script may not run.
std::string offline_page(const std::string& title, const std::string& plain, const std::string& data,
                         const ReportPage& page);

} // namespace sr::golden
