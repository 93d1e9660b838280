#pragma once
// A test is an address and a body:
//
//     const Test furnace("law.brdf.ggx.furnace", [] { EXPECT_LE(albedo, 1.0f); });
//
// The address is the test's full name in GoogleTest and in CTest; its first word is its kind and its CTest
// label.
#include <gtest/gtest.h>
#include <source_location>
#include <string_view>

namespace sr::testing {

class Test {
public:
    using Body = void (*)();
    Test(std::string_view address, Body body, std::source_location here = std::source_location::current());
};

} // namespace sr::testing
