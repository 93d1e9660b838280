#include "core/json.hpp"
#include "core/text.hpp"
#include "support/address.hpp"

using namespace sr;
using sr::testing::Test;

namespace {

const Test controls("unit.core.text.controls_are_shown", [] {
    EXPECT_EQ(shown("plain, größer, 光"), "plain, größer, 光");
    EXPECT_EQ(shown("a\nb\r\tc"), "a\\nb\\r\\tc");
    EXPECT_EQ(shown("\x1b[31m\x07\x7f"), "\\x1b[31m\\x07\\x7f");
    EXPECT_EQ(shown("\xc2\x9b"), "\\u009b");                          // CSI as one code point
    EXPECT_EQ(shown("\xe2\x80\xae!\xe2\x81\xa6"), "\\u202e!\\u2066"); // turns the text around
    EXPECT_EQ(shown("\xe2\x80\xa8"), "\\u2028");
    EXPECT_EQ(shown(std::string_view("\0", 1)), "\\x00");
});

const Test breaks("unit.core.text.line_breaks_are_one_kind",
                  [] { EXPECT_EQ(with_plain_breaks("a\r\nb\rc\n\rd\r"), "a\nb\nc\n\nd\n"); });

const Test invalid("unit.core.text.bytes_that_are_not_utf8_are_shown", [] {
    EXPECT_EQ(shown("\xff"), "\\xff");
    EXPECT_EQ(shown("\xc3"), "\\xc3");                   // cut short
    EXPECT_EQ(shown("\xc0\xaf"), "\\xc0\\xaf");          // longer than needed
    EXPECT_EQ(shown("\xed\xa0\x80"), "\\xed\\xa0\\x80"); // a surrogate
    EXPECT_EQ(shown("\x9b"), "\\x9b");                   // CSI in Latin-1
});

const Test lines("unit.core.text.lines_and_json_keep_their_breaks", [] {
    EXPECT_EQ(shown_lines("a\n\tb\x1b"), "a\n\tb\\x1b");
    EXPECT_EQ(shown_json("{\n \"a\": \"\xc2\x9b\x7f\"\n}"), "{\n \"a\": \"\\u009b\\u007f\"\n}");
});

const Test cut("unit.core.text.a_cut_keeps_characters_whole", [] {
    EXPECT_EQ(shorten("abc", 3), "abc");
    EXPECT_EQ(shorten("abcd", 3), "abc…");
    EXPECT_EQ(shorten("ab\xc3\xb6", 3), "ab…");
});

const Test line("unit.core.text.messages_of_libraries_are_one_line", [] {
    EXPECT_EQ(sr::one_line("it failed.\nhere.\n"), "it failed. here");
    EXPECT_EQ(sr::one_line(".\n"), "no reason given");
});

const Test extent("unit.core.json_scan.extent", [] {
    const JsonExtent found = json_extent(R"({"a": [1, 2, {"b": "[[[,,,\"{"}]})");
    EXPECT_EQ(found.depth, 3);
    EXPECT_GE(found.values, 5u);
    EXPECT_LE(found.values, 6u);
    EXPECT_LT(json_extent("]]]]").depth, 1);
});

const Test overflow("unit.core.json_scan.overflowing_number", [] {
    EXPECT_EQ(overflowing_number(R"({"1e999": [1, 2e3, -1e400]})"), std::optional<std::size_t>(19));
    EXPECT_EQ(overflowing_number(R"([1e308, "1e999"])"), std::nullopt);
});

} // namespace
