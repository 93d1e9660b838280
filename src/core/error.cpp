#include "core/error.hpp"

#include "core/output.hpp"
#include "core/text.hpp"

#include <cstdlib>
#include <fmt/format.h>

namespace sr {

std::string Location::text() const {
    if (line <= 0) return file;
    if (column <= 0) return fmt::format("{}:{}", file, line);
    return fmt::format("{}:{}:{}", file, line, column);
}

Error::Error(const Location& where, std::string_view what, std::string_view what_to_do)
    : std::runtime_error(shown(fmt::format("{}: {}: {}", where.text(), what, what_to_do))) {}

Error::Error(std::string_view what, std::string_view what_to_do)
    : std::runtime_error(shown(fmt::format("{}: {}", what, what_to_do))) {}

void require(bool claim, const char* what, std::source_location here) {
    if (claim) return;
    print_remark("{}:{}: {}: this is a bug in Steradian, please report it", here.file_name(), here.line(),
                 what);
    std::abort();
}

} // namespace sr
