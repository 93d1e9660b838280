#include "glsl/call_costs.hpp"

#include "core/error.hpp"
#include "glsl/declarations.hpp"
#include "glsl/macros.hpp"

#include <algorithm>
#include <fmt/format.h>
#include <map>

namespace sr::glsl {
namespace {

constexpr std::size_t max_depth = 64; // of calls in calls
constexpr double max_array_bytes = 64
                                   << 10; // in one invocation; llvmpipe keeps eight at a time, on the stack

struct Cost {
    double tokens = 0.0, bytes = 0.0; // of code and of arrays
};

struct Definition {
    std::size_t header = 0, begin = 0, end = 0; // of its type, and of its body
    int line = 0;
};

class Costs {
public:
    Costs(const std::vector<Token>& code, const std::string& place)
        : code_(code), place_(place), arrays_(code, place) {
        find_definitions();
    }

    void require_low() {
        for (const auto& [name, definitions] : functions_) cost_of_function(name, definitions.front().line);
        refuse_above(cost(0, code_.size()), 1);
    }

private:
    void find_definitions() {
        int depth = 0;
        std::size_t header = 0; // behind the statement or the body before
        for (std::size_t i = 0; i < code_.size(); ++i) {
            const std::string_view text = code_[i].text;
            if (text == "{") ++depth;
            if (text == "}") --depth;
            if (depth == 0 && (text == ";" || text == "}")) header = i + 1;
            if (depth != 0 || text != "(" || i < 1 || code_[i - 1].kind != Token::Kind::word) continue;
            const std::size_t brace = behind_bracket(code_, i, code_.size());
            if (brace < code_.size() && code_[brace].text == "{")
                functions_[code_[i - 1].text].push_back(
                    {header, brace, behind_bracket(code_, brace, code_.size()), code_[i - 1].line});
        }
    }

    void refuse_above(const Cost& cost, int line) const {
        if (cost.tokens > max_written_tokens)
            throw Error(
                {place_, line},
                fmt::format("more than {} tokens once macros and calls are written out", max_written_tokens),
                "call less");
        if (cost.bytes > max_array_bytes)
            throw Error({place_, line},
                        fmt::format("arrays of {:.0f} bytes, above {:.0f}", cost.bytes, max_array_bytes),
                        "use smaller arrays, or fewer");
    }

    /// The cost of [begin, end) once all calls are written out.
    Cost cost(std::size_t begin, std::size_t end) {
        Cost sum{0.0, arrays_.bytes(begin, end)};
        for (std::size_t i = begin; i < end && sum.tokens <= max_written_tokens; ++i) {
            sum.tokens += 1.0;
            if (code_[i].kind != Token::Kind::word || i + 1 >= end || code_[i + 1].text != "(") continue;
            if (!functions_.contains(code_[i].text)) continue;
            const Cost called = cost_of_function(code_[i].text, code_[i].line);
            sum.tokens += called.tokens;
            sum.bytes += called.bytes;
        }
        return sum;
    }

    /// That of the longest definition. A call by the same name is one of a definition before.
    Cost cost_of_function(std::string_view name, int line) {
        if (const auto known = costs_.find(name); known != costs_.end()) return known->second;
        const std::vector<Definition>& definitions = functions_.at(name);
        if (const auto open = open_.find(name); open != open_.end()) {
            if (definitions.size() == 1 || open_order_.back() != name)
                throw Error({place_, line}, fmt::format("{} calls itself", name),
                            "GLSL has no recursion: write a loop");
            return open->second;
        }
        if (open_.size() > max_depth) throw Error({place_, line}, "calls deeper than 64", "nest less");
        open_[name] = {};
        open_order_.push_back(name);
        for (const Definition& definition : definitions) {
            Cost sum = cost(definition.begin, definition.end);
            sum.bytes += arrays_.bytes(definition.header, definition.begin);
            refuse_above(sum, definition.line);
            Cost& most = open_[name];
            most = {std::max(most.tokens, sum.tokens), std::max(most.bytes, sum.bytes)};
        }
        const Cost most = open_[name];
        open_.erase(name);
        open_order_.pop_back();
        return costs_[name] = most;
    }

    const std::vector<Token>& code_;
    const std::string& place_;
    ArraySizes arrays_;
    std::map<std::string_view, std::vector<Definition>> functions_;
    std::map<std::string_view, Cost> costs_;
    std::map<std::string_view, Cost> open_; // functions that are being summed, with their sum so far
    std::vector<std::string_view> open_order_;
};

} // namespace

void require_low_costs(const std::vector<Token>& code, const std::string& place) {
    Costs(code, place).require_low();
}

} // namespace sr::glsl
