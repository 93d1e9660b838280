// Inspection tool: the scene panel; selects, hides and isolates objects, edits materials.
#include "viewer/palette.hpp"
#include "viewer/panels/scene_tree.hpp"
#include "viewer/tools/tool.hpp"

#include <algorithm>
#include <array>
#include <fmt/format.h>
#include <utility>

namespace sr::viewer {
class Inspect : public Tool {
public:
    using Tool::Tool;

    std::optional<Changes> handle(const Event& event) override;
    void notice(Changes changes) override;
    Changes draw(const Overlay& overlay) override;

private:
    Changes toggle();
    Changes select_pointed();
    Changes hide(std::set<ObjectId> objects);
    Changes isolate();
    std::set<ObjectId> all() const;
    std::string name_of(ObjectId object) const;
    void draw_box(const Overlay& overlay) const;

    ScenePanel panel_;
    bool is_open_ = false;
};

std::optional<Changes> Inspect::handle(const Event& event) {
    const auto command = command_in(event);
    if (!command) return std::nullopt;
    const bool needs_object = command == Command::hide_object || command == Command::isolate_object;
    const bool is_shown_alone = command == Command::isolate_object && !ws_.scene->loaded().hidden.empty();
    if (needs_object && !ws_.object && !is_shown_alone) {
        ws_.messages.notify(
            fmt::format("Select an object first: point at it ({}), or click it in a list ({}).",
                        ws_.keys.text(Command::inspect_pointed), ws_.keys.text(Command::scene_tree)));
        return Change::redraw;
    }
    switch (*command) {
    case Command::scene_tree: return toggle();
    case Command::inspect_pointed: return select_pointed();
    case Command::hide_object: {
        std::set<ObjectId> hidden = ws_.scene->loaded().hidden;
        hidden.insert(*ws_.object);
        return hide(std::move(hidden));
    }
    case Command::isolate_object: return isolate();
    case Command::show_objects: return hide({});
    case Command::cancel:
        if (!ws_.object) return std::nullopt;
        ws_.object.reset();
        return Change::redraw;
    default: return std::nullopt;
    }
}

/// Opens the panel, goes to its next list, or closes it after the last. A panel that is not seen is shown.
Changes Inspect::toggle() {
    if (ws_.show_panel(side::scene) && is_open_) return Change::redraw;
    if (!is_open_) panel_.show(ScenePanel::Tab::objects);
    is_open_ = !is_open_ || panel_.show_next();
    return Change::redraw;
}

Changes Inspect::select_pointed() {
    const scene::Scene& scene = ws_.scene->stage().scene;
    const auto hit = first_hit(scene, ws_.projection().ray(ws_.input.pointer()));
    const scene::Instance* instance =
        hit ? &scene.instances[static_cast<std::size_t>(hit->instance)] : nullptr;
    if (!instance || instance->node < 0) {
        ws_.messages.notify(instance ? "This is the surface of a light, and no object of the file."
                                     : "There is no object under the pointer.");
        return Change::redraw;
    }
    ws_.object = ObjectId{instance->node, instance->mesh};
    ws_.selected.reset();
    is_open_ = true;
    ws_.show_panel(side::scene);
    panel_.show(ScenePanel::Tab::objects);
    panel_.reveal();
    ws_.messages.notify(fmt::format("Inspecting {}.", name_of(*ws_.object)));
    return Change::redraw;
}

std::string Inspect::name_of(ObjectId object) const {
    const auto number = static_cast<std::size_t>(object.node);
    return name_or_number(ws_.scene->loaded().contents.nodes[number].name, "node", number);
}

std::set<ObjectId> Inspect::all() const {
    std::set<ObjectId> objects;
    const LoadedScene& loaded = ws_.scene->loaded();
    for (std::size_t i = 0; i < loaded.base.instances; ++i) {
        const scene::Instance& instance = loaded.stage.scene.instances[i];
        if (instance.node >= 0) objects.insert({instance.node, instance.mesh});
    }
    return objects;
}

Changes Inspect::hide(std::set<ObjectId> objects) {
    ws_.messages.notify(
        objects.empty() ? "All objects are shown."
                        : fmt::format("{} of {} objects are hidden. {} shows all. A saved file has all.",
                                      objects.size(), all().size(), ws_.keys.text(Command::show_objects)));
    ws_.scene->hide(std::move(objects));
    return Change::lights | Change::shadows;
}

/// Hides all but the selected object; if that is so already, shows all.
Changes Inspect::isolate() {
    std::set<ObjectId> others = all();
    if (ws_.object) others.erase(*ws_.object);
    return hide(!ws_.object || ws_.scene->loaded().hidden == others ? std::set<ObjectId>() : others);
}

void Inspect::notice(Changes changes) {
    if (changes == everything) panel_.restart();
}

/// Draws the edges of the box around the selected object.
void Inspect::draw_box(const Overlay& overlay) const {
    const scene::Bounds box = bounds_of(ws_.scene->stage().scene, *ws_.object);
    if (box.is_empty()) return;
    std::array<std::optional<vec2>, 8> corners;
    for (unsigned i = 0; i < corners.size(); ++i)
        corners[i] = overlay.projection(
            {(i & 1 ? box.max : box.min).x, (i & 2 ? box.max : box.min).y, (i & 4 ? box.max : box.min).z});
    ImDrawList& list = *ImGui::GetBackgroundDrawList();
    for (unsigned i = 0; i < corners.size(); ++i)
        for (const unsigned axis : {1u, 2u, 4u}) {
            const auto &a = corners[i], &b = corners[i | axis];
            if ((i & axis) || !a || !b) continue;
            list.AddLine({a->x, a->y}, {b->x, b->y}, palette::blue, 1.5f * overlay.scale);
        }
}

Changes Inspect::draw(const Overlay& overlay) {
    if (ws_.object) draw_box(overlay);
    if (!is_open_) return {};
    const PanelPlace place = ws_.layout.take_side(side::scene);
    if (!place.is_shown) return {};
    const auto before = ws_.object;
    ScenePanel::Outcome outcome =
        panel_.draw(ws_.scene->lights(), ws_.scene->loaded(), ws_.object, place.area, ws_.ui, ws_.keys);
    if (ws_.object != before) ws_.selected.reset();
    if (outcome.command) ws_.input.put(CommandEvent{*outcome.command});
    if (outcome.hidden) outcome.changes |= hide(std::move(*outcome.hidden));
    if (outcome.camera) {
        ws_.camera->use(named_camera(ws_.scene->stage().scene.cameras, *outcome.camera));
        outcome.changes |= Change::camera;
    }
    return outcome.changes;
}

std::unique_ptr<Tool> make_inspect(Workspace& workspace) { return std::make_unique<Inspect>(workspace); }

} // namespace sr::viewer
