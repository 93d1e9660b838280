#pragma once
// The protocol between a TrialCompiler and its process: texts, and one byte for each pair of them.
#include <string>

namespace sr::gl {

/// Writes the length and the text. @return whether all of it was written
bool write_text(int descriptor, const std::string& text);

/// Reads what write_text() wrote. @return whether there was a whole text
bool read_text(int descriptor, std::string& text);

bool write_answer(int descriptor);
bool read_answer(int descriptor);

} // namespace sr::gl
