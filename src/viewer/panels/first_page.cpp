#include "viewer/panels/first_page.hpp"

#include "core/error.hpp"
#include "image/file.hpp"
#include "viewer/app/fonts.hpp"
#include "viewer/config.hpp"
#include "viewer/palette.hpp"

#include <algorithm>
#include <cstdint>
#include <filesystem>
#include <fmt/format.h>
#include <imgui.h>
#include <utility>

namespace sr::viewer {
namespace {

constexpr float min_two_columns = 46.0f; // width of a page with two columns [heights of a letter]

/// The PNG of a thumbnail; absent if it is broken.
std::optional<gl::Texture> texture_of(const std::filesystem::path& file) {
    image::Image picture;
    try {
        picture = image::read(file);
    } catch (const Error&) {
        return std::nullopt;
    }
    std::vector<float> texels;
    for (int y = 0; y < picture.height; ++y)
        for (int x = 0; x < picture.width; ++x) {
            const auto pixel = picture.at(x, y);
            for (std::size_t i = 0; i < 3; ++i) texels.push_back(pixel[i < pixel.size() ? i : 0]);
        }
    gl::Texture texture(GL_TEXTURE_2D, "thumbnail");
    glTexImage2D(GL_TEXTURE_2D, 0, GL_RGB8, picture.width, picture.height, 0, GL_RGB, GL_FLOAT,
                 texels.data());
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAX_LEVEL, 0);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
    return texture;
}

} // namespace

FirstPage::FirstPage(std::vector<SampleScene> samples)
    : samples_(std::move(samples)), recent_(recent_files()) {
    browser_.show({scene_extensions.begin(), scene_extensions.end()}, "");
}

bool FirstPage::update() {
    if (!thumbnails_) {
        std::vector<std::string> files = recent_;
        for (const SampleScene& sample : samples_) files.push_back(sample.file);
        const std::filesystem::path folder = cache_folder();
        thumbnails_.emplace(files, folder.empty() ? folder : folder / "thumbnails");
        return true;
    }
    return thumbnails_->update();
}

std::string FirstPage::take_problem() {
    if (!thumbnails_ || std::exchange(is_problem_taken_, true)) return {};
    return thumbnails_->problem();
}

/// The picture of a file; null if there is none, or none yet.
const gl::Texture* FirstPage::picture_of(const std::string& file) {
    const auto known = pictures_.find(file);
    if (known != pictures_.end()) return &known->second;
    const std::filesystem::path picture =
        thumbnails_ ? thumbnails_->picture_of(file) : std::filesystem::path();
    if (picture.empty()) return nullptr;
    wants_frame_ = true;
    if (!std::exchange(may_read_, false)) return nullptr;
    std::optional<gl::Texture> texture = texture_of(picture);
    if (!texture) return nullptr;
    return &pictures_.emplace(file, std::move(*texture)).first->second;
}

/// A row with a picture, a name and what it is beside it, on as many lines as that needs.
bool FirstPage::draw_row(const std::string& file, const std::string& name, const std::string& what) {
    const float letter = ImGui::GetFontSize(), gap = 0.6f * letter;
    const ImVec2 side{4.4f * letter * Thumbnails::width / Thumbnails::height, 4.4f * letter};
    const float wrap = std::max(ImGui::GetContentRegionAvail().x - side.x - gap, 6.0f * letter);
    const std::string fault = thumbnails_ ? in_plain_letters(thumbnails_->fault_of(file)) : std::string();
    const std::string& second = fault.empty() ? what : fault;
    const float text = letter + ImGui::CalcTextSize(second.c_str(), nullptr, false, wrap).y;
    const ImVec2 at = ImGui::GetCursorScreenPos();
    const float height = std::max(side.y, text);
    const bool is_chosen = ImGui::Selectable(("##" + file).c_str(), false, 0, {0.0f, height});
    if (!fault.empty()) tooltip(fmt::format("{}: {}", file, fault));
    if (!ImGui::IsItemVisible()) return is_chosen;
    ImDrawList& list = *ImGui::GetWindowDrawList();
    const ImVec2 end{at.x + side.x, at.y + side.y};
    if (const gl::Texture* const picture = picture_of(file))
        list.AddImage(reinterpret_cast<ImTextureID>(static_cast<std::uintptr_t>(picture->id())), at, end);
    else
        list.AddRectFilled(at, end, IM_COL32(40, 40, 44, 255), 3.0f);
    if (!fault.empty())
        list.AddText(ImGui::GetFont(), 2.0f * letter,
                     {at.x + 0.5f * side.x - 0.3f * letter, at.y + 0.25f * side.y}, palette::orange, "!");
    const ImU32 ink = ImGui::IsItemHovered() ? palette::white : palette::blue;
    list.AddText({end.x + gap, at.y}, ink, name.c_str());
    list.AddText(ImGui::GetFont(), letter, {end.x + gap, at.y + 1.2f * letter},
                 fault.empty() ? palette::white : palette::orange, second.c_str(), nullptr, wrap);
    return is_chosen;
}

std::optional<std::string> FirstPage::draw(const Area& room, const Ui& ui) {
    may_read_ = true;
    wants_frame_ = false;
    place_next_window(room);
    ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {24.0f * ui.scale(), 18.0f * ui.scale()});
    ImGui::Begin("first page", nullptr,
                 ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoSavedSettings
                     | ImGuiWindowFlags_NoBringToFrontOnFocus);
    ImGui::PopStyleVar();
    const ImVec2 all = ImGui::GetContentRegionAvail();
    const bool has_two_columns = all.x > min_two_columns * ImGui::GetFontSize();
    const float gap = 28.0f * ui.scale();
    const float width = has_two_columns ? 0.45f * (all.x - gap) : all.x;
    std::optional<std::string> chosen;
    ImGui::BeginChild("open", {width, has_two_columns ? 0.0f : 0.5f * all.y});
    chosen = draw_browser(width, ui);
    ImGui::EndChild();
    if (has_two_columns) ImGui::SameLine(0.0f, gap);
    ImGui::BeginChild("lists");
    if (const auto listed = draw_lists(ui)) chosen = listed;
    ImGui::EndChild();
    ImGui::End();
    return chosen;
}

std::optional<std::string> FirstPage::draw_browser(float width, const Ui& ui) {
    heading("Open a scene", ui);
    ImGui::PushTextWrapPos();
    ImGui::TextDisabled("Drop a .gltf or .glb file on this window, or type its path.");
    ImGui::PopTextWrapPos();
    auto chosen = browser_.draw("a path, or the name of a bundled scene", width, -1.0f);
    std::error_code ignored;
    if (!chosen || std::filesystem::exists(*chosen, ignored)) return chosen;
    const auto sample = std::ranges::find(samples_, *chosen, &SampleScene::name);
    return sample == samples_.end() ? chosen : sample->file;
}

std::optional<std::string> FirstPage::draw_lists(const Ui& ui) {
    std::optional<std::string> chosen;
    if (!recent_.empty()) heading("Recent files", ui);
    for (const std::string& file : recent_) {
        const std::filesystem::path path(file);
        if (draw_row(file, path.filename().string(), path.parent_path().string())) chosen = file;
    }
    if (!recent_.empty()) ImGui::Spacing();
    if (!samples_.empty()) heading("Bundled scenes", ui);
    for (const SampleScene& sample : samples_)
        if (draw_row(sample.file, sample.name, in_plain_letters(sample.what))) chosen = sample.file;
    return chosen;
}

} // namespace sr::viewer
