#include "glsl/call_costs.hpp"

#include "core/error.hpp"

#include <algorithm>
#include <fmt/format.h>
#include <optional>
#include <set>

namespace sr::glsl {
namespace {

constexpr double max_cost = 100'000.0; // tokens
constexpr int max_depth = 64;          // of macros in macros, and of calls in calls

struct Definition {
    std::size_t begin = 0, end = 0; // of its body
    int line = 0;
};

class Costs {
public:
    Costs(const std::vector<Token>& tokens, const Macros& macros, const std::string& place)
        : tokens_(tokens), macros_(macros), place_(place) {
        find_definitions();
    }

    void require_short() {
        for (const auto& [name, definitions] : functions_) cost_of_function(name, definitions.front().line);
        refuse_above(cost(tokens_, 0, tokens_.size()), 1);
    }

private:
    void find_definitions() {
        int depth = 0;
        for (std::size_t i = 0; i < tokens_.size(); ++i) {
            const std::string_view text = tokens_[i].text;
            if (text == "{") ++depth;
            if (text == "}") --depth;
            if (depth != 0 || text != "(" || i < 1 || tokens_[i - 1].kind != Token::Kind::word) continue;
            const std::size_t brace = behind_bracket(tokens_, i, tokens_.size());
            if (brace < tokens_.size() && tokens_[brace].text == "{")
                functions_[tokens_[i - 1].text].push_back(
                    {brace, behind_bracket(tokens_, brace, tokens_.size()), tokens_[i - 1].line});
        }
    }

    void refuse_above(double cost, int line) const {
        if (cost > max_cost)
            throw Error({place_, line}, "more than 100000 tokens once macros and calls are written out",
                        "call less");
    }

    /// The tokens of [begin, end) once everything is written out.
    double cost(const std::vector<Token>& tokens, std::size_t begin, std::size_t end) {
        double sum = 0.0;
        for (std::size_t i = begin; i < end; ++i) {
            sum += 1.0;
            if (tokens[i].kind != Token::Kind::word) continue;
            const bool is_called = i + 1 < end && tokens[i + 1].text == "(";
            if (const auto macro = macros_.find(tokens[i].text); macro != macros_.end()) {
                if (!macro->second.has_parameters) {
                    sum += cost_of_macro(macro->first, macro->second, tokens[i].line);
                } else if (is_called) { // each parameter may stand in the body any number of times
                    const std::size_t behind = behind_bracket(tokens, i + 1, end);
                    sum += cost_of_macro(macro->first, macro->second, tokens[i].line)
                           * std::max(1.0, cost(tokens, i + 2, behind - 1));
                    i = behind - 1;
                }
            } else if (is_called && functions_.contains(tokens[i].text)) {
                sum += cost_of_function(tokens[i].text, tokens[i].line);
            }
            if (sum > max_cost) return sum;
        }
        return sum;
    }

    double cost_of_macro(std::string_view name, const Macro& macro, int line) {
        if (const auto known = macro_costs_.find(name); known != macro_costs_.end()) return known->second;
        if (!open_macros_.insert(name).second) return 1.0; // a macro is not written out within itself
        refuse_depth(line);
        const double sum = cost(macro.body, 0, macro.body.size());
        open_macros_.erase(name);
        refuse_above(sum, line);
        return macro_costs_[name] = sum;
    }

    void refuse_depth(int line) const {
        if (open_macros_.size() + open_.size() > max_depth)
            throw Error({place_, line}, "calls and macros deeper than 64", "nest less");
    }

    /// That of the longest definition. A call by the same name is one of a definition before.
    double cost_of_function(std::string_view name, int line) {
        if (const auto known = costs_.find(name); known != costs_.end()) return known->second;
        const std::vector<Definition>& definitions = functions_.at(name);
        if (const auto open = open_.find(name); open != open_.end()) {
            if (definitions.size() == 1 || open_order_.back() != name)
                throw Error({place_, line}, fmt::format("{} calls itself", name),
                            "GLSL has no recursion: write a loop");
            return open->second;
        }
        refuse_depth(line);
        open_[name] = 0.0;
        open_order_.push_back(name);
        for (const Definition& definition : definitions) {
            const double sum = cost(tokens_, definition.begin, definition.end);
            refuse_above(sum, definition.line);
            open_[name] = std::max(open_[name], sum);
        }
        const double most = open_[name];
        open_.erase(name);
        open_order_.pop_back();
        return costs_[name] = most;
    }

    const std::vector<Token>& tokens_;
    const Macros& macros_;
    const std::string& place_;
    std::map<std::string_view, std::vector<Definition>> functions_;
    std::map<std::string_view, double> costs_, macro_costs_;
    std::map<std::string_view, double> open_; // functions that are being summed, with their sum so far
    std::vector<std::string_view> open_order_;
    std::set<std::string_view> open_macros_;
};

} // namespace

void require_short_calls(const std::vector<Token>& tokens, const Macros& macros, const std::string& place) {
    Costs(tokens, macros, place).require_short();
}

} // namespace sr::glsl
