#include "viewer/panels/file_browser.hpp"

#include "viewer/config.hpp"
#include "viewer/palette.hpp"

#include <algorithm>
#include <cctype>
#include <cstdlib>
#include <cstring>
#include <imgui.h>
#include <utility>

namespace sr::viewer {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t max_entries = 500; // a longer list wants a letter more

bool same_letters(char a, char b) {
    return std::tolower(static_cast<unsigned char>(a)) == std::tolower(static_cast<unsigned char>(b));
}

bool begins_with(const std::string& text, const std::string& part) {
    return text.size() >= part.size()
           && std::equal(part.begin(), part.end(), text.begin(),
                         [](char a, char b) { return same_letters(a, b); });
}

} // namespace

fs::path expanded(const std::string& path) {
    const char* home = std::getenv("HOME");
    return home && path.starts_with("~/") ? fs::path(home) / path.substr(2) : fs::path(path);
}

void FileBrowser::show(std::vector<std::string_view> extensions, const std::string& typed) {
    extensions_ = std::move(extensions);
    type(typed);
    list(typed_.data());
    focus_.begin();
}

void FileBrowser::type(const std::string& path) {
    typed_.fill('\0');
    std::strncpy(typed_.data(), path.c_str(), typed_.size() - 1);
}

/// Lists what goes on from a typed text, folders first.
void FileBrowser::list(const char* typed) {
    listed_ = typed;
    const auto slash = listed_.rfind('/');
    folder_ = slash == std::string::npos ? "" : listed_.substr(0, slash + 1);
    const std::string begun = slash == std::string::npos ? listed_ : listed_.substr(slash + 1);
    entries_.clear();
    std::error_code failure;
    const fs::path folder = folder_.empty() ? fs::path(".") : expanded(folder_);
    for (fs::directory_iterator entry(folder, failure); !failure && entry != fs::directory_iterator();
         entry.increment(failure)) {
        const std::string name = entry->path().filename().string();
        const bool is_hidden = name.starts_with('.') && !begun.starts_with('.');
        std::error_code ignored;
        const bool is_folder = entry->is_directory(ignored);
        if (is_hidden || !begins_with(name, begun)) continue;
        if (is_folder)
            entries_.push_back({name + "/", true});
        else if (has_extension(name, extensions_))
            entries_.push_back({name, false});
    }
    std::ranges::sort(entries_, [](const Entry& a, const Entry& b) {
        return a.is_folder != b.is_folder ? a.is_folder : a.name < b.name;
    });
    if (begun.empty()) entries_.insert(entries_.begin(), {"../", true});
    has_more_ = entries_.size() > max_entries;
    entries_.resize(std::min(entries_.size(), max_entries));
}

int FileBrowser::call_back(ImGuiInputTextCallbackData* data) {
    auto& browser = *static_cast<FileBrowser*>(data->UserData);
    if (data->EventFlag == ImGuiInputTextFlags_CallbackCompletion) browser.complete(*data);
    if (data->EventFlag == ImGuiInputTextFlags_CallbackAlways && browser.ends_left_ > 0) {
        --browser.ends_left_;
        data->CursorPos = data->SelectionStart = data->SelectionEnd = data->BufTextLen;
    }
    return 0;
}

/// Appends the letters that all entries have in common. The last letters may have come in this frame.
void FileBrowser::complete(ImGuiInputTextCallbackData& data) {
    if (listed_ != data.Buf) list(data.Buf);
    const auto first = std::ranges::find_if(entries_, [](const Entry& e) { return e.name != "../"; });
    if (first == entries_.end()) return;
    std::string common = first->name;
    for (auto entry = first + 1; entry != entries_.end(); ++entry) {
        const auto [end, other] = std::ranges::mismatch(common, entry->name);
        common.erase(end, common.end());
    }
    const std::size_t begun = listed_.size() - folder_.size();
    if (common.size() <= begun) return;
    data.DeleteChars(static_cast<int>(folder_.size()), static_cast<int>(begun));
    data.InsertChars(data.BufTextLen, common.c_str());
    data.CursorPos = data.SelectionStart = data.SelectionEnd = data.BufTextLen;
    completed_ = data.Buf;
}

std::optional<std::string> FileBrowser::chosen_or_entered(const std::string& path) {
    std::error_code ignored;
    if (!fs::is_directory(expanded(path), ignored)) return expanded(path).string();
    type(path.ends_with('/') ? path : path + "/");
    list(typed_.data());
    ends_left_ = 4;
    focus_.begin();
    return std::nullopt;
}

std::optional<std::string> FileBrowser::draw(const char* hint, float width, float list_height) {
    std::optional<std::string> chosen;
    ImGui::SetNextItemWidth(width);
    if (focus_.is_pending()) ImGui::SetKeyboardFocusHere();
    const bool is_entered = ImGui::InputTextWithHint(
        "##file", hint, typed_.data(), typed_.size(),
        ImGuiInputTextFlags_EnterReturnsTrue | ImGuiInputTextFlags_AutoSelectAll
            | ImGuiInputTextFlags_CallbackCompletion | ImGuiInputTextFlags_CallbackAlways,
        &FileBrowser::call_back, this);
    focus_.update(ImGui::IsItemActive());
    tooltip("Tab completes a name, Enter opens a folder or takes a file; ~/ is the home folder");
    if (is_entered && typed_[0] != '\0') chosen = chosen_or_entered(typed_.data());
    if (listed_ != typed_.data()) list(typed_.data());
    if (const auto listed = draw_list(width, list_height)) {
        type(*listed);
        chosen = chosen_or_entered(*listed);
    }
    return chosen;
}

std::optional<std::string> FileBrowser::draw_list(float width, float height) {
    std::optional<std::string> chosen;
    ImGui::BeginChild("entries", {width, height}, true);
    for (const Entry& entry : entries_) {
        if (!entry.is_folder) ImGui::PushStyleColor(ImGuiCol_Text, palette::blue);
        if (ImGui::Selectable(entry.name.c_str())) chosen = folder_ + entry.name;
        if (!entry.is_folder) ImGui::PopStyleColor();
    }
    if (has_more_) ImGui::TextDisabled("and more: type the next letter");
    if (entries_.empty()) ImGui::TextDisabled("nothing here begins like that");
    ImGui::EndChild();
    return chosen;
}

} // namespace sr::viewer
