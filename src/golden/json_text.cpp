#include "golden/json_text.hpp"

#include "core/json_scan.hpp"
#include "core/limits.hpp"
#include "golden/bytes_of_file.hpp"

#include <algorithm>
#include <vector>

namespace sr::golden {
namespace {

using nlohmann::json;

constexpr int deepest = 64; // no suite needs more, and a recursive reader has a stack to lose

/// Walks a text that is known to be valid JSON.
class Walker {
public:
    explicit Walker(std::string_view text) : text_(text) { skip_space(); }

    std::size_t position() const { return at_; }

    /// Moves to the member `key` of the object, or to the element `key` of the array, that begins here.
    bool enter(const std::string& key) {
        const bool is_object = text_[at_] == '{';
        if (!is_object && text_[at_] != '[') return false;
        ++at_;
        for (std::size_t index = 0; skip_space(), text_[at_] != '}' && text_[at_] != ']'; ++index) {
            std::string name = std::to_string(index);
            if (is_object) {
                const std::size_t begin = at_;
                skip_string();
                name = json::parse(text_.substr(begin, at_ - begin)).get<std::string>();
                skip_to_value();
            }
            if (name == key) return true;
            skip_value();
            skip_space();
            if (text_[at_] == ',') ++at_;
        }
        return false;
    }

private:
    void skip_space() { at_ = std::min(text_.find_first_not_of(" \t\r\n", at_), text_.size()); }
    void skip_to_value() {
        at_ = text_.find(':', at_) + 1;
        skip_space();
    }
    void skip_string() {
        for (++at_; text_[at_] != '"'; ++at_)
            if (text_[at_] == '\\') ++at_;
        ++at_;
    }
    void skip_value() {
        int depth = 0;
        do {
            const char c = text_[at_];
            if (c == '"') {
                skip_string();
                continue;
            }
            if (c == '{' || c == '[') ++depth;
            if (c == '}' || c == ']') --depth;
            if (depth < 0) return; // the end of the container around a number or a word
            ++at_;
        } while (depth > 0
                 || (at_ < text_.size() && text_[at_] != ',' && text_[at_] != '}' && text_[at_] != ']'));
    }

    std::string_view text_;
    std::size_t at_ = 0;
};

/// nlohmann's message without its own numbering: "syntax error while parsing value - unexpected …".
std::string reason(const json::parse_error& error) {
    const std::string text = error.what();
    const auto dash = text.find(" - ");
    const auto colon = text.find(": ");
    if (dash != std::string::npos) return text.substr(dash + 3);
    return colon != std::string::npos ? text.substr(colon + 2) : text;
}

} // namespace

JsonText::JsonText(const std::filesystem::path& file) : JsonText(file, bytes_of_file(file)) {}

JsonText::JsonText(const std::filesystem::path& file, std::string text)
    : file_(file.string()), text_(std::move(text)) {
    const JsonExtent extent = json_extent(text_);
    check_limit(Limit::json_values, extent.values, file_);
    if (extent.depth > deepest)
        throw Error({file_}, "nested deeper than 64 levels", "a suite is two levels of lists and objects");
    try {
        root_ = json::parse(text_);
    } catch (const json::parse_error& error) {
        throw Error(place_of(error.byte > 0 ? error.byte - 1 : 0), reason(error), "correct the JSON there");
    } catch (const json::exception&) {
        throw Error(place_of(overflowing_number(text_).value_or(0)), "a number that is too large",
                    "write one below 1.8e308");
    }
}

Location JsonText::place_of(std::size_t byte) const {
    const auto end = text_.begin() + static_cast<std::ptrdiff_t>(std::min(byte, text_.size()));
    const auto line = std::count(text_.begin(), end, '\n') + 1;
    const auto last_break = text_.substr(0, static_cast<std::size_t>(end - text_.begin())).rfind('\n');
    const auto column = (end - text_.begin())
                        - (last_break == std::string::npos ? -1 : static_cast<std::ptrdiff_t>(last_break));
    return {file_, static_cast<int>(line), static_cast<int>(column)};
}

Location JsonText::place_of(const json::json_pointer& pointer) const {
    std::vector<std::string> keys;
    for (json::json_pointer rest = pointer; !rest.empty(); rest.pop_back()) keys.push_back(rest.back());
    Walker walker(text_);
    for (auto key = keys.rbegin(); key != keys.rend(); ++key)
        if (!walker.enter(*key)) break;
    return place_of(walker.position());
}

} // namespace sr::golden
