#include "gl/shared_library.hpp"

#include <dlfcn.h>

namespace sr::gl {

std::optional<SharedLibrary> SharedLibrary::open(std::initializer_list<const char*> names) {
    for (const char* name : names)
        if (void* handle = dlopen(name, RTLD_LAZY | RTLD_LOCAL)) return SharedLibrary(handle, name);
    return std::nullopt;
}

// Never closed: drivers leave threads and exit handlers behind that would run into unmapped code.
SharedLibrary::SharedLibrary(void* handle, std::string name)
    : handle_(handle, [](void*) {}), name_(std::move(name)) {}

void* SharedLibrary::address(const char* symbol) const { return dlsym(handle_.get(), symbol); }

} // namespace sr::gl
