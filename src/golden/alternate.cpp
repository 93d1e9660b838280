#include "golden/alternate.hpp"

#include "core/error.hpp"

#include <algorithm>
#include <fmt/format.h>

namespace sr::golden {
namespace {

namespace fs = std::filesystem;

fs::path folder_of(const Suite& suite) { return suite.goldens / "alternates"; }

} // namespace

fs::path alternate_of(const Suite& suite, const GoldenTest& test, std::string_view label) {
    return folder_of(suite) / label / (test.name + test.extension);
}

std::vector<std::string> alternates_of(const Suite& suite, const GoldenTest& test) {
    std::vector<std::string> labels;
    std::error_code ignored;
    for (const fs::directory_entry& entry : fs::directory_iterator(folder_of(suite), ignored)) {
        const std::string label = entry.path().filename().string();
        if (fs::exists(alternate_of(suite, test, label), ignored)) labels.push_back(label);
    }
    std::ranges::sort(labels);
    return labels;
}

void check_label(const std::string& label) {
    const auto is_plain = [](char c) {
        return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '-'
               || c == '_' || c == '.';
    };
    if (!label.empty() && label.front() != '.' && std::ranges::all_of(label, is_plain)) return;
    throw Error(fmt::format("'{}' cannot name an alternate", label),
                "take letters, digits, '-', '_' and '.', such as radeonsi-24.1");
}

} // namespace sr::golden
