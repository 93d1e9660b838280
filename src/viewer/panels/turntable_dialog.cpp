#include "viewer/panels/turntable_dialog.hpp"

#include "core/error.hpp"
#include "image/video.hpp"
#include "settings/render_settings.hpp"

#include <cmath>
#include <filesystem>
#include <fmt/format.h>
#include <imgui.h>

namespace sr::viewer {
namespace {

constexpr int most_pictures = 10'000;

const char* meaning_of(scene::TurnAxis axis) {
    switch (axis) {
    case scene::TurnAxis::x: return "around the scene's X, over the top";
    case scene::TurnAxis::y: return "around the scene's Y, which is up";
    case scene::TurnAxis::z: return "around the scene's Z";
    case scene::TurnAxis::camera: return "around what is up in the picture";
    }
    return "";
}

} // namespace

void TurntableDialog::show(const TurntableRequest& proposed, settings::Size window) {
    is_open_ = true;
    picture_.show(proposed.picture, window);
    axis_ = proposed.axis;
    TextForm::put(pictures_, std::to_string(proposed.pictures));
    TextForm::put(rate_, fmt::format("{}", proposed.rate));
    TextForm::put(target_, proposed.target);
    form_.begin();
}

TurntableRequest TurntableDialog::request() const {
    const std::string pictures = pictures_.data(), rate = rate_.data();
    TurntableRequest wanted{.picture = picture_.request(), .axis = axis_, .target = target_.data()};
    const double count = settings::parse_number(pictures).value_or(0.0);
    if (count < 2.0 || count > most_pictures || count != std::floor(count))
        throw Error(fmt::format("'{}' is no number of pictures", pictures),
                    fmt::format("give a whole number from 2 to {}", most_pictures));
    wanted.pictures = static_cast<int>(count);
    wanted.rate = settings::parse_number(rate).value_or(0.0);
    if (wanted.rate < 0.1 || wanted.rate > 1000.0)
        throw Error(fmt::format("'{}' is no rate", rate), "give pictures a second, from 0.1 to 1000");
    const std::filesystem::path target(wanted.target);
    if (image::is_video(target)) {
        image::require_video_encoder(target);
        image::require_writable(target);
    } else if (target.empty() || target.has_extension()) {
        throw Error({wanted.target}, "is neither a folder for PNGs nor a video",
                    "give a name without a dot for a folder, or one with .mp4 or .webm");
    } else if (std::filesystem::exists(target)) {
        throw Error({wanted.target}, "is there already, and its pictures would mix", "name a new folder");
    }
    return wanted;
}

void TurntableDialog::draw_counts() {
    for (const int count : {12, 36, 72, 120, 360}) {
        if (ImGui::Button(std::to_string(count).c_str())) TextForm::put(pictures_, std::to_string(count));
        tooltip(fmt::format("a picture every {}°", 360.0 / count));
        ImGui::SameLine();
    }
    ImGui::NewLine();
}

void TurntableDialog::draw_axes() {
    for (const auto& [name, axis] : settings::turn_axes) {
        if (ImGui::RadioButton(std::string(name).c_str(), axis_ == axis)) axis_ = axis;
        tooltip(meaning_of(axis));
        ImGui::SameLine();
    }
    ImGui::TextUnformatted("axis");
}

/// Draws buttons that give the target's name an extension, or take it away.
void TurntableDialog::draw_forms() {
    const std::filesystem::path target(target_.data());
    const std::filesystem::path stem =
        image::is_video(target) ? std::filesystem::path(target).replace_extension() : target;
    if (ImGui::Button("PNGs")) TextForm::put(target_, stem.string());
    tooltip("a folder with a PNG for each picture");
    for (const char* extension : {".mp4", ".webm"}) {
        ImGui::SameLine();
        if (ImGui::Button(extension)) TextForm::put(target_, stem.string() + extension);
        tooltip("a video, which the program ffmpeg encodes");
    }
}

std::optional<TurntableRequest> TurntableDialog::draw() {
    if (!is_open_) return std::nullopt;
    TextForm::begin_window("A full turn around the pivot", is_open_);
    bool is_entered = form_.field("pictures", pictures_, "of a full turn, 2 to 10000", true);
    draw_counts();
    draw_axes();
    is_entered |= form_.field("to", target_, "a new folder for PNGs, or a video: NAME.mp4 or NAME.webm");
    draw_forms();
    is_entered |= form_.field("rate", rate_, "of a video [pictures a second]");
    is_entered |= picture_.draw(form_, false);
    is_entered |=
        form_.end_window("write", "Enter does it, too; Esc closes this dialog, and later cancels the turn");
    return is_entered ? form_.taken([this] { return request(); }) : std::nullopt;
}

} // namespace sr::viewer
