#include "glsl/untrusted.hpp"

#include "core/text.hpp"
#include "glsl/call_costs.hpp"
#include "glsl/declarations.hpp"
#include "glsl/macros.hpp"
#include "glsl/tokens.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <fmt/format.h>
#include <map>
#include <set>

namespace sr::glsl {
namespace {

using Kind = Token::Kind;

constexpr std::size_t max_lines = 5'000, max_line_bytes = 2'000, max_tokens = 50'000;
constexpr std::size_t max_word_bytes = 128;
constexpr std::size_t max_nesting = 64;      // of brackets
constexpr std::size_t max_statement = 2'000; // tokens between ; { and }
constexpr std::size_t max_branches = 500;    // `else`, `if`, `case` of a file
constexpr double max_index = 4'096;          // a number in [ ]

constexpr std::array allowed_directives{"include", "define", "undef", "if",   "ifdef",
                                        "ifndef",  "elif",   "else",  "endif"};
constexpr std::array flow_words{"for",     "while", "do",       "if",     "else",    "switch", "case",
                                "default", "break", "continue", "return", "discard", "struct", "const"};
constexpr std::array refused_words{"layout",    "uniform",       "buffer",     "shared",       "coherent",
                                   "volatile",  "restrict",      "readonly",   "writeonly",    "attribute",
                                   "varying",   "subroutine",    "main",       "asm",          "goto",
                                   "barrier",   "memoryBarrier", "EmitVertex", "EndPrimitive", "precision",
                                   "invariant", "sample",        "patch"};

template<std::size_t N>
bool is_one_of(std::string_view text, const std::array<const char*, N>& words) {
    return std::ranges::find(words, text) != words.end();
}

bool is_loop(const Token& token) {
    return !token.is_directive && (token.text == "for" || token.text == "while");
}

/// FNV-1a, 20 bits of it, never 0.
int number_of(const std::string& place) {
    std::uint32_t hash = 2166136261u;
    for (const char c : place) hash = (hash ^ static_cast<unsigned char>(c)) * 16777619u;
    const std::uint32_t folded = (hash >> 20) ^ (hash & 0xfffffu);
    return folded == 0 ? 1 : static_cast<int>(folded);
}

double number(std::string_view text) {
    try {
        return std::stod(std::string(text)); // decimal and hexadecimal; an octal number is only larger
    } catch (const std::exception&) {
        return HUGE_VAL;
    }
}

/// Checks lengths and nesting of code whose macros are written out.
void require_statements(const std::vector<Token>& code, const std::string& place) {
    const auto refuse = [&](int line, const std::string& what, const std::string& what_to_do) {
        throw Error({place, line}, what, what_to_do);
    };
    std::size_t length = 0, branches = 0;
    std::vector<char> open;
    for (std::size_t i = 0; i < code.size(); ++i) {
        const Token& token = code[i];
        const std::string_view text = token.text;
        if (text == "(" || text == "[" || text == "{") open.push_back(text[0]);
        if (open.size() > max_nesting) refuse(token.line, "brackets nested deeper than 64", "nest less");
        if ((text == ")" || text == "]" || text == "}") && !open.empty()) open.pop_back();
        const bool is_inside = !open.empty() && open.back() != '{'; // of ( ) or [ ]
        length = (text == ";" && !is_inside) || text == "{" || text == "}" ? 0 : length + 1;
        if (length > max_statement)
            refuse(token.line, fmt::format("a statement of more than {} words", max_statement),
                   "write several");
        if (text == "else" || text == "if" || text == "case" || text == "?") ++branches;
        if (branches > max_branches)
            refuse(token.line, fmt::format("more than {} branches", max_branches), "write less");
        if ((text == "in" || text == "out" || text == "inout") && !is_inside)
            refuse(token.line, fmt::format("{} outside a function's parameters", text),
                   "pass it as a parameter");
        if (!open.empty() && open.back() == '[' && token.kind == Kind::number
            && std::abs(number(text)) > max_index)
            refuse(token.line, fmt::format("[{}] is above {}", text, max_index), "write a smaller number");
    }
}

class Gate {
public:
    Gate(std::string_view text, const std::string& place, std::span<const std::string> permitted)
        : text_(text), place_(place), permitted_(permitted) {}

