#include "glsl/tokens.hpp"

#include "core/error.hpp"
#include "core/text.hpp"

#include <algorithm>
#include <fmt/format.h>

namespace sr::glsl {
namespace {

bool is_letter(char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_'; }
bool is_digit(char c) { return c >= '0' && c <= '9'; }

/// @throws Error for bytes that are not UTF-8, for NUL and for lines that go on
void require_plain_text(std::string_view text, const std::string& place) {
    int line = 1;
    for (std::size_t i = 0; i < text.size();) {
        const std::size_t length = utf8_length(text.substr(i));
        if (length == 0)
            throw Error({place, line},
                        fmt::format("the byte {:#04x} is not UTF-8", static_cast<unsigned char>(text[i])),
                        "save the file as UTF-8");
        if (text[i] == '\0') throw Error({place, line}, "a NUL byte", "remove it: a shader is text");
        if (text[i] == '\\' && (i + 1 == text.size() || text[i + 1] == '\n'))
            throw Error({place, line}, "a line ends in \\", "write it as one line");
        if (text[i] == '\n') ++line;
        i += length;
    }
}

class Lexer {
public:
    Lexer(std::string_view text, const std::string& place) : text_(text), place_(place) {}

    std::vector<Token> tokens() {
        while (at_ < text_.size()) step();
        return std::move(tokens_);
    }

private:
    void step() {
        const char c = text_[at_];
        const std::string_view two = text_.substr(at_, 2);
        if (two == "//") {
            at_ = std::min(text_.find('\n', at_), text_.size());
        } else if (two == "/*") {
            skip_comment();
        } else if (c == '\n') {
            is_line_empty_ = true;
            is_directive_ = false;
            ++line_;
            ++at_;
        } else if (c == ' ' || c == '\t' || c == '\v' || c == '\f') {
            ++at_;
        } else {
            take(c);
            is_line_empty_ = false;
        }
    }

    void skip_comment() {
        const std::size_t end = text_.find("*/", at_ + 2);
        if (end == text_.npos) throw Error({place_, line_}, "this comment never ends", "close it with */");
        line_ += static_cast<int>(std::ranges::count(text_.substr(at_, end - at_), '\n'));
        at_ = end + 2;
    }

    void take(char c) {
        const bool begins = is_line_empty_ && c == '#';
        if (begins) is_directive_ = true;
        std::size_t end = at_ + 1;
        Token::Kind kind = Token::Kind::sign;
        if (is_letter(c)) {
            kind = Token::Kind::word;
            while (end < text_.size() && (is_letter(text_[end]) || is_digit(text_[end]))) ++end;
        } else if (is_digit(c) || (c == '.' && end < text_.size() && is_digit(text_[end]))) {
            kind = Token::Kind::number;
            while (end < text_.size() && is_part_of_number(end)) ++end;
        } else if (c == '"' && is_directive_) {
            kind = Token::Kind::name;
            end = std::min(text_.find_first_of("\"\n", end), text_.size());
            if (end < text_.size() && text_[end] == '"') ++end;
        } else if (std::string_view("#+-*/%<>=!&|^~?:;,.(){}[]").find(c) == std::string_view::npos) {
            throw Error({place_, line_},
                        fmt::format("'{}' outside a comment",
                                    shown(text_.substr(at_, utf8_length(text_.substr(at_))))),
                        "GLSL has no such character: remove it");
        }
        tokens_.push_back({kind, text_.substr(at_, end - at_), at_, line_, is_directive_, begins});
        at_ = end;
    }

    bool is_part_of_number(std::size_t i) const {
        if (is_letter(text_[i]) || is_digit(text_[i]) || text_[i] == '.') return true;
        return (text_[i] == '+' || text_[i] == '-') && (text_[i - 1] == 'e' || text_[i - 1] == 'E')
               && !text_.substr(at_).starts_with("0x") && !text_.substr(at_).starts_with("0X");
    }

    std::string_view text_;
    const std::string& place_;
    std::vector<Token> tokens_;
    std::size_t at_ = 0;
    int line_ = 1;
    bool is_line_empty_ = true; // so far, comments left out
    bool is_directive_ = false;
};

} // namespace

std::vector<Token> tokenize(std::string_view text, const std::string& place) {
    require_plain_text(text, place);
    return Lexer(text, place).tokens();
}

std::size_t behind_bracket(const std::vector<Token>& tokens, std::size_t open, std::size_t end) {
    int depth = 0;
    for (std::size_t i = open; i < end; ++i) {
        const std::string_view text = tokens[i].text;
        if (text == "(" || text == "[" || text == "{") ++depth;
        if ((text == ")" || text == "]" || text == "}") && --depth == 0) return i + 1;
    }
    return end;
}

} // namespace sr::glsl
