#pragma once
// A folder that is written whole or not at all.
#include <filesystem>
#include <string_view>

namespace sr::mitsuba {

/// Writes a file. @throws Error that names the cause.
void write_text(const std::filesystem::path& file, std::string_view text);

/// Makes a folder, unless it is there. @throws Error
void make_folder(const std::filesystem::path& folder);

/// Fills a folder beside its place, and puts it there when it is complete.
class NewFolder {
public:
    /// `place` is free, empty, or holds nothing but what an earlier export wrote.
    /// @throws Error if it is anything else, or if nothing can be written beside it.
    explicit NewFolder(std::filesystem::path place);
    NewFolder(const NewFolder&) = delete;
    NewFolder& operator=(const NewFolder&) = delete;
    ~NewFolder();

    /// The folder to write to until put_in_place().
    const std::filesystem::path& path() const { return temporary_; }

    /// Replaces what was at the place. @throws Error
    void put_in_place();

private:
    std::filesystem::path place_;
    std::filesystem::path temporary_;
};

} // namespace sr::mitsuba
