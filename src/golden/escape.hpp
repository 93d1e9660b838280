#pragma once
// Text made safe for what it is put into.
#include <string>
#include <string_view>
#include <vector>

namespace sr::golden {

/// For HTML and XML, in text and in quoted attributes. Bytes that are not UTF-8, and control characters that
/// XML cannot hold, become U+FFFD.
std::string escaped_markup(std::string_view text);

/// JSON that can stand in an HTML script element: no '<' is left that could end it.
std::string escaped_script_json(std::string_view json);

/// A command as one line that a POSIX shell reads back as these words.
std::string shell_line(const std::vector<std::string>& words);

} // namespace sr::golden
