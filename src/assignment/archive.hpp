#pragma once
// The texts of a submission, from a folder or from the archive that `assignment pack` makes.
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

struct zip;

namespace sr::assignment {

/// The files of a submission. Nothing of an archive reaches the disk; only requested names are read.
class SubmittedFiles {
public:
    /// `submission`: a folder, or a zip file with assignment.json at its root or in its one folder.
    /// @throws Error if it is neither
    explicit SubmittedFiles(std::filesystem::path submission);

    /// The name of a file in messages: SUBMISSION/NAME.
    std::filesystem::path place(const std::string& name) const { return submission_ / name; }

    /// @throws Error if there is no such file, or if it is larger than 1 MiB or cannot be read
    std::string text(const std::string& name) const;

private:
    struct Close {
        void operator()(zip* archive) const;
    };
    std::string unpacked(const std::string& name) const;

    std::filesystem::path submission_;
    std::unique_ptr<zip, Close> archive_; // null for a folder
    std::string prefix_;                  // of names in the archive
};

struct PackedFile {
    std::string name;
    std::string text;
};

/// Writes a zip file. Equal files make equal bytes. @throws Error
void write_archive(const std::filesystem::path& archive, const std::vector<PackedFile>& files);

} // namespace sr::assignment
