// Light view tool: shows the picture by one light alone, without an edit.
#include "viewer/tools/tool.hpp"

#include <fmt/format.h>

namespace sr::viewer {

class ViewLight : public Tool {
public:
    using Tool::Tool;

    std::optional<Changes> handle(const Event& event) override;
    void notice(Changes changes) override;
    Changes draw(const Overlay& overlay) override;

private:
    Changes show(std::optional<std::size_t> entry);
    std::string label() const;

    std::size_t count_ = 0; // of lights when one was chosen: others have other numbers
};

std::optional<Changes> ViewLight::handle(const Event& event) {
    if (const auto* chosen = std::get_if<LightViewEvent>(&event)) return show(chosen->entry);
    const auto alone = ws_.scene->alone();
    const auto command = command_in(event);
    if (command == Command::cancel && alone) return show(std::nullopt);
    if (command != Command::next_light_alone) return std::nullopt;
    const std::size_t next = alone ? *alone + 1 : 0;
    return show(next < ws_.scene->lights().entries().size() ? std::optional(next) : std::nullopt);
}

/// @return the change that has App relight the scene
Changes ViewLight::show(std::optional<std::size_t> entry) {
    count_ = ws_.scene->lights().entries().size();
    if (ws_.is_mixing) {
        ws_.messages.notify("The light mixer is open. Its S shows a light alone.");
        return Change::redraw;
    }
    if (!entry && !ws_.scene->alone()) {
        ws_.messages.notify("The scene has no lights.");
        return Change::redraw;
    }
    ws_.scene->light_alone(entry);
    ws_.messages.notify(entry ? fmt::format("{}. {} goes on, {} shows all.", label(),
                                            ws_.keys.text(Command::next_light_alone),
                                            ws_.keys.text(Command::cancel))
                              : "All lights.");
    return Change::lights;
}

std::string ViewLight::label() const {
    const auto& entries = ws_.scene->lights().entries();
    const std::size_t alone = *ws_.scene->alone();
    return fmt::format("Only {}, {} of {}", entries[alone].name, alone + 1, entries.size());
}

void ViewLight::notice(Changes changes) {
    const bool is_other = ws_.scene->alone() && ws_.scene->lights().entries().size() != count_;
    if (!is_other || !changes.has(Change::lights)) return;
    ws_.scene->light_alone(std::nullopt);
    ws_.answered |= Change::lights;
}

Changes ViewLight::draw(const Overlay& overlay) {
    if (!ws_.scene->alone() || *ws_.scene->alone() >= ws_.scene->lights().entries().size()) return {};
    const Area picture = ws_.shown_area();
    const float margin = 10.0f * overlay.scale;
    draw_caption({picture.from.x + margin, picture.from.y + margin}, label());
    return {};
}

std::unique_ptr<Tool> make_view_light(Workspace& workspace) { return std::make_unique<ViewLight>(workspace); }

} // namespace sr::viewer
