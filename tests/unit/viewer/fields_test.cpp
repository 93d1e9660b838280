// Fields of numbers: the digits that fit.
#include "viewer/fields.hpp"

#include "support/address.hpp"

#include <array>

using namespace sr;
using namespace sr::viewer;
using sr::testing::Test;

namespace {

std::string in_characters(const std::string& format, std::span<const float> values, std::size_t count) {
    return fitting_format(format, values, [count](const std::string& text) { return text.size() <= count; });
}

const Test digits("unit.viewer.fields.a_number_has_as_many_digits_as_fit_and_none_is_cut", [] {
    const std::array radiance{31074.2f, 3107.0f, 0.0f};
    EXPECT_EQ(in_characters("%.4g", radiance, 9), "%.4g");
    EXPECT_EQ(in_characters("%.4g", radiance, 8), "%.3g"); // 3.11e+04
    EXPECT_EQ(in_characters("%.4g", radiance, 7), "%.2g");
    EXPECT_EQ(in_characters("%.4g", radiance, 6), "#"); // 3.1e+04 has seven
    const std::array place{-12.3456f, 1.0f};
    EXPECT_EQ(in_characters("%.3f", place, 7), "%.3f");
    EXPECT_EQ(in_characters("%.3f", place, 3), "%.0f");
    EXPECT_EQ(in_characters("%.3f", place, 2), "#");
    EXPECT_EQ(in_characters("%.2f m", std::array{0.8f}, 5), "%.1f m"); // the unit stays
    EXPECT_EQ(in_characters("rest", std::array{0.8f}, 4), "rest");
});

} // namespace
