#include "assignment/code_changes.hpp"

#include "assignment/regions.hpp"
#include "core/text.hpp"

#include <array>
#include <cctype>
#include <optional>
#include <regex>
#include <sstream>
#include <string_view>
#include <utility>

namespace sr::assignment {
namespace {

constexpr std::size_t max_line = 400; // longer lines are no handwriting; std::regex recurses

bool is_word(char c) { return std::isalnum(static_cast<unsigned char>(c)) || c == '_'; }

/// The offset behind the bracket that closes the one at `open`; npos if it is not on this line.
std::size_t behind_partner(const std::string& line, std::size_t open) {
    int depth = 0;
    for (std::size_t i = open; i < line.size(); ++i) {
        if (line[i] == '(' || line[i] == '[') ++depth;
        if ((line[i] == ')' || line[i] == ']') && --depth == 0) return i + 1;
    }
    return std::string::npos;
}

/// A call on one line: [begin, end), and its arguments.
struct Call {
    std::size_t begin = 0, end = 0;
    std::vector<std::string> arguments;
};

std::vector<Call> calls_of(const std::string& line, const std::string& function) {
    std::vector<Call> calls;
    for (std::size_t at = line.find(function + "("); at != std::string::npos;
         at = line.find(function + "(", at + 1)) {
        const std::size_t open = at + function.size();
        const std::size_t end = behind_partner(line, open);
        if ((at > 0 && is_word(line[at - 1])) || end == std::string::npos) continue;
        Call call{at, end, {""}};
        int depth = 0;
        for (std::size_t i = open + 1; i + 1 < end; ++i) {
            if (line[i] == '(' || line[i] == '[') ++depth;
            if (line[i] == ')' || line[i] == ']') --depth;
            if (line[i] == ',' && depth == 0)
                call.arguments.emplace_back();
            else
                call.arguments.back() += line[i];
        }
        for (std::string& argument : call.arguments) argument = std::string(trimmed(argument));
        calls.push_back(call);
    }
    return calls;
}

bool is_zero(const std::string& text) {
    static const std::regex form(R"((vec[234]\()?0(\.0*)?\)?)");
    return std::regex_match(text, form);
}

/// The end of the factor that begins at `at`: a name or a number with calls, indices and members, or
/// brackets. Absent if none begins there.
std::optional<std::size_t> factor_end(const std::string& line, std::size_t at) {
    std::size_t i = at;
    while (i < line.size() && (is_word(line[i]) || line[i] == '.')) ++i;
    if (i == at && (i >= line.size() || line[i] != '(')) return std::nullopt;
    while (i < line.size() && (line[i] == '(' || line[i] == '[' || line[i] == '.' || is_word(line[i]))) {
        if (line[i] == '(' || line[i] == '[')
            i = behind_partner(line, i);
        else
            ++i;
        if (i == std::string::npos) return std::nullopt;
    }
    return i;
}

/// Collects the changes of one line.
class LineChanges {
public:
    LineChanges(const std::string& line, int number, std::vector<CodeChange>& changes)
        : line_(line), number_(number), changes_(changes) {}

    void add_all() {
        remove_max();
        drop_factors();
        for (const Call& call : calls_of(line_, "pow"))
            if (call.arguments.size() == 2)
                add("power_off_by_one", call.begin, call.end,
                    "pow(" + call.arguments[0] + ", " + call.arguments[1] + " + 1.0)");
        for (const Call& call : calls_of(line_, "dot"))
            if (call.arguments.size() == 2 && call.arguments[0] == call.arguments[1])
                add("power_off_by_one", call.begin, call.end, "length(" + call.arguments[0] + ")");
        swap_wi_and_wo();
        constexpr std::array<std::pair<const char*, const char*>, 2> signs{{{" - ", " + "}, {" + ", " - "}}};
        for (const auto& [from, to] : signs) replace_each("other_sign", from, to);
        if (line_.find("for (") == std::string::npos && line_.find("while (") == std::string::npos) {
            constexpr std::array<std::pair<const char*, const char*>, 4> comparisons{
                {{" < ", " > "}, {" > ", " < "}, {" <= ", " >= "}, {" >= ", " <= "}}};
            for (const auto& [from, to] : comparisons) replace_each("other_comparison", from, to);
        }
    }

private:
    void add(const char* name, std::size_t begin, std::size_t end, const std::string& replacement) {
        std::string to = line_;
        to.replace(begin, end - begin, replacement);
        if (trimmed(to) == trimmed(line_)) return;
        changes_.push_back({name, number_, std::string(trimmed(line_)), std::string(trimmed(to)),
                            std::string(trimmed(line_.substr(begin, end - begin)))});
    }

