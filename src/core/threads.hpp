#pragma once
// True if the system still gives threads.

namespace sr {

/// Starts as many threads as a library may want, one for each core and a few more, and ends them. Software
/// OpenGL and what OpenImageIO loads wait for ever for a thread that the system refuses, so this comes
/// before.
/// @throws std::system_error if the system refuses one
void require_threads();

} // namespace sr
