#include "viewer/panels/question.hpp"

#include "viewer/ui.hpp"

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>
#include <algorithm>
#include <fmt/format.h>
#include <imgui.h>

namespace sr::viewer {

const Answer* Question::answer_of(int key) const {
    if (key == GLFW_KEY_ENTER || key == GLFW_KEY_KP_ENTER) return &answers.front();
    if (key == GLFW_KEY_ESCAPE) return &answers.back();
    const auto found = std::ranges::find_if(answers, [=](const Answer& a) { return a.key && a.key == key; });
    return found == answers.end() ? nullptr : &*found;
}

const Answer* draw_question(const Question& question) {
    const ImGuiViewport& viewport = *ImGui::GetMainViewport();
    const float width = std::min(0.9f * viewport.Size.x, 40.0f * ImGui::GetFontSize());
    ImGui::SetNextWindowPos(viewport.GetCenter(), ImGuiCond_Always, {0.5f, 0.5f});
    ImGui::SetNextWindowSize({width, 0.0f});
    ImGui::SetNextWindowFocus(); // takes the keyboard from a text field
    ImGui::Begin("Question", nullptr,
                 ImGuiWindowFlags_NoCollapse | ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoSavedSettings
                     | ImGuiWindowFlags_AlwaysAutoResize);
    ImGui::PushTextWrapPos();
    ImGui::TextUnformatted(question.text.c_str());
    ImGui::PopTextWrapPos();
    ImGui::Spacing();
    const Answer* chosen = nullptr;
    for (const Answer& answer : question.answers) {
        const bool is_first = &answer == &question.answers.front();
        const std::string key = answer.key ? std::string(1, static_cast<char>(answer.key)) : "Esc";
        const std::string label = fmt::format("{}  [{}{}]", answer.text, key, is_first ? ", Enter" : "");
        if (ImGui::Button(label.c_str(), {-1.0f, 0.0f})) chosen = &answer;
        tooltip(fmt::format("key {}{}", key, is_first ? ", or Enter" : ""));
    }
    ImGui::End();
    return chosen;
}

} // namespace sr::viewer
