#include "viewer/panels/animation.hpp"

#include "viewer/fields.hpp"
#include "viewer/ui.hpp"

#include <algorithm>
#include <fmt/format.h>
#include <imgui.h>

namespace sr::viewer {
namespace {

using Animations = std::span<const gltf::Contents::AnimationInfo>;

std::string argument_of(Animations all, std::size_t i) {
    const std::string& name = all[i].name;
    const bool is_unique = !name.empty() && name != "all"
                           && name.find_first_not_of("0123456789") != std::string::npos
                           && name.find('\'') == std::string::npos
                           && std::ranges::count(all, name, &gltf::Contents::AnimationInfo::name) == 1;
    return is_unique ? name : std::to_string(i);
}

void clip_combo(AnimationRequest& request, const Playback& playback, Animations all, float width) {
    const std::string now = animation_argument(all, playback.animations);
    const auto shown = static_cast<std::size_t>(playback.animations.front());
    const std::string title = now == "all" ? "all at once" : fmt::format("{} {}", shown, all[shown].name);
    ImGui::SetNextItemWidth(width);
    const bool is_open = ImGui::BeginCombo("##animation", title.c_str());
    tooltip("animation of the file that plays, or all at once");
    if (!is_open) return;
    for (std::size_t i = 0; i < all.size(); ++i) {
        const std::string argument = argument_of(all, i);
        const std::string label = fmt::format("{} {} ({:.2f} s)##{}", i, all[i].name, all[i].duration, i);
        if (ImGui::Selectable(label.c_str(), argument == now)) request.animation = argument;
    }
    if (all.size() > 1) {
        if (ImGui::Selectable("all at once", now == "all")) request.animation = "all";
        tooltip("the later one wins where two move the same property");
    }
    ImGui::EndCombo();
}

void buttons(AnimationRequest& request, const Playback& playback, const Keymap& keys, float width) {
    const auto button = [&](const char* label, Command command, const char* tip) {
        if (ImGui::Button(label)) request.command = command;
        tooltip(keys.hint(tip, command));
        ImGui::SameLine();
    };
    button("|<", Command::first_frame, "Home over the bar: to the start");
    button("<", Command::frame_back, "left over the bar: a frame back");
    if (ImGui::Button(playback.is_playing ? "pause" : "play", {width, 0.0f})) request.command = Command::play;
    tooltip(keys.hint("play or pause; also Space while no light is selected", Command::play));
    ImGui::SameLine();
    button(">", Command::frame_forward, "right over the bar: a frame forward");
    button(">|", Command::last_frame, "End over the bar: to the end");
    if (ImGui::Button("rest")) request.rests = true;
    tooltip("rest pose, without animations");
    ImGui::SameLine();
}

} // namespace

std::string animation_argument(Animations all, std::span<const int> chosen) {
    if (chosen.size() == 1) return argument_of(all, static_cast<std::size_t>(chosen.front()));
    return "all";
}

AnimationRequest animation_bar(Playback& playback, Animations all, Layout& layout, const Keymap& keys,
                               float scale) {
    AnimationRequest request;
    const float height = ImGui::GetFrameHeight() + 10.0f * scale;
    place_next_window(layout.take_bottom(height, height));
    ImGui::PushStyleVar(ImGuiStyleVar_WindowMinSize, {1.0f, 1.0f});
    ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {6.0f * scale, 5.0f * scale});
    ImGui::Begin("animation", nullptr,
                 ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoSavedSettings
                     | ImGuiWindowFlags_NoBringToFrontOnFocus);
    buttons(request, playback, keys, 46.0f * scale);
    const float others = 300.0f * scale; // right of the time
    const auto duration = static_cast<float>(playback.duration);
    auto time = static_cast<float>(playback.seconds.value_or(0.0));
    ImGui::SetNextItemWidth(std::max(60.0f * scale, ImGui::GetContentRegionAvail().x - others));
    std::string format = playback.seconds ? fmt::format("%.3f / {:.3f} s", playback.duration)
                                          : fmt::format("rest pose / {:.3f} s", playback.duration);
    if (field_width_of(format) > ImGui::CalcItemWidth()) format = playback.seconds ? "%.2f s" : "rest";
    if (ImGui::SliderFloat("##time", &time, 0.0f, duration, format.c_str(), ImGuiSliderFlags_AlwaysClamp))
        request.time = static_cast<double>(time);
    tooltip("time of the animation [s]; a drag goes to another, a click with Ctrl types it");
    ImGui::SameLine();
    clip_combo(request, playback, all, 90.0f * scale);
    ImGui::SameLine();
    auto speed = static_cast<float>(playback.speed);
    ImGui::SetNextItemWidth(54.0f * scale);
    if (ImGui::SliderFloat("##speed", &speed, static_cast<float>(Playback::min_speed),
                           static_cast<float>(Playback::max_speed), "%.2fx",
                           ImGuiSliderFlags_AlwaysClamp | ImGuiSliderFlags_Logarithmic))
        playback.speed = static_cast<double>(speed);
    tooltip("speed of the clock, 1: as the file says; Ctrl click to type it");
    ImGui::SameLine();
    ImGui::Checkbox("back", &playback.is_reversed);
    tooltip("play backwards");
    ImGui::SameLine();
    ImGui::Checkbox("loop", &playback.loops);
    tooltip("begin again at the end");
    request.has_pointer = ImGui::IsWindowHovered(ImGuiHoveredFlags_AllowWhenBlockedByActiveItem);
    ImGui::End();
    ImGui::PopStyleVar(2);
    return request;
}

std::optional<std::string> variants_section(std::span<const std::string> variants, const std::string& shown) {
    std::optional<std::string> chosen;
    if (variants.empty()) return chosen;
    const bool is_unfolded = ImGui::CollapsingHeader("Variants", ImGuiTreeNodeFlags_DefaultOpen);
    tooltip("material variants of the file (KHR_materials_variants)");
    if (!is_unfolded) return chosen;
    if (ImGui::RadioButton("none##variant", shown.empty())) chosen = "";
    tooltip("the materials that the file has without a variant");
    for (const std::string& name : variants) {
        if (ImGui::RadioButton((name + "##variant").c_str(), shown == name)) chosen = name;
        tooltip("the materials of this variant; the file is loaded again");
    }
    return chosen;
}

} // namespace sr::viewer
