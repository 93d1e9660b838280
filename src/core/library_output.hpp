#pragma once
// Redirection of what libraries print themselves, such as libpng's own line before the error that it returns.

namespace sr {

/// Lets what C libraries print to `stderr` go nowhere. Our own remarks (core/output.hpp) and sanitizers use
/// the descriptor instead, which stays. Does nothing if STERADIAN_LIBRARY_OUTPUT is set, for those who debug
/// a driver, and with C libraries other than glibc.
void silence_libraries();

} // namespace sr
