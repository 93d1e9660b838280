#include "cli/commands.hpp"
#include "core/output.hpp"
#include "settings/options.hpp"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <string>
#include <vector>

namespace sr::cli {
namespace {

/// Parts of the bash function: patterns of `case` and their words.
struct BashCases {
    std::string commands; // which words lead to a subcommand
    std::string words;    // of each command
    std::string values;   // of each option
};

/// Returns the values of an option: the words of the table of options, or those of its type "auto|egl".
std::vector<std::string> values_of(const CLI::Option& option) {
    std::vector<std::string> values;
    for (const settings::Option& row : settings::all_options())
        if (row.value.words && option.check_name(row.flag()))
            for (const settings::Word& word : row.value.words()) values.emplace_back(word.name);
    if (!values.empty()) return values;
    const std::string type = option.get_type_name();
    const bool is_list = type.find('|') != std::string::npos
                         && type.find_first_not_of("abcdefghijklmnopqrstuvwxyz-|") == std::string::npos;
    return is_list ? CLI::detail::split(type, '|') : values;
}

void append(const CLI::App& command, const std::string& path, BashCases& cases) {
    std::vector<std::string> words;
    for (const CLI::App* sub : command.get_subcommands([](const CLI::App*) { return true; })) {
        if (sub->get_group().empty()) continue; // hidden
        words.push_back(sub->get_name());
        const std::string sub_path = path + "/" + sub->get_name();
        cases.commands += fmt::format("            {}) path+=/$part ;;\n", sub_path);
        append(*sub, sub_path, cases);
    }
    const bool has_subcommands = !words.empty();
    for (const CLI::Option* option : command.get_options()) {
        for (const std::string& name : option->get_lnames()) {
            words.push_back("--" + name);
            if (const auto values = values_of(*option); !values.empty())
                cases.values +=
                    fmt::format("        {},--{}) words='{}' ;;\n", path, name, fmt::join(values, " "));
        }
    }
    // Where files are expected, options are offered after a dash only.
    cases.words += fmt::format("            '{}') {}words='{}' ;;\n", path,
                               has_subcommands ? "" : "[[ $word == -* ]] && ", fmt::join(words, " "));
}

} // namespace

void add_completion_command(CLI::App& app) {
    CLI::App* command = app.add_subcommand("completion", "print a script that completes words in a shell");
    command->add_subcommand("bash", "print the script for bash")->callback([&app] {
        BashCases cases;
        append(app, "", cases);
        write_output(fmt::format("_steradian() {{\n"
                                 "    local word=${{COMP_WORDS[COMP_CWORD]}} words= path= part\n"
                                 "    local previous=${{COMP_WORDS[COMP_CWORD-1]}}\n"
                                 "    for part in \"${{COMP_WORDS[@]:1:COMP_CWORD-1}}\"; do\n"
                                 "        case $path/$part in\n{}"
                                 "        esac\n"
                                 "    done\n"
                                 "    case $path,$previous in\n{}"
                                 "    *)\n"
                                 "        case $path in\n{}"
                                 "        esac ;;\n"
                                 "    esac\n"
                                 "    COMPREPLY=($(compgen -W \"$words\" -- \"$word\"))\n"
                                 "}}\n"
                                 "complete -o default -F _steradian steradian\n",
                                 cases.commands, cases.values, cases.words));
    });
    command->require_subcommand(1);
    command->footer(
        "Example:\n  steradian completion bash > ~/.local/share/bash-completion/completions/steradian");
}

} // namespace sr::cli
