#pragma once
// A student's folder: made from an assignment, read back.
#include "assignment/archive.hpp"
#include "assignment/evaluation.hpp"

#include <filesystem>
#include <map>
#include <optional>
#include <string>

namespace sr::assignment {

/// The identity of a folder, from its assignment.json.
struct FolderLabel {
    std::string assignment; // "a3-brdf"
    std::string student;
};

/// Of a folder or an archive. @throws Error if it is none that `assignment new` or `pack` made
FolderLabel label_of(const std::filesystem::path& submission);
FolderLabel label_of(const SubmittedFiles& files);

/// A student's code by task, and what is wrong with files that cannot be read as regions.
struct Submission {
    Codes codes;                               // by region, `helpers` among them
    std::map<std::string, std::string> faults; // by task: one line
};

/// Reads the student's *.glsl files. Whatever is wrong with them becomes a fault of the tasks concerned.
Submission read_submission(const Assignment& assignment, const SubmittedFiles& files);

/// A folder's label and the files that its student writes; an archive itself. @throws Error
std::vector<std::filesystem::path> files_of(const std::filesystem::path& submission);

/// Writes these files of a folder, and the text `result` as result.json unless it is empty, to a zip file.
/// What the student's own check found is no proof: `check` never reads it. @throws Error
void pack(const std::filesystem::path& folder, const std::string& result,
          const std::filesystem::path& archive);

/// The student's version of one of the reference's files: signatures with bodies that are still to be
/// written.
/// @throws Error for a region that has no function of its task
std::string student_version(const Assignment& assignment, const std::string& file);

/// The functions still to be written, as a submission.
Submission empty_submission(const Assignment& assignment);

/// Makes a student's folder: shaders, handout, figures, scenes, editor settings. @throws Error if the folder
/// is there and not empty
void make_folder(const Assignment& assignment, const std::filesystem::path& folder,
                 const std::string& student);

/// Where assignments lie: $STERADIAN_ASSIGNMENTS, assignments beside the program (a build folder's link), or
/// ../share/steradian/assignments from there (where they are installed).
/// @throws Error naming the places, if none is a folder
std::filesystem::path assignments_folder();

/// The assignment of a label, which stands in the folder of assignments: a student's file names no other
/// place.
/// @throws Error
std::filesystem::path assignment_of(const FolderLabel& label);

/// The assignment of this name, or the one whose name begins with it and "-": "a3" is "a3-brdf". @throws
/// Error
std::filesystem::path assignment_named(const std::string& name);

} // namespace sr::assignment
