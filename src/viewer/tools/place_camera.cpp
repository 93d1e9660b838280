// Camera placing tool: exact position, target and field of view, and bookmarks of views.
#include "core/error.hpp"
#include "viewer/document/bookmarks.hpp"
#include "viewer/fields.hpp"
#include "viewer/tools/tool.hpp"
#include "viewer/view/camera_values.hpp"

#include <array>
#include <cstring>
#include <fmt/format.h>
#include <functional>
#include <imgui.h>
#include <utility>

namespace sr::viewer {
class PlaceCamera : public Tool {
public:
    using Tool::Tool;

    std::optional<Changes> handle(const Event& event) override;
    Changes update(double seconds) override;
    Changes draw_section() override;

private:
    /// A field that shows a value, and takes what is typed.
    struct Field {
        const char* label;
        const char* tip;
        std::string (*text)(const scene::LookAt& view);
        void (*take)(scene::LookAt& view, const std::string& typed);
    };
    static std::array<Field, 3> fields_of(const scene::LookAt& view);

    Changes draw_field(const Field& field, bool is_first, const scene::LookAt& view);
    Changes draw_bookmarks();
    Changes recall(std::size_t index);
    Changes go_to(const std::string& look_at, const std::string& message);

    std::optional<Bookmarks> bookmarks_; // of the file that is shown
    std::size_t next_ = 0;               // bookmark that next_bookmark goes to
    FocusRequest focus_;
    bool is_requested_ = false; // the section shall open
    std::string edited_;        // label of the field that has the keyboard; empty: none
    std::array<char, 96> typed_{};
};

std::optional<Changes> PlaceCamera::handle(const Event& event) {
    const auto command = command_in(event);
    if (!command || !bookmarks_) return std::nullopt;
    switch (*command) {
    case Command::type_camera:
        is_requested_ = true;
        focus_.begin();
        ws_.show_panel(side::controls);
        return Change::redraw;
    case Command::keep_bookmark: {
        const std::string& name = bookmarks_->keep(ws_.camera->look_at_text());
        next_ = 0;
        ws_.messages.notify(
            fmt::format("Kept as {}{}. {} goes to the bookmarks in turn.", name,
                        bookmarks_->is_stored() ? "" : ", for this run only: it cannot be written",
                        ws_.keys.text(Command::next_bookmark)));
        return Change::redraw;
    }
    case Command::next_bookmark:
        if (!bookmarks_->all().empty()) return recall(next_ % bookmarks_->all().size());
        ws_.messages.notify(fmt::format("This file has no bookmarks. {} keeps the view as one.",
                                        ws_.keys.text(Command::keep_bookmark)));
        return Change::redraw;
    default: return std::nullopt;
    }
}

Changes PlaceCamera::update(double /*seconds*/) {
    const std::string& file = ws_.scene->loaded().file;
    if (bookmarks_ && bookmarks_->scene_file() == file) return {};
    bookmarks_.emplace(file);
    next_ = 0;
    return Change::redraw;
}

Changes PlaceCamera::go_to(const std::string& look_at, const std::string& message) {
    try {
        ws_.camera->go_to(look_at);
        ws_.messages.notify(message);
        return Change::camera;
    } catch (const Error& error) {
        ws_.messages.notify(error.what());
        return Change::redraw;
    }
}

Changes PlaceCamera::recall(std::size_t index) {
    const Bookmark& bookmark = bookmarks_->all()[index];
    next_ = index + 1;
    return go_to(bookmark.look_at, fmt::format("Bookmark {}.", bookmark.name));
}

std::array<PlaceCamera::Field, 3> PlaceCamera::fields_of(const scene::LookAt& view) {
    using scene::LookAt;
    const Field eye{"position", "of the eye, in the file's world: three numbers with m, cm, mm, km, ft or in",
                    [](const LookAt& v) { return text_of_point(v.origin + glm::dvec3(v.eye)); },
                    [](LookAt& v, const std::string& typed) { v.eye = vec3(parse_point(typed) - v.origin); }};
    const Field target{
        "target", "the point that the view looks at and turns around",
        [](const LookAt& v) { return text_of_point(v.origin + glm::dvec3(v.target)); },
        [](LookAt& v, const std::string& typed) { v.target = vec3(parse_point(typed) - v.origin); }};
    const Field lens{
        "lens", "the full vertical field of view: 40 deg, 0.7 rad, or 50 mm before film of 24 mm height",
        [](const LookAt& v) { return text_of_field_of_view(v.yfov); },
        [](LookAt& v, const std::string& typed) { v.yfov = static_cast<float>(parse_field_of_view(typed)); }};
    const Field height{
        "height", "of the picture, in the world: the view is orthographic",
        [](const LookAt& v) { return text_of_length(2.0 * v.ymag.value_or(0.0f)); },
        [](LookAt& v, const std::string& typed) { v.ymag = 0.5f * static_cast<float>(parse_length(typed)); }};
    return {eye, target, view.ymag ? height : lens};
}

/// Shows a value, or what is typed in its place. Enter takes it.
Changes PlaceCamera::draw_field(const Field& field, bool is_first, const scene::LookAt& view) {
    const bool is_edited = edited_ == field.label;
    std::array<char, 96> shown{};
    std::strncpy(shown.data(), field.text(view).c_str(), shown.size() - 1);
    if (is_first && focus_.is_pending()) ImGui::SetKeyboardFocusHere();
    auto& text = is_edited ? typed_ : shown;
    const bool is_entered =
        ImGui::InputText(make_room(field.label, text.data()).c_str(), text.data(), text.size(),
                         ImGuiInputTextFlags_EnterReturnsTrue | ImGuiInputTextFlags_AutoSelectAll);
    if (is_first) focus_.update(ImGui::IsItemActive());
    tooltip(field.tip);
    if (!is_entered) {
        if (ImGui::IsItemActive() && !is_edited) {
            edited_ = field.label;
            typed_ = text;
        } else if (is_edited && !ImGui::IsItemActive()) {
            edited_.clear();
        }
        return focus_.is_pending() ? Changes(Change::redraw) : Changes();
    }
    edited_.clear();
    try {
        scene::LookAt wanted = view;
        field.take(wanted, text.data());
        return go_to(scene::text_of(wanted), fmt::format("Camera: {} {}.", field.label, field.text(wanted)));
    } catch (const Error& error) {
        ws_.messages.notify(error.what());
        return Change::redraw;
    }
}

Changes PlaceCamera::draw_section() {
    if (std::exchange(is_requested_, false)) ImGui::SetNextItemOpen(true);
    const bool is_unfolded = ImGui::CollapsingHeader("Position and bookmarks");
    tooltip("the camera as numbers with units, and views of this file that were kept");
    if (!is_unfolded) return {};
    const CameraController& camera = *ws_.camera;
    const scene::LookAt view = scene::parse_look_at(camera.look_at_text(), camera.origin());
    Changes changes;
    bool is_first = true;
    for (const Field& field : fields_of(view))
        changes |= draw_field(field, std::exchange(is_first, false), view);
    return changes | draw_bookmarks();
}

Changes PlaceCamera::draw_bookmarks() {
    if (!bookmarks_) return {};
    Changes changes;
    if (ImGui::Button("keep the view"))
        changes |= handle(CommandEvent{Command::keep_bookmark}).value_or(Changes());
    tooltip(ws_.keys.hint("as a bookmark of this file", Command::keep_bookmark));
    std::optional<std::size_t> removed;
    for (std::size_t i = 0; i < bookmarks_->all().size(); ++i) {
        const Bookmark& bookmark = bookmarks_->all()[i];
        ImGui::PushID(static_cast<int>(i));
        if (ImGui::SmallButton("x")) removed = i;
        tooltip("remove this bookmark");
        ImGui::SameLine();
        if (ImGui::Selectable(bookmark.name.c_str())) changes |= recall(i);
        tooltip(bookmark.look_at.c_str());
        ImGui::PopID();
    }
    if (!removed) return changes;
    bookmarks_->remove(*removed);
    return changes | Change::redraw;
}

std::unique_ptr<Tool> make_place_camera(Workspace& workspace) {
    return std::make_unique<PlaceCamera>(workspace);
}

} // namespace sr::viewer
