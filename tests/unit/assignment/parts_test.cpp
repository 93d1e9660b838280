#include "assignment/compile_problem.hpp"
#include "assignment/evaluation.hpp"
#include "assignment/parameters.hpp"
#include "assignment/regions.hpp"
#include "assignment/value_check.hpp"
#include "core/error.hpp"
#include "support/address.hpp"
#include "support/gl.hpp"

#include <algorithm>
#include <cmath>

using namespace sr;
using namespace sr::assignment;
using sr::testing::Test;

namespace {

const char* const file = "int before;\n"
                         "// begin solution A3.2\n"
                         "// What it is.\n"
                         "float half_of(float x) { return 0.5 * x; } // end of it\n"
                         "// end\n"
                         "int after;\n";

const Test found("unit.assignment.regions.found", [] {
    const auto regions = regions_of(file, "a.glsl");
    ASSERT_EQ(regions.size(), 1u);
    EXPECT_EQ(regions[0].name, "A3.2");
    EXPECT_EQ(regions[0].begin_line, 2);
    EXPECT_EQ(regions[0].end_line, 5);
    EXPECT_NE(regions[0].text.find("half_of"), std::string::npos);
});

const Test included("unit.assignment.regions.included", [] {
    const std::string text = with_includes(file, "a.glsl", {"A3.2"});
    EXPECT_NE(text.find("#include \"region/A3.2.glsl\""), std::string::npos);
    EXPECT_EQ(text.find("half_of"), std::string::npos);
    EXPECT_NE(text.find("int after;"), std::string::npos);
    EXPECT_EQ(with_includes(file, "a.glsl", {"A3.1"}), file);
});

const Test remarks("unit.assignment.regions.remarks_are_no_markers", [] {
    const auto regions =
        regions_of("// begin A1.1: a\n// begin with h\n// end\nfloat x;\n// end A1.1\n", "a.glsl");
    ASSERT_EQ(regions.size(), 1u);
    EXPECT_EQ(regions[0].end_line, 5);
});

std::string complaint_about(const char* text) {
    try {
        regions_of(text, "a.glsl");
    } catch (const Error& error) {
        return error.what();
    }
    return "none";
}

const Test wrong("unit.assignment.regions.errors_name_the_line", [] {
    EXPECT_TRUE(complaint_about("\n// begin A1.1\nfloat x;\n").starts_with("a.glsl:2: "))
        << complaint_about("");
    EXPECT_TRUE(complaint_about("// end A1.1\n").starts_with("a.glsl:1: "));
    EXPECT_TRUE(complaint_about("// begin A1.1\n// begin A1.2\n").starts_with("a.glsl:2: "));
    EXPECT_TRUE(complaint_about("// begin A1.1\n// end A1.1\n// begin A1.1\n// end A1.1\n")
                    .starts_with("a.glsl:3: "));
});

const Test variants("unit.assignment.regions.variants", [] {
    const auto sections =
        variants_of("// Of A1.1.\n// mistake pi_missing\na\n// solution other\nb\n", "v.glsl");
    ASSERT_EQ(sections.size(), 2u);
    EXPECT_TRUE(sections[0].is_mistake);
    EXPECT_EQ(sections[0].text, "a\n");
    EXPECT_EQ(sections[1].line, 5);
    EXPECT_THROW(variants_of("a\n// mistake b\n", "v.glsl"), Error);
});

const Test stubbed("unit.assignment.stub.keeps_signature_and_comment", [] {
    const std::string region = "float secret(float x) { return x; }\n// What it is.\nvec3 f(vec3 a,\n       "
                               "float b) {\n    if (b > 0.0) { "
                               "return a; }\n    return secret(b) * a; // how\n}\n";
    EXPECT_EQ(stub_of(region, {"f"}, "a.glsl", 1),
              "// What it is.\nvec3 f(vec3 a,\n       float b) {\n    return not_implemented().xyz;\n}\n");
    EXPECT_THROW(stub_of(region, {"g"}, "a.glsl", 1), Error);
});

const Test stated("unit.assignment.stub.stated_body", [] {
    EXPECT_EQ(stub_of("// stub: return Sample(not_implemented().xyz, 0.0);\nSample f(vec2 u) { return x; }\n",
                      {"f"}, "a", 1),
              "Sample f(vec2 u) {\n    return Sample(not_implemented().xyz, 0.0);\n}\n");
    EXPECT_THROW(stub_of("Sample f(vec2 u) { return x; }\n", {"f"}, "a", 1), Error);
});

const Test brackets("unit.assignment.stub.lone_bracket", [] {
    EXPECT_EQ(lone_bracket("float f() { return (1.0); } // (\n/* { */\n").line, 0);
    EXPECT_EQ(lone_bracket("float f()\n{ if (a) {\n }\n").line, 2);
    EXPECT_EQ(lone_bracket("float f()\n{ }\n }\n").line, 3);
});

Assignment with_parameters() {
    Assignment assignment;
    assignment.id = "a1-light";
    assignment.parameters = {{"rho", "1", "albedo", {}, 0.2, 0.8, 2}, {"lamps", "", "", {1, 2, 3}, 0, 1, 0}};
    return assignment;
}

const Test own("unit.assignment.parameters.are_the_students_own", [] {
    const Assignment assignment = with_parameters();
    EXPECT_EQ(parameters_of(assignment, "anna"), parameters_of(assignment, "anna"));
    int distinct = 0;
    for (int i = 0; i < 20; ++i) {
        const Parameters p = parameters_of(assignment, std::to_string(i));
        distinct += p != parameters_of(assignment, std::to_string(i + 1));
        EXPECT_GE(p.at("rho"), 0.2);
        EXPECT_LE(p.at("rho"), 0.8);
    }
    EXPECT_GE(distinct, 19);
});

const Test put("unit.assignment.parameters.substituted", [] {
    EXPECT_EQ(substituted("ρ = {{rho}}, {{ x }}", {{"rho", 0.25}}, "a"), "ρ = 0.25, {{ x }}");
    EXPECT_EQ(substituted_json("{\"a\": \"{{rho}}\"}", {{"rho", 2.0}}, "a"), "{\"a\": 2.0}");
    EXPECT_THROW(substituted("\n{{sigma}}", {{"rho", 0.25}}, "a"), Error);
});

Input input(const char* name, Input::Kind kind, double low = 0.0, double high = 1.0,
            const char* around = "") {
    Input made;
    made.name = name;
    made.kind = kind;
    made.low = low;
    made.high = high;
    made.around = around;
    return made;
}

const Test rows("unit.assignment.inputs.keep_their_ranges", [] {
    const Inputs inputs =
        inputs_of({input("n", Input::Kind::sphere), input("w", Input::Kind::hemisphere, 0.3, 1.0, "n"),
                   input("m", Input::Kind::integer, 1, 4), input("x", Input::Kind::number, 2, 3)},
                  200);
    float least = 9.0f, most = 0.0f;
    for (const render::Row& row : inputs.rows) {
        const vec3 n(row[0]), w(row[0].w, row[1].x, row[1].y);
        EXPECT_NEAR(glm::length(w), 1.0f, 1e-5f);
        EXPECT_GE(glm::dot(n, w), 0.3f - 1e-5f);
        EXPECT_EQ(row[1].z, std::floor(row[1].z));
        EXPECT_GE(row[1].z, 1.0f);
        EXPECT_LE(row[1].z, 4.0f);
        least = std::min(least, row[1].w);
        most = std::max(most, row[1].w);
    }
    EXPECT_EQ(least, 2.0f);
    EXPECT_EQ(most, 3.0f);
});

/// An assignment of one file, which is given.
Assignment sampler() {
    Assignment assignment;
    assignment.folder = "nowhere";
    assignment.files["s.glsl"] =
        "#include \"base/constants.glsl\"\n"
        "vec3 drawn(vec2 u) {\n    float r = sqrt(u.x);\n"
        "    return vec3(r * cos(2.0 * pi * u.y), r * sin(2.0 * pi * u.y), sqrt(1.0 - u.x));\n}\n"
        "float noise(float s, int i) { return fract(sin(s * 91.7 + float(i) * 12.9898) * 43758.5453); }\n"
        "float mean_of(float s, int count) {\n    float sum = 0.0;\n"
        "    for (int i = 0; i < count; ++i) sum += noise(s, i);\n    return sum / float(count);\n}\n";
    return assignment;
}

const Test chi_squared("unit.assignment.samples.found_to_fit_or_not", [] {
    sr::testing::context();
    Check check;
    check.kind = Check::Kind::samples;
    check.rows = 1;
    check.value = "drawn(u)";
    check.other = "max(w.z, 0.0) / pi";
    EXPECT_TRUE(check_samples(sampler(), {}, check, {}).passed);
    check.other = "w.z > 0.0 ? 0.5 / pi : 0.0";
    EXPECT_FALSE(check_samples(sampler(), {}, check, {}).passed);
    check.other = "max(w.z, 0.0)";
    EXPECT_NE(check_samples(sampler(), {}, check, {}).message.find("integrates to 3.14"), std::string::npos);
    check.other = "max(w.z, 0.0) / pi";
    check.value = "2.0 * drawn(u)";
    EXPECT_NE(check_samples(sampler(), {}, check, {}).message.find("length 1"), std::string::npos);
});

const Test not_a_density("unit.assignment.samples.a_density_that_is_no_number_fails", [] {
    sr::testing::context();
    Check check;
    check.kind = Check::Kind::samples;
    check.rows = 1;
    check.value = "drawn(u)";
    for (const char* there : {"sqrt(w.z)", "1.0 / (w.z - w.z)"}) { // where no direction is drawn
        check.other = std::string("w.z < -0.9 ? ") + there + " : max(w.z, 0.0) / pi";
        EXPECT_FALSE(check_samples(sampler(), {}, check, {}).passed) << there;
    }
});

const Test infinite("unit.assignment.values.no_law_holds_for_infinity", [] {
    const Inputs inputs = inputs_of({input("x", Input::Kind::number)}, 1);
    Check check;
    check.type = "float";
    for (const double value : {HUGE_VAL, -HUGE_VAL, std::nan("")}) {
        Compared compared;
        compared.got.means = compared.expected = {glm::dvec4(value)};
        compared.tolerance = {glm::dvec4(1e-4)};
        check.relation = Check::Relation::reference;
        EXPECT_EQ(judge(check, compared, inputs).passed, !std::isnan(value));
        for (const auto law :
             {Check::Relation::equals, Check::Relation::at_most, Check::Relation::at_least}) {
            check.relation = law;
            EXPECT_FALSE(judge(check, compared, inputs).passed) << value;
        }
    }
});

const Test fall("unit.assignment.slope.of_a_random_mean", [] {
    sr::testing::context();
    Check check;
    check.kind = Check::Kind::slope;
    check.rows = 1;
    check.counts = {4, 16, 64, 256};
    check.value = "mean_of(seed, count)";
    check.other = "0.5";
    const Finding mean = check_slope(sampler(), {}, check, {});
    EXPECT_TRUE(mean.passed) << mean.got;
    check.value = "noise(seed, 1)";
    EXPECT_FALSE(check_slope(sampler(), {}, check, {}).passed);
});

const Test hints("unit.assignment.compile_problem.hints", [] {
    const auto has = [](const char* complaint, const char* line, const char* words) {
        EXPECT_NE(hint_for_complaint(complaint, line).find(words), std::string::npos)
            << complaint << " → " << hint_for_complaint(complaint, line);
    };
    has("`alpa' undeclared", "x = alpa;", "not declared");
    has("syntax error, unexpected RETURN, expecting ',' or ';'", "return a;", "semicolon");
    has("no matching function for call to `pow(vec3, int)'; candidates are:", "pow(v, 2)", "arguments");
    has("operands to arithmetic operators must be numeric", "float a = v * 2;", "types");
    has("`return' with wrong type vec3, in function `f' returning float", "return v;", "returned");
    has("assignment to read-only variable 'n'", "n = 2.0;", "Copy it");
    has("LHS of operator ^ must be an integer", "float y = x ^ 2;", "pow(x, y)");
    EXPECT_EQ(hint_for_complaint("something new", ""), "");
});

} // namespace