    Bounded pass() {
        require_size();
        tokens_ = tokenize(text_, place_);
        if (tokens_.size() > max_tokens)
            refuse(1, fmt::format("{} tokens, above {}", tokens_.size(), max_tokens), "write less");
        require_brackets();
        std::vector<Token> part; // of the code, up to a directive
        for (std::size_t i = 0; i < tokens_.size(); ++i) {
            require_word(tokens_[i]);
            if (tokens_[i].begins_line) {
                write_out(std::move(part));
                part.clear();
                read_directive(i);
            }
            if (!tokens_[i].is_directive) part.push_back(tokens_[i]);
        }
        write_out(std::move(part));
        require_statements(code_, place_);
        require_own_names(code_, place_);
        require_low_costs(code_, place_);
        return with_bounds();
    }

private:
    [[noreturn]] void refuse(int line, const std::string& what, const std::string& what_to_do) const {
        throw Error({place_, line}, what, what_to_do);
    }

    void require_size() const {
        if (text_.size() > max_untrusted_bytes)
            refuse(1, "larger than 256 KiB", "hand in what you wrote alone");
        int line = 1;
        for (std::size_t begin = 0; begin < text_.size(); ++line) {
            const std::size_t end = std::min(text_.find('\n', begin), text_.size());
            if (end - begin > max_line_bytes)
                refuse(line, fmt::format("a line of {} bytes, above {}", end - begin, max_line_bytes),
                       "break it");
            begin = end + 1;
        }
        if (line > static_cast<int>(max_lines) + 1)
            refuse(line, fmt::format("{} lines, above {}", line - 1, max_lines), "write less");
    }

    /// Brackets have partners, whichever branch of a conditional is compiled; directives stand outside ( ).
    void require_brackets() const {
        std::vector<const Token*> open;
        std::vector<std::size_t> conditions; // how many brackets were open at each #if
        for (std::size_t i = 0; i < tokens_.size(); ++i) {
            const Token& token = tokens_[i];
            const char c = token.text[0];
            if (token.begins_line) {
                if (!open.empty() && open.back()->text != "{")
                    refuse(token.line, "a directive inside brackets", "put it outside");
                const std::string_view name = i + 1 < tokens_.size() ? tokens_[i + 1].text : "";
                if (name.starts_with("if")) conditions.push_back(open.size());
                const bool is_branch = name == "elif" || name == "else" || name == "endif";
                if (is_branch && (conditions.empty() || conditions.back() != open.size()))
                    refuse(token.line, fmt::format("#{} where other brackets are open than at its #if", name),
                           "close in each branch what it opens");
                if (name == "endif") conditions.pop_back();
            }
            if (token.is_directive || token.kind != Kind::sign) continue;
            if (c == '(' || c == '[' || c == '{') {
                open.push_back(&token);
                if (open.size() > max_nesting)
                    refuse(token.line, "brackets nested deeper than 64", "nest less");
            }
            if (c != ')' && c != ']' && c != '}') continue;
            const char partner = c == ')' ? '(' : c == ']' ? '[' : '{';
            if (open.empty()) refuse(token.line, fmt::format("{} has no partner", c), "count the brackets");
            if (open.back()->text[0] != partner)
                refuse(open.back()->line, fmt::format("{} has no partner", open.back()->text),
                       "count the brackets");
            open.pop_back();
        }
        if (!open.empty())
            refuse(open.back()->line, fmt::format("{} has no partner", open.back()->text),
                   "count the brackets");
    }

    void write_out(std::vector<Token> part) {
        const std::vector<Token> written = written_out(std::move(part), macros_, place_, steps_);
        code_.insert(code_.end(), written.begin(), written.end());
        if (code_.size() > max_written_tokens)
            refuse(code_.back().line,
                   fmt::format("more than {} tokens once macros are written out", max_written_tokens),
                   "write less");
    }

