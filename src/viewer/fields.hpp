#pragma once
// Fields of numbers whose texts fit: beside the label, below it, or with fewer digits.
#include "core/math.hpp"

#include <functional>
#include <optional>
#include <span>
#include <string>

namespace sr::viewer {

/// A number of printf's form with as many digits after the point, at most those of `format`, as let the texts
/// of all `values` fit; "#", which is no number, if none does.
std::string fitting_format(const std::string& format, std::span<const float> values,
                           const std::function<bool(const std::string& text)>& fits);

/// Width of a field that holds `text` [unit of the pointer].
float field_width_of(const std::string& text);

/// Makes room for the next field: beside its label if `text` fits there, else as wide as the panel and below
/// it. A field that is dragged or typed into stays where it is. `taken`: width of the field that is not for
/// text. @return the label to give the field
std::string make_room(const std::string& label, const std::string& text, float taken = 0.0f);

/// Range and appearance of a number.
struct NumberRange {
    float min = 0.0f, max = 0.0f; // equal: unlimited
    const char* format = "%.3f";
    bool is_clamped = true; // typed numbers, too
    bool is_logarithmic = false;
};

// Fields of one or more numbers. `speed`: of a drag, in a pixel; absent: a slider. @return true if one
// changed
bool number_field(const std::string& label, std::span<float> values, const NumberRange& range,
                  std::optional<float> speed = std::nullopt);
bool number_field(const std::string& label, float& value, const NumberRange& range,
                  std::optional<float> speed = std::nullopt);
bool number_field(const std::string& label, vec3& values, const NumberRange& range,
                  std::optional<float> speed = std::nullopt);

/// Field of a linear colour with numbers, the last of which is alpha if there are four.
bool color_field(const std::string& label, std::span<float> values, bool has_swatch = true);

} // namespace sr::viewer
