#include "assignment/archive.hpp"

#include "core/error.hpp"
#include "core/file.hpp"

#include <algorithm>
#include <cstdint>
#include <fmt/format.h>
#include <zip.h>

namespace sr::assignment {
namespace {

namespace fs = std::filesystem;

constexpr std::uintmax_t max_text_bytes = 1 << 20;     // of one file
constexpr std::uintmax_t max_archive_bytes = 64 << 20; // packed
constexpr zip_int64_t max_entries = 10'000;
constexpr zip_uint16_t first_dos_date = 0x21; // 1980-01-01: equal files make equal bytes

Error no_archive(const fs::path& file, const std::string& why) {
    return {{file.string()},
            "no submission: " + why,
            "name a folder that `steradian assignment new` made, or a file that `pack` made"};
}

Error too_large(const fs::path& file) {
    return {{file.string()}, "larger than 1 MiB", "hand in the shaders alone"};
}

std::string words_of(int code) {
    zip_error_t error;
    zip_error_init_with_code(&error, code);
    std::string words = zip_error_strerror(&error);
    zip_error_fini(&error);
    return words;
}

/// The folder of assignment.json: "", or "my-a3/" if the folder itself was packed. @throws Error
std::string prefix_in(zip* archive, const fs::path& file) {
    const std::string_view label = "assignment.json";
    const zip_int64_t count = zip_get_num_entries(archive, 0);
    if (count > max_entries) throw no_archive(file, "more than 10000 entries");
    if (zip_name_locate(archive, "assignment.json", 0) >= 0) return "";
    for (zip_int64_t i = 0; i < count; ++i) {
        const char* bytes = zip_get_name(archive, static_cast<zip_uint64_t>(i), 0);
        const std::string_view name = bytes ? bytes : "";
        const std::size_t slash = name.find('/');
        if (slash != std::string_view::npos && name.substr(slash + 1) == label)
            return std::string(name.substr(0, slash + 1));
    }
    throw no_archive(file, "it has no assignment.json");
}

} // namespace

void SubmittedFiles::Close::operator()(zip* archive) const { zip_discard(archive); }

SubmittedFiles::SubmittedFiles(fs::path submission) : submission_(std::move(submission)) {
    std::error_code failure;
    if (fs::is_directory(submission_, failure)) return;
    if (!fs::is_regular_file(submission_, failure)) throw no_archive(submission_, "no folder and no file");
    if (fs::file_size(submission_, failure) > max_archive_bytes)
        throw no_archive(submission_, "larger than 64 MiB");
    int code = 0;
    archive_.reset(zip_open(submission_.c_str(), ZIP_RDONLY, &code));
    if (!archive_) throw no_archive(submission_, words_of(code));
    prefix_ = prefix_in(archive_.get(), submission_);
}

std::string SubmittedFiles::text(const std::string& name) const {
    if (archive_) return unpacked(name);
    const fs::path file = place(name);
    std::error_code failure;
    if (!fs::is_regular_file(fs::symlink_status(file, failure)))
        throw Error({file.string()}, "no file", "put it back: `steradian assignment new` makes it");
    if (fs::file_size(file, failure) > max_text_bytes) throw too_large(file);
    return read_text(file);
}

/// Reads no more than a text may have, whatever the archive says that the size is.
std::string SubmittedFiles::unpacked(const std::string& name) const {
    const fs::path file = place(name);
    zip_file_t* entry = zip_fopen(archive_.get(), (prefix_ + name).c_str(), 0);
    if (!entry)
        throw Error({file.string()}, zip_strerror(archive_.get()),
                    "pack the folder again: `steradian assignment pack`");
    std::string text(max_text_bytes + 1, '\0');
    std::size_t size = 0;
    zip_int64_t count = 1;
    while (count > 0 && size < text.size()) {
        count = zip_fread(entry, text.data() + size, text.size() - size);
        if (count > 0) size += static_cast<std::size_t>(count);
    }
    zip_fclose(entry);
    if (count < 0)
        throw Error({file.string()}, "is damaged", "pack the folder again: `steradian assignment pack`");
    if (size > max_text_bytes) throw too_large(file);
    text.resize(size);
    return text;
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
