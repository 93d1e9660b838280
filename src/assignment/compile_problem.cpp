#include "assignment/compile_problem.hpp"

#include "assignment/regions.hpp"
#include "core/text.hpp"

#include <algorithm>
#include <array>
#include <fmt/format.h>
#include <optional>
#include <regex>
#include <sstream>

namespace sr::assignment {
namespace {

constexpr std::size_t max_problems = 5;

/// Words of drivers, and what stands in the line ("" for anything), in the order in which they are tried.
struct KnownComplaint {
    const char* words;
    const char* line;
    const char* hint;
};
constexpr auto icase = std::regex::icase;

constexpr std::array known_complaints{
    KnownComplaint{"reserved|illegal use of reserved", "", "This word belongs to GLSL: choose another name."},
    KnownComplaint{"must return|returning|return with|does not return|no return|return type|`return'", "",
                   "What is returned must have the type that stands before the function's name."},
    KnownComplaint{"modulus|integer|bit-wise|operator '\\^'|operator '%'|type mismatch", "\\^",
                   "In GLSL ^ is a bit operation: write x*x or pow(x, y)."},
    KnownComplaint{"modulus|operator '%'|integer", "%", "% is for int only: write mod(x, y)."},
    KnownComplaint{"recurs", "", "GLSL has no recursion: write a loop."},
    KnownComplaint{"redeclar|redefin|already", "",
                   "The name is declared already: a variable once in a block, a function once in a file."},
    KnownComplaint{"syntax error|unexpected|expected",
                   "\\b(double|let|var|const\\s+auto|auto|fn|function)\\b",
                   "Declare with a GLSL type: float, vec3, int, bool."},
    KnownComplaint{"unexpected end of file|unexpected \\$end|unexpected end", "",
                   "A bracket is open at the end of the file: count { } and ( )."},
    KnownComplaint{"syntax error|unexpected|expected", "",
                   "Look at the line before as well: a semicolon or a bracket may be missing at its end."},
    KnownComplaint{
        "read-only|const|l-value|not assignable|assignment to|in variable", "=",
        "This name cannot be assigned to: it is a constant or an input. Copy it into a variable first."},
    KnownComplaint{"no matching function|no overload|not a function|no function|cannot call|too (few|many)",
                   "",
                   "The function exists with other arguments only: compare their number and types (float or "
                   "vec3? 1 or 1.0?)."},
    KnownComplaint{"undeclared|undefined|not declared|no such variable|unknown identifier", "",
                   "The name is not declared here: look for a typing error, declare it before this line, or "
                   "pass it in."},
    KnownComplaint{"int|cannot convert|implicit|type mismatch|must be|operands|cannot initialize|initializer",
                   "",
                   "The types on both sides differ: float and vec3 do not mix in an assignment, and whole "
                   "numbers of float want a "
                   "point (1.0)."},
};

std::string line_of(const Code& code, int line) {
    std::istringstream text(code.text);
    std::string found;
    for (int i = code.line; i <= line; ++i)
        if (!std::getline(text, found)) return {};
    return found;
}

std::optional<Problem> problem_in(const std::string& log_line, const Codes& codes) {
    static const std::regex form(R"((.*?):(\d{1,9})(?::(\d{1,9}))?: ([a-z ]*error): (.*))");
    constexpr std::size_t max_line = 2000; // std::regex recurses for each character
    const std::string line = shorten(log_line, max_line);
    std::smatch found;
    if (!std::regex_match(line, found, form)) return std::nullopt;
    Problem problem{found[1], std::stoi(found[2]), found[3].matched ? std::stoi(found[3]) : 0, found[5], {},
                    {}};
    for (const auto& [region, code] : codes)
        if (code.place == problem.place && problem.source.empty())
            problem.source = line_of(code, problem.line);
    problem.hint = hint_for_complaint(problem.text, problem.source);
    return problem;
}

} // namespace

std::string hint_for_complaint(const std::string& complaint, const std::string& source) {
    const std::string code = without_comments(source);
    for (const KnownComplaint& known : known_complaints)
        if (std::regex_search(complaint, std::regex(known.words, icase))
            && (*known.line == '\0' || std::regex_search(code, std::regex(known.line))))
            return known.hint;
    return {};
}

std::vector<Problem> problems_of(const gl::ShaderError& error, const std::string& task, const Codes& codes) {
    const Code& code = codes.at(task);
    std::vector<Problem> theirs, others;
    std::istringstream log(error.log());
    for (std::string line; std::getline(log, line);)
        if (auto problem = problem_in(line, codes)) {
            std::vector<Problem>& known = problem->source.empty() ? others : theirs;
            const auto is_same_line = [&](const Problem& p) {
                return p.place == problem->place && p.line == problem->line;
            };
            // The first complaint about a line is the cause of the others.
            if (std::ranges::none_of(known, is_same_line)) known.push_back(std::move(*problem));
        }
    if (theirs.size() > max_problems) theirs.resize(max_problems);
    if (!theirs.empty()) return theirs;
    const LoneBracket lone = lone_bracket(code.text);
    if (lone.line > 0) {
        const int line = code.line + lone.line - 1;
        return {{code.place, line, 0, fmt::format("{} has no partner", lone.bracket), line_of(code, line),
                 "Count the brackets of this function."}};
    }
    const std::string words = others.empty() ? error.what() : others.front().text;
    return {{code.place,
             code.line,
             0,
             fmt::format("with your code for {} the rest does not compile: {}", task, words),
             {},
             "Keep the function's name, its parameters and what it returns."}};
}

} // namespace sr::assignment
