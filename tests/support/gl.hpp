#pragma once
// One OpenGL context for all tests of a process, with debug output on: any error or warning fails the test
// that provoked it.
#include "gl/context.hpp"

namespace sr::testing {

/// Opens the context at the first call (backend: $STERADIAN_BACKEND, or automatic).
gl::Context& context();

} // namespace sr::testing
