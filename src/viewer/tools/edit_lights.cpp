// Light editing tool: selects, enables, adds and removes lights, sets quantities, undoes.
#include "viewer/panels/lights.hpp"
#include "viewer/tools/tool.hpp"

#include <cmath>
#include <fmt/format.h>

namespace sr::viewer {
namespace {

constexpr float light_step = 1.0f / 3.0f; // [EV]

} // namespace

class EditLights : public Tool {
public:
    using Tool::Tool;

    std::optional<Changes> handle(const Event& event) override;
    Changes draw(const Overlay& overlay) override;
    Changes draw_section() override;

private:
    std::optional<Changes> select_at(vec2 pointer);
    std::optional<Changes> execute(Command command);
    Changes step(bool is_undo);
    Changes edit_selected(Command command);
    Changes select(std::size_t entry);
    void scale_quantity(float by);

    LightsPanel panel_;
};

std::optional<Changes> EditLights::handle(const Event& event) {
    if (const auto* click = std::get_if<ClickEvent>(&event)) return select_at(click->at);
    const auto command = command_in(event);
    return command ? execute(*command) : std::nullopt;
}

Changes EditLights::select(std::size_t entry) {
    ws_.selected = entry;
    ws_.messages.notify("Selected " + ws_.scene->lights().entries()[entry].name + ".");
    return Change::redraw;
}

/// Selects the light whose mark or surface is under the pointer.
std::optional<Changes> EditLights::select_at(vec2 pointer) {
    const LightEditor& lights = ws_.scene->lights();
    const Projection projection = ws_.projection();
    auto found = mark_under(lights, projection, pointer);
    const scene::RenderScene& stage = ws_.scene->stage();
    if (!found)
        if (const auto hit = first_hit(stage.scene, projection.ray(pointer)))
            found = lights.entry_of_instance(stage, hit->instance);
    if (found) return select(*found);
    ws_.selected.reset();
    return std::nullopt;
}

std::optional<Changes> EditLights::execute(Command command) {
    const std::size_t count = ws_.scene->lights().entries().size();
    switch (command) {
    case Command::next_light:
        if (count == 0) return Changes();
        return select(ws_.selected ? (*ws_.selected + 1) % count : 0);
    case Command::undo_light: return step(true);
    case Command::redo_light: return step(false);
    case Command::edit_light:
    case Command::switch_light:
    case Command::solo_light:
    case Command::brighten_light:
    case Command::dim_light:
    case Command::delete_light:
        if (ws_.selected) return edit_selected(command);
        ws_.messages.notify(select_first);
        return Change::redraw;
    case Command::cancel:
        if (!ws_.selected) return std::nullopt;
        ws_.selected.reset();
        return Change::redraw;
    default: return std::nullopt;
    }
}

Changes EditLights::step(bool is_undo) {
    LightEditor& lights = ws_.scene->lights();
    const char* const verb = is_undo ? "undo" : "redo";
    const std::vector<LightEdit> before = lights.edits();
    const auto what = is_undo ? lights.undo() : lights.redo();
    if (!what) {
        ws_.messages.notify(fmt::format("Nothing to {}.", verb));
        return Change::redraw;
    }
    ws_.messages.notify(fmt::format("{}: {}.", is_undo ? "Undone" : "Redone", *what));
    if (are_at_same_places(before, lights.edits())) return Change::lights;
    return Change::lights | Change::shadows;
}

Changes EditLights::edit_selected(Command command) {
    LightEditor& lights = ws_.scene->lights();
    const std::size_t entry = *ws_.selected;
    if (command == Command::edit_light) {
        panel_.edit();
        return Change::redraw;
    }
    lights.begin_step();
    if (command == Command::switch_light) lights.enable(entry, !lights.entries()[entry].is_enabled);
    if (command == Command::solo_light) lights.solo(entry);
    if (command == Command::brighten_light) scale_quantity(std::exp2(light_step));
    if (command == Command::dim_light) scale_quantity(std::exp2(-light_step));
    if (command != Command::delete_light) return Change::lights;
    if (lights.remove(entry))
        ws_.selected.reset();
    else
        ws_.messages.notify("Emissive surfaces cannot be removed. The light is disabled.");
    return Change::lights | Change::shadows;
}

void EditLights::scale_quantity(float by) {
    LightEditor& lights = ws_.scene->lights();
    const auto own = lights.lights_of(*ws_.selected);
    lights.set_quantity(*ws_.selected, by * quantity_of(own.front()));
    ws_.messages.notify(fmt::format("{}: {:+.2f} EV.", lights.entries()[*ws_.selected].name, std::log2(by)));
}

Changes EditLights::draw(const Overlay& overlay) {
    draw_light_marks(ws_.scene->lights(), ws_.selected, overlay.projection, overlay.scale);
    return {};
}

Changes EditLights::draw_section() {
    std::string message;
    const Changes changes = panel_.draw(ws_.scene->lights(), ws_.scene->loaded(), ws_.selected,
                                        ws_.camera->view().pivot, message);
    if (!message.empty()) ws_.messages.notify(message);
    return changes;
}

std::unique_ptr<Tool> make_edit_lights(Workspace& workspace) {
    return std::make_unique<EditLights>(workspace);
}

} // namespace sr::viewer
