#pragma once
// Alternates: what another driver makes of a test and people have approved beside its golden. They lie in
// GOLDENS/alternates/LABEL/ and hold only for the renderer that made them, so that no other hides behind one.
#include "golden/suite.hpp"

namespace sr::golden {

/// Where the alternate `label` of a test lies, or would.
std::filesystem::path alternate_of(const Suite& suite, const GoldenTest& test, std::string_view label);

/// The labels of the test's alternates, in order.
std::vector<std::string> alternates_of(const Suite& suite, const GoldenTest& test);

/// @throws Error for a label that cannot be a folder's name.
void check_label(const std::string& label);

} // namespace sr::golden
