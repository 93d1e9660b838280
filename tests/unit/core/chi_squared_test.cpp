#include "core/math.hpp"
#include "support/address.hpp"

#include <cmath>

using namespace sr;
using sr::testing::Test;

namespace {

const Test by_hand("unit.core.chi_squared.by_hand", [] {
    // (110 - 100)² / 100 + (90 - 100)² / 100 = 2, of one degree of freedom: mean 1, variance 2.
    EXPECT_DOUBLE_EQ(chi_squared_excess({100.0, 100.0}, {110.0, 90.0}).value(), 1.0 / std::sqrt(2.0));
    // Three cells that expect few are one, of 12 expected and 12 counted.
    EXPECT_DOUBLE_EQ(chi_squared_excess({100.0, 4.0, 4.0, 4.0}, {110.0, 12.0, 0.0, 0.0}).value(), 0.0);
    // Samples where none are expected count, once they are many.
    EXPECT_GT(chi_squared_excess({100.0, 100.0, 0.0}, {100.0, 100.0, 60.0}).value(), 100.0);
    EXPECT_FALSE(chi_squared_excess({100.0, 5.0}, {100.0, 5.0}).has_value());
});

} // namespace
