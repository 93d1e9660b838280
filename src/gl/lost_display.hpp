#pragma once
// Handling of a lost connection to the X server.

namespace sr::gl {

/// Calls `end` instead of Xlib's own two lines, on whatever thread notices it. Xlib ends the program once
/// `end` returns, so it must not return, and must not touch the window. Without X11 nothing happens.
void when_display_is_lost(void (*end)());

} // namespace sr::gl
