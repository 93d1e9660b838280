#pragma once
// OpenGL 4.1 core contexts, chosen at run time.
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace sr::gl {

enum class Backend {
    automatic, // EGL, then OSMesa, then a hidden window: the first that works
    egl,       // no display needed: Mesa's surfaceless platform, or a device (a GPU)
    osmesa,    // no display and no device: Mesa's software renderer in memory
    window,    // GLFW, needs a display
};

/// "auto", "egl", "osmesa", "window"; absent for any other name.
std::optional<Backend> backend_named(std::string_view name);

/// Returns the name that backend_named() accepts.
const char* name_of(Backend backend);

/// Returns whether a GL_RENDERER of this name runs on the CPU.
bool is_software_renderer(std::string_view renderer);

/// Properties of an open context.
struct ContextInfo {
    std::string backend; // "EGL surfaceless", "EGL device", "OSMesa", "window"
    std::string renderer;
    std::string version;
    std::string shading_language;

    /// Returns whether GL itself runs on the CPU.
    bool is_software() const;
};

/// The driver's messages (KHR_debug): collects errors and warnings of the context that is current when it is
/// made, for as long as it lives. Without KHR_debug it stays empty.
class DebugLog {
public:
    DebugLog();
    ~DebugLog();
    DebugLog(const DebugLog&) = delete;
    DebugLog& operator=(const DebugLog&) = delete;

    /// Every message above notification level, oldest first. Performance hints are not among them.
    const std::vector<std::string>& messages() const { return messages_; }

private:
    std::vector<std::string> messages_;
};

/// A current OpenGL 4.1 core context; only window.hpp gives it a visible surface. One at a time: opening one
/// makes it current on this thread and loads the GL functions for it.
class Context {
public:
    virtual ~Context() = default;
    Context(const Context&) = delete;
    Context& operator=(const Context&) = delete;

    const ContextInfo& info() const { return info_; }

    /// Errors and warnings so far; always empty unless the context was opened with debug.
    const std::vector<std::string>& debug_messages() const;

    /// @throws Error with the first message if there is any, or with the error that OpenGL reports.
    void require_silence() const;

protected:
    Context() = default;

    /// To be called by each backend once its context is current: loads GL and fills info().
    /// @throws Error if the driver offers less than OpenGL 4.1 core.
    void loaded(std::string backend, void (*(*load)(const char*))(), bool debug);

    std::unique_ptr<DebugLog> debug_;

private:
    ContextInfo info_;
};

struct ContextOptions {
    Backend backend = Backend::automatic;
    bool debug = false; // ask for a debug context and collect its messages
};

/// @throws Error naming each backend that was tried and why it does not work here.
std::unique_ptr<Context> open_context(const ContextOptions& options);

/// One backend as it is on this machine: what it offers, or why it does not work.
struct BackendReport {
    std::string name;
    std::optional<ContextInfo> info;
    std::string failure;
};

/// Opens each backend in turn. No context is current afterwards.
std::vector<BackendReport> report_backends();

// The backends behind open_context(). Each throws Error if it does not work here.

std::unique_ptr<Context> open_egl(bool debug);
std::unique_ptr<Context> open_osmesa(bool debug);
std::unique_ptr<Context> open_window(bool debug);

} // namespace sr::gl