    /// max(0, x), max(x, 0) and clamp(x, 0, 1) become (x).
    void remove_max() {
        for (const Call& call : calls_of(line_, "max")) {
            if (call.arguments.size() != 2) continue;
            if (is_zero(call.arguments[0]))
                add("remove_max", call.begin, call.end, "(" + call.arguments[1] + ")");
            else if (is_zero(call.arguments[1]))
                add("remove_max", call.begin, call.end, "(" + call.arguments[0] + ")");
        }
        for (const Call& call : calls_of(line_, "clamp"))
            if (call.arguments.size() == 3 && is_zero(call.arguments[1]))
                add("remove_max", call.begin, call.end, "(" + call.arguments[0] + ")");
    }

    void drop_factors() {
        for (std::size_t i = 1; i + 1 < line_.size(); ++i) {
            if ((line_[i] != '*' && line_[i] != '/') || line_[i + 1] == '=') continue;
            std::size_t begin = i;
            while (begin > 0 && line_[begin - 1] == ' ') --begin;
            const std::size_t factor = line_.find_first_not_of(' ', i + 1);
            if (factor == std::string::npos) continue;
            if (const auto end = factor_end(line_, factor)) add("drop_factor", begin, *end, "");
        }
    }

    void swap_wi_and_wo() {
        static const std::regex form(R"(\bw[io]\b)");
        std::string swapped = line_;
        for (std::sregex_iterator i(line_.begin(), line_.end(), form), last; i != last; ++i) {
            char& letter = swapped[static_cast<std::size_t>(i->position()) + 1];
            letter = letter == 'i' ? 'o' : 'i';
        }
        // A signature or a declaration of one of them would rename it.
        static const std::regex declares(R"(\b(float|vec[234])\s+w[io]\b)");
        if (!std::regex_search(line_, declares)) add("swap_wi_wo", 0, line_.size(), swapped);
    }

    void replace_each(const char* name, const std::string& from, const std::string& to) {
        for (std::size_t at = line_.find(from); at != std::string::npos; at = line_.find(from, at + 1))
            add(name, at, at + from.size(), to);
    }

    const std::string& line_;
    int number_;
    std::vector<CodeChange>& changes_;
};

} // namespace

std::vector<CodeChange> code_changes(const Code& code) {
    std::vector<CodeChange> changes;
    std::istringstream lines(without_comments(code.text));
    int number = code.line;
    for (std::string line; std::getline(lines, line); ++number) {
        const std::string content(trimmed(line));
        if (content.empty() || content.starts_with('#') || content.size() > max_line) continue;
        LineChanges(line, number, changes).add_all();
    }
    return changes;
}

Code changed(const Code& code, const CodeChange& change) {
    Code result = code;
    std::size_t begin = 0;
    for (int line = code.line; line < change.line && begin != std::string::npos; ++line)
        begin = code.text.find('\n', begin) + 1; // npos + 1 is 0: not for a change of this code
    const std::size_t end = code.text.find('\n', begin);
    const std::string line = code.text.substr(begin, end - begin);
    const std::string indentation = line.substr(0, std::min(line.size(), line.find_first_not_of(" \t")));
    result.text.replace(begin, line.size(), indentation + change.to);
    return result;
}

} // namespace sr::assignment
