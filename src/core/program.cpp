#include "core/program.hpp"

#include <cstdint>
#include <system_error>
#ifdef __APPLE__
#include <mach-o/dyld.h>
#endif

namespace sr {
namespace {

std::filesystem::path& named_program() {
    static std::filesystem::path named;
    return named;
}

} // namespace

// No standard function tells. A run path would not do for modules: AddressSanitizer stands between the
// program and dlopen, which then no longer knows whose run path to take.
std::filesystem::path program_file() {
    if (!named_program().empty()) return named_program();
#ifdef __APPLE__
    char path[4096];
    std::uint32_t size = sizeof path;
    return _NSGetExecutablePath(path, &size) == 0 ? std::filesystem::path(path) : std::filesystem::path();
#else
    std::error_code ignored;
    return std::filesystem::read_symlink("/proc/self/exe", ignored);
#endif
}

std::filesystem::path program_to_start() {
#ifdef __linux__
    if (named_program().empty()) return "/proc/self/exe";
#endif
    return program_file();
}

void set_program_file(const std::filesystem::path& file) { named_program() = file; }

} // namespace sr
