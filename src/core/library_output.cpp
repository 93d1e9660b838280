#include "core/library_output.hpp"

#include <cstdio>
#include <cstdlib>

namespace sr {

void silence_libraries() {
#ifdef __GLIBC__
    if (std::getenv("STERADIAN_LIBRARY_OUTPUT")) return;
    // glibc's manual, section "Standard Streams": these are variables, to be set as any other.
    if (std::FILE* nowhere = std::fopen("/dev/null", "we")) stderr = nowhere;
#endif
}

} // namespace sr
