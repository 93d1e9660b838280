#include "gl/backend.hpp"

#include "core/error.hpp"
#include "core/threads.hpp"

#include <array>
#include <fmt/format.h>

namespace sr::gl {
namespace {

struct Entry {
    Backend backend;
    std::unique_ptr<Context> (*open)(bool debug);
};

/// In the order in which `auto` tries them.
constexpr std::array<Entry, 3> entries{{
    {Backend::egl, open_egl},
    {Backend::osmesa, open_osmesa},
    {Backend::window, open_window},
}};

} // namespace

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
        const std::string name(name_in(backends, entry.backend));
        try {
            reports.push_back({name, entry.open(false)->info(), ""});
        } catch (const Error& error) {
            reports.push_back({name, std::nullopt, error.what()});
        }
    }
    return reports;
}

} // namespace sr::gl
