#include "glsl/loops.hpp"

#include "glsl/tokens.hpp"

#include <algorithm>
#include <fmt/format.h>
#include <map>
#include <optional>
#include <set>
#include <vector>

namespace sr::glsl {
namespace {

/// Tokens first to end, the last not among them.
struct Range {
    std::size_t first = 0;
    std::size_t end = 0;
};

/// The head of a loop.
struct Head {
    Range initial, test, step;
    std::size_t behind = 0; // the token behind its bracket
};

class Inversion {
public:
    explicit Inversion(std::string_view text) : text_(text), tokens_(tokenize(text, "shader")) {
        for (std::size_t i = 0; i + 2 < tokens_.size(); ++i)
            if (is(i, "const") && (is(i + 1, "int") || is(i + 1, "uint")))
                constants_.insert(tokens_[i + 2].text);
    }

    std::string inverted() {
        for (std::size_t i = 0; i < tokens_.size();) i = is(i, "{") ? behind_statement(i) : i + 1;
        std::string result;
        std::size_t at = 0;
        for (const auto& [place, edit] : edits_) {
            result.append(text_.substr(at, place - at)) += edit.inserted;
            at = place + edit.erased;
        }
        return result += text_.substr(at);
    }

private:
    struct Edit {
        std::size_t erased = 0; // bytes
        std::string inserted;
    };

    bool is(std::size_t i, std::string_view text) const {
        return i < tokens_.size() && !tokens_[i].is_directive && tokens_[i].text == text;
    }
    std::size_t behind_bracket_at(std::size_t i) const {
        return is(i, "(") ? behind_bracket(tokens_, i, tokens_.size()) : i;
    }

    /// Returns the token behind the statement that begins with token `i`, whose loops it inverts.
    std::size_t behind_statement(std::size_t i) {
        if (is(i, "{")) {
            const std::size_t end = behind_bracket(tokens_, i, tokens_.size());
            for (std::size_t j = i + 1; j + 1 < end;) j = behind_statement(j);
            return end;
        }
        if (is(i, "if")) {
            const std::size_t then = behind_statement(behind_bracket_at(i + 1));
            return is(then, "else") ? behind_statement(then + 1) : then;
        }
        if (is(i, "for") || is(i, "while")) return behind_loop(i);
        if (is(i, "do")) return behind_bracket_at(behind_statement(i + 1) + 1) + 1;
        if (is(i, "switch")) return behind_statement(behind_bracket_at(i + 1));
        if (i < tokens_.size() && tokens_[i].is_directive) return i + 1;
        const std::string_view end = is(i, "case") || is(i, "default") ? ":" : ";";
        while (i < tokens_.size() && !is(i, end) && !is(i, "}"))
            i = is(i, "(") || is(i, "[") || is(i, "{") ? behind_bracket(tokens_, i, tokens_.size()) : i + 1;
        return i + 1;
    }

    std::size_t behind_loop(std::size_t i) {
        const std::optional<Head> head = head_of(i);
        const std::size_t body = head ? head->behind : i + 1;
        const std::size_t end = behind_statement(body);
        if (!head || counts_to_a_constant(*head) || !is_plain({i, body + 1})) return end;
        if (end > tokens_.size() || (!is(end - 1, ";") && !is(end - 1, "}"))) return end; // it has no end
        const std::string test = head->test.first == head->test.end ? "true" : text_of(head->test);
        const std::string step = text_of(head->step);
        const std::size_t first = tokens_[i].at, behind = tokens_[body - 1].at + 1;
        edits_[first].erased = behind - first;
        edits_[first].inserted += fmt::format("{{ {}; if ({}) do {}", text_of(head->initial), test,
                                              lines_of(text_.substr(first, behind - first)));
        edits_[tokens_[end - 1].at + 1].inserted +=
            fmt::format(" while (({}{}{})); }}", step, step.empty() ? "" : ", ", test);
        return end;
    }

    std::optional<Head> head_of(std::size_t i) const {
        const std::size_t behind = behind_bracket_at(i + 1);
        if (behind < i + 3) return std::nullopt;
        const Range all{i + 2, behind - 1};
        if (is(i, "while")) return Head{{all.first, all.first}, all, {all.end, all.end}, behind};
        std::vector<std::size_t> stops;
        for (std::size_t j = all.first; j < all.end;) {
            if (is(j, ";")) stops.push_back(j);
            j = is(j, "(") || is(j, "[") ? behind_bracket(tokens_, j, all.end) : j + 1;
        }
        if (stops.size() != 2) return std::nullopt;
        return Head{{all.first, stops[0]}, {stops[0] + 1, stops[1]}, {stops[1] + 1, all.end}, behind};
    }

    /// `i < 3` or `i <= n` with a constant n, and a variable of the loop's own.
    bool counts_to_a_constant(const Head& head) const {
        if (head.initial.first == head.initial.end || head.test.end < head.test.first + 3) return false;
        const Token& last = tokens_[head.test.end - 1];
        const bool is_simple = std::all_of(
            tokens_.begin() + static_cast<std::ptrdiff_t>(head.test.first) + 1,
            tokens_.begin() + static_cast<std::ptrdiff_t>(head.test.end) - 1,
            [](const Token& token) { return token.text == "<" || token.text == ">" || token.text == "="; });
        return is_simple && (last.kind == Token::Kind::number || constants_.contains(last.text));
    }

    bool is_plain(Range range) const {
        return std::none_of(tokens_.begin() + static_cast<std::ptrdiff_t>(range.first),
                            tokens_.begin()
                                + static_cast<std::ptrdiff_t>(std::min(range.end, tokens_.size())),
                            [](const Token& token) { return token.is_directive; });
    }

    /// The tokens on one line, without comments.
    std::string text_of(Range range) const {
        std::string text;
        for (std::size_t i = range.first; i < range.end; ++i) {
            const bool touches =
                i > range.first && tokens_[i - 1].at + tokens_[i - 1].text.size() == tokens_[i].at;
            if (!text.empty() && !touches) text += ' ';
            text += tokens_[i].text;
        }
        return text;
    }

    static std::string lines_of(std::string_view text) {
        return std::string(static_cast<std::size_t>(std::ranges::count(text, '\n')), '\n');
    }

    std::string_view text_;
    std::vector<Token> tokens_;
    std::set<std::string_view> constants_; // integers
    std::map<std::size_t, Edit> edits_;    // by the first byte
};

} // namespace

std::string invert_loops(std::string_view text) { return Inversion(text).inverted(); }

} // namespace sr::glsl