    std::vector<Token> rest_of_directive(std::size_t hash) const {
        std::vector<Token> rest;
        for (std::size_t i = hash + 1;
             i < tokens_.size() && tokens_[i].is_directive && !tokens_[i].begins_line; ++i)
            rest.push_back(tokens_[i]);
        return rest;
    }

    void read_directive(std::size_t hash) {
        const std::vector<Token> words = rest_of_directive(hash);
        const int line = tokens_[hash].line;
        const std::string name(words.empty() ? "" : words[0].text);
        if (!is_one_of(name, allowed_directives))
            refuse(line, fmt::format("#{} is not allowed", name), "remove it");
        // The lexer takes text in quotes as one token. To the driver a macro's is code.
        if (name != "include"
            && std::ranges::any_of(words, [](const Token& w) { return w.kind == Kind::name; }))
            refuse(line, fmt::format("text in quotes in a #{}", name), "remove it: GLSL has no texts");
        if (name == "include") require_include(words, line);
        read_condition(words);
        if (name != "define" && name != "undef") return;
        // A macro must be known without the driver's conditions.
        if (std::ranges::find(certain_, false) != certain_.end())
            refuse(line, fmt::format("a #{} that depends on a condition", name), "put it outside of #if");
        if (name == "define") return read_macro(words, line);
        if (words.size() != 2 || !macros_.contains(words[1].text))
            refuse(line, "#undef of what this file does not define", "remove it");
        macros_.erase(words[1].text);
    }

    /// Follows #if and its branches. Their conditions are written out by the driver, too.
    void read_condition(const std::vector<Token>& words) {
        const std::string_view name = words[0].text;
        if (name.starts_with("if")) // #ifndef of what this file has not defined is true
            certain_.push_back(name == "ifndef" && words.size() == 2 && !defined_.contains(words[1].text)
                               && !words[1].text.starts_with("GL_"));
        if (name == "elif" || name == "else") certain_.back() = false;
        if (name == "endif") certain_.pop_back();
        if (name != "if" && name != "elif") return;
        std::vector<Token> condition;
        for (std::size_t i = 1; i < words.size(); ++i) {
            if (words[i].text == "defined")
                i += i + 1 < words.size() && words[i + 1].text == "(" ? 2 : 1;
            else
                condition.push_back(words[i]);
        }
        written_out(std::move(condition), macros_, place_, steps_);
    }

    void require_include(const std::vector<Token>& words, int line) const {
        if (!macros_.empty()) refuse(line, "#include after #define", "put it before all #define lines");
        if (words.size() != 2 || words[1].kind != Kind::name || words[1].text.size() < 3)
            refuse(line, "malformed #include", "write #include \"file.glsl\"");
        const std::string_view name = words[1].text.substr(1, words[1].text.size() - 2);
        const bool is_plain = std::ranges::all_of(name, [](char c) {
            return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_'
                   || c == '/' || c == '.' || c == '-';
        });
        if (!is_plain || !name.ends_with(".glsl") || name.starts_with("/") || name.find("..") != name.npos)
            refuse(line, fmt::format("includes \"{}\"", shown(name)),
                   "name a .glsl file of this folder or of shaders/");
    }

