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

void TextForm::draw_problem() const {
    if (problem_.empty()) return;
    ImGui::PushTextWrapPos();
    ImGui::TextUnformatted(problem_.c_str());
    ImGui::PopTextWrapPos();
}

} // namespace sr::viewer
