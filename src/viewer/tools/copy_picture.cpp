// Copying tool: the picture that is seen, as a PNG on the clipboard, which a program of the system holds.
#include "core/error.hpp"
#include "core/parallel.hpp"
#include "core/piped_program.hpp"
#include "image/texture_formats.hpp"
#include "viewer/tools/tool.hpp"

#include <chrono>
#include <cstdint>
#include <cstdlib>
#include <fmt/format.h>
#include <future>
#include <stop_token>
#include <string>
#include <utility>
#include <vector>

namespace sr::viewer {
namespace {

constexpr auto patience = std::chrono::seconds(5); // with the program

/// A command that puts a PNG from its stdin on the clipboard; empty if no such program is in PATH.
std::vector<std::string> clipboard_command() {
    const std::string wayland = program_in_path("wl-copy").string(), x11 = program_in_path("xclip").string();
    const bool is_wayland = std::getenv("WAYLAND_DISPLAY") != nullptr;
    if (!wayland.empty() && (is_wayland || x11.empty())) return {wayland, "--type", "image/png"};
    if (!x11.empty()) return {x11, "-selection", "clipboard", "-target", "image/png", "-in"};
    return {};
}

/// @throws Error with what the program says
void pipe(const std::vector<std::string>& command, const std::vector<std::uint8_t>& png,
          const std::stop_token& stop) {
    PipedProgram program(command);
    program.write(png, stop);
    if (program.finish(stop)) return;
    throw Error({command.front()}, stop.stop_requested() ? "takes too long" : program.complaint(),
                "see that the display has a clipboard, or write a PNG instead");
}

} // namespace

class CopyPicture : public Tool {
public:
    using Tool::Tool;
    ~CopyPicture() override { stop(); }

    std::optional<Changes> handle(const Event& event) override;
    Changes update(double seconds) override;
    Activity activity() const override { return copying_.valid() ? Activity::waiting : Activity::idle; }

private:
    void copy(const image::Image& picture);
    void stop();

    std::string copied_; // a description of the picture
    std::chrono::steady_clock::time_point begin_;
    std::stop_source stop_;
    std::future<void> copying_;
};

std::optional<Changes> CopyPicture::handle(const Event& event) {
    if (command_in(event) != Command::copy_picture) return std::nullopt;
    if (!copying_.valid()) ws_.takes_seen = [this](const image::Image& picture) { copy(picture); };
    return Change::redraw;
}

void CopyPicture::copy(const image::Image& picture) {
    const std::vector<std::string> command = clipboard_command();
    if (command.empty())
        throw Error("neither xclip nor wl-copy is in PATH",
                    "install one: sudo apt-get install xclip, or wl-clipboard for Wayland");
    copied_ = fmt::format("Copied the picture: {}x{} pixels.", picture.width, picture.height);
    begin_ = std::chrono::steady_clock::now();
    stop_ = {};
    copying_ = started([command, png = image::encode_png(picture, "the clipboard"),
                        token = stop_.get_token()] { pipe(command, png, token); });
}

Changes CopyPicture::update(double /*seconds*/) {
    if (!copying_.valid()) return {};
    if (std::chrono::steady_clock::now() - begin_ > patience) stop_.request_stop();
    if (!is_done(copying_)) return {};
    try {
        std::exchange(copying_, {}).get();
        ws_.messages.notify(copied_);
    } catch (const Error& error) {
        ws_.messages.fail("Cannot copy the picture.", error.what());
    }
    return Change::redraw;
}

void CopyPicture::stop() {
    stop_.request_stop();
    if (copying_.valid()) copying_.wait();
}

std::unique_ptr<Tool> make_copy_picture(Workspace& workspace) {
    return std::make_unique<CopyPicture>(workspace);
}

} // namespace sr::viewer