    /// A macro is an expression: it hides no statement, no bracket and no loop.
    void read_macro(const std::vector<Token>& words, int line) {
        if (words.size() < 2 || words[1].kind != Kind::word)
            refuse(line, "#define without a name", "write one");
        const std::string_view name = words[1].text;
        if (is_one_of(name, flow_words) || is_one_of(name, refused_words) || name == "defined")
            refuse(line, fmt::format("#define {}", name), "choose a name that is no word of GLSL");
        if (!defined_.insert(name).second)
            refuse(line, fmt::format("a second #define {}", name), "choose another name");
        std::size_t body = 2;
        // "#define f(x)" has parameters, "#define f (x)" has none.
        const bool has_parameters =
            words.size() > 2 && words[2].text == "(" && words[2].at == words[1].at + name.size();
        if (has_parameters) body = behind_bracket(words, 2, words.size());
        Macro macro{has_parameters, {}, {words.begin() + static_cast<std::ptrdiff_t>(body), words.end()}};
        for (std::size_t i = 3; has_parameters && i + 1 < body; ++i) {
            if (words[i].kind == Kind::word)
                macro.parameters.push_back(words[i].text);
            else if (words[i].text != ",")
                refuse(line, fmt::format("{} among the parameters of a macro", words[i].text), "write names");
        }
        int depth = 0;
        for (std::size_t i = 2; i < words.size(); ++i) {
            const std::string_view text = words[i].text;
            if (text == "#") refuse(line, "# in a macro", "write the name out");
            if (text == "{" || text == "}" || text == ";" || is_one_of(text, flow_words))
                refuse(line, fmt::format("{} in a macro", text), "write a function");
            if (text == "(" || text == "[") ++depth;
            if ((text == ")" || text == "]") && --depth < 0) break;
        }
        if (depth != 0) refuse(line, "brackets in a macro that do not close", "close them in the macro");
        macros_[name] = std::move(macro);
    }

    bool is_permitted(std::string_view word) const {
        return std::ranges::find(permitted_, word) != permitted_.end();
    }

    void require_word(const Token& token) const {
        if (token.kind == Kind::sign) return;
        const std::string_view w = token.text;
        if (w.size() > max_word_bytes && token.kind != Kind::name)
            refuse(token.line, fmt::format("a word of {} letters", w.size()), "write a shorter one");
        if (token.kind != Kind::word || is_permitted(w)) return;
        const bool is_image =
            (w.starts_with("image") || w.starts_with("iimage") || w.starts_with("uimage")) && w.size() > 5
            && w.back() != 's'
            && !std::ranges::all_of(w.substr(5), [](char c) { return c >= 'a' && c <= 'z'; });
        const bool is_gl = w.starts_with("gl_") && w != "gl_FragCoord" && w != "gl_FrontFacing";
        const bool is_atomic =
            w.starts_with("atomic") && w.size() > 6 && (w[6] == '_' || (w[6] >= 'A' && w[6] <= 'Z'));
        if (w == "discard" || is_gl || is_image || is_atomic || is_one_of(w, refused_words))
            refuse(token.line, fmt::format("{} is not allowed here", w), "remove it");
        if (w.starts_with("steradian_") || w.find("__") != w.npos)
            refuse(token.line, fmt::format("the name {} is reserved", w), "choose another name");
    }

    Bounded with_bounds() {
        std::map<std::size_t, std::string> insertions; // by the byte before which they stand
        Bounded result;
        for (std::size_t i = 0; i < tokens_.size(); ++i)
            if (is_loop(tokens_[i])) bound(i, insertions, result.loops);
        std::size_t at = 0;
        for (const auto& [before, inserted] : insertions) {
            result.text.append(text_.substr(at, before - at)) += inserted;
            at = before;
        }
        result.text += text_.substr(at);
        for (const Token& token : code_) (result.code += token.text) += ' ';
        if (!result.text.empty() && result.text.back() != '\n') result.text += '\n';
        for (const auto& [name, macro] : macros_) result.text += fmt::format("#undef {}\n", name);
        return result;
    }

