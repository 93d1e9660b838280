#pragma once
// Texts of a submission, from a folder or a zip file that somebody untrusted made.
#include "core/error.hpp"

#include <filesystem>
#include <map>
#include <string>
#include <vector>

namespace sr::assignment {

/// The *.glsl files and the label (assignment.json) of a submission, read once. Nothing of an archive reaches
/// the disk, no link is followed, and no more is read than a text may have.
class SubmittedFiles {
public:
    /// `submission`: a folder, or a zip file. A folder with one zip file and no shader is that zip file's.
    /// Files are known by their last name, in whatever folder of the submission they lie.
    /// @throws Error if it is neither, or holds more than 10,000 files
    explicit SubmittedFiles(std::filesystem::path submission);

    /// The name of a file in messages: SUBMISSION/NAME.
    std::filesystem::path place(const std::string& name) const { return submission_ / name; }

    bool has(const std::string& name) const { return texts_.contains(name); }

    /// @throws Error if there is no such file, or that with which it was refused
    std::string text(const std::string& name) const;

    /// Lists what was not taken: one line each of `file: what: what to do`, at most 20.
    std::vector<std::string> refused() const;

private:
    void read_folder();
    void read_archive(const std::filesystem::path& file);
    void refuse(const std::string& path, const std::string& what, const std::string& what_to_do);
    bool is_wanted(const std::string& path);
    void count_bytes(std::size_t count);
    void keep(const std::string& path, std::string text);

    std::filesystem::path submission_;
    std::map<std::string, std::string> texts_; // by last name
    std::map<std::string, std::string> paths_; // of those, within the submission
    std::map<std::string, Error> refused_;     // by last name, or by path
    std::size_t bytes_ = 0;                    // of all texts
};

struct PackedFile {
    std::string name;
    std::string text;
};

/// Writes a zip file. Equal files make equal bytes. @throws Error
void write_archive(const std::filesystem::path& archive, const std::vector<PackedFile>& files);

} // namespace sr::assignment
