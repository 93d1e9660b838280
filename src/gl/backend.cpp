#include "gl/backend.hpp"

#include "core/error.hpp"
#include "core/threads.hpp"

#include <array>
#include <fmt/format.h>

namespace sr::gl {
namespace {

struct Entry {
    Backend backend;
    const char* name;
    std::unique_ptr<Context> (*open)(bool debug);
};

/// In the order in which `auto` tries them.
constexpr std::array<Entry, 3> entries{{
    {Backend::egl, "egl", open_egl},
    {Backend::osmesa, "osmesa", open_osmesa},
    {Backend::window, "window", open_window},
}};

} // namespace

std::optional<Backend> backend_named(std::string_view name) {
    if (name == "auto") return Backend::automatic;
    for (const Entry& entry : entries)
        if (name == entry.name) return entry.backend;
    return std::nullopt;
}

const char* name_of(Backend backend) {
    for (const Entry& entry : entries)
        if (entry.backend == backend) return entry.name;
    return "auto";
}

std::unique_ptr<Context> open_context(const ContextOptions& options) {
    require_threads();
    std::string failures;
    for (const Entry& entry : entries) {
        if (options.backend == entry.backend) return entry.open(options.debug);
        if (options.backend != Backend::automatic) continue;
        try {
            return entry.open(options.debug);
        } catch (const Error& error) {
            failures += fmt::format("{}{}", failures.empty() ? "" : "; ", error.what());
        }
    }
    throw Error(fmt::format("no OpenGL 4.1 here ({})", failures),
                "install a driver, e.g. sudo apt-get install libegl1 libgl1-mesa-dri");
}

std::vector<BackendReport> report_backends() {
    std::vector<BackendReport> reports;
    for (const Entry& entry : entries) {
        try {
            reports.push_back({entry.name, entry.open(false)->info(), ""});
        } catch (const Error& error) {
            reports.push_back({entry.name, std::nullopt, error.what()});
        }
    }
    return reports;
}

} // namespace sr::gl
