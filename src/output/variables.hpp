#pragma once
// The table of output variables: what a picture can hold besides radiance, for `--aov` and `--view`.
#include "image/colormap.hpp"
#include "image/image.hpp"
#include "scene/units.hpp"

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace sr::output {

/// Source of a variable's samples.
enum class SampleSource {
    picture, // the picture itself: no shader
    ids,     // the pixel's centre
    surface, // the surface without lights
    lights,  // points on the lights
};

/// How samples become values.
enum class Finish {
    rgb,       // red, green and blue
    quotient,  // red over green; `without` where green is 0
    leaks,     // red and green over blue
    luminance, // of red, green and blue
    depth,
    object,
    material,
    samples,
    error,
};

/// How a screen shows a view.
enum class Display {
    none,        // no view
    exposed,     // as radiance: exposure and tone curve
    share,       // 0 to 1, black to white
    leaks,       // light that leaks through is red, light that is kept out is blue
    false_color, // luminance [cd/m²] on the colour map
    count,       // numbers on the colour map, by count_decades
};

/// The range of Display::count, from 1/2, which none has, to 32: a doubling is a sixth of the colours.
inline constexpr image::Decades count_decades{-0.30103f, 1.50515f};

struct Variable {
    const char* name;
    const char* shader; // null: none
    const char* what;
    const char* unit;     // null: the film's
    const char* channels; // of the AOV, one letter or word each, separated by blanks; empty: no AOV
    SampleSource source;
    Finish finish;
    Display display;
    float without = 0.0f; // value of a surface where a quotient has no divisor
};

using Variables = std::vector<const Variable*>;

std::span<const Variable> all_variables();
const Variable* aov_named(std::string_view name);  // null if there is none
const Variable* view_named(std::string_view name); // null if there is none
std::vector<std::string> aov_names();

/// Returns "depth.Z" and so on, one for each channel of the AOV.
std::vector<std::string> channels_of(const Variable& variable);

/// Reads "depth,normal"; absent if a name is unknown or occurs twice.
std::optional<Variables> parse_aovs(const std::string& text);

/// Returns the unit of a view; of radiance if `view` is null.
std::string unit_of(const Variable* view, scene::UnitSystem units);

bool holds(const Variables& variables, Finish finish);

/// Returns a view's values in R, G and B from the film of its shader; A stays.
image::Image numbers_of(const Variable& view, const image::Image& film);

/// Returns a view's colours for an 8-bit file from its values. Not for Display::exposed.
image::Image colors_of(const Variable& view, const image::Image& numbers);

} // namespace sr::output
