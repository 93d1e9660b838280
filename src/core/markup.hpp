#pragma once
// Text within the syntax of another format.
#include <string>
#include <string_view>

namespace sr {

/// Escapes text for HTML and XML, also in quoted attributes. Bytes that are not UTF-8, and control characters
/// that XML cannot hold, become U+FFFD.
std::string escape_markup(std::string_view text);

/// A cell of a CSV file (RFC 4180), quoted, control characters shown. One that a spreadsheet would take for a
/// formula begins with an apostrophe.
std::string csv_cell(std::string_view text);

} // namespace sr
