#include "viewer/app/panels.hpp"

#include "core/math.hpp"
#include "viewer/config.hpp"
#include "viewer/panels/help.hpp"

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>
#include <fmt/format.h>
#include <imgui.h>
#include <utility>

namespace sr::viewer {

Panels::Panels(Workspace& workspace) : ws_(workspace), first_page_(workspace.options.samples) {
    const auto remembered = remembered_panels();
    are_shown_ = remembered.are_shown;
    if (remembered.column > 0.0f) ws_.layout.set_column(remembered.column);
    begin();
}

void Panels::begin() {
    if (std::exchange(ws_.wants_panels, false)) show();
    ws_.layout.begin(ws_.window_size(), ws_.ui.scale(), are_shown_);
}

Changes Panels::update() {
    if (ws_.scene || ws_.loading) {
        first_page_.rest();
        return {};
    }
    if (!ws_.has_first_page || !first_page_.update()) return {};
    if (const std::string problem = first_page_.take_problem(); !problem.empty())
        ws_.messages.notify(problem);
    return Change::redraw;
}

bool Panels::execute(Command command) {
    switch (command) {
    case Command::help: has_help_ = !has_help_; return true;
    case Command::messages: has_history_ = !has_history_; return true;
    case Command::panels: toggle(); return true;
    case Command::find_command: palette_.open(); return true;
    case Command::open_file:
        if (has_first_page()) first_page_.request_focus();
        return has_first_page();
    default: return false;
    }
}

bool Panels::take(const KeyEvent& key) {
    const int rows = (key.key == GLFW_KEY_DOWN) - (key.key == GLFW_KEY_UP);
    if (!palette_.is_open() || rows == 0) return false;
    palette_.move(rows);
    return true;
}

bool Panels::runs_command(int key) const {
    return palette_.is_open() && (key == GLFW_KEY_ENTER || key == GLFW_KEY_KP_ENTER);
}

void Panels::toggle() {
    are_shown_ = !are_shown_;
    remember_panels({ws_.layout.column(), are_shown_});
}

void Panels::show() {
    if (!are_shown_) toggle();
}

bool Panels::close_one() {
    return palette_.close() || std::exchange(has_help_, false) || std::exchange(has_history_, false);
}

Changes Panels::draw(const Tools& tools) {
    draw_over_picture();
    Changes changes;
    if (ws_.layout.is_docked()) draw_menu();
    if (const auto command = palette_.draw(ws_.ui, ws_.keys)) {
        ws_.input.put(CommandEvent{*command});
        changes |= Change::redraw;
    }
    if (palette_.wants_frame()) changes |= Change::redraw;
    if (has_first_page()) {
        changes |= draw_first_page();
    } else if (!ws_.scene) {
        message_area({fmt::format("loading {} ...", ws_.options.scene), {}, {}}, ws_.layout);
    } else if (are_shown_) {
        const std::string progress = !ws_.exporting.empty() ? ws_.exporting
                                     : ws_.is_mixing        ? ws_.mixing
                                                            : progress_of(ws_.scene->render());
        message_area({progress, under_pointer(), ws_.messages.status()}, ws_.layout);
        const Overlay overlay{ws_.projection(), ws_.ui.scale(),
                              [this](vec3 point) { return ws_.hides(point); }};
        const Area clip = ws_.shown_area();
        ImDrawList& marks = *ImGui::GetBackgroundDrawList();
        marks.PushClipRect({clip.from.x, clip.from.y},
                           {clip.from.x + clip.size.x, clip.from.y + clip.size.y});
        draw_tabs();
        for (const auto& tool : tools) changes |= tool->draw(overlay);
        marks.PopClipRect();
        changes |= draw_column(tools);
    }
    ws_.layout.end();
    return changes;
}

Changes Panels::draw_first_page() {
    message_area({{}, {}, ws_.messages.status()}, ws_.layout);
    const bool is_covered = palette_.is_open() || has_help_ || has_history_ || ws_.question;
    if (!is_covered && !ImGui::IsAnyItemActive()) first_page_.request_focus();
    const auto file = first_page_.draw(ws_.layout.rest(), ws_.ui);
    if (const std::string path = first_page_.take_completed(); !path.empty())
        ws_.messages.log("Completed: " + path);
    if (file) ws_.open(*file);
    return file || first_page_.wants_frame() ? Changes(Change::redraw) : Changes();
}

void Panels::draw_over_picture() {
    help_panel(has_help_, ws_.keys);
    if (ws_.messages.has_error()) error_panel(ws_.messages.error_title(), ws_.messages.error_text());
    history_panel(has_history_, ws_.messages.history());
    if (!ws_.question) return;
    if (!std::exchange(ws_.question->is_shown, true)) ws_.messages.log("Asked: " + ws_.question->text);
    if (const Answer* answer = draw_question(*ws_.question)) ws_.answer(*answer);
}

/// Draws a menu for each group of commands.
void Panels::draw_menu() {
    if (!ImGui::BeginMainMenuBar()) return;
    const auto commands = all_commands();
    for (std::size_t i = 0; i < commands.size();) {
        const std::string_view group = commands[i].group;
        const bool is_open = ImGui::BeginMenu(commands[i].group);
        for (; i < commands.size() && group == commands[i].group; ++i) {
            if (!is_open) continue;
            const std::string keys = ws_.keys.text(commands[i].command);
            if (ImGui::MenuItem(commands[i].name, keys.c_str()))
                ws_.input.put(CommandEvent{commands[i].command});
            tooltip(commands[i].what);
        }
        if (is_open) ImGui::EndMenu();
    }
    draw_views_menu();
    ws_.layout.take_top(ImGui::GetWindowSize().y);
    ImGui::EndMainMenuBar();
}

/// Draws a menu of all views, each with its meaning as a tooltip.
void Panels::draw_views_menu() {
    if (!ImGui::BeginMenu("Views")) return;
    if (ImGui::MenuItem("radiance", nullptr, !ws_.display.view)) ws_.input.put(ViewEvent{});
    tooltip("the picture itself");
    for (const output::Variable& variable : output::all_variables()) {
        if (!output::view_named(variable.name)) continue;
        if (ImGui::MenuItem(variable.name, nullptr, ws_.display.view == &variable))
            ws_.input.put(ViewEvent{&variable});
        tooltip(variable.what);
    }
    if (ws_.scene) draw_lights_menu();
    ImGui::EndMenu();
}

/// Draws a menu of all lights, one of which lights the picture alone.
void Panels::draw_lights_menu() {
    ImGui::Separator();
    const auto& entries = ws_.scene->lights().entries();
    const auto alone = ws_.scene->alone();
    if (!ImGui::BeginMenu("light alone", !entries.empty())) return;
    if (ImGui::MenuItem("all lights", nullptr, !alone)) ws_.input.put(LightViewEvent{});
    tooltip("the picture by all lights again");
    for (std::size_t i = 0; i < entries.size(); ++i)
        if (ImGui::MenuItem(fmt::format("{}##{}", entries[i].name, i).c_str(), nullptr, alone == i))
            ws_.input.put(LightViewEvent{i});
    ImGui::EndMenu();
}

/// Draws the tabs of panels that share a column.
void Panels::draw_tabs() {
    const std::vector<std::string> tabs = ws_.layout.tabs();
    if (!ws_.layout.has_one_column() || tabs.size() < 2) return;
    const ImVec2 margin{4.0f * ws_.ui.scale(), 2.0f * ws_.ui.scale()};
    place_next_window(ws_.layout.take_tabs(ImGui::GetFrameHeight() + 2.0f * margin.y));
    ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, margin);
    ImGui::PushStyleVar(ImGuiStyleVar_WindowMinSize, {1.0f, 1.0f});
    if (ImGui::Begin("tabs", nullptr, ws_.ui.panel_flags(true) | ImGuiWindowFlags_NoScrollbar)
        && ImGui::BeginTabBar("panels")) {
        for (const std::string& name : tabs) {
            const bool is_new_front = name == ws_.layout.front() && name != shown_tab_;
            const int flags = is_new_front ? ImGuiTabItemFlags_SetSelected : 0;
            if (ImGui::BeginTabItem(name.c_str(), nullptr, flags)) {
                shown_tab_ = name;
                ImGui::EndTabItem();
            }
            if (ImGui::IsItemClicked()) ws_.layout.bring_forward(name);
            tooltip("panels share this column until the window is wider");
        }
        ImGui::EndTabBar();
    }
    ImGui::End();
    ImGui::PopStyleVar(2);
}

