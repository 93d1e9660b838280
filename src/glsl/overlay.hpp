#pragma once
// Folders of shaders that replace none of ours, by a slip in a name.
#include "glsl/root.hpp"

#include <optional>
#include <string>
#include <vector>

namespace sr::glsl {

/// Describes a folder none of whose files has the name of one in `ours`: one line with the nearest
/// name. Absent if one has, or if a file in one of the folders `all` includes one of its files: it then
/// serves a replacement there.
std::optional<std::string> remark_on_overlay(const std::filesystem::path& folder, const Root& ours,
                                             const std::vector<std::string>& all);

} // namespace sr::glsl
