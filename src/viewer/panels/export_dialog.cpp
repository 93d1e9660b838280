#include "viewer/panels/export_dialog.hpp"

#include "core/error.hpp"
#include "render/adaptive/convergence.hpp"
#include "viewer/config.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <imgui.h>

namespace sr::viewer {
namespace {

constexpr std::array<std::string_view, 5> extensions{".png", ".exr", ".hdr", ".jpg", ".jpeg"};

template<std::size_t size>
void put(std::array<char, size>& text, const std::string& value) {
    text.fill('\0');
    std::copy_n(value.begin(), std::min(value.size(), size - 1), text.begin());
}

} // namespace

void ExportDialog::show(const ExportRequest& proposed, settings::Size window) {
    is_open_ = true;
    window_ = window;
    problem_.clear();
    put(size_, settings::text_of(proposed.size));
    put(samples_, std::to_string(proposed.samples));
    put(error_, proposed.error ? settings::percentage_text(*proposed.error) : "");
    put(file_, proposed.file);
    focus_.begin();
}

ExportRequest ExportDialog::request() const {
    ExportRequest wanted;
    const std::string size = size_.data(), samples = samples_.data(), error = error_.data();
    if (const auto read = settings::parse_size(size))
        wanted.size = *read;
    else
        throw Error(fmt::format("'{}' is no size", size), "give width and height in pixels: 3840x2160");
    const double count = settings::parse_number(samples).value_or(0.0);
    if (count < 1.0 || count > render::max_samples || count != std::floor(count))
        throw Error(fmt::format("'{}' is no number of samples", samples),
                    fmt::format("give a whole number from 1 to {}", render::max_samples));
    wanted.samples = static_cast<int>(count);
    if (!error.empty() && !(wanted.error = settings::parse_percentage(error)))
        throw Error(fmt::format("'{}' is no error", error), "give a percentage, as in 0.5%, or nothing");
    wanted.file = file_.data();
    if (!has_extension(wanted.file, extensions))
        throw Error({wanted.file}, "has no extension of a picture",
                    "give .png or .jpg for a screen, .exr or .hdr for cd/m²");
    return wanted;
}

/// @return true if Enter was pressed in the field
bool ExportDialog::field(const char* label, Text& text, const char* tip, bool is_first) {
    if (is_first && focus_.is_pending()) ImGui::SetKeyboardFocusHere();
    const bool is_entered =
        ImGui::InputText(label, text.data(), text.size(),
                         ImGuiInputTextFlags_EnterReturnsTrue | ImGuiInputTextFlags_AutoSelectAll);
    if (ImGui::IsItemActivated()) focused_ = label;
    if (is_first) focus_.update(ImGui::IsItemActive());
    tooltip(tip);
    return is_entered;
}

/// Draws buttons of common sizes.
void ExportDialog::draw_sizes() {
    const std::array<std::pair<const char*, settings::Size>, 4> sizes{
        {{"window", window_},
         {"2 x window", {2 * window_.width, 2 * window_.height}},
         {"1920x1080", {1920, 1080}},
         {"3840x2160", {3840, 2160}}}};
    for (const auto& [name, size] : sizes) {
        if (ImGui::Button(name)) put(size_, settings::text_of(size));
        tooltip(fmt::format("a picture of {} pixels", settings::text_of(size)));
        ImGui::SameLine();
    }
    ImGui::NewLine();
}

std::optional<ExportRequest> ExportDialog::draw() {
    if (!is_open_) return std::nullopt;
    const float width = std::min(30.0f * ImGui::GetFontSize(), 0.85f * ImGui::GetMainViewport()->Size.x);
    ImGui::SetNextWindowPos(ImGui::GetMainViewport()->GetCenter(), ImGuiCond_Always, {0.5f, 0.5f});
    ImGui::SetNextWindowSize({width, 0.0f});
    ImGui::Begin("Export a picture", &is_open_, ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_NoResize);
    ImGui::PushItemWidth(0.72f * ImGui::GetContentRegionAvail().x);
    bool is_entered =
        field("size", size_, "width x height [pixels]; the shape may differ from the window's", true);
    draw_sizes();
    is_entered |= field("samples", samples_, "of a pixel, at most: 1 to 65536");
    is_entered |= field("error", error_, "at which it stops earlier, as in 0.5%; empty: after all samples");
    is_entered |= field("file", file_, "in the working directory, or a path: .png, .jpg, .exr or .hdr");
    ImGui::PopItemWidth();
    ImGui::Spacing();
    is_entered |= ImGui::Button("export");
    tooltip("Enter does it, too; Esc closes this dialog, and later cancels the export");
    ImGui::PushTextWrapPos();
    if (!problem_.empty()) ImGui::TextUnformatted(problem_.c_str());
    ImGui::PopTextWrapPos();
    ImGui::End();
    if (!is_entered) return std::nullopt;
    try {
        problem_.clear();
        return request();
    } catch (const Error& error) {
        problem_ = error.what();
        focus_.begin();
        return std::nullopt;
    }
}

} // namespace sr::viewer
