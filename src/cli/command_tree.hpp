#pragma once
// The commands and options of the command line as text: for shell completion and the manual.
#include <string>
#include <vector>

namespace CLI {
class App;
class Option;
} // namespace CLI

namespace sr::cli {

/// Returns the subcommands that --help lists, in its order.
std::vector<const CLI::App*> listed_subcommands(const CLI::App& command);

/// Returns the options that --help lists, positional ones excluded, in its order.
std::vector<const CLI::Option*> listed_options(const CLI::App& command);

/// Returns the values of an option: the words of the table of options, or those of its type "auto|egl".
/// Empty if it takes any text.
std::vector<std::string> values_of(const CLI::Option& option);

} // namespace sr::cli
