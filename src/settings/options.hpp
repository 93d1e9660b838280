#pragma once
// The table of options: command lines, --help, shell completion, golden suites, `render --json` and the
// attributes of pictures read it.
#include "settings/render_settings.hpp"

#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace sr::settings {

/// Commands and files that take an option; a set of bits.
enum Taker : unsigned {
    by_render = 1,
    by_view = 2,
    by_probe = 4,
    by_export = 8,
    by_info = 16,
    by_suites = 32, // a key of each test
    in_json = 64,   // a key in the summary of `render --json`
    by_illuminance = 128,
};

/// A word that an option takes.
struct Word {
    std::string_view name;
    std::string_view what{}; // it means; empty where the option's help says so
};

/// Form of an option's text, and its conversion into the settings and back.
struct Value {
    enum class Kind { text, number, whole, flag, list }; // list: may be repeated
    Kind kind = Kind::text;
    const char* type = ""; // of a text, as --help shows it: "WIDTHxHEIGHT"
    double min = 0.0;      // of a number
    double max = 0.0;
    std::vector<Word> (*words)() = nullptr; // null: any text of the type
    /// Takes over `text`, of a list one entry more. Returns false if it is no such value. A flag ignores it.
    bool (*read)(const Value& value, RenderSettings& settings, const std::string& text) = nullptr;
    /// Returns the text that read() takes over; empty if the value is absent or the flag is off.
    std::string (*write)(const RenderSettings& settings) = nullptr;
    /// Returns the texts of a list, one for each entry; null for other values.
    std::vector<std::string> (*entries)(const RenderSettings& settings) = nullptr;
};

/// Attribute of a picture's file, "steradian:NAME".
struct OptionAttribute {
    const char* name = nullptr;                           // null: none
    std::string (*text)(const RenderSettings&) = nullptr; // empty: left out; null: as Value::write
};

/// Returns "--exr-type" for the key exr_type.
std::string flag_of(std::string_view key);

struct Option {
    const char* key;   // in suites and JSON
    const char* group; // heading in --help
    unsigned takers;   // Taker
    Value value;
    const char* help;
    const char* view_help = nullptr; // of `view`, where it means something else there
    OptionAttribute attribute{};

    std::string flag() const { return flag_of(key); }
};

/// All options, in the order of --help.
std::span<const Option> all_options();

/// Returns the type that --help shows: "WIDTHxHEIGHT", "auto|egl|window", "1..32".
std::string type_of(const Value& value);

/// Returns what is allowed, for messages: "a whole number from 1 to 32".
std::string allowed_by(const Value& value);

/// Returns a word as shells take it: in quotes, if it has other letters than a name, a number or a path.
std::string shell_word(const std::string& word);

/// Returns the options that make a picture as `render` takes them, each after a space: those that are not the
/// default. Scene, outputs and checks of the driver are not among them.
std::string render_arguments(const RenderSettings& settings);

/// Returns the text of the default; empty if the option has none.
std::string default_of(const Option& option);

} // namespace sr::settings
