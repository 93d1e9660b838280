// Loops whose tests move behind their bodies.
#include "glsl/loops.hpp"
#include "support/address.hpp"

#include <algorithm>
#include <string>
#include <vector>

using namespace sr;
using sr::glsl::invert_loops;
using sr::testing::Test;

namespace {

/// A function with this body.
std::string function(const std::string& body) { return "void f(int n) {" + body + "}\n"; }

std::string inverted(const std::string& body) {
    const std::string text = invert_loops(function(body));
    const std::string before = "void f(int n) {";
    EXPECT_TRUE(text.starts_with(before) && text.ends_with("}\n")) << text;
    return text.substr(before.size(), text.size() - before.size() - 2);
}

const Test forms("unit.glsl.loops.the_test_follows_the_body", [] {
    EXPECT_EQ(inverted("for (int i = 0; i < n; ++i) { g(i); }"),
              "{ int i = 0; if (i < n) do  { g(i); } while ((++i, i < n)); }");
    EXPECT_EQ(inverted("while (a && b) c();"), "{ ; if (a && b) do  c(); while ((a && b)); }");
    EXPECT_EQ(inverted("for (;;) { if (a) break; }"),
              "{ ; if (true) do  { if (a) break; } while ((true)); }");
    EXPECT_EQ(inverted("for (int k = 0; k < n;) k = next(k);"),
              "{ int k = 0; if (k < n) do  k = next(k); while ((k < n)); }");
});

const Test nested("unit.glsl.loops.nested_loops_and_conditions_keep_their_order", [] {
    EXPECT_EQ(inverted("for (a; b; c) for (d; e; f) g();h();"),
              "{ a; if (b) do  { d; if (e) do  g(); while ((f, e)); } while ((c, b)); }h();");
    EXPECT_EQ(inverted("if (a) while (b) c(); else while (d) e();"),
              "if (a) { ; if (b) do  c(); while ((b)); } else { ; if (d) do  e(); while ((d)); }");
    EXPECT_EQ(inverted("while (a) if (b) { c(); } else d();while (e) f();"),
              "{ ; if (a) do  if (b) { c(); } else d(); while ((a)); }{ ; if (e) do  f(); while ((e)); }");
    EXPECT_EQ(inverted("switch (n) { case 0: while (a) b(); break; default: c(); }"),
              "switch (n) { case 0: { ; if (a) do  b(); while ((a)); } break; default: c(); }");
});

const Test kept("unit.glsl.loops.others_stay_as_they_are", [] {
    for (const std::string body :
         {"for (int i = 0; i < 3; ++i) g(i);", "for (int i = 0; i <= most; ++i) { g(i); }",
          "do { g(); } while (a);", "int a = 1; // for (;;) x();\n",
          "for (int i = 0; i < n; ++i)\n#if A\n g();\n#endif\n", "for (int i = 0) g();"}) {
        const std::string text = "const int most = 4;\n" + function(body);
        EXPECT_EQ(invert_loops(text), text);
    }
});

// Errors of drivers name lines.
const Test lines("unit.glsl.loops.every_line_stays_where_it_is", [] {
    const std::string text =
        function("\nfor (int i = 0; // first\n     i < n;  /* last\n */ ++i)\n{\n  g(i);\n}\nh();\n");
    const std::string changed = invert_loops(text);
    const auto line_of = [](const std::string& in, const std::string& word) {
        return std::count(in.begin(), in.begin() + static_cast<std::ptrdiff_t>(in.find(word)), '\n');
    };
    EXPECT_NE(changed, text);
    EXPECT_EQ(changed.find("first"), changed.npos) << "a comment would hide what follows on its line";
    for (const std::string word : {"g(i)", "h()"}) EXPECT_EQ(line_of(changed, word), line_of(text, word));
});

} // namespace
