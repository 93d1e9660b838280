#pragma once
// Driver messages about a shader, mapped to the files that people edit. Each vendor has its own format
// of positions: Mesa `0:LINE(COL): error: …`, NVIDIA `0(LINE) : error C1234: …`, AMD, Apple and Intel `ERROR:
// 0:LINE: …`.
#include "glsl/source.hpp"

#include <optional>
#include <string>
#include <string_view>

namespace sr::glsl {

/// One complaint of a driver.
struct Complaint {
    Location where;       // in the original file; the column is 0 where the driver names none
    std::string severity; // "error", "warning" or the driver's own word ("preprocessor error")
    std::string text;     // the driver's words, with its error code if it has one
    bool is_error = false;

    /// `file:line[:column]: error: text`, as compilers write it.
    std::string line() const;
};

/// The complaint that a line of a driver's log makes; absent for lines of any other form.
std::optional<Complaint> complaint(std::string_view log_line, const Source& source);

/// The whole log with every place rewritten to `file:line[:column]: error: …`. Lines that match no form are
/// kept.
std::string rewrite_log(std::string_view driver_log, const Source& source);

/// The first error of a log, for building an Error; absent if no line of the log can be read as one.
std::optional<Complaint> first_error(std::string_view driver_log, const Source& source);

} // namespace sr::glsl
