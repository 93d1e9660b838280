#include "gl/lost_display.hpp"

#include "gl/shared_library.hpp"

#include <atomic>

namespace sr::gl {
namespace {

std::atomic<void (*)()> end_of_display{nullptr}; // Xlib hands nothing of ours to its handler

int lost(void* /*display*/) {
    if (const auto end = end_of_display.load()) end();
    return 0;
}

} // namespace

void when_display_is_lost(void (*end)()) {
    end_of_display = end;
    using Handler = int(void*);
    const auto xlib = SharedLibrary::open({"libX11.so.6"}); // the very one that GLFW has opened
    if (!xlib) return;
    if (auto* set_handler = xlib->function<Handler*(Handler*)>("XSetIOErrorHandler")) set_handler(lost);
}

} // namespace sr::gl
