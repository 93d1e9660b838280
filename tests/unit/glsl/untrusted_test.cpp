#include "glsl/source.hpp"
#include "glsl/untrusted.hpp"
#include "support/address.hpp"
#include "support/models.hpp"

#include <algorithm>
#include <string>
#include <vector>

using namespace sr;
using namespace sr::glsl;
using sr::testing::Test;

namespace {

std::string repeated(const std::string& text, int count) {
    std::string result;
    for (int i = 0; i < count; ++i) result += text;
    return result;
}

/// Returns the gate's complaint about a text; empty if it passes.
std::string complaint(const std::string& text, const std::vector<std::string>& permitted = {}) {
    try {
        bounded(text, "a.glsl", permitted);
    } catch (const Error& error) {
        return error.what();
    }
    return {};
}

/// A chain of functions each of which calls the one before twice.
std::string doubling_functions(int count) {
    std::string text = "float f0(float x) { return x + 1.0; }\n";
    for (int i = 1; i < count; ++i)
        text += "float f" + std::to_string(i) + "(float x) { return f" + std::to_string(i - 1) + "(f"
                + std::to_string(i - 1) + "(x)); }\n";
    return text;
}

std::string doubling_macros(int count) {
    std::string text = "#define M0 1.0\n";
    for (int i = 1; i < count; ++i)
        text += "#define M" + std::to_string(i) + " (M" + std::to_string(i - 1) + " + M"
                + std::to_string(i - 1) + ")\n";
    return text + "float f() { return M" + std::to_string(count - 1) + "; }\n";
}

/// Macros of nothing, each of which has the one before twice.
std::string empty_macros(int count) {
    std::string text;
    for (int i = 1; i <= count; ++i)
        text += "#define E" + std::to_string(i) + " E" + std::to_string(i - 1) + " E" + std::to_string(i - 1)
                + "\n";
    return text;
}

std::string many_arrays(int count) {
    std::string text;
    for (int i = 0; i < count; ++i) text += "float a" + std::to_string(i) + "[100];\n";
    return text;
}

struct Refused {
    const char* name;
    std::string text;
    const char* words; // of the complaint
};

const std::vector<Refused> refused{
    {"version", "#version 450\n", "a.glsl:1: #version is not allowed"},
    {"extension", "float x;\n#extension GL_ARB_shader_image_load_store : enable\n", "a.glsl:2: #extension"},
    {"pragma", "# pragma optimize(off)\n", "#pragma"},
    {"line", "\n\n#line 7\n", "a.glsl:3: #line"},
    {"error", "#error x\n", "#error"},
    {"directive_behind_comment", "/* a */ #pragma x\n", "#pragma"},
    {"directive_over_two_lines", "#define A /*\n*/ for\nA\n", "for in a macro"},
    {"include_of_system_file", "#include \"/etc/passwd\"\n", "includes \"/etc/passwd\""},
    {"include_of_parent", "#include \"../secret.glsl\"\n", "includes \"../secret.glsl\""},
    {"include_of_other_type", "#include \"assignment.json\"\n", "includes \"assignment.json\""},
    {"include_in_angle_brackets", "#include <a.glsl>\n", "malformed #include"},
    {"include_behind_macro", "#define pi 3.0\n#include \"base/constants.glsl\"\n",
     "a.glsl:2: #include after #define"},
    {"token_pasting", "#define J(a, b) a##b\n", "# in a macro"},
    {"stringification", "#define S(a) #a\n", "# in a macro"},
    {"loop_in_macro", "#define EVER for(;;)\n", "for in a macro"},
    {"while_in_macro", "#define W while\n", "while in a macro"},
    {"return_in_macro", "#define R return\n", "return in a macro"},
    {"brace_in_macro", "#define B {\n", "{ in a macro"},
    {"bracket_in_macro", "#define C )\nfloat f() { return sin(1.0 C; }\n", "("},
    {"keyword_macro", "#define while if\n", "#define while"},
    {"undef_of_ours", "#undef pi\n", "#undef of what"},
    {"macro_bomb", doubling_macros(40), "100000 tokens"},
    {"parameter_bomb",
     "#define D(x) ((x)+(x))\nfloat f(float x) { return " + repeated("D(", 30) + "x" + repeated(")", 30)
         + "; }\n",
     "100000 tokens"},
    {"function_bomb", doubling_functions(40), "100000 tokens"},
    {"recursion", "float f(float x) {\n    return f(x);\n}\n", "a.glsl:2: f calls itself"},
    {"indirect_recursion",
     "float g(float x);\nfloat f(float x) { return g(x); }\nfloat g(float x) { return f(x); }\n",
     "calls itself"},
    {"recursion_by_macro", "#define CALL f(1.0)\nfloat f(float x) { return CALL; }\n", "calls itself"},
    {"recursion_by_alias", "#define g f\nfloat f(float x) { return g(x); }\n", "f calls itself"},
    {"recursion_by_parameter", "#define CALL(g) g(1.0)\nfloat f(float x) { return CALL(f); }\n",
     "f calls itself"},
    {"recursion_by_two_parameters", "#define J(a, b) a b\nfloat f(float x) { return J(f, (x)); }\n",
     "f calls itself"},
    {"recursion_by_defined_alias", "#define g f\nfloat g(float x) { return f(x); }\n", "f calls itself"},
    {"recursion_behind_condition", "#if 0\n#define f(x) (x)\n#endif\nfloat f(float x) { return f(x); }\n",
     "a.glsl:2: a #define that depends on a condition"},
    {"undef_behind_condition", "#define f(x) (x)\n#if 1\n#undef f\n#endif\n", "a #undef that depends"},
    {"define_behind_guard", "#define A 1\n#ifndef A\n#define f(x) (x)\n#endif\n", "depends on a condition"},
    {"define_behind_else", "#ifndef A\n#else\n#define f(x) (x)\n#endif\n", "depends on a condition"},
    {"alias_bomb",
     "#define D(x) ((x)+(x))\n#define G D\nfloat f(float x) { return " + repeated("G(", 30) + "x"
         + repeated(")", 30) + "; }\n",
     "100000 tokens"},
    {"bomb_of_nothing", "#define E0\n" + empty_macros(40) + "E40\nfloat x;\n", "100000 tokens"},
    {"bomb_in_condition", doubling_macros(40) + "#if M39 > 1\n#endif\n", "100000 tokens"},
    {"macro_in_itself", "#define A A + 1.0\nfloat x = A;\n", "the macro A is used within itself"},
    {"macro_without_arguments", "#define F(x) (x)\nfloat y = F;\n", "the macro F without its arguments"},
    {"many_parameters", "#define F(...) 1.0\nfloat y = F(1);\n", ". among the parameters"},
    {"deep_brackets_by_macros",
     "#define P(x) " + repeated("(", 30) + "x" + repeated(")", 30) + "\nfloat x = P(P(P(1.0)));\n",
     "deeper than 64"},
    {"long_statement_by_macros", doubling_macros(12), "more than 2000 words"},
    {"output_by_macro", "#define O out\nO vec4 color;\n", "out outside a function's parameters"},
    {"built_in", "float max(float a, float b) { return a; }\n", "a.glsl:1: max is a function of GLSL"},
    {"built_in_overload", "float dot(float a, vec2 b);\n", "dot is a function of GLSL"},
    {"built_in_of_arrays", "float[2] pow(float[2] a) { return a; }\n", "pow is a function of GLSL"},
    {"built_in_by_macro", "#define g max\nfloat g(float a, float b) { return a; }\n",
     "max is a function of GLSL"},
    {"built_in_type", "struct mix { float x; };\n", "mix is a function of GLSL"},
    {"built_in_variable", "const float x = 1.0; float sqrt;\n", "sqrt is a function of GLSL"},
    {"array_of_arrays", "void f() { float a[4096][4096]; }\n", "arrays of"},
    {"array_of_its_type", "void f() { float[4096] a[4096]; }\n", "arrays of"},
    {"many_arrays", "void f() { " + many_arrays(200) + "}\n", "arrays of"},
    {"arrays_on_a_line", "float a[4096], b[4096], c[4096], d[4096], e[4096];\n", "arrays of"},
    {"structs_in_structs", repeated("struct { ", 40) + "float x; " + repeated("} s; ", 40) + "\n",
     "a.glsl:1: a struct within a struct"},
    {"array_of_structs", "struct S { mat4 a[64]; };\nS s[64];\n", "arrays of"},
    {"array_behind_a_struct", "struct { mat4 a; } s[2048];\n", "arrays of"},
    {"array_of_a_product", "const int n = 4096;\nfloat a[n * n];\n", "neither a number nor a constant"},
    {"array_of_a_computed_constant", "const int n = 4096 * 4096;\nfloat a[n];\n",
     "neither a number nor a constant"},
    {"array_of_the_second_constant", "const int m = 4, n = 1000000;\nfloat a[n];\n", "arrays of"},
    {"array_size_by_macro", "#define N 100000000\nfloat a[N];\n", "above 4096"},
    {"arrays_by_calls",
     "float f() { float a[1024]; return a[1]; }\nfloat g() { return " + repeated("f() + ", 20) + "1.0; }\n",
     "arrays of"},
    {"image_store", "void f() { imageStore(i, ivec2(0), vec4(1.0)); }\n", "imageStore is not allowed"},
    {"image", "image2D i;\n", "image2D is not allowed"},
    {"unsigned_image", "uimageBuffer i;\n", "uimageBuffer is not allowed"},
    {"buffer", "buffer B { float x[]; };\n", "buffer is not allowed"},
    {"uniform", "uniform float x;\n", "uniform is not allowed"},
    {"layout", "layout(location = 0) in vec3 x;\n", "layout is not allowed"},
    {"atomic", "void f() { atomicAdd(x, 1); }\n", "atomicAdd is not allowed"},
    {"output", "out vec4 color;\n", "out outside a function's parameters"},
    {"discard", "void f() { discard; }\n", "discard is not allowed"},
    {"depth", "void f() { gl_FragDepth = 0.0; }\n", "gl_FragDepth is not allowed"},
    {"main", "void main() {}\n", "main is not allowed"},
    {"our_counter", "void f() { steradian_turns = -1000000; }\n", "reserved"},
    {"reserved_name", "float a__b;\n", "reserved"},
    {"NUL", std::string("float x;\n\0float y;\n", 19), "a.glsl:2: a NUL byte"},
    {"escape_in_code", "float \x1b;\n", "outside a comment"},
    {"overlong", "// \xc0\xaf\n", "is not UTF-8"},
    {"lone_byte", "float x; // \xff\n", "is not UTF-8"},
    {"letters_in_code", "float α;\n", "'α' outside a comment"},
    {"continued_comment", "// a \\\nwhile (true);\n", "a line ends in \\"},
    {"continued_line", "#define A \\\n for\n", "a line ends in \\"},
    {"text", "float x = \"a\";\n", "outside a comment"},
    {"text_in_macro", "#define S(a, b) b\n#define L S(\",for(;;){}\",)\n", "a.glsl:2: text in quotes"},
    {"second_definition", "#define A 1.0\n#undef A\n#define A 2.0\n", "a.glsl:3: a second #define A"},
    {"continued_end", "float x;\n// \\", "a line ends in \\"},
    {"open_comment", "float x; /* \n", "never ends"},
    {"lone_closing_brace", "}\nvoid g() {\n", "} has no partner"},
    {"wrong_partner", "void f() { (]; }\n", "( has no partner"},
    {"branches_of_brackets", "#if 1\nvoid f() {\n#else\nvoid f() { {\n#endif\n}\n", "other brackets"},
    {"directive_in_brackets", "void f() { for (int i = 0;\n#if 1\ntrue; ) ; }\n#endif\n", "inside brackets"},
    {"deep_brackets", "float x = " + repeated("(", 100) + "1.0" + repeated(")", 100) + ";\n",
     "deeper than 64"},
    {"long_statement", "float x = 1.0" + repeated("\n+ 1.0", 3000) + ";\n", "more than 2000 words"},
    {"many_signs",
     "float x = " + repeated("- ", 900) + "\n" + repeated("! ", 900) + "\n" + repeated("~ ", 900) + "1.0;\n",
     "more than 2000 words"},
    {"many_branches",
     "void f(float x) {\nif (x > 0.0) x = 1.0;\n" + repeated("else if (x > 1.0) x = 2.0;\n", 600) + "}\n",
     "branches"},
    {"large_array", "float x[100000000];\n", "above 4096"},
    {"large_array_in_e_notation", "float x[1e9];\n", "above 4096"},
    {"long_word", "float " + std::string(1000, 'a') + ";\n", "a word of 1000 letters"},
    {"long_line", "//" + std::string(3000, ' ') + "\n", "a line of 3002 bytes"},
    {"many_lines", std::string(6000, '\n'), "lines"},
    {"large_file", repeated(std::string(1000, ' ') + "\n", 1000), "larger than 256 KiB"},
    {"declared_condition", "void f() { while (bool b = true) { } }\n", "declared in a loop's condition"},
    {"hidden_header", "#define ID(x) x\nvoid f() { for (ID(int i = 0; true;) ) { } }\n",
     "for without its two ;"},
    {"hidden_bracket", "#define ID(x) x\nvoid f() { ID(while) (true) { } }\n", "while without ("},
    {"loop_as_argument", "#define M(x) x(;;)\n", "; in a macro"},
};

const Test refusals("unit.glsl.untrusted.refuses", [] {
    for (const Refused& r : refused) {
        SCOPED_TRACE(r.name);
        const std::string found = complaint(r.text);
        EXPECT_NE(found.find(r.words), std::string::npos) << (found.empty() ? "it passes" : found);
        EXPECT_EQ(std::ranges::count(found, '\n'), 0);
        EXPECT_TRUE(found.starts_with("a.glsl:")) << found;
    }
});

const Test passes("unit.glsl.untrusted.passes", [] {
    for (const std::string text :
         {"",
          "#include \"base/constants.glsl\"\n#define TWO_PI (2.0 * pi)\n#define saturate(x) clamp(x, 0.0, "
          "1.0)\n"
          "float f(float x) { return TWO_PI * saturate(saturate(x)); } // π α² \\int\n",
          "float f(float x) { return x; }\nvec3 f(vec3 v) { return vec3(f(v.x), f(v.y), f(v.z)); }\n",
          "#ifdef A\nfloat f() { return 1.0; }\n#else\nfloat f() { return 2.0; }\n#endif\n",
          "void f(in float x, inout vec3 y, out float z) { z = x + y.x; }\n",
          "#ifndef MINE\n#define MINE\n#define N 4\nconst int m = 8;\nfloat f(float a[N]) { float max = "
          "a[0], b[m]; b[1] = "
          "a[N - 1]; return max * b[1]; }\nfloat g() { return f(float[](1.0, 2.0, 3.0, 4.0)); }\n#endif\n",
          "#define sq(x) ((x) * (x))\n#if defined(sq) && 1\nconst float a = "
          "sqrt(sq(sq(2.0)));\n#endif\n#undef sq\nfloat "
          "sq(float x) { return x * x; }\nstruct S { vec3 n, t; float a[3]; };\nS f(in S s) { S r = s; "
          "return r; }\n",
          "const float table[3] = float[](1.0, 2.0, .5e-3);\nstruct A { float x; };\nfloat imagery, atomics, "
          "images;\n",
          "float f() { return gl_FragCoord.x; }"})
        EXPECT_EQ(complaint(text), "") << text;
    EXPECT_EQ(complaint("void f() { discard; }\n", {"discard"}), "");
});

const Test bounds("unit.glsl.untrusted.bounds_every_loop", [] {
    const Bounded found = bounded("void f() {\n"
                                  "    for (int i = 0; i < 3, true; ++i) while (a || b) { }\n"
                                  "    do { } while (x); /* for (;;) */\n"
                                  "    for (;;) break;\n"
                                  "}\n#define N 3",
                                  "a.glsl");
    ASSERT_EQ(found.loops.size(), 4u);
    std::vector<int> n;
    for (const Loop& loop : found.loops) n.push_back(loop.number);
    const auto turn = [&](std::size_t i) { return " steradian_turn(" + std::to_string(n[i]) + ")"; };
    EXPECT_EQ(found.text, "void f() {\n"
                          "    for (int i = 0;  steradian_turn("
                              + std::to_string(n[0]) + ") && (i < 3, true); ++i) while (" + turn(1)
                              + " && (a || b)) { }\n"
                                "    do { } while ("
                              + turn(2)
                              + " && (x)); /* for (;;) */\n"
                                "    for (;"
                              + turn(3)
                              + ";) break;\n"
                                "}\n#define N 3\n#undef N\n");
    std::ranges::sort(n);
    EXPECT_EQ(std::ranges::unique(n).size(), 0u) << "each loop has a number of its own";
    EXPECT_GT(n.front(), 0);
    EXPECT_LT(n.back(), 1 << 20);
    EXPECT_EQ(found.loops[2].where.text(), "a.glsl:3");
});

const Test expanded_lines("unit.glsl.untrusted.keeps_the_places_of_lines", [] {
    const Root roots[] = {
        Root::memory("theirs", {{"a.glsl", "float a() {\n    while (true) { }\n    return 1.0;\n}"}})
            .untrusted(),
        Root::memory("ours", {{"main.frag", "#version 410 core\nout vec4 film;\n#include \"a.glsl\"\nvoid "
                                            "main() { film = vec4(a()); }\n"}})};
    const Source source = expand(roots, "main.frag");
    ASSERT_EQ(source.loops.size(), 1u);
    EXPECT_EQ(source.loops[0].where.text(), "theirs/a.glsl:2");
    EXPECT_EQ(std::ranges::count(source.text, '\n'), std::ssize(source.lines));
    int line = 1;
    for (std::size_t i = 0; i < source.text.find("while"); ++i) line += source.text[i] == '\n';
    EXPECT_EQ(source.location(line).text(), "theirs/a.glsl:2");
    EXPECT_TRUE(source.text.starts_with("#version 410 core\n"));
    EXPECT_NE(source.text.find("steradian_main(); if (steradian_stopped != 0) film ="), std::string::npos);
});

const Test several_files("unit.glsl.untrusted.writes_calls_out_across_files", [] {
    const auto roots = [](const std::string& a, const std::string& b) {
        return std::vector{
            Root::memory("one", {{"a.glsl", a}}).untrusted(),
            Root::memory("two", {{"b.glsl", b}}).untrusted(),
            Root::memory("ours", {{"main.frag", "#version 410 core\n#include \"a.glsl\"\n#include "
                                                "\"b.glsl\"\nvoid main() { }\n"}})};
    };
    EXPECT_NO_THROW(expand(
        roots("float f(float x) { return x; }\n", "float g(float x) { return f(f(x)); }\n"), "main.frag"));
    EXPECT_THROW(expand(roots(doubling_functions(9), "float g(float x) { return " + repeated("f8(", 40) + "x"
                                                         + repeated(")", 40) + "; }\n"),
                        "main.frag"),
                 Error);
    EXPECT_THROW(expand(roots("float g(float x);\nfloat f(float x) { return g(x); }\n",
                              "float g(float x) { return f(x); }\n"),
                        "main.frag"),
                 Error);
});

const Test only_glsl("unit.glsl.untrusted.serves_glsl_files_alone", [] {
    const Root root = Root::memory("theirs", {{"forward.frag", "a"}, {"a.glsl", "b"}}).untrusted();
    EXPECT_FALSE(root.text_of("forward.frag"));
    EXPECT_TRUE(root.text_of("a.glsl"));
});

const Test told("unit.glsl.untrusted.tells_the_loop_that_was_stopped", [] {
    const std::vector<Loop> loops{{{"a.glsl", 3}, 5}, {{"a.glsl", 7}, 700'001}};
    const auto mark = [](int number, float share) {
        const float r = 0x1p100f * share;
        return std::vector<float>{r, r * static_cast<float>(number >> 10) / 1024.0f,
                                  r * static_cast<float>(number & 1023) / 1024.0f, r};
    };
    const auto where = [&](const std::vector<float>& pixels) -> std::string {
        try {
            require_ended_loops(pixels, loops);
        } catch (const LoopError& error) {
            return error.where().text();
        }
        return "";
    };
    EXPECT_EQ(where({0.1f, 1e9f, 2.0f, 1.0f}), "");
    EXPECT_EQ(where(mark(5, 1.0f)), "a.glsl:3");
    EXPECT_EQ(where(mark(700'001, 1.0f)), "a.glsl:7");
    EXPECT_EQ(where(mark(700'001, 1.0f / 4096.0f)), "a.glsl:7")
        << "a mean in which one sample of many was stopped";
});

} // namespace
