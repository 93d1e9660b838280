#include "viewer/panels/text_form.hpp"

#include <algorithm>
#include <imgui.h>

namespace sr::viewer {

void TextForm::put(Text& text, const std::string& value) {
    text.fill('\0');
    std::copy_n(value.begin(), std::min(value.size(), text.size() - 1), text.begin());
}

void TextForm::begin() {
    problem_.clear();
    focus_.begin();
}

void TextForm::refuse(const std::string& problem) {
    problem_ = problem;
    focus_.begin();
}

bool TextForm::field(const char* label, Text& text, const char* tip, bool is_first) {
    if (is_first && focus_.is_pending()) ImGui::SetKeyboardFocusHere();
    const bool is_entered =
        ImGui::InputText(label, text.data(), text.size(),
                         ImGuiInputTextFlags_EnterReturnsTrue | ImGuiInputTextFlags_AutoSelectAll);
    if (ImGui::IsItemActivated()) focused_ = label;
    if (is_first) focus_.update(ImGui::IsItemActive());
    tooltip(tip);
    return is_entered;
}

void TextForm::begin_window(const char* title, bool& is_open) {
    const float width = std::min(30.0f * ImGui::GetFontSize(), 0.85f * ImGui::GetMainViewport()->Size.x);
    ImGui::SetNextWindowPos(ImGui::GetMainViewport()->GetCenter(), ImGuiCond_Always, {0.5f, 0.5f});
    ImGui::SetNextWindowSize({width, 0.0f});
    ImGui::Begin(title, &is_open, ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_NoResize);
    ImGui::PushItemWidth(0.72f * ImGui::GetContentRegionAvail().x);
}

bool TextForm::end_window(const char* button, const char* tip) const {
    ImGui::PopItemWidth();
    ImGui::Spacing();
    const bool is_pressed = ImGui::Button(button);
    tooltip(tip);
    if (!problem_.empty()) {
        ImGui::PushTextWrapPos();
        ImGui::TextUnformatted(problem_.c_str());
        ImGui::PopTextWrapPos();
    }
    ImGui::End();
    return is_pressed;
}

} // namespace sr::viewer
