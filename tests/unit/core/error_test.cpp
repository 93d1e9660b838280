#include "core/error.hpp"
#include "support/address.hpp"

using namespace sr;
using sr::testing::Test;

namespace {

const Test one_line("unit.core.error.one_line", [] {
    EXPECT_STREQ(Error({"a.gltf", 3, 7}, "unexpected '}'", "add the missing value").what(),
                 "a.gltf:3:7: unexpected '}': add the missing value");
    EXPECT_STREQ(Error({"a.gltf"}, "no such file", "check the path").what(),
                 "a.gltf: no such file: check the path");
    EXPECT_STREQ(Error("no OpenGL driver", "install libgl1-mesa-dri").what(),
                 "no OpenGL driver: install libgl1-mesa-dri");
});

const Test a_bug_aborts("unit.core.error.a_bug_aborts", [] {
    EXPECT_DEATH(require(false, "two is one"), "error_test.cpp:[0-9]+: two is one: this is a bug");
});

} // namespace
