// View history tool: goes back to earlier views, and forward again.
#include "core/error.hpp"
#include "viewer/document/view_history.hpp"
#include "viewer/tools/tool.hpp"

#include <string>

namespace sr::viewer {

class RevisitViews : public Tool {
public:
    using Tool::Tool;

    std::optional<Changes> handle(const Event& event) override;
    Changes update(double seconds) override;

private:
    Changes go_to(const std::optional<std::string>& view, const char* end);
    NamedCamera camera_named(const std::string& view) const;

    ViewHistory history_;
    std::string file_; // whose views they are
};

std::optional<Changes> RevisitViews::handle(const Event& event) {
    const auto command = command_in(event);
    if (command != Command::earlier_view && command != Command::later_view) return std::nullopt;
    history_.visit(ws_.camera->argument()); // it may still move
    return command == Command::earlier_view ? go_to(history_.earlier(), "There is no earlier view.")
                                            : go_to(history_.later(), "There is no later view.");
}

/// A view at which a person has stayed until it converges is one to come back to.
Changes RevisitViews::update(double /*seconds*/) {
    if (file_ != ws_.scene->loaded().file) {
        file_ = ws_.scene->loaded().file;
        history_ = {};
    }
    if (!ws_.scene->render().is_interactive()) history_.visit(ws_.camera->argument());
    return {};
}

Changes RevisitViews::go_to(const std::optional<std::string>& view, const char* end) {
    if (!view) {
        ws_.messages.notify(end);
        return Change::redraw;
    }
    try {
        if (scene::is_look_at(*view))
            ws_.camera->go_to(*view);
        else
            ws_.camera->use(camera_named(*view));
    } catch (const Error& error) {
        ws_.messages.notify(error.what());
        return Change::redraw;
    }
    ws_.messages.notify("View: --camera '" + *view + "'.");
    return Change::camera;
}

/// A camera of the file, as it is at this time.
NamedCamera RevisitViews::camera_named(const std::string& view) const {
    const auto& cameras = ws_.scene->stage().scene.cameras;
    for (std::size_t i = 0; i < cameras.size(); ++i)
        if (named_camera(cameras, i).argument == view) return named_camera(cameras, i);
    if (view == "auto") return {ws_.scene->framing_camera(ws_.aspect_ratio()), view};
    return named_camera(ws_.scene->stage(), view);
}

std::unique_ptr<Tool> make_revisit_views(Workspace& workspace) {
    return std::make_unique<RevisitViews>(workspace);
}

} // namespace sr::viewer