Changes Panels::draw_column(const Tools& tools) {
    Changes changes;
    const bool is_docked = ws_.layout.is_docked();
    if (ws_.layout.has_one_column() && ws_.layout.front() != side::controls) return changes;
    if (is_docked) {
        const Area area = ws_.layout.left();
        const vec2 range = ws_.layout.column_range();
        place_next_window(area);
        ImGui::SetNextWindowSizeConstraints({range.x, area.size.y}, {range.y, area.size.y});
    } else {
        ImGui::SetNextWindowPos({10.0f, 10.0f}, ImGuiCond_FirstUseEver);
        ImGui::SetNextWindowSizeConstraints({0.0f, 0.0f}, {1e4f, 0.92f * ws_.window_size().y});
    }
    // The edge of the docked column can be dragged.
    const int flags = ws_.ui.panel_flags(is_docked) & ~ImGuiWindowFlags_NoResize;
    if (ImGui::Begin("Steradian", nullptr, flags)) {
        const float width = is_docked ? ImGui::GetContentRegionAvail().x : 280.0f * ws_.ui.scale();
        ImGui::PushItemWidth(is_docked ? 0.58f * width : 170.0f * ws_.ui.scale());
        ImGui::PushTextWrapPos(is_docked ? 0.0f : width);
        for (const auto& tool : tools) changes |= tool->draw_section();
        ImGui::TextDisabled("%s", ws_.keys.hint("all keys", Command::help).c_str());
        ImGui::PopTextWrapPos();
        ImGui::PopItemWidth();
    }
    if (!is_docked) keep_in_viewport();
    const float width = ImGui::GetWindowSize().x / ws_.ui.scale();
    const bool is_as_placed = ImGui::GetWindowSize().x == ws_.layout.left().size.x;
    ImGui::End();
    if (!is_docked || is_as_placed) return changes;
    const bool is_dragged = ImGui::IsMouseDragging(ImGuiMouseButton_Left);
    if (!is_dragged) return changes; // a narrow window is no wish of a person
    ws_.layout.set_column(width);
    remember_panels({width, are_shown_});
    return changes | Change::redraw;
}

/// Radiance and luminance at the pixel under the pointer.
std::string Panels::under_pointer() const {
    const ProgressiveRender& render = ws_.scene->render();
    const bool is_shown =
        !render.is_interactive() && render.sample_count() > 0 && !ws_.is_mixing && !ws_.kept.shown();
    if (!is_shown || ws_.ui.has_pointer()) return {};
    const vec2 place = ws_.place_in_picture(ws_.input.pointer());
    if (!(place.x >= 0.0f && place.x < 1.0f && place.y >= 0.0f && place.y < 1.0f)) return {};
    const int column = static_cast<int>(place.x * static_cast<float>(ws_.width));
    const int row = static_cast<int>(place.y * static_cast<float>(ws_.height));
    const output::Variable* const view = ws_.display.view;
    if (view && view->finish != output::Finish::luminance) return {}; // the film has no radiance
    const vec3 L = render.pixel(place);
    return fmt::format("{},{}: L {:.4g} {:.4g} {:.4g}, luminance {:.4g} {}", column, row, L.r, L.g, L.b,
                       luminance(L), scene::radiance_unit(ws_.scene->stage().scene.units));
}

} // namespace sr::viewer
