#include "assignment/submission.hpp"

#include "assignment/regions.hpp"
#include "core/error.hpp"
#include "core/file.hpp"
#include "core/json.hpp"
#include "core/program.hpp"
#include "core/text.hpp"
#include "image/whole_file.hpp"

#include <algorithm>
#include <cstdlib>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <fstream>
#include <sstream>
#include <utility>

namespace sr::assignment {
namespace {

namespace fs = std::filesystem;

void write_text(const fs::path& file, const std::string& text) {
    fs::create_directories(file.parent_path());
    image::write_text(file, text);
}

const Task* task_of(const Assignment& assignment, const std::string& region) {
    const auto found = std::ranges::find(assignment.tasks, region, &Task::id);
    return found == assignment.tasks.end() ? nullptr : &*found;
}

void add_regions(Submission& submission, const Assignment& assignment, const std::string& file,
                 const std::string& text, const std::string& place) {
    std::string fault;
    try {
        for (const char* mark : {"\xff\xfe", "\xfe\xff"})
            if (text.starts_with(mark)) throw Error({place}, "is UTF-16", "save it as UTF-8");
        for (const Region& region : regions_of(with_plain_breaks(text), place))
            if (region.name == helpers_region || task_of(assignment, region.name))
                submission.codes[region.name] = {place, region.begin_line + 1, region.text};
    } catch (const Error& error) {
        fault = error.what();
    }
    for (const Task& task : assignment.tasks) {
        if (task.file != file) continue;
        if (!fault.empty())
            submission.faults[task.id] = fault;
        else if (!submission.codes.contains(task.id))
            submission.faults[task.id] =
                fmt::format("{}: the region {} is missing: write // begin {} and // end {} around its code",
                            place, task.id, task.id, task.id);
    }
}

/// True for a file that students write in; the others are given.
bool is_written(const Assignment& assignment, const std::string& file) {
    return !regions_of(assignment.files.at(file), assignment.place_of(file)).empty();
}

} // namespace

FolderLabel label_of(const fs::path& submission) {
    const fs::path label = submission / "assignment.json";
    if (fs::is_directory(submission) && !fs::exists(label))
        throw Error({label.string()}, "no file", "put it back: `steradian assignment new` makes it");
    return label_of(SubmittedFiles(submission));
}

FolderLabel label_of(const SubmittedFiles& files) {
    const std::string name = "assignment.json";
    const JsonFile text(files.place(name), files.text(name));
    const JsonObject root(text, JsonObject::Pointer(""));
    if (!root.has("assignment"))
        root.fail("no student's folder", "make one with `steradian assignment new NAME DIR`");
    FolderLabel label{root.required_text("assignment"), root.text("student", "")};
    constexpr std::size_t max_id = 200; // bytes: it stands in cells, names of files and arguments
    for (const auto& [key, id] : {std::pair{"assignment", &label.assignment}, {"student", &label.student}})
        if (id->size() > max_id) root.fail_at(key, "longer than 200 bytes", "write the id alone");
    return label;
}

Submission read_submission(const Assignment& assignment, const SubmittedFiles& files) {
    Submission submission;
    for (const auto& [name, reference] : assignment.files) {
        if (!is_written(assignment, name)) continue; // given
        try {
            add_regions(submission, assignment, name, files.text(name), files.place(name).string());
        } catch (const Error& error) {
            for (const Task& task : assignment.tasks)
                if (task.file == name) submission.faults[task.id] = error.what();
        }
    }
    return submission;
}

std::vector<fs::path> files_of(const fs::path& submission) {
    if (!fs::is_directory(submission)) return {submission};
    const Assignment assignment = load(assignment_of(label_of(submission)));
    std::vector<fs::path> files{submission / "assignment.json"};
    for (const auto& [name, reference] : assignment.files)
        if (is_written(assignment, name)) files.push_back(submission / name);
    return files;
}

void pack(const fs::path& submission, const std::string& result, const fs::path& archive) {
    const SubmittedFiles files(submission);
    std::vector<PackedFile> packed;
    for (const fs::path& file : files_of(submission)) {
        const std::string name = file.filename().string();
        packed.push_back({name, files.text(name)});
    }
    if (!result.empty()) packed.push_back({"result.json", result});
    write_archive(archive, packed);
}

std::string student_version(const Assignment& assignment, const std::string& file) {
    const std::string& text = assignment.files.at(file);
    const std::vector<Region> regions = regions_of(text, assignment.place_of(file));
    std::string result;
    std::istringstream lines(text);
    int number = 0;
    for (std::string line; std::getline(lines, line);) {
        ++number;
        const auto region = std::ranges::find_if(
            regions, [number](const Region& r) { return r.begin_line <= number && number <= r.end_line; });
        if (region == regions.end()) {
            result += line + "\n";
        } else if (number == region->begin_line) {
            const Task* task = task_of(assignment, region->name);
            if (!task) {
                result +=
                    fmt::format("// begin {}: functions of your own that several tasks use\n// end {}\n",
                                region->name, region->name);
                continue;
            }
            result += fmt::format("// begin {}: {} ({:g} points)\n", task->id, task->title, task->points());
            result +=
                stub_of(region->text, task->functions, assignment.place_of(file), region->begin_line + 1);
            result += fmt::format("// end {}\n", task->id);
        }
    }
    return result;
}

Submission empty_submission(const Assignment& assignment) {
    Submission submission;
    for (const auto& [name, text] : assignment.files)
        if (is_written(assignment, name))
            add_regions(submission, assignment, name, student_version(assignment, name), name);
    return submission;
}

void make_folder(const Assignment& assignment, const fs::path& folder, const std::string& student) {
    std::error_code failure;
    if (fs::exists(folder, failure) && !fs::is_empty(folder, failure))
        throw Error({folder.string()}, "is there and not empty", "name a new folder");
    const Parameters parameters = parameters_of(assignment, student);
    for (const auto& [name, text] : assignment.files)
        write_text(folder / name, student_version(assignment, name));
    if (!parameters.empty()) write_text(folder / "parameters.glsl", parameters_glsl(assignment, parameters));
    const nlohmann::ordered_json label{{"assignment", assignment.id}, {"student", student}};
    write_text(folder / "assignment.json", label.dump(2) + "\n");
    write_text(folder / ".vscode" / "extensions.json", "{ \"recommendations\": [\"slevesque.shader\"] }\n");
    write_text(
        folder / ".vscode" / "settings.json",
        "{ \"files.associations\": { \"*.glsl\": \"glsl\", \"*.frag\": \"glsl\", \"*.vert\": \"glsl\" } }\n");
    for (const char* page : {"README.md", "README.html"})
        if (const fs::path file = assignment.folder / page; fs::exists(file))
            write_text(folder / page, substituted(read_text(file), parameters, file.string()));
    for (const char* part : {"figures", "scenes", "overlay"})
        if (const fs::path from = assignment.folder / part; fs::is_directory(from))
            fs::copy(from, folder / part, fs::copy_options::recursive);
    if (!fs::is_directory(folder / "scenes")) return;
    for (const auto& entry : fs::recursive_directory_iterator(folder / "scenes"))
        if (entry.path().extension() == ".gltf")
            write_text(entry.path(),
                       substituted_json(read_text(entry.path()), parameters, entry.path().string()));
}

fs::path assignments_folder() {
    std::vector<std::string> places;
    if (const char* named = std::getenv("STERADIAN_ASSIGNMENTS")) places.emplace_back(named);
    for (const char* place :
         {"assignments", "../share/steradian/assignments"}) // in a build folder; installed
        places.push_back((program_file().parent_path() / place).lexically_normal().string());
    for (const std::string& place : places)
        if (fs::is_directory(place)) return place;
    throw Error(fmt::format("no folder of assignments in {}", fmt::join(places, ", ")),
                "install them, or name their folder in $STERADIAN_ASSIGNMENTS");
}

namespace {

fs::path known_assignment(const std::string& name) {
    std::vector<std::string> known;
    for (const auto& entry : fs::directory_iterator(assignments_folder())) {
        const std::string id = entry.path().filename().string();
        if (!fs::exists(entry.path() / "assignment.json")) continue;
        if (id == name || id.starts_with(name + "-")) return entry.path();
        known.push_back(id);
    }
    std::ranges::sort(known);
    throw Error(fmt::format("no assignment '{}'", name), fmt::format("there are {}", fmt::join(known, ", ")));
}

} // namespace

fs::path assignment_of(const FolderLabel& label) { return known_assignment(label.assignment); }

fs::path assignment_named(const std::string& name) {
    if (fs::exists(fs::path(name) / "assignment.json")) return name;
    return known_assignment(name);
}

} // namespace sr::assignment
