#include "viewer/panels/kept_pictures.hpp"

#include "viewer/ui.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <imgui.h>

namespace sr::viewer {
namespace {

/// A row's two buttons: what is shown, and what it is compared with.
bool choose(const char* id, bool is_chosen, const char* meaning) {
    const bool is_clicked = ImGui::RadioButton(id, is_chosen);
    tooltip(meaning);
    return is_clicked && !is_chosen;
}

std::string metric_text(double value) {
    return std::isnan(value) ? std::string("-") : fmt::format("{:.4g}", value);
}

} // namespace

KeptPicturesOutcome KeptPicturesList::draw(KeptPictures& pictures) {
    KeptPicturesOutcome outcome;
    std::optional<std::size_t> removed;
    if (!ImGui::BeginTable("kept pictures", 4, ImGuiTableFlags_SizingFixedFit)) return outcome;
    draw_table_heads(std::array<std::pair<std::string, const char*>, 4>{
        {{"show", "the picture that is seen, at the left of a wipe"},
         {"with", "the reference: the picture that it is compared with"},
         {"picture", "its letter and name; a click types another name"},
         {"", "removes the picture"}}});
    ImGui::TableNextRow();
    ImGui::TableNextColumn();
    if (choose("##render", !pictures.shown_index(), "show the render")) {
        pictures.show(std::nullopt);
        outcome.has_changed = true;
    }
    ImGui::TableSetColumnIndex(2);
    ImGui::TextUnformatted("the render");
    for (std::size_t i = 0; i < pictures.all().size(); ++i) {
        const auto& [letter, picture] = pictures.all()[i];
        ImGui::PushID(letter);
        ImGui::TableNextRow();
        ImGui::TableNextColumn();
        if (choose("##show", pictures.shown_index() == i, "show this picture in place of the render")) {
            pictures.show(i);
            outcome.has_changed = true;
        }
        ImGui::TableNextColumn();
        if (choose("##with", pictures.reference_index() == i, "compare with this picture")) {
            pictures.compare_with(i);
            outcome.has_changed = true;
        }
        ImGui::TableNextColumn();
        if (named_ == i) {
            ImGui::SetNextItemWidth(10.0f * ImGui::GetFontSize());
            if (ImGui::InputText("##name", name_.data(), name_.size(), ImGuiInputTextFlags_EnterReturnsTrue)
                && name_[0] != '\0') {
                pictures.rename(i, name_.data());
                named_.reset();
            }
            tooltip("the name of this picture; Enter takes it");
            if (ImGui::IsItemDeactivated()) named_.reset();
            if (named_ && !ImGui::IsAnyItemActive()) ImGui::SetKeyboardFocusHere(-1);
        } else {
            if (ImGui::Selectable(fmt::format("{}: {}", letter, picture.name()).c_str(), false,
                                  ImGuiSelectableFlags_None, {10.0f * ImGui::GetFontSize(), 0.0f})) {
                named_ = i;
                name_.fill('\0');
                std::copy_n(picture.name().begin(), std::min(picture.name().size(), name_.size() - 1),
                            name_.begin());
                outcome.has_changed = true;
            }
            tooltip(fmt::format("{}: {}, {}x{}{}. A click types another name.", letter, picture.name(),
                                picture.film().width, picture.film().height,
                                picture.camera().empty() ? "" : ", camera " + picture.camera()));
        }
        ImGui::TableNextColumn();
        if (ImGui::SmallButton("x")) removed = i;
        tooltip("remove this picture");
        ImGui::PopID();
    }
    ImGui::EndTable();
    if (removed) {
        pictures.remove(*removed);
        named_.reset();
        outcome.has_changed = true;
    }
    outcome.measures = ImGui::Button("measure");
    tooltip("the errors between the two pictures, as `steradian compare` has them");
    return outcome;
}

void draw_metrics(const compare::Metrics& metrics, const std::string& what, const std::string& unit) {
    struct Row {
        const char* name;
        std::string value;
        const char* meaning;
    };
    const std::array rows{
        Row{"RMSE", metric_text(metrics.rmse) + " " + unit, "root of the mean square of the differences"},
        Row{"relMSE", metric_text(metrics.rel_mse),
            "mean square of the differences, each over its reference"},
        Row{"mean |difference|", metric_text(metrics.mean_abs) + " " + unit, "over pixels and channels"},
        Row{"max |difference|", metric_text(metrics.max_abs) + " " + unit, "the largest one of a channel"},
        Row{"energy R, G, B",
            fmt::format("{} {} {}", metric_text(metrics.energy_ratio[0]),
                        metric_text(metrics.energy_ratio[1]), metric_text(metrics.energy_ratio[2])),
            "sum of the picture over the sum of its reference; 1: as bright"},
        Row{"FLIP", metric_text(metrics.flip),
            "mean, of what a screen shows: 0 is equal, 1 is black and white"},
        Row{"HDR-FLIP", metric_text(metrics.hdr_flip), "mean, over all exposures"},
        Row{"SSIM", metric_text(metrics.ssim), "structural similarity of what a screen shows; 1 is equal"}};
    ImGui::TextWrapped("%s", what.c_str());
    for (const Row& row : rows) {
        ImGui::TextUnformatted(with_superscripts(fmt::format("{}: {}", row.name, row.value)).c_str());
        tooltip(row.meaning);
    }
}

} // namespace sr::viewer
