// Keys that a person gives commands in a file: what it changes, and what it refuses, with line and column.
#include "core/error.hpp"
#include "core/json.hpp"
#include "support/address.hpp"
#include "support/models.hpp"
#include "viewer/keymap.hpp"

#include <filesystem>
#include <fstream>
#include <string>

using namespace sr;
using namespace sr::viewer;
using sr::testing::Test;

namespace {

std::filesystem::path file_of(const std::string& text) {
    const std::filesystem::path file = sr::testing::scratch_folder("keymap") / "keys.json";
    std::ofstream(file) << text;
    return file;
}

/// The message without the folder of the file.
std::string refusal_of(const std::string& text) {
    const std::filesystem::path file = file_of(text);
    try {
        Keymap::read(file);
    } catch (const Error& error) {
        return std::string(error.what()).substr(file.parent_path().string().size() + 1);
    }
    return "";
}

const Test every_key("unit.viewer.keymap.each_key_is_read_as_it_is_written", [] {
    for (const Binding& binding : bindings()) {
        const auto key = parse_key(keys_of(binding));
        ASSERT_TRUE(key) << keys_of(binding);
        EXPECT_EQ(*key, std::pair(binding.key, binding.modifiers)) << keys_of(binding);
    }
    EXPECT_EQ(parse_key("ctrl+shift+z"), parse_key("Ctrl Shift Z"));
    EXPECT_EQ(parse_key("shift num +"), parse_key("Shift Num +"));
    for (const char* none : {"", "Ctrl", "Ctrl ", "Hyper Z", "ZZ", "F26", "Num", "Space Z"})
        EXPECT_FALSE(parse_key(none)) << none;
});

const Test a_change("unit.viewer.keymap.a_file_changes_what_it_names", [] {
    const Keymap map = Keymap::read(file_of(
        R"({"Frame all": ["Ctrl Home", "F9"], "Pixels": "K", "Play or pause": "W", "Write a turntable": []})"));
    EXPECT_EQ(map.text(Command::frame_all), "Ctrl Home");
    const auto command = [&](const char* key) {
        const auto parsed = parse_key(key).value();
        return map.command_of(parsed.first, parsed.second);
    };
    EXPECT_EQ(command("F9"), Command::frame_all);
    EXPECT_EQ(command("Home"), std::nullopt) << "the built-in key of a command with others";
    EXPECT_EQ(command("K"), Command::pixels) << "keys are exchanged";
    EXPECT_EQ(command("W"), Command::play);
    EXPECT_EQ(map.text(Command::turntable), "");
    EXPECT_EQ(map.hint("write", Command::turntable), "write");
    EXPECT_EQ(map.hint("frame", Command::frame_all), "frame (Ctrl Home)");
    EXPECT_EQ(map.text(Command::undo_light), "Ctrl Z") << "another command";
});

const Test round_trip("unit.viewer.keymap.what_is_printed_is_read_again", [] {
    const Keymap built_in, again = Keymap::read(file_of(built_in.json()));
    EXPECT_EQ(again.json(), built_in.json());
    EXPECT_EQ(again.all().size(), bindings().size());
});

const Test refusals("unit.viewer.keymap.a_wrong_file_is_refused_with_its_place", [] {
    EXPECT_EQ(refusal_of("{\n \"Frame evrything\": \"A\"}"),
              "keys.json:2:2: there is no command \"Frame evrything\": write its name as F1 lists it, or see "
              "steradian view --print-keys");
    EXPECT_EQ(refusal_of("{\"Pixels\": [\"F9\",\n\"Ctl P\"]}").substr(0, 45),
              "keys.json:2:1: there is no key \"Ctl P\": write");
    EXPECT_EQ(
        refusal_of("{\"Pixels\":\n  \"Ctrl Q\"}"),
        "keys.json:2:3: Ctrl Q is the key of \"Quit\", too: give one of the two another key, or none: []");
    EXPECT_EQ(refusal_of("{\"Pixels\": \"F9\", \"Scene\": \"F9\"}").substr(0, 61),
              "keys.json:1:27: F9 is the key of \"Pixels\", too: give one of t");
    EXPECT_EQ(refusal_of("{\"Pixels\": [\"F9\", \"f9\"]}"),
              "keys.json:1:19: F9 stands twice in this list: name it once");
    EXPECT_EQ(refusal_of("{\"Pixels\": 3}").substr(0, 34), "keys.json:1:12: a key is no text: ");
    EXPECT_NE(refusal_of("{\"Pixels\": \"F9\", \"Scene\": \"O\",\n\"Pixels\": \"F8\"}")
                  .find("\"Pixels\" stands here twice: write its"),
              std::string::npos);
    EXPECT_EQ(refusal_of("[]").substr(0, 29), "keys.json:1:1: is no object: ");
    EXPECT_NE(refusal_of("{\"Pixels\" \"W\"}").find("keys.json:1:"), std::string::npos) << "no JSON";
});

} // namespace
