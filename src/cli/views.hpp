#pragma once
// One term of the equation instead of the sum: `render --view`.
#include "image/image.hpp"

#include <span>
#include <string>

namespace sr::cli {

/// What a view's numbers are, and so how a screen shows them.
enum class ViewKind {
    light,     // as the film: exposure and tone curve
    share,     // 0 to 1, black to white
    leak,      // 0 to 1: what leaks in red, what is kept out in blue
    luminance, // [cd/m²], in false colours
};

struct View {
    const char* name;
    const char* shader;
    const char* what;
    ViewKind kind;
    const char* unit; // null: the film's
    bool is_quotient; // the shader's red over its green; of leaks red and green over blue
    float without;    // what stands on a surface where the quotient has no divisor
};

std::span<const View> all_views();
const View* view_named(const std::string& name); // null if there is none

/// The numbers of the view from the film of its shader, in R, G and B; A stays.
image::Image numbers_of(const View& view, const image::Image& film);

/// For an 8-bit file, from the view's numbers. Not for ViewKind::light.
image::Image colors_of(const View& view, const image::Image& numbers);

} // namespace sr::cli
