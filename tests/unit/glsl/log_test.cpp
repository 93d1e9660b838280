#include "glsl/log.hpp"
#include "support/address.hpp"

using namespace sr;
using namespace sr::glsl;
using sr::testing::Test;

namespace {

/// Flat lines 1, 4 are main.frag:1, main.frag:3; flat lines 2, 3 are brdf.glsl:1, brdf.glsl:2.
Source example() {
    const Root roots[] = {
        Root::memory("s", {{"main.frag", "#version 410 core\n#include \"brdf.glsl\"\nvoid main() {}\n"},
                           {"brdf.glsl", "float f;\nfloat g = h;\n"}})};
    return expand(roots, "main.frag");
}

void expect_rewritten(const char* line, const char* rewritten) {
    EXPECT_EQ(rewrite_log(line, example()), std::string(rewritten) + "\n");
}

const Test mesa("unit.glsl.log.mesa", [] {
    expect_rewritten("0:3(11): error: `h' undeclared", "s/brdf.glsl:2:11: error: `h' undeclared");
    expect_rewritten("0:4(1): warning: `x' used uninitialized",
                     "s/main.frag:3:1: warning: `x' used uninitialized");
    expect_rewritten("0:2(3): preprocessor error: Unterminated #if",
                     "s/brdf.glsl:1:3: preprocessor error: Unterminated #if");
});

const Test nvidia("unit.glsl.log.nvidia", [] {
    expect_rewritten("0(3) : error C1503: undefined variable \"h\"",
                     "s/brdf.glsl:2: error: C1503: undefined variable \"h\"");
    expect_rewritten("0(4) : warning C7050: \"x\" might be used before being initialized",
                     "s/main.frag:3: warning: C7050: \"x\" might be used before being initialized");
    expect_rewritten("0(2) : fatal error C9999: out of registers",
                     "s/brdf.glsl:1: fatal error: C9999: out of registers");
});

const Test amd("unit.glsl.log.amd", [] {
    expect_rewritten("ERROR: 0:3: error(#143) Undeclared identifier: h",
                     "s/brdf.glsl:2: error: (#143) Undeclared identifier: h");
    expect_rewritten("WARNING: 0:4: warning(#402) Implicit truncation of vector",
                     "s/main.frag:3: warning: (#402) Implicit truncation of vector");
});

const Test apple("unit.glsl.log.apple", [] {
    expect_rewritten("ERROR: 0:3: Use of undeclared identifier 'h'",
                     "s/brdf.glsl:2: error: Use of undeclared identifier 'h'");
});

const Test intel_windows("unit.glsl.log.intel_windows", [] {
    expect_rewritten("ERROR: 0:3: 'h' : undeclared identifier ",
                     "s/brdf.glsl:2: error: 'h' : undeclared identifier ");
    expect_rewritten("ERROR: 0:4: 'errorneous' : syntax error",
                     "s/main.frag:3: error: 'errorneous' : syntax error");
});

const Test other_lines_are_kept("unit.glsl.log.other_lines_are_kept", [] {
    for (const char* line :
         {"Fragment shader failed to compile with the following errors:", "",
          "ERROR: 1 compilation errors.  No code generated.", "1:3(11): error: not our string",
          "error: vertex shader output `x' is not declared", "0:99999999999999999999: ?"})
        EXPECT_EQ(rewrite_log(std::string(line) + "\n", example()), std::string(line) + "\n");
});

const Test whole_log("unit.glsl.log.whole_log", [] {
    EXPECT_EQ(rewrite_log("head\r\n0:3(11): error: a\n0:4(1): error: b", example()),
              "head\ns/brdf.glsl:2:11: error: a\ns/main.frag:3:1: error: b\n");
    EXPECT_EQ(rewrite_log("", example()), "");
    expect_rewritten("0:0(0): error: no main", "s/main.frag: error: no main");
    expect_rewritten("0:77(1): error: unexpected end of file",
                     "s/main.frag:3:1: error: unexpected end of file");
});

const Test first_error_skips_warnings("unit.glsl.log.first_error_skips_warnings", [] {
    const auto found =
        first_error("0:2(1): warning: w\n0:3(11): error: `h' undeclared\n0:4(1): error: x\n", example());
    ASSERT_TRUE(found.has_value());
    EXPECT_EQ(found->where.text(), "s/brdf.glsl:2:11");
    EXPECT_EQ(found->text, "`h' undeclared");
    EXPECT_FALSE(first_error("0:2(1): warning: w\nlinking failed\n", example()).has_value());
});

} // namespace
