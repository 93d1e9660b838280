// The table of options: its texts, its command lines, and the schema of suites.
#include "settings/options.hpp"

#include "cli/arguments.hpp"
#include "core/file.hpp"
#include "support/address.hpp"

#include <CLI/CLI.hpp>
#include <fmt/format.h>
#include <map>
#include <nlohmann/json.hpp>
#include <set>

using namespace sr;
using settings::Option;
using settings::Value;
using sr::testing::Test;

namespace {

/// Texts that an option takes.
std::vector<std::string> examples_of(const Option& option) {
    static const std::map<std::string, std::string> of_types{
        {"WIDTHxHEIGHT", "1920x1080"}, {"A:B|A:", "3:47"},         {"L|R,G,B", "0.5,1,2"},
        {"PERCENT%", "0.5%"},          {"SECONDS|2s|5min", "90s"}, {"EV|auto", "-1.5"}};
    const Value& value = option.value;
    if (const auto found = of_types.find(value.type); found != of_types.end()) return {found->second};
    std::vector<std::string> texts;
    if (value.words)
        for (const settings::Word& word : value.words()) texts.emplace_back(word.name);
    else if (value.kind == Value::Kind::whole)
        texts = {std::to_string(static_cast<long long>(value.min)),
                 std::to_string(static_cast<long long>(value.max))};
    else if (value.kind == Value::Kind::flag)
        texts = {"true"};
    else
        texts = {"7"};
    return texts;
}

std::string text_of_keys(const std::set<std::string>& keys) {
    std::string text;
    for (const std::string& key : keys) text += key + " ";
    return text;
}

const Test survives("unit.cli.options.a_value_survives_as_text", [] {
    for (const Option& option : settings::all_options())
        for (const std::string& text : examples_of(option)) {
            settings::RenderSettings settings;
            EXPECT_TRUE(option.value.read(option.value, settings, text)) << option.key << " " << text;
            EXPECT_EQ(option.value.write(settings), text) << option.key;
        }
});

const Test arguments("unit.cli.options.those_that_are_set_become_arguments_again", [] {
    EXPECT_EQ(settings::render_arguments({}), "");
    for (const Option& option : settings::all_options())
        for (const std::string& text : examples_of(option)) {
            settings::RenderSettings settings;
            option.value.read(option.value, settings, text);
            const bool is_said = (option.takers & settings::by_render)
                                 && option.key != std::string("gl_debug")
                                 && text != settings::default_of(option);
            const std::string value =
                option.value.kind == Value::Kind::flag ? "" : " " + settings::shell_word(text);
            EXPECT_EQ(settings::render_arguments(settings), is_said ? " " + option.flag() + value : "");
        }
    settings::RenderSettings settings;
    settings.shaders = {"a b", "c"};
    settings.camera = "eye=0,1,4;target=0,1,0";
    EXPECT_EQ(settings::render_arguments(settings),
              " --camera 'eye=0,1,4;target=0,1,0' --shaders 'a b' --shaders c");
    EXPECT_EQ(settings::shell_word("it's"), "'it'\\''s'");
    EXPECT_EQ(settings::shell_word(""), "''");
});

const Test refuses("unit.cli.options.refuse_what_they_do_not_allow", [] {
    settings::RenderSettings settings;
    for (const Option& option : settings::all_options()) {
        const Value& value = option.value;
        if (value.kind == Value::Kind::flag || (value.kind == Value::Kind::list)) continue;
        const bool is_free = value.kind == Value::Kind::text && !value.words && examples_of(option)[0] == "7";
        EXPECT_EQ(value.read(value, settings, "no such"), is_free) << option.key;
        if (value.kind != Value::Kind::whole && value.kind != Value::Kind::number) continue;
        for (const double outside : {value.min - 1.0, value.max + 1.0})
            if (outside < value.min || outside > value.max) { // a limit beyond all doubles has no neighbour
                EXPECT_FALSE(value.read(value, settings, fmt::format("{}", outside))) << option.key;
            }
        for (const char* text : {"nan", "inf", "1e999", "", "1x"})
            EXPECT_FALSE(value.read(value, settings, text)) << option.key << " " << text;
    }
});

const Test messages("unit.cli.options.messages_say_what_is_allowed", [] {
    std::map<std::string, std::string> allowed;
    for (const Option& option : settings::all_options())
        allowed[option.key] = settings::allowed_by(option.value);
    EXPECT_EQ(allowed["layers"], "lights, the only choice");
    EXPECT_EQ(allowed["estimator"], "one of sampled, analytic");
    EXPECT_EQ(allowed["size"], "WIDTHxHEIGHT");
});

const Test commands("unit.cli.options.commands_take_those_of_the_table", [] {
    for (const settings::Taker taker : {settings::by_render, settings::by_view, settings::by_probe,
                                        settings::by_export, settings::by_info}) {
        settings::RenderSettings settings;
        CLI::App app;
        cli::declare(app, taker, settings);
        std::set<std::string> expected, declared;
        for (const CLI::Option* option : app.get_options())
            if (!option->check_lname("help")) declared.insert(option->get_name());
        for (const Option& option : settings::all_options()) {
            if (!(option.takers & taker)) continue;
            EXPECT_TRUE(expected.insert(option.flag()).second) << option.key << " is there twice";
            const CLI::Option* const declaration = app.get_option_no_throw(option.flag());
            ASSERT_NE(declaration, nullptr) << option.key;
            EXPECT_FALSE(declaration->get_description().empty()) << option.key;
            std::vector<std::string> words{option.flag()};
            if (option.value.kind != Value::Kind::flag)
                words.insert(words.begin(), examples_of(option)[0]); // CLI11 reads them from the back
            app.clear();
            app.parse(std::move(words));
            EXPECT_EQ(option.value.write(settings), examples_of(option)[0]) << option.key;
        }
        EXPECT_EQ(text_of_keys(declared), text_of_keys(expected));
    }
});

/// The schema of an option of a suite's test.
nlohmann::json schema_of(const Option& option) {
    nlohmann::json schema{{"description", "steradian render " + option.flag() + ": " + option.help}};
    if (option.value.kind == Value::Kind::flag)
        schema["type"] = "boolean";
    else if (option.value.kind == Value::Kind::list)
        schema["oneOf"] = {{{"type", "string"}}, {{"type", "array"}, {"items", {{"type", "string"}}}}};
    else
        schema["type"] = {"string", "number"};
    return schema;
}

const Test schema("unit.cli.options.schema_of_suites_has_them", [] {
    const auto json = nlohmann::json::parse(read_text(STERADIAN_SOURCE "/assets/golden_suite.schema.json"));
    nlohmann::json expected = nlohmann::json::object();
    for (const Option& option : settings::all_options())
        if (option.takers & settings::by_suites) expected[option.key] = schema_of(option);
    EXPECT_EQ(json["$defs"]["options"]["properties"], expected) << "write there: " << expected.dump(1);
});

} // namespace
