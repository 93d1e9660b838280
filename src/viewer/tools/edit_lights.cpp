// Light editing tool: selects, enables, adds and removes lights, sets quantities, undoes.
#include "image/display.hpp"
#include "viewer/document/new_light.hpp"
#include "viewer/panels/light_shapes.hpp"
#include "viewer/panels/lights.hpp"
#include "viewer/tools/tool.hpp"

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>
#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

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
    std::optional<Changes> select_at(const ClickEvent& click);
    std::optional<Changes> go_through_list(const KeyEvent& key);
    Changes say_selection() const;
    std::optional<Changes> execute(Command command);
    Changes step(bool is_undo);
    Changes edit_selected(Command command);
    Changes select(std::size_t entry);
    void scale_quantity(float by);
    Changes ask_kind();
    Changes add(std::string_view kind);
    Changes duplicate();
    Changes remove();
    void select_new(std::vector<scene::Light> lights);
    float suitable_length() const;

    LightsPanel panel_;
};

std::optional<Changes> EditLights::handle(const Event& event) {
    if (const auto* click = std::get_if<ClickEvent>(&event)) return select_at(*click);
    if (const auto* key = std::get_if<KeyEvent>(&event)) return go_through_list(*key);
    const auto command = command_in(event);
    return command ? execute(*command) : std::nullopt;
}

Changes EditLights::select(std::size_t entry) {
    ws_.selected = entry;
    return say_selection();
}

Changes EditLights::say_selection() const {
    const auto& entries = ws_.scene->lights().entries();
    const std::size_t count = ws_.selected.count();
    ws_.messages.notify(count == 0   ? "No light is selected."
                        : count == 1 ? fmt::format("Selected {}.", entries[*ws_.selected].name)
                                     : fmt::format("Selected {} lights.", count));
    return Change::redraw;
}

/// Up and down over the list go through it; with Shift they select what they pass.
std::optional<Changes> EditLights::go_through_list(const KeyEvent& key) {
    const bool is_up = key.key == GLFW_KEY_UP;
    const bool is_of_list = panel_.has_pointer_in_list() && (is_up || key.key == GLFW_KEY_DOWN)
                            && (key.modifiers == no_modifier || key.modifiers == shift);
    const std::size_t count = ws_.scene->lights().entries().size();
    if (!is_of_list || count == 0 || ws_.ui.has_keyboard()) return std::nullopt;
    if (!ws_.selected) return select(is_up ? count - 1 : 0);
    const std::size_t now = *ws_.selected, next = is_up ? std::max<std::size_t>(now, 1) - 1 : now + 1;
    if (key.modifiers == no_modifier) return select(std::min(next, count - 1));
    ws_.selected.extend_to(std::min(next, count - 1));
    return say_selection();
}

/// Selects the light whose mark or surface is under the pointer. With Ctrl or Shift it is added to the
/// selection or taken away.
std::optional<Changes> EditLights::select_at(const ClickEvent& click) {
    const vec2 pointer = click.at;
    const LightEditor& lights = ws_.scene->lights();
    const Projection projection = ws_.projection();
    auto found = mark_under(lights, projection, pointer);
    if (!found) found = outline_under(lights, projection, pointer);
    const scene::RenderScene& stage = ws_.scene->stage();
    if (!found)
        if (const auto hit = first_hit(stage.scene, projection.ray(pointer)))
            found = lights.entry_of_instance(stage, hit->instance);
    if (click.modifiers != no_modifier) {
        if (!found) return Changes();
        ws_.selected.toggle(*found);
        return say_selection();
    }
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
    case Command::add_light: return ask_kind();
    case Command::undo_light: return step(true);
    case Command::redo_light: return step(false);
    case Command::edit_light:
    case Command::rename_light:
    case Command::duplicate_light:
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
    const std::vector<LightEntry> listed = lights.entries();
    const auto what = is_undo ? lights.undo() : lights.redo();
    if (!what) {
        ws_.messages.notify(fmt::format("Nothing to {}.", verb));
        return Change::redraw;
    }
    ws_.messages.notify(fmt::format("{}: {}.", is_undo ? "Undone" : "Redone", *what));
    ws_.scene->stage_lights();
    ws_.selected.follow(listed, lights);
    if (are_at_same_places(before, lights.edits())) return Change::lights;
    return Change::lights | Change::shadows;
}

Changes EditLights::edit_selected(Command command) {
    LightEditor& lights = ws_.scene->lights();
    const std::size_t entry = *ws_.selected;
    if (command == Command::edit_light || command == Command::rename_light) ws_.show_panel(side::controls);
    if (command == Command::edit_light) panel_.edit();
    if (command == Command::rename_light) ws_.selected = entry; // a name belongs to one light
    if (command == Command::rename_light && lights.can_move(entry)) panel_.rename();
    if (command == Command::rename_light && !lights.can_move(entry))
        ws_.messages.notify("Emissive surfaces have the name of their material.");
    if (command == Command::edit_light || command == Command::rename_light) return Change::redraw;
    if (command == Command::duplicate_light) return duplicate();
    if (command == Command::delete_light) return remove();
    const bool is_on = lights.entries()[entry].is_enabled;
    lights.begin_step(ws_.selected.count());
    if (command == Command::switch_light)
        for (const std::size_t i : ws_.selected.entries()) lights.enable(i, !is_on);
    if (command == Command::solo_light) lights.solo(ws_.selected.entries());
    if (command == Command::brighten_light) scale_quantity(std::exp2(light_step));
    if (command == Command::dim_light) scale_quantity(std::exp2(-light_step));
    return Change::lights;
}