    /// The condition of `for` or `while` also counts a turn.
    void bound(std::size_t i, std::map<std::size_t, std::string>& insertions,
               std::vector<Loop>& loops) const {
        const Token& word = tokens_[i];
        if (i + 1 >= tokens_.size() || tokens_[i + 1].text != "(")
            refuse(word.line, fmt::format("{} without (", word.text), fmt::format("write {} (…)", word.text));
        std::size_t begin = i + 2, end = behind_bracket(tokens_, i + 1, tokens_.size()) - 1;
        if (word.text == "for") {
            std::vector<std::size_t> stops;
            int depth = 0;
            for (std::size_t j = begin; j < end; ++j) {
                const std::string_view text = tokens_[j].text;
                if (text == "(" || text == "[" || text == "{") ++depth;
                if (text == ")" || text == "]" || text == "}") --depth;
                if (text == ";" && depth == 0) stops.push_back(j);
            }
            if (stops.size() != 2)
                refuse(word.line, "for without its two ;", "write for (int i = 0; i < n; ++i)");
            begin = stops[0] + 1;
            end = stops[1];
        }
        const bool declares =
            end > begin + 1 && tokens_[begin].kind == Kind::word && tokens_[begin + 1].kind == Kind::word;
        if (declares)
            refuse(word.line, "a variable declared in a loop's condition", "declare it before the loop");
        const Location here{place_, word.line};
        const Loop loop{here, number_of(fmt::format("{}:{}", here.text(), loops.size()))};
        loops.push_back(loop);
        const std::string turn = fmt::format(" steradian_turn({})", loop.number);
        if (begin == end) {
            insertions[tokens_[end].at] = turn;
        } else {
            insertions[tokens_[begin].at] = turn + " && (";
            insertions[tokens_[end].at] += ")";
        }
    }

    std::string_view text_;
    const std::string& place_;
    std::span<const std::string> permitted_;
    std::vector<Token> tokens_;
    std::vector<Token> code_;            // without directives, macros written out
    Macros macros_;                      // of the place that is read
    int steps_ = 0;                      // of writing them out
    std::set<std::string_view> defined_; // macros, of which some may be undefined again
    std::vector<bool> certain_;          // of each open #if: whether the branch is compiled for sure
};

} // namespace

Bounded bounded(std::string_view text, const std::string& place, std::span<const std::string> permitted) {
    return Gate(text, place, permitted).pass();
}

void require_plain_name(std::string_view name, const std::string& place) {
    const bool is_plain = !name.empty() && name.size() <= 100 && name[0] != '.' && name[0] != '-'
                          && std::ranges::all_of(name, [](char c) {
                                 return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z')
                                        || (c >= '0' && c <= '9') || c == '_' || c == '-' || c == '.';
                             });
    if (!is_plain)
        throw Error({place}, "a name of other signs than letters, digits, _ - and .",
                    "give the file its own name again");
}

std::string_view turn_counter() {
    return "int steradian_turns = 0, steradian_stopped = 0;\n"
           "bool steradian_turn(int loop) { if (++steradian_turns <= 32768) return true; "
           "if (steradian_stopped == 0) steradian_stopped = loop; return false; }\n";
}

std::string_view main_renamed() { return "#define main steradian_main\n"; }

std::string main_that_tells(std::string_view out) {
    // 2¹⁰⁰: exact times the ten bits of each half of the number, also in a mean with other pixels. A shader
    // can overload functions, but neither operators nor constructors.
    return fmt::format(
        "#undef main\n"
        "void main() {{ steradian_main(); if (steradian_stopped != 0) {} = 1267650600228229401496703205376.0 "
        "* "
        "vec4(1.0, float(steradian_stopped >> 10) / 1024.0, float(steradian_stopped & 1023) / 1024.0, 1.0); "
        "}}\n",
        out);
}

LoopError::LoopError(const Location& where)
    : Error(where, fmt::format("this loop was stopped: all loops together took {} turns", max_turns),
            "let it end sooner"),
      where_(where) {}

void require_ended_loops(std::span<const float> pixels, std::span<const Loop> loops) {
    constexpr float min_mark = 0x1p80f; // of a mean over 2²⁰ samples, one of which was stopped
    if (loops.empty()) return;
    bool was_stopped = false;
    for (std::size_t i = 0; i + 3 < pixels.size(); i += 4) {
        const float r = pixels[i];
        if (!(r >= min_mark) || !(pixels[i + 3] >= min_mark)) continue;
        was_stopped = true;
        const auto half = [&](std::size_t c) {
            return static_cast<int>(std::lround(1024.0f * pixels[i + c] / r));
        };
        const Loop told{{}, (half(1) << 10) + half(2)};
        const auto found = std::ranges::find(loops, told);
        if (found != loops.end()) throw LoopError(found->where);
    }
    if (was_stopped) throw LoopError({loops.front().where.file});
}

} // namespace sr::glsl
