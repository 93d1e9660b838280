#include "glsl/source.hpp"
#include "support/address.hpp"
#include "support/models.hpp"

#include <fstream>

using namespace sr;
using namespace sr::glsl;
using sr::testing::Test;

namespace {

Source expanded(Files files, std::string_view entry = "main.frag") {
    const Root roots[] = {Root::memory("mem", std::move(files))};
    return expand(roots, entry);
}

std::string failure(Files files, std::string_view entry = "main.frag") {
    try {
        expanded(std::move(files), entry);
    } catch (const Error& error) {
        return error.what();
    }
    return "no error";
}

bool contains(const std::string& text, std::string_view part) { return text.find(part) != std::string::npos; }

const Test includes("unit.glsl.expand.includes", [] {
    const Source source = expanded({{"main.frag", "#version 410 core\n#include \"a.glsl\"\nvoid main() {}\n"},
                                    {"a.glsl", "float a;\n  #  include \"b/b.glsl\" // why\nfloat c;\n"},
                                    {"b/b.glsl", "float b;"}});
    EXPECT_EQ(source.text, "#version 410 core\nfloat a;\nfloat b;\nfloat c;\nvoid main() {}\n");
    EXPECT_EQ(source.files, (std::vector<std::string>{"mem/main.frag", "mem/a.glsl", "mem/b/b.glsl"}));
});

const Test line_table("unit.glsl.expand.line_table", [] {
    const Source source = expanded({{"main.frag", "#version 410 core\n#include \"a.glsl\"\nvoid main() {}\n"},
                                    {"a.glsl", "\nfloat a;\r\n"}});
    ASSERT_EQ(source.lines.size(), 4u);
    EXPECT_EQ(source.location(1).text(), "mem/main.frag:1");
    EXPECT_EQ(source.location(3).text(), "mem/a.glsl:2");
    EXPECT_EQ(source.location(4).text(), "mem/main.frag:3");
    EXPECT_EQ(source.location(0).text(), "mem/main.frag") << "a driver's line 0 is no line";
    EXPECT_EQ(source.location(99).text(), "mem/main.frag:3") << "beyond the end is the last line";
    EXPECT_FALSE(contains(source.text, "\r"));
});

const Test declarations("unit.glsl.expand.declares", [] {
    EXPECT_TRUE(declares("vec3 f_r(Surface x)\n{ return vec3(1.0); }", "f_r"));
    EXPECT_FALSE(declares("vec3 f_r(Surface x);\nvoid main() {}", "f_r")) << "a prototype";
    EXPECT_FALSE(declares("vec3 y = 2.0 * f_r(x); if (is_lit) {}", "f_r")) << "a call";
    EXPECT_FALSE(declares("float pdf_f_r(Surface x) { return 0.0; }", "f_r")) << "another name";
});

const Test once("unit.glsl.expand.once", [] {
    const Source source =
        expanded({{"main.frag", "#include \"a.glsl\"\n#include \"b.glsl\"\n#include \"a.glsl\"\n"},
                  {"a.glsl", "float a;\n"},
                  {"b.glsl", "#include \"a.glsl\"\nfloat b;\n"}});
    EXPECT_EQ(source.text, "float a;\nfloat b;\n");
});

const Test overlay_wins("unit.glsl.expand.overlay_wins", [] {
    const Root roots[] = {
        Root::memory("mine", {{"brdf/f.glsl", "mine\n"}}),
        Root::memory("base", {{"brdf/f.glsl", "base\n"}, {"main.frag", "#include \"brdf/f.glsl\"\n"}})};
    const Source source = expand(roots, "main.frag");
    EXPECT_EQ(source.text, "mine\n");
    EXPECT_EQ(source.files, (std::vector<std::string>{"base/main.frag", "mine/brdf/f.glsl"}));
});

const Test comments_do_not_include("unit.glsl.expand.comments_do_not_include", [] {
    const std::string text =
        "// #include \"none.glsl\"\n/* a\n#include \"none.glsl\"\n#version 1\n*/ float x; // /*\n";
    EXPECT_EQ(expanded({{"main.frag", text}}).text, text);
    EXPECT_EQ(expanded({{"main.frag", "/* x */ #include \"a.glsl\"\n"}, {"a.glsl", "a\n"}}).text, "a\n");
});

const Test byte_order_mark_is_dropped("unit.glsl.expand.byte_order_mark_is_dropped", [] {
    EXPECT_EQ(expanded({{"main.frag", "\xEF\xBB\xBF#version 410 core\n"}}).text, "#version 410 core\n");
});

const Test missing_file("unit.glsl.expand.missing_file", [] {
    const std::string nested =
        failure({{"main.frag", "\n#include \"a.glsl\"\n"}, {"a.glsl", "#include \"b.glsl\"\n"}});
    EXPECT_TRUE(nested.starts_with("mem/a.glsl:1: includes \"b.glsl\", which no root has (searched: mem): "))
        << nested;
    EXPECT_TRUE(failure({}, "x.frag").starts_with("x.frag: no such shader in the roots (mem): "));
    EXPECT_THROW(expand({}, "x.frag"), Error);
});

const Test cycle("unit.glsl.expand.cycle", [] {
    const std::string error = failure({{"main.frag", "#include \"a.glsl\"\n"},
                                       {"a.glsl", "float a;\n#include \"b.glsl\"\n"},
                                       {"b.glsl", "#include \"a.glsl\"\n"}});
    EXPECT_TRUE(error.starts_with("mem/b.glsl:1: include cycle: a.glsl → b.glsl → a.glsl: ")) << error;
    EXPECT_TRUE(contains(failure({{"main.frag", "#include \"main.frag\"\n"}}), "main.frag → main.frag"));
});

const Test malformed("unit.glsl.expand.malformed", [] {
    for (const char* line :
         {"#include", "#include a.glsl", "#include \"a.glsl", "#include <a.glsl>", "#include \"\"",
          "#include \"a.glsl\" b", "#include \"../a.glsl\"", "#include \"/a.glsl\"", "#include \"b\\a.glsl\"",
          "#include \"a.glsl\" \"a.glsl\""}) {
        const std::string error = failure({{"main.frag", std::string("\n") + line}, {"a.glsl", ""}});
        EXPECT_TRUE(error.starts_with("mem/main.frag:2: malformed #include: ")) << line << " gave " << error;
    }
    EXPECT_TRUE(
        contains(failure({{"main.frag", "#include \"a.glsl\" /* x\n*/"}, {"a.glsl", ""}}), "comment"));
    EXPECT_EQ(failure({{"main.frag", "x\n/* y\n"}}),
              "mem/main.frag:2: this comment never ends: close it with */");
});

const Test version_place("unit.glsl.expand.version_place", [] {
    const std::string included = failure(
        {{"main.frag", "#version 410 core\n#include \"a.glsl\"\n"}, {"a.glsl", "#version 410 core\n"}});
    EXPECT_TRUE(included.starts_with("mem/a.glsl:1: #version in a file that is included: ")) << included;
    EXPECT_TRUE(
        failure({{"main.frag", "float a;\n#version 410 core\n"}}).starts_with("mem/main.frag:2: #version"));
});

const Test places("unit.glsl.expand.refuses_what_moves_places", [] {
    const auto refused = [](const char* text, std::string_view begin) {
        const std::string said =
            failure({{"main.frag", "#include \"a.glsl\"\nfloat z;\n"}, {"a.glsl", text}});
        EXPECT_TRUE(said.starts_with(begin)) << text << ": " << said;
    };
    refused("float a;\n#line 7\n", "mem/a.glsl:2: #line");
    refused("float a;\n # /* */ line 7 7\n", "mem/a.glsl:2: #line");
    refused("float a;\n#\\\nline 7\n", "mem/a.glsl:3: #line");
    refused("float a;\n#li\\\nne 7\n", "mem/a.glsl:3: #line");
    refused("# /*\n*/ line 7\n", "mem/a.glsl:2: #line");
    refused("#line\n", "mem/a.glsl:1: #line");
    refused("#if 1\nfloat a;\n", "mem/a.glsl:1: this #if never ends");
    refused("float a;\n#endif\n", "mem/a.glsl:2: #endif without #if");
    refused("#define A \\", "mem/a.glsl:1: the last line ends in \\");
    EXPECT_EQ(failure({{"main.frag", "// #line 7\n#define line 1\n#ifdef A\n#if 1\n#endif\n#endif\n"}}),
              "no error");
    const std::string nul = failure({{"main.frag", std::string("float a;\nflo\0at b;\n", 18)}});
    EXPECT_TRUE(nul.starts_with("mem/main.frag:2: a NUL byte")) << nul;
});

const Test line_breaks("unit.glsl.expand.line_breaks", [] {
    const Source source = expanded({{"main.frag", "a\rb\r\nc\nd"}});
    EXPECT_EQ(source.text, "a\nb\nc\nd\n");
    EXPECT_EQ(source.location(3).text(), "mem/main.frag:3");
});

const Test foreign("unit.glsl.expand.knows_what_is_foreign", [] {
    const Root roots[] = {Root::single("/home/me/mine.glsl", "a.glsl", "float a;\n"),
                          Root::memory("mem", {{"main.frag", "#include \"a.glsl\"\n#include \"b.glsl\"\n"},
                                               {"b.glsl", "float b;\n"}})};
    EXPECT_EQ(expand(roots, "main.frag").foreign, std::vector<std::string>{"/home/me/mine.glsl"});
    EXPECT_TRUE(expanded({{"main.frag", "float a;\n"}}).foreign.empty());
});

const Test folder_root("unit.glsl.root.folder", [] {
    const auto folder = sr::testing::scratch_folder("glsl_root");
    std::filesystem::create_directories(folder / "brdf");
    std::ofstream(folder / "brdf" / "f.glsl") << "float f;\n";
    const Root roots[] = {Root::folder(folder)};
    const Source source = expand(roots, "brdf/f.glsl");
    EXPECT_EQ(source.text, "float f;\n");
    EXPECT_TRUE(std::filesystem::exists(source.files.at(0))) << "a person can open it";
    EXPECT_THROW(roots[0].text_of("brdf"), Error) << "a folder is no shader";
    EXPECT_THROW(Root::folder(folder / "none"), Error);
});

const Test embedded_is_the_tree("unit.glsl.root.embedded_is_the_tree", [] {
    namespace fs = std::filesystem;
    const fs::path shaders = sr::testing::source_folder() / "shaders";
    if (!fs::exists(shaders)) GTEST_SKIP() << "no shaders/ in the source tree";
    const Root disk = Root::folder(shaders);
    const Root built_in = embedded();
    for (const auto& entry : fs::recursive_directory_iterator(shaders)) {
        const std::string extension = entry.path().extension().string();
        if (extension != ".glsl" && extension != ".vert" && extension != ".frag") continue;
        const std::string name = fs::relative(entry.path(), shaders).generic_string();
        EXPECT_EQ(built_in.text_of(name), disk.text_of(name)) << name;
        EXPECT_EQ(built_in.place_of(name), "shaders/" + name);
    }
});

} // namespace