/// Removes the selected lights. Emissive surfaces are disabled, and stay selected.
Changes EditLights::remove() {
    LightEditor& lights = ws_.scene->lights();
    lights.begin_step(ws_.selected.count());
    const std::vector<LightEntry> before = lights.entries();
    std::vector<std::size_t> staying;
    for (const std::size_t entry : ws_.selected.entries())
        if (!lights.remove(entry)) staying.push_back(entry);
    if (!staying.empty())
        ws_.messages.notify(staying.size() == 1
                                ? "Emissive surfaces cannot be removed. The light is disabled."
                                : "Emissive surfaces cannot be removed. These lights are disabled.");
    ws_.selected.select(std::move(staying));
    ws_.scene->stage_lights();
    ws_.selected.follow(before, lights);
    return Change::lights | Change::shadows;
}

/// Asks for the kind of a new light, which a letter chooses.
Changes EditLights::ask_kind() {
    Question question{"Add which light?", {}};
    for (const NewLightKind& row : new_light_kinds)
        question.answers.push_back(
            {row.key, std::string(row.kind), [this, row] { ws_.answered |= add(row.kind); }});
    question.answers.push_back({0, "Cancel", {}});
    ws_.ask(std::move(question));
    return Change::redraw;
}

/// Length of an area light, an arrow or a step that suits the scene [m].
float EditLights::suitable_length() const {
    const scene::Bounds& bounds = ws_.scene->loaded().bounds;
    return bounds.is_empty() ? 0.5f : 0.12f * glm::distance(bounds.min, bounds.max);
}

/// Adds lights and selects them. They are listed at once: others look the selection up before the scene is
/// relit.
void EditLights::select_new(std::vector<scene::Light> lights) {
    LightEditor& editor = ws_.scene->lights();
    editor.begin_step(lights.size());
    std::vector<std::size_t> entries;
    for (scene::Light& light : lights) entries.push_back(editor.add(std::move(light)));
    ws_.scene->stage_lights();
    ws_.selected.select(std::move(entries));
}

/// Adds a light between the eye and what it looks at, which it lights as bright as the exposure wants it.
Changes EditLights::add(std::string_view kind) {
    const Viewpoint& view = ws_.camera->view();
    constexpr float nearer = 0.4f;                      // of the way to the eye
    constexpr float grey = 0.18f, white_surface = 0.8f; // what a screen shows, and what reflects it
    const float half_height = (view.is_orthographic ? 1.0f : 1.0f - nearer) * view.half_height();
    const float E = grey * pi / (white_surface * image::exposure_factor(ws_.exposure.ev100()));
    const vec3 at = view.pivot + nearer * (view.eye() - view.pivot) + 0.5f * half_height * view.up();
    const NewLightPlace place{at, view.pivot, std::min(suitable_length(), 0.5f * half_height), E};
    select_new({new_light(kind, place)});
    ws_.messages.notify(fmt::format("Added a light: {}. {} moves it, {} turns it, {} types a value.", kind,
                                    ws_.keys.text(Command::move_light), ws_.keys.text(Command::turn_light),
                                    ws_.keys.text(Command::edit_light)));
    return Change::lights | Change::shadows;
}

Changes EditLights::duplicate() {
    const LightEditor& lights = ws_.scene->lights();
    std::vector<scene::Light> copies;
    for (const std::size_t entry : ws_.selected.entries())
        if (lights.can_move(entry))
            if (auto copy = duplicate_of(lights.lights_of(entry).front(), suitable_length()))
                copies.push_back(*std::move(copy));
    if (copies.empty()) {
        ws_.messages.notify(
            "A light like this cannot be duplicated: it is a surface, or has a picture or a profile.");
        return Change::redraw;
    }
    const std::size_t left = ws_.selected.count() - copies.size();
    ws_.messages.notify(copies.size() == 1 ? fmt::format("Added {}.", name_of(copies.front()))
                        : left == 0
                            ? fmt::format("Added {} lights.", copies.size())
                            : fmt::format("Added {} lights. {} cannot be duplicated.", copies.size(), left));
    select_new(std::move(copies));
    return Change::lights | Change::shadows;
}

void EditLights::scale_quantity(float by) {
    LightEditor& lights = ws_.scene->lights();
    for (const std::size_t entry : ws_.selected.entries()) lights.brighten(entry, by);
    ws_.messages.notify(fmt::format("{}: {:+.2f} EV.",
                                    ws_.selected.count() == 1
                                        ? lights.entries()[*ws_.selected].name
                                        : fmt::format("{} lights", ws_.selected.count()),
                                    std::log2(by)));
}

Changes EditLights::draw(const Overlay& overlay) {
    const LightEditor& lights = ws_.scene->lights();
    const vec2 pointer = ws_.input.pointer();
    const bool is_pointed = ws_.shown_area().contains(pointer) && !ws_.ui.has_pointer();
    const auto hovered = is_pointed ? outline_under(lights, overlay.projection, pointer) : std::nullopt;
    draw_light_shapes(lights, ws_.selected, hovered, overlay.projection, suitable_length(),
                      ws_.camera->view().pivot, overlay.scale);
    draw_light_marks(lights, ws_.selected, overlay.projection, overlay.scale);
    return {};
}

Changes EditLights::draw_section() {
    std::string message;
    std::optional<Command> wanted;
    const Changes changes =
        panel_.draw(ws_.scene->lights(), ws_.scene->loaded(), ws_.selected, wanted, ws_.keys, message);
    if (wanted) ws_.input.put(CommandEvent{*wanted});
    if (!message.empty()) ws_.messages.notify(message);
    return changes;
}

std::unique_ptr<Tool> make_edit_lights(Workspace& workspace) {
    return std::make_unique<EditLights>(workspace);
}

} // namespace sr::viewer
