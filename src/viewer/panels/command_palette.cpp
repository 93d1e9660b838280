#include "viewer/panels/command_palette.hpp"

#include <algorithm>
#include <cctype>
#include <imgui.h>
#include <sstream>
#include <string_view>
#include <utility>

namespace sr::viewer {
namespace {

std::string lower(std::string text) {
    std::ranges::transform(text, text.begin(), [](unsigned char c) { return std::tolower(c); });
    return text;
}

/// How well a command fits what is typed: 0 is best; absent if it does not fit.
std::optional<int> rank_of(const CommandInfo& command, const std::string& typed) {
    const std::string name = lower(command.name);
    const std::string all = name + " " + lower(command.group) + " " + lower(command.what);
    if (name.starts_with(typed)) return 0;
    std::istringstream words(typed);
    int rank = 1;
    for (std::string word; words >> word;) {
        if (all.find(word) == std::string::npos) return std::nullopt;
        if (name.find(word) == std::string::npos) rank = 2;
    }
    return rank;
}

} // namespace

std::vector<const CommandInfo*> commands_like(std::string_view typed) {
    const std::string wanted = lower(std::string(typed));
    std::vector<std::pair<int, const CommandInfo*>> found;
    for (const CommandInfo& command : all_commands())
        if (const auto rank = rank_of(command, wanted)) found.emplace_back(*rank, &command);
    std::ranges::stable_sort(found, {}, &std::pair<int, const CommandInfo*>::first);
    std::vector<const CommandInfo*> commands;
    for (const auto& [rank, command] : found) commands.push_back(command);
    return commands;
}

void CommandPalette::open() {
    is_open_ = true;
    typed_.fill('\0');
    chosen_ = moves_ = 0;
    focus_.begin();
}

std::optional<Command> CommandPalette::draw(const Ui& ui, const Keymap& keymap) {
    if (!is_open_) return std::nullopt;
    const ImGuiViewport& viewport = *ImGui::GetMainViewport();
    const ImVec2 size{std::min(0.9f * viewport.Size.x, 560.0f * ui.scale()),
                      std::min(0.8f * viewport.Size.y, 420.0f * ui.scale())};
    ImGui::SetNextWindowPos({viewport.GetCenter().x, 0.08f * viewport.Size.y}, ImGuiCond_Always,
                            {0.5f, 0.0f});
    ImGui::SetNextWindowSize(size);
    ImGui::Begin("All commands", &is_open_,
                 ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_NoCollapse | ImGuiWindowFlags_NoMove
                     | ImGuiWindowFlags_NoResize);
    ImGui::SetNextItemWidth(-1.0f);
    if (focus_.is_pending()) ImGui::SetKeyboardFocusHere();
    const bool is_entered =
        ImGui::InputTextWithHint("##typed", "type a part of its name; up, down, Enter", typed_.data(),
                                 typed_.size(), ImGuiInputTextFlags_EnterReturnsTrue);
    focus_.update(ImGui::IsItemActive());
    if (ImGui::IsItemEdited()) chosen_ = 0;
    tooltip("a part of a command's name, group or meaning; up, down and Enter run it, Esc closes");
    const std::vector<const CommandInfo*> rows = commands_like(typed_.data());
    const bool is_moved = moves_ != 0;
    const int count = std::max(1, static_cast<int>(rows.size()));
    chosen_ = ((chosen_ + std::exchange(moves_, 0)) % count + count) % count;
    std::optional<Command> chosen;
    if (is_entered && !rows.empty()) chosen = rows[static_cast<std::size_t>(chosen_)]->command;
    ImGui::BeginChild("rows");
    for (std::size_t i = 0; i < rows.size(); ++i) {
        const CommandInfo& row = *rows[i];
        const bool is_chosen = static_cast<int>(i) == chosen_;
        if (ImGui::Selectable((std::string(row.name) + "##" + row.group).c_str(), is_chosen))
            chosen = row.command;
        if (is_chosen && is_moved) ImGui::SetScrollHereY();
        tooltip(row.what);
        const std::string keys = keymap.text(row.command);
        ImGui::SameLine(0.42f * size.x);
        ImGui::TextDisabled("%s", row.group);
        ImGui::SameLine(size.x - ImGui::CalcTextSize(keys.c_str()).x - 3.0f * ImGui::GetFontSize());
        ImGui::TextUnformatted(keys.c_str());
    }
    if (rows.empty()) ImGui::TextDisabled("no command is like that");
    ImGui::EndChild();
    ImGui::End();
    if (chosen) is_open_ = false;
    return chosen;
}

} // namespace sr::viewer
