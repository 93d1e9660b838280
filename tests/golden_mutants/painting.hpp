#pragma once
// Recipes that change a few pixels of an image.
#include "golden_mutants/change.hpp"
#include "golden_mutants/recipes.hpp"

namespace sr::testing {

inline constexpr float code = 1.0f / 255.0f; // of 8 bits

inline Recipe wrong_image(Base base, const char* name, const Change& change) {
    return {base, name, false, [change](Mutant& m) { change(m.test); }};
}

inline Recipe right_image(Base base, const char* name, const Change& change) {
    return {base, name, true, [change](Mutant& m) { change(m.test); }, ""};
}

/// A change of both images, and one of the test.
inline Recipe wrong_beside(Base base, const char* name, const Change& both, const Change& change) {
    return {base, name, false, [=](Mutant& m) {
                both(m.reference);
                both(m.test);
                change(m.test);
            }};
}

inline Extent extent(const image::Image& image) { return {image.width, image.height}; }

/// `f(colours, x, y)` of a rectangle in pixels.
template<typename Function>
void in_rectangle(image::Image& image, int left, int top, int width, int height, const Function& f) {
    for (int y = std::max(top, 0); y < std::min(top + height, image.height); ++y)
        for (int x = std::max(left, 0); x < std::min(left + width, image.width); ++x)
            f(image.at(x, y).first(3), x, y);
}

inline void paint(image::Image& image, int left, int top, int width, int height, float value) {
    in_rectangle(image, left, top, width, height, [=](auto p, int, int) { std::ranges::fill(p, value); });
}

inline void add_to(image::Image& image, int left, int top, int width, int height, float value) {
    in_rectangle(image, left, top, width, height, [=](auto p, int, int) {
        for (float& v : p) v += value;
    });
}

inline int at_share(int edge, float share) { return static_cast<int>(share * static_cast<float>(edge)); }

} // namespace sr::testing
