#pragma once
// The first hour of examples/README.md, as a part of the manual.
#include <string>

namespace sr::cli {

/// Returns it as HTML: headings of the second and third level, paragraphs, commands.
std::string first_hour_html();

} // namespace sr::cli
