#pragma once
// Submissions of a class, as learning platforms download them.
#include <filesystem>
#include <string>
#include <vector>

namespace sr::assignment {

/// A submission and who handed it in, as the platform says.
struct HandedIn {
    std::string key;  // a file name of letters, digits, `_`, `-` and `.`; another for each submission
    std::string name; // of the person; the file's own name where the platform gives none
    std::string id;   // the person's; may be empty
    std::filesystem::path path; // a folder or a zip file
};

struct ClassFolder {
    std::vector<HandedIn> submissions; // in the order of their keys
    std::vector<std::string> remarks;  // on what was left out, one line each
};

/// Lists a folder: each folder or zip file in it is a submission.
/// Moodle: "Ann Example_4711_assignsubmission_file" (a folder; with "_NAME.zip" a file); 4711 is the
/// participant's number there, no student's id. Online texts are left out.
/// Gradescope: "submission_4711", with names and ids in submission_metadata.yml. @throws Error if it is no
/// folder, or has no submission
ClassFolder class_folder(const std::filesystem::path& folder);

/// The SHA-256 of a file in hexadecimal; empty if it cannot be read.
std::string digest_of(const std::filesystem::path& file);

/// Changes with each change of a submission's files: their names and contents.
std::string fingerprint_of(const std::filesystem::path& submission);

} // namespace sr::assignment
