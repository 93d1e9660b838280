#pragma once
// Checks of what a GLSL text declares: names of built-in functions, and sizes of arrays.
#include "glsl/tokens.hpp"

#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace sr::glsl {

/// @throws Error for a function, a type or a global variable of the name of one of GLSL's own functions. An
/// overload would also be taken by the expressions of checks.
void require_own_names(const std::vector<Token>& code, const std::string& place);

/// Sizes of arrays in code whose macros are written out.
class ArraySizes {
public:
    ArraySizes(const std::vector<Token>& code, const std::string& place);

    /// The bytes of all arrays, and of structs above 512 bytes, that [begin, end) declares. @throws Error for
    /// a size that is neither a number nor a constant of a number
    double bytes(std::size_t begin, std::size_t end) const { return bytes(begin, end, false); }

private:
    double bytes_of_type(std::string_view type) const;
    double dimensions(std::size_t& at, std::size_t end) const;
    double elements(std::size_t begin, std::size_t end) const;
    double declared(std::size_t& at, std::size_t end, double each, bool all) const;
    double bytes(std::size_t begin, std::size_t end, bool all) const;
    void find_constants();
    void find_structs();

    const std::vector<Token>& code_;
    const std::string& place_;
    std::map<std::string_view, double> structs_;   // bytes
    std::map<std::string_view, double> constants_; // of int; negative: not a plain number
};

} // namespace sr::glsl
