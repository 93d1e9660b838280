#include "glsl/macros.hpp"

#include "core/error.hpp"

#include <algorithm>
#include <fmt/format.h>
#include <iterator>
#include <set>

namespace sr::glsl {
namespace {

constexpr int max_steps = 4 * max_written_tokens; // a macro's argument is read twice
constexpr std::size_t max_macro_depth = 64;       // of macros in macros

class MacroWriter {
public:
    MacroWriter(const Macros& macros, const std::string& place, int& steps)
        : macros_(macros), place_(place), steps_(steps) {}

    std::vector<Token> written(std::vector<Token> code, std::size_t depth) {
        std::vector<Frame> frames;
        frames.push_back({std::move(code), 0, {}});
        std::vector<Token> result;
        while (peek(frames)) {
            const Token token = next(frames);
            const auto macro = token.kind == Token::Kind::word ? macros_.find(token.text) : macros_.end();
            if (macro == macros_.end()) {
                result.push_back(token);
                continue;
            }
            if (active_.contains(token.text))
                refuse(token.line, fmt::format("the macro {} is used within itself", token.text),
                       "write a function");
            if (frames.size() + depth > max_macro_depth)
                refuse(token.line, "macros deeper than 64", "nest less");
            std::vector<Token> body = macro->second.body;
            if (macro->second.has_parameters)
                body = with_arguments(macro->second, arguments_of(frames, token), frames.size() + depth);
            for (Token& part : body) part.line = token.line;
            active_.insert(token.text);
            frames.push_back({std::move(body), 0, token.text});
        }
        return result;
    }

private:
    /// Tokens still to be read: the code, or the body of a macro.
    struct Frame {
        std::vector<Token> tokens;
        std::size_t at = 0;
        std::string_view macro; // empty: the code
    };

    [[noreturn]] void refuse(int line, const std::string& what, const std::string& what_to_do) const {
        throw Error({place_, line}, what, what_to_do);
    }

    void step(int line) {
        if (++steps_ > max_steps)
            refuse(line, fmt::format("more than {} tokens once macros are written out", max_written_tokens),
                   "write less");
    }

    /// The token to be read next; null at the end. A macro ends where its last token has been read.
    const Token* peek(std::vector<Frame>& frames) {
        while (!frames.empty() && frames.back().at == frames.back().tokens.size()) {
            active_.erase(frames.back().macro);
            frames.pop_back();
        }
        return frames.empty() ? nullptr : &frames.back().tokens[frames.back().at];
    }

    Token next(std::vector<Frame>& frames) {
        const Token token = frames.back().tokens[frames.back().at++];
        step(token.line);
        return token;
    }

    std::vector<std::vector<Token>> arguments_of(std::vector<Frame>& frames, const Token& name) {
        const Token* open = peek(frames);
        if (!open || open->text != "(")
            refuse(name.line, fmt::format("the macro {} without its arguments", name.text),
                   fmt::format("write {}(…)", name.text));
        next(frames);
        std::vector<std::vector<Token>> arguments(1);
        for (int depth = 1; peek(frames);) {
            const Token token = next(frames);
            if (token.text == "(") ++depth;
            if (token.text == ")" && --depth == 0) return arguments;
            if (token.text == "," && depth == 1)
                arguments.emplace_back();
            else
                arguments.back().push_back(token);
        }
        refuse(name.line, fmt::format("the arguments of the macro {} do not end", name.text),
               "close the bracket");
    }

    std::vector<Token> with_arguments(const Macro& macro, std::vector<std::vector<Token>> arguments,
                                      std::size_t depth) {
        for (std::vector<Token>& argument : arguments) argument = written(std::move(argument), depth);
        std::vector<Token> result;
        for (const Token& token : macro.body) {
            const auto found = std::ranges::find(macro.parameters, token.text);
            const auto index = static_cast<std::size_t>(found - macro.parameters.begin());
            if (found == macro.parameters.end() || index >= arguments.size()) {
                result.push_back(token);
                continue;
            }
            for (const Token& part : arguments[index]) {
                step(part.line);
                result.push_back(part);
            }
        }
        return result;
    }

    const Macros& macros_;
    const std::string& place_;
    int& steps_;
    std::set<std::string_view> active_; // macros that are being written out
};

} // namespace

std::vector<Token> written_out(std::vector<Token> code, const Macros& macros, const std::string& place,
                               int& steps) {
    return MacroWriter(macros, place, steps).written(std::move(code), 0);
}

} // namespace sr::glsl
