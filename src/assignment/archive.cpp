#include "assignment/archive.hpp"

#include "core/error.hpp"
#include "core/file.hpp"
#include "core/text.hpp"
#include "glsl/untrusted.hpp"

#include <algorithm>
#include <cstdint>
#include <fmt/format.h>
#include <memory>
#include <optional>
#include <zip.h>

namespace sr::assignment {
namespace {

namespace fs = std::filesystem;

constexpr std::uintmax_t max_text_bytes = 1 << 20;     // of one file
constexpr std::uintmax_t max_all_bytes = 8 << 20;      // of all texts
constexpr std::uintmax_t max_archive_bytes = 64 << 20; // packed
constexpr zip_int64_t max_entries = 10'000;
constexpr int max_depth = 8;                  // of folders
constexpr std::size_t max_lines = 20;         // of what was refused
constexpr zip_uint16_t first_dos_date = 0x21; // 1980-01-01: equal files make equal bytes
constexpr zip_uint32_t unix_type_mask = 0170000, unix_link = 0120000, unix_file = 0100000;

struct Discard {
    void operator()(zip* archive) const { zip_discard(archive); }
};

Error no_archive(const fs::path& file, const std::string& why) {
    return {{file.string()},
            "no submission: " + why,
            "name a folder that `steradian assignment new` made, or a file that `pack` made"};
}

std::string words_of(int code) {
    zip_error_t error;
    zip_error_init_with_code(&error, code);
    std::string words = zip_error_strerror(&error);
    zip_error_fini(&error);
    return words;
}

std::string last_name(const std::string& path) { return path.substr(path.find_last_of('/') + 1); }

bool leaves_its_folder(const std::string& path) {
    if (path.starts_with("/") || path.find('\\') != std::string::npos || path.find(':') != std::string::npos)
        return true;
    return std::ranges::any_of(fs::path(path), [](const fs::path& part) { return part == ".."; });
}

/// A file of a file manager, of which nothing is said.
bool is_of_a_system(const std::string& path) {
    return path.starts_with("__MACOSX/") || last_name(path).starts_with("._")
           || path.find("/.") != std::string::npos;
}

/// The bytes of an entry, one more than a text may have at most, whatever the archive says that its size is.
/// Absent if it is damaged. `size` gets the bytes that were unpacked.
std::optional<std::string> unpacked(zip* archive, zip_uint64_t index, std::size_t& size) {
    size = 0;
    zip_file_t* entry = zip_fopen_index(archive, index, 0);
    if (!entry) return std::nullopt;
    std::string text(max_text_bytes + 1, '\0');
    zip_int64_t count = 1;
    while (count > 0 && size < text.size()) {
        count = zip_fread(entry, text.data() + size, text.size() - size);
        if (count > 0) size += static_cast<std::size_t>(count);
    }
    zip_fclose(entry);
    if (count < 0) return std::nullopt;
    text.resize(size);
    return text;
}

/// True for an entry that is a link or a device; its mode is that of Unix if it was packed there.
bool is_no_file(zip* archive, zip_uint64_t index) {
    zip_uint8_t system = 0;
    zip_uint32_t attributes = 0;
    if (zip_file_get_external_attributes(archive, index, 0, &system, &attributes) != 0) return false;
    const zip_uint32_t type = (attributes >> 16) & unix_type_mask;
    return system == ZIP_OPSYS_UNIX && type != 0 && type != unix_file;
}

} // namespace

SubmittedFiles::SubmittedFiles(fs::path submission) : submission_(std::move(submission)) {
    std::error_code failure;
    if (fs::is_directory(submission_, failure))
        read_folder();
    else if (fs::is_regular_file(submission_, failure))
        read_archive(submission_);
    else
        throw no_archive(submission_, "no folder and no file");
}

void SubmittedFiles::refuse(const std::string& path, const std::string& what, const std::string& what_to_do) {
    refused_.insert_or_assign(leaves_its_folder(path) ? path : last_name(path),
                              Error({place(shorten(path, 200)).string()}, what, what_to_do));
}

/// True for a path whose text is to be read. What is no shader and no label is left alone.
bool SubmittedFiles::is_wanted(const std::string& path) {
    if (leaves_its_folder(path)) {
        refuse(path, "a name outside the archive", "pack the folder again");
        return false;
    }
    if (is_of_a_system(path) || path.ends_with('/')) return false;
    const std::string name = last_name(path);
    if (name != "assignment.json" && !name.ends_with(".glsl")) return false;
    try {
        glsl::require_plain_name(name, place(shorten(path, 200)).string());
    } catch (const Error& error) {
        refused_.insert_or_assign(name, error);
        return false;
    }
    return true;
}

/// Adds bytes that were read, kept or not, since unpacking takes time. @throws Error above the limit
void SubmittedFiles::count_bytes(std::size_t count) {
    bytes_ += count;
    if (bytes_ > max_all_bytes) throw no_archive(submission_, "more than 8 MiB of shaders");
}

/// Of two files of one name the one that lies in fewer folders counts.
void SubmittedFiles::keep(const std::string& path, std::string text) {
    const std::string name = last_name(path);
    count_bytes(text.size());
    if (text.size() > max_text_bytes) return refuse(path, "larger than 1 MiB", "hand in the shaders alone");
    if (const auto other = paths_.find(name); other != paths_.end()) {
        const auto depth = [](const std::string& p) { return std::ranges::count(p, '/'); };
        if (depth(other->second) == depth(path)) {
            texts_.erase(name);
            return refuse(path, fmt::format("two files of this name, the other is {}", shown(other->second)),
                          "keep one");
        }
        if (depth(other->second) < depth(path)) return;
        refused_.erase(name);
    }
    paths_[name] = path;
    texts_[name] = std::move(text);
}

void SubmittedFiles::read_folder() {
    std::vector<fs::path> archives;
    std::error_code failure;
    fs::recursive_directory_iterator entry(submission_, failure);
    if (failure) throw no_archive(submission_, failure.message());
    zip_int64_t count = 0;
    for (; entry != fs::recursive_directory_iterator(); entry.increment(failure)) {
        if (failure) throw no_archive(submission_, failure.message());
        if (++count > max_entries) throw no_archive(submission_, "more than 10000 files");
        if (entry.depth() >= max_depth) entry.disable_recursion_pending();
        const fs::path file = entry->path();
        const std::string path = file.lexically_relative(submission_).generic_string();
        const fs::file_status status = fs::symlink_status(file, failure);
        if (fs::is_directory(status)) continue;
        if (file.extension() == ".zip" && fs::is_regular_file(status)) archives.push_back(file);
        if (!is_wanted(path)) continue;
        if (fs::is_symlink(status)) {
            refuse(path, "a link", "hand in the file itself");
        } else if (!fs::is_regular_file(status)) {
            refuse(path, "no regular file", "hand in a file");
        } else if (fs::file_size(file, failure) > max_text_bytes) {
            refuse(path, "larger than 1 MiB", "hand in the shaders alone");
        } else {
            keep(path, read_text(file));
        }
    }
    if (failure) throw no_archive(submission_, failure.message()); // an increment that fails is the end
    const bool has_shaders =
        std::ranges::any_of(texts_, [](const auto& t) { return t.first.ends_with(".glsl"); });
    if (archives.size() == 1 && !has_shaders) read_archive(archives.front());
}

void SubmittedFiles::read_archive(const fs::path& file) {
    std::error_code failure;
    if (fs::file_size(file, failure) > max_archive_bytes) throw no_archive(file, "larger than 64 MiB");
    int code = 0;
    const std::unique_ptr<zip, Discard> archive(zip_open(file.c_str(), ZIP_RDONLY, &code));
    if (!archive) throw no_archive(file, words_of(code));
    const zip_int64_t count = zip_get_num_entries(archive.get(), 0);
    if (count > max_entries) throw no_archive(file, "more than 10000 files");
    for (zip_int64_t i = 0; i < count; ++i) {
        const auto index = static_cast<zip_uint64_t>(i);
        const char* name = zip_get_name(archive.get(), index, ZIP_FL_ENC_GUESS);
        const std::string path = name ? name : "";
        if (!is_wanted(path)) continue;
        if (is_no_file(archive.get(), index)) {
            refuse(path, "a link", "hand in the file itself");
            continue;
        }
        std::size_t size = 0;
        auto text = unpacked(archive.get(), index, size);
        if (text) {
            keep(path, std::move(*text));
        } else {
            count_bytes(size);
            refuse(path, "is damaged or encrypted", "pack the folder again: `steradian assignment pack`");
        }
    }
    if (texts_.empty() && refused_.empty()) throw no_archive(file, "it has no .glsl file");
}

std::string SubmittedFiles::text(const std::string& name) const {
    if (const auto found = texts_.find(name); found != texts_.end()) return found->second;
    if (const auto why = refused_.find(name); why != refused_.end()) throw why->second;
    throw Error({place(name).string()}, "no file", "put it back: `steradian assignment new` makes it");
}

std::vector<std::string> SubmittedFiles::refused() const {
    std::vector<std::string> lines;
    for (const auto& [name, line] : refused_) {
        if (lines.size() == max_lines) {
            lines.push_back(fmt::format("{}: {} more were refused: pack the folder again",
                                        submission_.string(), refused_.size() - max_lines));
            break;
        }
        lines.emplace_back(line.what());
    }
    return lines;
}

void write_archive(const fs::path& archive, const std::vector<PackedFile>& files) {
    int code = 0;
    zip* zipped = zip_open(archive.c_str(), ZIP_CREATE | ZIP_TRUNCATE, &code);
    const auto refuse = [&](const std::string& why) {
        if (zipped) zip_discard(zipped);
        throw Error({archive.string()}, "cannot be written: " + why, "name another file with -o");
    };
    if (!zipped) refuse(words_of(code));
    for (const PackedFile& file : files) {
        zip_source_t* source = zip_source_buffer(zipped, file.text.data(), file.text.size(), 0);
        const zip_int64_t index =
            source ? zip_file_add(zipped, file.name.c_str(), source, ZIP_FL_ENC_UTF_8) : -1;
        if (index < 0) refuse(zip_strerror(zipped));
        zip_file_set_dostime(zipped, static_cast<zip_uint64_t>(index), 0, first_dos_date, 0);
    }
    if (zip_close(zipped) < 0) refuse(zip_strerror(zipped));
}

} // namespace sr::assignment
