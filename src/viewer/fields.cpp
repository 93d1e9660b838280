#include "viewer/fields.hpp"

#include "core/error.hpp"

#include <algorithm>
#include <array>
#include <cstdio>
#include <imgui.h>
#include <imgui_internal.h>

namespace sr::viewer {
namespace {

std::string printed(const std::string& format, float value) {
    std::array<char, 64> text{};
    std::snprintf(text.data(), text.size(), format.c_str(), static_cast<double>(value));
    return text.data();
}

/// Width of each of `count` fields beside one another in `width`.
float part_of_width(float width, std::size_t count) {
    const float gaps = static_cast<float>(count - 1) * ImGui::GetStyle().ItemInnerSpacing.x;
    return std::floor((width - gaps) / static_cast<float>(count));
}

/// The text that takes as much room as `count` fields, each as wide as the widest of these numbers.
float room_of(const std::string& format, std::span<const float> values) {
    float widest = 0.0f;
    for (const float value : values) widest = std::max(widest, field_width_of(printed(format, value)));
    const auto count = static_cast<float>(values.size());
    return count * widest + (count - 1.0f) * ImGui::GetStyle().ItemInnerSpacing.x;
}

/// Places the next field in the room that it needs [pixels]. @return its label
std::string place_field(const std::string& label, float needed) {
    const std::string shown = label.substr(0, label.find("##"));
    const ImGuiID id = ImGui::GetID(label.c_str());
    ImGuiStorage& storage = *ImGui::GetStateStorage();
    const float label_width = ImGui::CalcTextSize(shown.c_str()).x + ImGui::GetStyle().ItemInnerSpacing.x;
    const float beside = std::min(ImGui::CalcItemWidth(), ImGui::GetContentRegionAvail().x - label_width);
    if (!ImGui::IsAnyItemActive()) storage.SetBool(id, needed > beside);
    if (shown.empty()) return label;
    if (!storage.GetBool(id)) {
        ImGui::SetNextItemWidth(beside);
        return label;
    }
    ImGui::TextUnformatted(shown.c_str());
    ImGui::SetNextItemWidth(ImGui::GetContentRegionAvail().x);
    return "##" + label;
}

} // namespace

float field_width_of(const std::string& text) {
    return ImGui::CalcTextSize(text.c_str()).x + 2.0f * ImGui::GetStyle().FramePadding.x;
}

std::string fitting_format(const std::string& format, std::span<const float> values,
                           const std::function<bool(const std::string& text)>& fits) {
    const auto point = format.find('.', format.find('%'));
    const bool has_point = point < format.size();
    const char fewest = has_point && format.find('g', point) < format.size() ? '2' : '0';
    for (std::string shorter = format;; --shorter[point + 1]) {
        if (std::ranges::all_of(values, [&](float value) { return fits(printed(shorter, value)); }))
            return shorter;
        if (!has_point || shorter[point + 1] <= fewest) return "#";
    }
}

std::string make_room(const std::string& label, const std::string& text, float taken) {
    return place_field(label, field_width_of(text) + taken);
}

bool number_field(const std::string& label, std::span<float> values, const NumberRange& range,
                  std::optional<float> speed) {
    const std::string placed = place_field(label, room_of(range.format, values));
    const float width = part_of_width(ImGui::CalcItemWidth(), values.size());
    const std::string format = fitting_format(
        range.format, values, [width](const std::string& text) { return field_width_of(text) <= width; });
    const int flags = (range.is_clamped && range.min < range.max ? ImGuiSliderFlags_AlwaysClamp : 0)
                      | (range.is_logarithmic ? ImGuiSliderFlags_Logarithmic : 0)
                      | (format == range.format ? 0 : ImGuiSliderFlags_NoRoundToFormat);
    const auto count = static_cast<int>(values.size());
    if (!speed)
        return ImGui::SliderScalarN(placed.c_str(), ImGuiDataType_Float, values.data(), count, &range.min,
                                    &range.max, format.c_str(), flags);
    return ImGui::DragScalarN(placed.c_str(), ImGuiDataType_Float, values.data(), count, *speed, &range.min,
                              &range.max, format.c_str(), flags);
}

bool number_field(const std::string& label, float& value, const NumberRange& range,
                  std::optional<float> speed) {
    return number_field(label, std::span(&value, 1), range, speed);
}

bool number_field(const std::string& label, vec3& values, const NumberRange& range,
                  std::optional<float> speed) {
    return number_field(label, std::span(&values.x, 3), range, speed);
}

bool color_field(const std::string& label, std::span<float> values, bool has_swatch) {
    require(values.size() == 3 || values.size() == 4, "a colour has three or four numbers");
    const float swatch = has_swatch ? ImGui::GetFrameHeight() + ImGui::GetStyle().ItemInnerSpacing.x : 0.0f;
    const std::string placed = place_field(label, room_of("%.3f", values) + swatch);
    const int flags = ImGuiColorEditFlags_Float | (has_swatch ? 0 : ImGuiColorEditFlags_NoSmallPreview);
    return values.size() == 4 ? ImGui::ColorEdit4(placed.c_str(), values.data(), flags)
                              : ImGui::ColorEdit3(placed.c_str(), values.data(), flags);
}

} // namespace sr::viewer
