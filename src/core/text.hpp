#pragma once
// Text from files, made safe to show on a terminal or on a page.
#include <cstddef>
#include <string>
#include <string_view>

namespace sr {

/// The length of the UTF-8 sequence at the front of a text that is not empty, 0 if it is invalid (RFC 3629).
std::size_t utf8_length(std::string_view text);

/// Returns whether a terminal or a text layout acts on the code point at the front of `text` (of `length`
/// bytes) instead of showing it: C0 and C1 controls, DEL, line and paragraph separators, and the marks that
/// change the direction of text (Unicode Standard Annex 9).
bool is_control(std::string_view text, std::size_t length);

/// The text on one line that a terminal only shows. Control characters and bytes that are not UTF-8 become
/// `\n`, `\t`, `\x1b`, `\u202e`.
std::string shown(std::string_view text);

/// The same, except that line breaks and tabs stay.
std::string shown_lines(std::string_view text);

/// A JSON text whose strings hold no control character: they become `\u009b`.
std::string shown_json(std::string_view json);

/// The text without spaces, tabs and line breaks at its ends.
std::string_view trimmed(std::string_view text);

/// The text with \n for each line break: \r\n, \n, and the lone \r at which drivers end a line, too.
std::string with_plain_breaks(std::string text);

/// A library's message as a part of one line: spaces for line breaks, and no full stop at its end. An empty
/// one says that no reason was given.
std::string one_line(std::string_view message);

/// At most the first `size` bytes, cut between characters, and then "…".
std::string shorten(std::string_view text, std::size_t size);

} // namespace sr
