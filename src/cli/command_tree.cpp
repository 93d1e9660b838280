#include "cli/command_tree.hpp"

#include "settings/options.hpp"

#include <CLI/CLI.hpp>

namespace sr::cli {

std::vector<const CLI::App*> listed_subcommands(const CLI::App& command) {
    return command.get_subcommands([](const CLI::App* sub) { return !sub->get_group().empty(); });
}

std::vector<const CLI::Option*> listed_options(const CLI::App& command) {
    return command.get_options(
        [](const CLI::Option* option) { return option->nonpositional() && !option->get_group().empty(); });
}

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

} // namespace sr::cli
