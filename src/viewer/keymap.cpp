#include "viewer/keymap.hpp"

#include "core/file.hpp"
#include "core/json.hpp"
#include "viewer/config.hpp"

#include <algorithm>
#include <fmt/format.h>
#include <set>

namespace sr::viewer {
namespace {

using Pointer = JsonFile::Pointer;

/// A key of the file, and where it stands.
struct ReadBinding {
    Binding binding;
    Location place;
};

const CommandInfo& command_named(const std::string& name, const JsonFile& file, const Pointer& at) {
    for (const CommandInfo& info : all_commands())
        if (info.name == name) return info;
    throw Error(file.place_of_key(at), fmt::format("there is no command \"{}\"", name),
                "write its name as F1 lists it, or see steradian view --print-keys");
}

ReadBinding binding_at(const nlohmann::json& value, Command command, const JsonFile& file,
                       const Pointer& at) {
    if (!value.is_string())
        throw Error(file.place_of(at), "a key is no text", "write \"Ctrl Shift Z\", or a list of such texts");
    const std::string text = value.get<std::string>();
    const auto key = parse_key(text);
    if (!key)
        throw Error(
            file.place_of(at), fmt::format("there is no key \"{}\"", text),
            "write Ctrl, Alt and Shift, then a key as F1 lists it: \"Ctrl Shift Z\", \"Num 5\", \"PgUp\"");
    return {{key->first, key->second, command}, file.place_of(at)};
}

/// JSON keeps one of two members with the same name, and says nothing.
void refuse_doubles(const JsonFile& file, const std::string& text) {
    std::set<std::string> names;
    const auto look = [&](int depth, nlohmann::json::parse_event_t event, nlohmann::json& parsed) {
        if (depth != 1 || event != nlohmann::json::parse_event_t::key) return true;
        const auto name = parsed.get<std::string>();
        if (!names.insert(name).second)
            throw Error(file.place_of_key(Pointer() / name), fmt::format("\"{}\" stands here twice", name),
                        "write its keys as one list: [\"W\", \"F9\"]");
        return true;
    };
    require(nlohmann::json::parse(text, look).is_object(), "the file has been parsed already");
}

} // namespace

Keymap::Keymap() : bindings_(bindings().begin(), bindings().end()) {}

Keymap Keymap::read(const std::filesystem::path& path) {
    const std::string text = read_text(path);
    const JsonFile file(path, text);
    if (!file.root().is_object())
        throw Error(file.place_of(Pointer()), "is no object", "write {\"Frame all\": \"Ctrl Home\"}");
    refuse_doubles(file, text);
    Keymap map;
    std::vector<ReadBinding> given;
    for (const auto& [name, value] : file.root().items()) {
        const Pointer at = Pointer() / name;
        const Command command = command_named(name, file, at).command;
        std::erase_if(map.bindings_, [&](const Binding& b) { return b.command == command; });
        if (!value.is_array()) given.push_back(binding_at(value, command, file, at));
        for (std::size_t i = 0; value.is_array() && i < value.size(); ++i)
            given.push_back(binding_at(value[i], command, file, at / i));
    }
    for (const auto& [binding, place] : given) {
        const auto other = map.command_of(binding.key, binding.modifiers);
        if (other == binding.command)
            throw Error(place, fmt::format("{} stands twice in this list", keys_of(binding)), "name it once");
        if (other)
            throw Error(place,
                        fmt::format("{} is the key of \"{}\", too", keys_of(binding), info_of(*other).name),
                        "give one of the two another key, or none: []");
        map.bindings_.push_back(binding);
    }
    return map;
}

Keymap Keymap::in_use() {
    const std::filesystem::path file = keys_file();
    std::error_code ignored;
    const bool has_file =
        !file.empty() && std::filesystem::exists(std::filesystem::symlink_status(file, ignored));
    return has_file ? read(file) : Keymap();
}

std::string Keymap::text(Command command) const {
    const auto found = std::ranges::find(bindings_, command, &Binding::command);
    return found == bindings_.end() ? std::string() : keys_of(*found);
}

std::string Keymap::hint(std::string_view what, Command command) const {
    const std::string keys = text(command);
    return keys.empty() ? std::string(what) : fmt::format("{} ({})", what, keys);
}

std::optional<Command> Keymap::command_of(int key, int modifiers) const {
    const auto found = std::ranges::find_if(
        bindings_, [=](const Binding& b) { return b.key == key && b.modifiers == modifiers; });
    return found == bindings_.end() ? std::nullopt : std::optional(found->command);
}

std::string Keymap::json() const {
    nlohmann::ordered_json all = nlohmann::ordered_json::object();
    for (const CommandInfo& info : all_commands()) {
        auto keys = nlohmann::ordered_json::array();
        for (const Binding& binding : bindings_)
            if (binding.command == info.command) keys.push_back(keys_of(binding));
        all[info.name] = keys.size() == 1 ? keys[0] : keys;
    }
    std::string text;
    for (const auto& [name, keys] : all.items())
        text +=
            fmt::format("{}\n  {}: {}", text.empty() ? "{" : ",", nlohmann::json(name).dump(), keys.dump());
    return text + "\n}";
}

std::filesystem::path keys_file() {
    const std::filesystem::path folder = config_folder();
    return folder.empty() ? folder : folder / "keys.json";
}

} // namespace sr::viewer
