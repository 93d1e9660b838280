#include "glsl/declarations.hpp"

#include "core/error.hpp"

#include <algorithm>
#include <array>
#include <cstdlib>
#include <fmt/format.h>

namespace sr::glsl {
namespace {

using Kind = Token::Kind;

// GLSL 4.60, chapter 8, in the order of their characters: binary_search reads it.
// clang-format off
constexpr std::string_view built_in_functions[] = {
    "abs", "acos", "acosh", "all", "any", "asin", "asinh", "atan", "atanh", "bitCount", "bitfieldExtract",
    "bitfieldInsert", "bitfieldReverse", "ceil", "clamp", "cos", "cosh", "cross", "dFdx", "dFdxCoarse",
    "dFdxFine", "dFdy", "dFdyCoarse", "dFdyFine", "degrees", "determinant", "distance", "dot", "equal", "exp",
    "exp2", "faceforward", "findLSB", "findMSB", "floatBitsToInt", "floatBitsToUint", "floor", "fma", "fract",
    "frexp", "ftransform", "fwidth", "fwidthCoarse", "fwidthFine", "greaterThan", "greaterThanEqual",
    "imulExtended", "intBitsToFloat", "interpolateAtCentroid", "interpolateAtOffset", "interpolateAtSample",
    "inverse", "inversesqrt", "isinf", "isnan", "ldexp", "length", "lessThan", "lessThanEqual", "log", "log2",
    "matrixCompMult", "max", "min", "mix", "mod", "modf", "noise1", "noise2", "noise3", "noise4", "normalize",
    "not", "notEqual", "outerProduct", "packDouble2x32", "packHalf2x16", "packSnorm2x16", "packSnorm4x8",
    "packUnorm2x16", "packUnorm4x8", "pow", "radians", "reflect", "refract", "round", "roundEven", "sign",
    "sin", "sinh", "smoothstep", "sqrt", "step", "tan", "tanh", "texelFetch", "texelFetchOffset", "texture",
    "textureGather", "textureGatherOffset", "textureGatherOffsets", "textureGrad", "textureGradOffset",
    "textureLod", "textureLodOffset", "textureOffset", "textureProj", "textureProjGrad",
    "textureProjGradOffset", "textureProjLod", "textureProjLodOffset", "textureProjOffset",
    "textureQueryLevels", "textureQueryLod", "textureSamples", "textureSize", "transpose", "trunc",
    "uaddCarry", "uintBitsToFloat", "umulExtended", "unpackDouble2x32", "unpackHalf2x16", "unpackSnorm2x16",
    "unpackSnorm4x8", "unpackUnorm2x16", "unpackUnorm4x8", "usubBorrow"};
// clang-format on
static_assert(std::ranges::is_sorted(built_in_functions));

// Words that stand before a type, or before an expression.
constexpr auto words_before = std::to_array<std::string_view>(
    {"return", "else", "do", "case", "const", "in", "out", "inout", "flat", "smooth", "noperspective",
     "centroid", "highp", "mediump", "lowp", "precise"});

constexpr double max_plain_bytes = 512.0;   // of a variable without [ ] that is left out of sums
constexpr double unknown_elements = 512.0;  // of an array whose initialiser gives the size
constexpr double foreign_elements = 4096.0; // of an array whose size is a constant of a file that is included
constexpr double foreign_bytes = 256.0;     // of a type of a file that is included

bool is_text(const std::vector<Token>& code, std::size_t at, std::string_view text) {
    return at < code.size() && code[at].text == text;
}

bool is_word(const std::vector<Token>& code, std::size_t at) {
    return at < code.size() && code[at].kind == Kind::word;
}

double value_of(const Token& token) { return std::strtod(std::string(token.text).c_str(), nullptr); }

bool is_basic(std::string_view type) {
    for (const std::string_view part : {"float", "int", "uint", "bool", "double", "void"})
        if (type == part) return true;
    for (const std::string_view part : {"vec", "ivec", "uvec", "bvec", "dvec", "mat", "dmat"})
        if (type.starts_with(part) && type.size() > part.size()
            && type.find_first_not_of("234x", part.size()) == type.npos)
            return true;
    return false;
}

} // namespace

void require_own_names(const std::vector<Token>& code, const std::string& place) {
    int depth = 0;
    for (std::size_t i = 0; i < code.size(); ++i) {
        const std::string_view text = code[i].text;
        if (text == "(" || text == "[" || text == "{") ++depth;
        if (text == ")" || text == "]" || text == "}") --depth;
        if (depth != 0 || i == 0 || code[i].kind != Kind::word) continue;
        const bool is_declared = code[i - 1].kind == Kind::word || code[i - 1].text == "]";
        if (is_declared && std::ranges::binary_search(built_in_functions, text))
            throw Error({place, code[i].line}, fmt::format("{} is a function of GLSL", text),
                        "choose another name");
    }
}

ArraySizes::ArraySizes(const std::vector<Token>& code, const std::string& place)
    : code_(code), place_(place) {
    find_constants();
    find_structs();
}

/// Finds "int NAME = NUMBER".
void ArraySizes::find_constants() {
    for (std::size_t i = 1; i + 2 < code_.size(); ++i) {
        const std::string_view before = code_[i - 1].text;
        const bool is_declared = before == "int" || before == "uint" || before == ",";
        if (!is_declared || !is_word(code_, i) || code_[i + 1].text != "=" || code_[i + 2].text == "=")
            continue;
        const bool is_plain =
            code_[i + 2].kind == Kind::number && (is_text(code_, i + 3, ";") || is_text(code_, i + 3, ","));
        double& known = constants_.try_emplace(code_[i].text, 0.0).first->second;
        const double value = is_plain ? value_of(code_[i + 2]) : -1.0;
        known = known < 0.0 || value < 0.0 ? -1.0 : std::max(known, value);
    }
}

/// Measures structs. Each has only those that are declared before it.
void ArraySizes::find_structs() {
    for (std::size_t i = 0; i < code_.size(); ++i)
        if (code_[i].text == "struct" && is_word(code_, i + 1) && is_text(code_, i + 2, "{"))
            structs_[code_[i + 1].text] = bytes(i + 3, behind_bracket(code_, i + 2, code_.size()), true);
}

double ArraySizes::bytes_of_type(std::string_view type) const {
    if (const auto found = structs_.find(type); found != structs_.end()) return found->second;
    if (!is_basic(type)) return foreign_bytes;
    const double single = type.find("mat") != type.npos ? 64.0 : type.find("vec") != type.npos ? 16.0 : 4.0;
    return type.starts_with('d') ? 2.0 * single : single;
}

double ArraySizes::elements(std::size_t begin, std::size_t end) const {
    if (begin == end) return unknown_elements;
    const Token& token = code_[begin];
    if (end == begin + 1 && token.kind == Kind::number) return std::max(1.0, value_of(token));
    if (end == begin + 1 && token.kind == Kind::word) {
        const auto found = constants_.find(token.text);
        if (found == constants_.end()) return foreign_elements;
        if (found->second >= 0.0) return std::max(1.0, found->second);
    }
    throw Error({place_, token.line}, "the size of an array is neither a number nor a constant of a number",
                "write the number");
}

/// The product of "[a][b]" at a token, which moves behind them; 1 if none stands there.
double ArraySizes::dimensions(std::size_t& at, std::size_t end) const {
    double product = 1.0;
    while (at < end && code_[at].text == "[") {
        const std::size_t behind = behind_bracket(code_, at, end);
        product *= elements(at + 1, behind - 1);
        at = behind;
    }
    return product;
}

/// The bytes of "NAME [a], NAME [b]" at a token, which moves to the last name.
double ArraySizes::declared(std::size_t& at, std::size_t end, double each, bool all) const {
    double sum = 0.0;
    for (std::size_t next = at; next < end && code_[next].kind == Kind::word;) {
        at = next++;
        const double count = dimensions(next, end);
        if (all || count > 1.0 || each > max_plain_bytes) sum += count * each;
        while (next < end && std::string_view(",;){").find(code_[next].text) == std::string_view::npos)
            next = code_[next].text == "(" || code_[next].text == "[" ? behind_bracket(code_, next, end)
                                                                      : next + 1;
        const bool goes_on =
            is_text(code_, next, ",") && is_word(code_, next + 1) && !is_word(code_, next + 2);
        if (!goes_on) break;
        ++next;
    }
    return sum;
}

double ArraySizes::bytes(std::size_t begin, std::size_t end, bool all) const {
    double sum = 0.0;
    for (std::size_t i = begin; i < end; ++i) {
        const std::string_view word = code_[i].text;
        if (!is_word(code_, i) || std::ranges::find(words_before, word) != words_before.end()) continue;
        std::size_t at = i + 1;
        if (word == "struct") { // struct NAME { … } NAME [a];
            if (all)            // GLSL 4.60, section 4.1.8; each level would double the time of measuring it
                throw Error({place_, code_[i].line}, "a struct within a struct", "declare it before");
            if (is_word(code_, at)) ++at;
            if (!is_text(code_, at, "{")) continue;
            const std::size_t behind = behind_bracket(code_, at, end);
            std::size_t name = behind;
            sum += declared(name, end, bytes(at + 1, behind, true), all);
            continue; // its members follow
        }
        std::size_t name = at; // TYPE [a] NAME
        while (name < end && code_[name].text == "[") name = behind_bracket(code_, name, end);
        if (name >= end || !is_word(code_, name)) continue;
        const double of_type = dimensions(at, end);
        sum += declared(at, end, of_type * bytes_of_type(word), all || of_type > 1.0);
        i = at;
    }
    return sum;
}

} // namespace sr::glsl
