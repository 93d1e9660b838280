#include "viewer/ui.hpp"

#include "viewer/config.hpp"
#include "viewer/palette.hpp"

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>
#include <algorithm>
#include <backends/imgui_impl_glfw.h>
#include <backends/imgui_impl_opengl3.h>
#include <imgui.h>
#include <imgui_internal.h>
#include <utility>

namespace sr::viewer {
namespace {

/// Sets blue and orange on grey, which people with any kind of colour blindness can distinguish (Okabe & Ito
/// 2008).
void set_style(float scale) {
    ImGui::GetStyle() = ImGuiStyle();
    ImGui::StyleColorsDark();
    ImGuiStyle& style = ImGui::GetStyle();
    style.WindowRounding = style.FrameRounding = style.GrabRounding = 3.0f;
    style.Colors[ImGuiCol_WindowBg] = {0.11f, 0.11f, 0.12f, 0.95f};
    style.ScaleAllSizes(scale);
}

/// Lets Ctrl A, C, V, X, Y and Z of text fields go by labels. Later versions do so themselves.
template<class Io>
void go_by_labels(Io& io) {
    if constexpr (IMGUI_VERSION_NUM < 18700 && requires { io.KeyMap[0]; })
        for (int place = GLFW_KEY_A; place <= GLFW_KEY_Z; ++place)
            for (const auto& [letter, key] : {std::pair(GLFW_KEY_A, ImGuiKey_A),
                                              {GLFW_KEY_C, ImGuiKey_C},
                                              {GLFW_KEY_V, ImGuiKey_V},
                                              {GLFW_KEY_X, ImGuiKey_X},
                                              {GLFW_KEY_Y, ImGuiKey_Y},
                                              {GLFW_KEY_Z, ImGuiKey_Z}})
                if (labelled(place) == letter) io.KeyMap[key] = place;
}

/// Holds these keys, or lets them go. Later versions queue keys themselves and have no such array.
template<class Io>
void hold(Io& io, const std::vector<KeyEvent>& keys, bool is_down) {
    if constexpr (IMGUI_VERSION_NUM < 18700 && requires { io.KeysDown[0]; })
        for (const KeyEvent& key : keys) {
            if (key.place < 0) continue; // one that GLFW does not know
            io.KeysDown[key.place] = is_down;
            if (key.modifiers & control) io.KeyCtrl = is_down;
        }
}

void on_key_pressed(GLFWwindow* window, int key, int scancode, int action, int modifiers) {
    if (!WindowInput::of(window).keep({0, key, scancode, action, modifiers}))
        ImGui_ImplGlfw_KeyCallback(window, key, scancode, action, modifiers);
}

void on_character_typed(GLFWwindow* window, unsigned character) {
    if (!WindowInput::of(window).keep({character})) ImGui_ImplGlfw_CharCallback(window, character);
}

} // namespace

Ui::Ui(GLFWwindow* window) : window_(window) {
    IMGUI_CHECKVERSION();
    ImGui::CreateContext();
    const auto folder = config_folder();
    if (!folder.empty()) layout_file_ = (folder / "panels.ini").string();
    ImGui::GetIO().IniFilename = layout_file_.empty() ? nullptr : layout_file_.c_str();
    ImGui_ImplGlfw_InitForOpenGL(window, true); // its callbacks call those of WindowInput
    glfwSetKeyCallback(window, on_key_pressed);
    glfwSetCharCallback(window, on_character_typed);
    ImGui_ImplOpenGL3_Init("#version 410 core");
    watch_scale();
}

Ui::~Ui() {
    ImGui_ImplOpenGL3_Shutdown();
    ImGui_ImplGlfw_Shutdown();
    ImGui::DestroyContext();
}

/// Dear ImGui counts in the window's coordinates. Where these are pixels (X11, Windows), a dense screen wants
/// larger ones; where they are not (macOS, Wayland), the framebuffer's scale does it.
void Ui::watch_scale() {
    float content = 1.0f;
    glfwGetWindowContentScale(window_, &content, nullptr);
    int window = 1, pixels = 1;
    glfwGetWindowSize(window_, &window, nullptr);
    glfwGetFramebufferSize(window_, &pixels, nullptr);
    const float dense = static_cast<float>(std::max(1, pixels)) / static_cast<float>(std::max(1, window));
    const float scale = std::max(1.0f, content / dense);
    if (scale == scale_) return;
    scale_ = scale;
    set_style(scale);
    fonts_ = load_fonts(scale);
    ImGui_ImplOpenGL3_DestroyDeviceObjects(); // they come back with the next frame, font included
}

void Ui::replay(const std::vector<TypedEvent>& typed) {
    for (const TypedEvent& event : typed)
        if (event.character != 0)
            ImGui_ImplGlfw_CharCallback(window_, event.character);
        else
            ImGui_ImplGlfw_KeyCallback(window_, event.key, event.scancode, event.action, event.modifiers);
}

void Ui::begin(std::vector<KeyEvent> taps) {
    taps_ = std::move(taps);
    watch_scale();
    ImGui_ImplOpenGL3_NewFrame();
    ImGui_ImplGlfw_NewFrame();
    go_by_labels(ImGui::GetIO()); // the layout may have changed
    hold(ImGui::GetIO(), taps_, true);
    ImGui::NewFrame();
}

void Ui::end() {
    hold(ImGui::GetIO(), taps_, false);
    ImGui::Render();
    ImGui_ImplOpenGL3_RenderDrawData(ImGui::GetDrawData());
}

bool Ui::has_pointer() const { return ImGui::GetIO().WantCaptureMouse; }
int Ui::panel_flags(bool is_docked) const {
    constexpr int docked = ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoCollapse | ImGuiWindowFlags_NoTitleBar
                           | ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_NoBringToFrontOnFocus
                           | ImGuiWindowFlags_NoResize;
    return (is_docked ? docked : ImGuiWindowFlags_AlwaysAutoResize)
           | (has_keyboard() ? 0 : ImGuiWindowFlags_NoNavInputs);
}
bool Ui::has_keyboard() const {
    // WantTextInput is of the frame before: a field that Enter has closed has no keys any more.
    return ImGui::GetIO().WantTextInput && ImGui::IsAnyItemActive();
}

bool Ui::needs_frame() {
    const bool is_active = ImGui::IsAnyItemActive();
    const bool has_changed = std::exchange(had_active_item_, is_active) != is_active;
#if IMGUI_VERSION_NUM >= 18700 // hands a widget about one key a frame, and keeps the others for later frames
    return has_changed || !ImGui::GetCurrentContext()->InputEventsQueue.empty();
#else
    return has_changed; // the keyboard follows a frame later
#endif
}

bool Ui::changed_field() {
    if (!has_keyboard()) return false;
    const unsigned before = std::exchange(field_, ImGui::GetActiveID());
    return before != 0 && before != field_;
}

bool Ui::took_keyboard() { return !std::exchange(had_keyboard_, has_keyboard()) && had_keyboard_; }

void tooltip(const std::string& text) {
    if (!ImGui::IsItemHovered()) return;
    ImGui::BeginTooltip();
    ImGui::PushTextWrapPos(32.0f * ImGui::GetFontSize());
    ImGui::TextUnformatted(in_plain_letters(text).c_str());
    ImGui::PopTextWrapPos();
    ImGui::EndTooltip();
}

void draw_caption(vec2 at, const std::string& text) {
    const std::string shown = in_plain_letters(text);
    const ImVec2 size = ImGui::CalcTextSize(shown.c_str());
    const float margin = 0.4f * ImGui::GetFontSize();
    ImDrawList& list = *ImGui::GetBackgroundDrawList();
    list.AddRectFilled({at.x, at.y}, {at.x + size.x + 2.0f * margin, at.y + size.y + 2.0f * margin},
                       IM_COL32(0, 0, 0, 190), margin);
    list.AddText({at.x + margin, at.y + margin}, palette::white, shown.c_str());
}

void draw_table_heads(std::span<const std::pair<std::string, const char*>> heads) {
    const auto shown = [](const std::string& head) { return with_superscripts(in_plain_letters(head)); };
    for (const auto& [head, tip] : heads) ImGui::TableSetupColumn(shown(head).c_str());
    ImGui::TableNextRow(ImGuiTableRowFlags_Headers);
    for (const auto& [head, tip] : heads) {
        ImGui::TableNextColumn();
        ImGui::TableHeader(shown(head).c_str());
        tooltip(tip);
    }
}

void heading(const char* text, const Ui& ui) {
    ImGui::PushFont(ui.fonts().heading);
    ImGui::TextUnformatted(text);
    ImGui::PopFont();
}

void place_next_window(const Area& area) {
    ImGui::SetNextWindowPos({area.from.x, area.from.y});
    ImGui::SetNextWindowSize({area.size.x, area.size.y});
}

void keep_in_viewport() {
    const ImGuiViewport& viewport = *ImGui::GetMainViewport();
    const ImVec2 at = ImGui::GetWindowPos(), size = ImGui::GetWindowSize();
    const auto kept = [](float begin, float length, float from, float room) {
        return std::max(from, std::min(begin, from + room - length));
    };
    const ImVec2 inside{kept(at.x, size.x, viewport.Pos.x, viewport.Size.x),
                        kept(at.y, size.y, viewport.Pos.y, viewport.Size.y)};
    if (inside.x != at.x || inside.y != at.y) ImGui::SetWindowPos(inside);
}

} // namespace sr::viewer
