#include "cli/arguments.hpp"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <fmt/format.h>
#include <utility>

namespace sr::cli {
namespace {

using settings::Option;

/// The help of an option, with the words that its type does not name.
std::string help_of(const Option& option, settings::Taker taker) {
    std::string text = taker == settings::by_view && option.view_help ? option.view_help : option.help;
    if (!option.value.words || !*option.value.type) return text;
    const char* separator = ": ";
    for (const settings::Word& word : option.value.words()) {
        text += fmt::format("{}{}", std::exchange(separator, ", "), word.name);
        if (!word.what.empty()) text += fmt::format(" ({})", word.what);
    }
    return text;
}

void take_over(const Option& option, RenderSettings& settings, const std::string& text) {
    if (!option.value.read(option.value, settings, text))
        throw CLI::ValidationError(option.flag(),
                                   fmt::format("'{}' is not {}", text, settings::allowed_by(option.value)));
}

} // namespace

void declare(CLI::App& command, settings::Taker taker, RenderSettings& settings) {
    for (const Option& option : settings::all_options()) {
        if (!(option.takers & taker)) continue;
        const auto take = [&option, &settings](const std::string& text) {
            take_over(option, settings, text);
        };
        const std::string flag = option.flag(), help = help_of(option, taker);
        CLI::Option* declared = nullptr;
        if (option.value.kind == settings::Value::Kind::flag)
            declared = command.add_flag_callback(
                flag, [take] { take(""); }, help);
        else if (option.value.kind == settings::Value::Kind::list)
            declared = command
                           .add_option_function<std::vector<std::string>>(
                               flag, [take](const auto& texts) { std::ranges::for_each(texts, take); }, help)
                           ->allow_extra_args(false);
        else
            declared = command.add_option_function<std::string>(flag, take, help);
        declared->group(option.group);
        if (option.value.kind == settings::Value::Kind::flag) continue;
        declared->type_name(settings::type_of(option.value));
        if (taker != settings::by_view || !option.view_help)
            declared->default_str(settings::default_of(option));
    }
}

std::string refusal_of_number(const std::string& text) {
    return std::isfinite(std::strtod(text.c_str(), nullptr)) ? "" : "'" + text + "' is not a finite number";
}

} // namespace sr::cli
