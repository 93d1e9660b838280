// A student's folder in the window: its marks, its errors, and the reference's picture beside theirs.
#include "viewer/session.hpp"

#include <algorithm>
#include <fmt/format.h>
#include <imgui.h>

namespace sr::viewer {

/// Marks as they come. The window runs the student's code only after a child process has come to its end with
/// it: a loop without an end would take the window along.
void Session::take_marks() {
    if (!marks_ || !show_) return;
    if (marks_->take()) frames_to_draw_ = std::max(frames_to_draw_, 3);
    if (!marks_->take_end()) return;
    if (!marks_->failure().empty()) return fail("Nothing can be checked.", marks_->failure());
    if (const std::string task = marks_->endless(); !task.empty())
        return fail(fmt::format("{} does not come to an end. The picture is by the code before.", task),
                    marks_->problems());
    options_.shows_reference = false;
    reload_shaders();
    if (!error_text_.empty() && !marks_->problems().empty())
        fail("Your code does not compile. The picture is by the code before.", marks_->problems());
}

/// Whether the reference's picture is needed beside the student's.
bool Session::shows_reference_beside() const {
    const bool is_compared =
        look_.comparison == Comparison::wipe || look_.comparison == Comparison::difference;
    return marks_ && show_ && !reference_ && is_compared;
}

void Session::advance_reference() {
    if (shows_reference_beside()) show_->advance_reference(options_, eye_->camera(), width_, height_);
}

void Session::draw_marks() {
    if (!marks_) return;
    const float width = std::min(540.0f * ui_.scale(), 0.6f * window_size().x);
    const float below_errors = 6.0f * ImGui::GetFontSize(); // so that an error of few lines hides no mark
    ImGui::SetNextWindowPos({window_size().x - width - 10.0f, below_errors}, ImGuiCond_FirstUseEver);
    ImGui::SetNextWindowSizeConstraints({width, 0.0f}, {width, 0.8f * window_size().y});
    if (ImGui::Begin("Assignment", nullptr, ui_.panel_flags())) {
        const auto choice = [&](const char* label, Comparison comparison) {
            if (ImGui::RadioButton(label, look_.comparison == comparison)) look_.comparison = comparison;
        };
        if (!reference_) { // a kept picture has its own list, in the panel "Compare"
            choice("yours", Comparison::none);
            ImGui::SameLine();
            choice("yours | reference", Comparison::wipe);
            ImGui::SameLine();
            choice("difference", Comparison::difference);
            if (look_.comparison == Comparison::wipe)
                ImGui::SliderFloat("##wipe", &look_.wipe, 0.0f, 1.0f, "%.2f");
        }
        if (options_.shows_reference)
            ImGui::TextDisabled("The picture is the reference's until yours is checked.");
        marks_->draw();
    }
    ImGui::End();
}

} // namespace sr::viewer
