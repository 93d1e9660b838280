// The table of commands: complete, without doubles, and found by a part of a name.
#include "support/address.hpp"
#include "viewer/panels/command_palette.hpp"

#include <algorithm>
#include <set>
#include <string>

using namespace sr::viewer;
using sr::testing::Test;

namespace {

constexpr int command_count = static_cast<int>(Command::quit) + 1; // the last one

const Test every_row("unit.viewer.commands.each_has_a_name_a_tooltip_a_group_and_a_key", [] {
    std::set<std::string> names;
    std::set<int> commands;
    for (const CommandInfo& info : all_commands()) {
        EXPECT_TRUE(commands.insert(static_cast<int>(info.command)).second) << info.name << " has two rows";
        EXPECT_TRUE(names.insert(info.name).second) << info.name << " names two commands";
        EXPECT_GT(std::string(info.what).size(), 8u) << info.name;
        EXPECT_FALSE(std::string(info.group).empty()) << info.name;
        EXPECT_FALSE(Keymap().text(info.command).empty()) << info.name << " has no key";
    }
    EXPECT_EQ(static_cast<int>(commands.size()), command_count);
});

const Test one_command("unit.viewer.commands.a_key_has_one_command", [] {
    std::set<std::string> seen;
    const Keymap keys;
    for (const Binding& binding : bindings()) {
        EXPECT_TRUE(seen.insert(keys_of(binding)).second) << keys_of(binding) << " has two commands";
        EXPECT_EQ(keys.command_of(binding.key, binding.modifiers), binding.command) << keys_of(binding);
    }
    EXPECT_EQ(keys.text(Command::redo_light), "Ctrl Shift Z");
    EXPECT_EQ(keys.text(Command::screenshot_png), "F12");
    EXPECT_EQ(keys.text(Command::frame_back), "Alt Left");
});

const Test in_groups("unit.viewer.commands.a_group_is_in_one_piece", [] {
    std::set<std::string> closed;
    std::string group;
    for (const CommandInfo& info : all_commands()) {
        if (group == info.group) continue;
        EXPECT_TRUE(closed.insert(info.group).second) << info.group << " begins again at " << info.name;
        group = info.group;
    }
});

const Test by_name("unit.viewer.commands.a_part_of_its_name_finds_a_command", [] {
    EXPECT_EQ(commands_like("").size(), all_commands().size());
    for (const CommandInfo& info : all_commands()) {
        const auto found = commands_like(info.name);
        ASSERT_FALSE(found.empty()) << info.name;
        EXPECT_TRUE(std::ranges::find(found, &info) != found.end()) << info.name;
    }
    EXPECT_EQ(commands_like("tone").front()->command, Command::next_tone_curve);
    EXPECT_EQ(commands_like("EXR write").front()->command, Command::screenshot_exr);
    EXPECT_EQ(commands_like("und").front()->command, Command::undo_light) << "the beginning of a name wins";
    EXPECT_TRUE(commands_like("no such thing").empty());
});

} // namespace
