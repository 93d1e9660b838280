#pragma once
// Sources of GLSL files. A shader path is a list of roots; the first that has a file wins, so a root
// put in front of the others is an overlay.
#include <filesystem>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace sr::glsl {

/// File names relative to a root ("brdf/ggx.glsl", always with '/') and their texts.
using Files = std::map<std::string, std::string, std::less<>>;

/// A folder on disk, read again at each call, or files in memory, which copies of the root share.
class Root {
public:
    /// @throws Error if there is no such folder.
    static Root folder(const std::filesystem::path& folder);
    /// `label` stands before the files' names in errors, like a folder.
    static Root memory(std::string label, Files files);

    /// One text that stands for the file `name`, whatever its own place is called: errors say `place`.
    static Root single(std::string place, std::string name, std::string text);

    /// The same root as somebody untrusted wrote it: it has *.glsl files alone, which pass a gate
    /// (untrusted.hpp). `permitted`: words that the gate refuses otherwise.
    Root untrusted(std::vector<std::string> permitted = {}) const;

    /// The text of a file, or absent if the root has no such file.
    /// @throws Error if a file is there and cannot be read; in an untrusted folder also for a link, and for a
    /// file that is no regular one or larger than 256 KiB.
    std::optional<std::string> text_of(std::string_view name) const;

    /// The names of files in memory, in order; none of a folder.
    std::vector<std::string> names() const;

    /// Returns the name that errors give the file: on disk a path that a person can open.
    std::string place_of(std::string_view name) const;

    const std::string& label() const { return label_; }
    /// Returns whether somebody else wrote it: a folder or a file of the user's.
    bool is_foreign() const { return is_single_ || std::holds_alternative<std::filesystem::path>(place_); }

    bool is_untrusted() const { return permitted_.has_value(); }
    const std::vector<std::string>& permitted() const { return *permitted_; }

private:
    using Place = std::variant<std::filesystem::path, std::shared_ptr<const Files>>;

    Root(std::string label, Place place);

    /// Absent for a folder.
    const Files* in_memory() const;

    std::string label_;
    Place place_;
    bool is_single_ = false;
    std::optional<std::vector<std::string>> permitted_; // words; absent: everything is
};

/// The shaders/ tree as it was when the program was built; its places read "shaders/brdf/ggx.glsl".
Root embedded();

/// Describes a folder none of whose files has the name of one in `ours`: one line with the nearest
/// name. Absent if one has, or if a file in one of the folders `all` includes one of its files: it then
/// serves a replacement there.
std::optional<std::string> remark_on_overlay(const std::filesystem::path& folder, const Root& ours,
                                             const std::vector<std::string>& all);

} // namespace sr::glsl
