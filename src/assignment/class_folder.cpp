#include "assignment/class_folder.hpp"

#include "core/error.hpp"
#include "core/file.hpp"
#include "core/text.hpp"
#include "golden/sha256.hpp"

#include <algorithm>
#include <cctype>
#include <cstdint>
#include <fmt/format.h>
#include <map>
#include <regex>
#include <set>
#include <sstream>

namespace sr::assignment {
namespace {

namespace fs = std::filesystem;

constexpr int max_fingerprint_files = 10'000;
constexpr std::uintmax_t max_fingerprint_bytes = 64 << 20; // of one file; no larger one is taken
constexpr std::uintmax_t max_digested_bytes = 256 << 20;   // of all; of further files the time counts

std::string plain(const std::string& text) {
    std::string result = shorten(text, 60);
    for (char& c : result)
        if (!std::isalnum(static_cast<unsigned char>(c)) && c != '-' && c != '_' && c != '.') c = '_';
    if (result.empty() || result[0] == '.' || result[0] == '-') result.insert(0, "_");
    return result;
}

/// The value behind "key:" of a line of YAML, without quotes.
std::string value_of(const std::string& line, std::size_t colon) {
    const std::string value(trimmed(std::string_view(line).substr(colon)));
    const bool is_quoted =
        value.size() > 1 && (value[0] == '"' || value[0] == '\'') && value.back() == value[0];
    return is_quoted ? value.substr(1, value.size() - 2) : value;
}

struct Person {
    std::string name, id;
};

/// The submitters of Gradescope's submission_metadata.yml by the submission's name. Of a group the names are
/// joined, and the id is the first one's.
std::map<std::string, Person> gradescope_people(const fs::path& file) {
    std::map<std::string, Person> people;
    std::error_code ignored;
    if (!fs::is_regular_file(fs::symlink_status(file, ignored))) return people;
    std::istringstream lines(read_text(file));
    Person* person = nullptr;
    for (std::string line; std::getline(lines, line);) {
        if (!line.empty() && !std::isspace(static_cast<unsigned char>(line[0]))) {
            person = &people[line.substr(0, line.find(':'))];
            continue;
        }
        if (!person) continue;
        if (const std::size_t at = line.find(":name:"); at != std::string::npos)
            person->name += (person->name.empty() ? "" : ", ") + value_of(line, at + 6);
        if (const std::size_t at = line.find(":sid:"); at != std::string::npos && person->id.empty())
            person->id = value_of(line, at + 5);
    }
    return people;
}

HandedIn handed_in(const fs::path& path, const std::map<std::string, Person>& people) {
    static const std::regex moodle(R"((.+)_([0-9]+)_assignsubmission_file_?(.*))");
    const std::string name = path.filename().string();
    const std::string stem = path.extension() == ".zip" ? path.stem().string() : name;
    if (const auto found = people.find(stem); found != people.end())
        return {plain(stem), found->second.name.empty() ? stem : found->second.name, found->second.id, path};
    std::smatch found;
    if (name.size() < 300 && std::regex_match(name, found, moodle))
        return {plain(found.str(1) + "_" + found.str(2)), found[1], "", path};
    return {plain(stem), stem, "", path};
}

} // namespace

std::string digest_of(const fs::path& file) {
    try {
        return golden::sha256_text(read_text(file));
    } catch (const Error&) {
        return {};
    }
}

ClassFolder class_folder(const fs::path& folder) {
    std::error_code failure;
    if (!fs::is_directory(folder, failure))
        throw Error({folder.string()}, "no folder", "name the folder of all submissions");
    const auto people = gradescope_people(folder / "submission_metadata.yml");
    ClassFolder result;
    const auto unreadable = [&] {
        return Error({folder.string()}, failure.message(), "let this user read the folder");
    };
    fs::directory_iterator entries(folder, failure), end;
    if (failure) throw unreadable();
    for (; entries != end; entries.increment(failure)) {
        const fs::directory_entry& entry = *entries;
        const std::string name = entry.path().filename().string();
        const auto leave_out = [&](const char* what, const char* what_to_do) {
            result.remarks.emplace_back(Error({entry.path().string()}, what, what_to_do).what());
        };
        if (name == "submission_metadata.yml" || name.starts_with(".")) continue;
        const fs::file_status status = entry.symlink_status(failure);
        if (fs::is_symlink(status)) {
            leave_out("left out: a link", "put the submission itself there");
        } else if (name.find("_assignsubmission_onlinetext") != std::string::npos) {
            leave_out("left out: an online text", "ask for files in Moodle's settings of the assignment");
        } else if (fs::is_directory(status)
                   || (fs::is_regular_file(status) && entry.path().extension() == ".zip")) {
            result.submissions.push_back(handed_in(entry.path(), people));
        } else {
            leave_out("left out: no folder and no zip file", "pack it as a zip file");
        }
    }
    if (failure) throw unreadable(); // an increment that fails is the end
    if (result.submissions.empty())
        throw Error({folder.string()}, "no submission in it",
                    "put a folder or a zip file for each student there");
    std::ranges::sort(result.submissions, {}, &HandedIn::path);
    std::set<std::string> keys;
    for (HandedIn& one : result.submissions) {
        const std::string key = one.key;
        for (int i = 2; !keys.insert(one.key).second; ++i) one.key = fmt::format("{}-{}", key, i);
    }
    return result;
}

std::string fingerprint_of(const fs::path& submission) {
    std::vector<std::string> lines;
    std::uintmax_t digested = 0;
    const auto add = [&](const fs::path& file) {
        std::error_code ignored;
        const bool is_file = fs::is_regular_file(fs::symlink_status(file, ignored));
        const std::uintmax_t size = is_file ? fs::file_size(file, ignored) : 0;
        std::string content;
        if (is_file && size <= max_fingerprint_bytes) {
            digested += size;
            content = digested <= max_digested_bytes
                          ? digest_of(file)
                          : fmt::format("{}", fs::last_write_time(file, ignored).time_since_epoch().count());
        }
        lines.push_back(fmt::format("{} {} {}", file.lexically_relative(submission).string(), size, content));
    };
    std::error_code failure;
    add(submission);
    if (fs::is_directory(fs::symlink_status(submission, failure)))
        for (fs::recursive_directory_iterator i(submission, failure), end; !failure && i != end;
             i.increment(failure)) {
            if (std::ssize(lines) > max_fingerprint_files) break;
            if (i.depth() > 8) i.disable_recursion_pending();
            add(i->path());
        }
    std::ranges::sort(lines);
    std::string text;
    for (const std::string& line : lines) text += line + "\n";
    return golden::sha256_text(text);
}

} // namespace sr::assignment
