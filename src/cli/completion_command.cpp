#include "cli/command_tree.hpp"
#include "cli/commands.hpp"
#include "core/output.hpp"

#include <CLI/CLI.hpp>
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

void append(const CLI::App& command, const std::string& path, BashCases& cases) {
    std::vector<std::string> words;
    for (const CLI::App* sub : listed_subcommands(command)) {
        words.push_back(sub->get_name());
        const std::string sub_path = path + "/" + sub->get_name();
        cases.commands += fmt::format("            {}) path+=/$part ;;\n", sub_path);
        append(*sub, sub_path, cases);
    }
    const bool has_subcommands = !words.empty();
    for (const CLI::Option* option : listed_options(command)) {
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

/// Returns a bash function of this name, and the command that makes it complete `steradian`.
std::string bash_script(const CLI::App& app, const std::string& function = "_steradian") {
    BashCases cases;
    append(app, "", cases);
    return fmt::format(
        "{}() {{\n"
        "    local word=${{COMP_WORDS[COMP_CWORD]}} words= path= part\n"
        "    local previous=${{COMP_WORDS[COMP_CWORD-1]}}\n"
        "    for part in \"${{COMP_WORDS[@]:1:$((COMP_CWORD - 1))}}\"; do\n" // zsh takes :C for a modifier
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
        "complete -o default -F {} steradian\n",
        function, cases.commands, cases.values, cases.words, function);
}

/// The bash function in zsh's own emulation of bash. The last line serves the first completion, at which zsh
/// runs the file as a function.
std::string zsh_script(const CLI::App& app) {
    return "#compdef steradian\nautoload -U +X bashcompinit && bashcompinit\n"
           + bash_script(app, "_steradian_words")
           + "[[ $funcstack[1] != _steradian ]] || _bash_complete -o default -F _steradian_words\n";
}

/// Quotes a text for fish, which knows \\ and \' between single quotes.
std::string fish_quoted(const std::string& text) {
    std::string quoted = "'";
    for (const char c : text) {
        if (c == '\\' || c == '\'') quoted += '\\';
        quoted += c;
    }
    return quoted + "'";
}

/// Adds a line for each subcommand and option. `paths` gets the paths of subcommands.
void append_fish(const CLI::App& command, const std::string& path, std::string& paths, std::string& lines) {
    const std::string start = fmt::format("complete -c steradian -n '__steradian_at {}/'", path);
    for (const CLI::App* sub : listed_subcommands(command)) {
        const std::string sub_path = path + "/" + sub->get_name();
        paths += " " + sub_path;
        lines +=
            fmt::format("{} -f -a {} -d {}\n", start, sub->get_name(), fish_quoted(sub->get_description()));
        append_fish(*sub, sub_path, paths, lines);
    }
    for (const CLI::Option* option : listed_options(command)) {
        std::string line = start;
        for (const std::string& name : option->get_lnames()) line += " -l " + name;
        for (const std::string& name : option->get_snames()) line += " -s " + name;
        const auto values = values_of(*option);
        const bool is_flag = option->get_items_expected_max() == 0;
        if (!is_flag) line += values.empty() ? " -r" : " -x";
        if (!values.empty()) line += fmt::format(" -a '{}'", fmt::join(values, " "));
        lines += fmt::format("{} -d {}\n", line, fish_quoted(option->get_description()));
    }
}

std::string fish_script(const CLI::App& app) {
    std::string paths, lines;
    append_fish(app, "", paths, lines);
    return fmt::format("# True if the words so far lead to the command of this path, such as /golden/.\n"
                       "function __steradian_at\n"
                       "    set -l path ''\n"
                       "    set -l words (commandline -opc)\n"
                       "    set -e words[1]\n"
                       "    for word in $words\n"
                       "        if contains -- $path/$word{}\n"
                       "            set path $path/$word\n"
                       "        end\n"
                       "    end\n"
                       "    test $path/ = $argv[1]\n"
                       "end\n{}",
                       paths, lines);
}

} // namespace

void add_completion_command(CLI::App& app) {
    CLI::App* command = app.add_subcommand("completion", "print a script that completes words in a shell");
    command->add_subcommand("bash", "print the script for bash")->callback([&app] {
        write_output(bash_script(app));
    });
    command->add_subcommand("zsh", "print the script for zsh")->callback([&app] {
        write_output(zsh_script(app));
    });
    command->add_subcommand("fish", "print the script for fish")->callback([&app] {
        write_output(fish_script(app));
    });
    command->require_subcommand(1);
    command->footer("Examples:\n"
                    "  steradian completion bash > ~/.local/share/bash-completion/completions/steradian\n"
                    "  steradian completion zsh > ~/.zfunc/_steradian           (a folder of $fpath)\n"
                    "  steradian completion fish > ~/.config/fish/completions/steradian.fish");
}

} // namespace sr::cli
