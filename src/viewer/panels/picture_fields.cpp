#include "viewer/panels/picture_fields.hpp"

#include "core/error.hpp"
#include "render/adaptive/convergence.hpp"

#include <array>
#include <cmath>
#include <fmt/format.h>
#include <imgui.h>
#include <string>
#include <utility>

namespace sr::viewer {

void PictureFields::show(const PictureRequest& proposed, settings::Size window) {
    window_ = window;
    TextForm::put(size_, settings::text_of(proposed.size));
    TextForm::put(samples_, std::to_string(proposed.samples));
    TextForm::put(error_, proposed.error ? settings::percentage_text(*proposed.error) : "");
}

PictureRequest PictureFields::request() const {
    PictureRequest wanted;
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
    return wanted;
}

/// Draws buttons of common sizes.
void PictureFields::draw_sizes() {
    const std::array<std::pair<const char*, settings::Size>, 4> sizes{
        {{"window", window_},
         {"2 x window", {2 * window_.width, 2 * window_.height}},
         {"1920x1080", {1920, 1080}},
         {"3840x2160", {3840, 2160}}}};
    for (const auto& [name, size] : sizes) {
        if (ImGui::Button(name)) TextForm::put(size_, settings::text_of(size));
        tooltip(fmt::format("a picture of {} pixels", settings::text_of(size)));
        ImGui::SameLine();
    }
    ImGui::NewLine();
}

bool PictureFields::draw(TextForm& form, bool is_first) {
    bool is_entered = form.field("size", size_,
                                 "width x height [pixels]; the shape may differ from the window's", is_first);
    draw_sizes();
    is_entered |= form.field("samples", samples_, "of a pixel, at most: 1 to 65536");
    is_entered |=
        form.field("error", error_, "at which it stops earlier, as in 0.5%; empty: after all samples");
    return is_entered;
}

} // namespace sr::viewer
