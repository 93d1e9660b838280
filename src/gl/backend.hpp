#pragma once
// The single backends behind open_context(); each throws Error if it does not work here.
#include "gl/context.hpp"

namespace sr::gl {

std::unique_ptr<Context> open_egl(bool debug);
std::unique_ptr<Context> open_osmesa(bool debug);
std::unique_ptr<Context> open_window(bool debug);

} // namespace sr::gl
