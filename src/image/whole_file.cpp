#include "image/whole_file.hpp"

#include "core/error.hpp"

#include <atomic>
#include <cerrno>
#include <cstring>
#include <fcntl.h>
#include <fmt/format.h>
#include <optional>
#include <sys/stat.h>
#include <unistd.h>

namespace sr::image {
namespace {

namespace fs = std::filesystem;

fs::path folder_of(const fs::path& file) {
    return file.has_parent_path() ? file.parent_path() : fs::path(".");
}

/// @param target where the links of `file` lead
[[noreturn]] void fail(const fs::path& file, const fs::path& target, int cause) {
    const Location where{file.string()};
    const fs::path folder = folder_of(target);
    std::error_code ignored;
    switch (cause) {
    case ENOENT:
    case ENOTDIR:
        if (fs::is_directory(folder, ignored)) // such as /proc
            throw Error(where, fmt::format("the folder {} takes no new files", folder.string()),
                        "choose another folder");
        throw Error(where, fmt::format("there is no folder {}", folder.string()), "create it first");
    case EACCES:
    case EPERM:
    case EROFS:
        throw Error(where, fmt::format("no permission to write in {}", folder.string()),
                    "choose a folder of yours, or change its permissions");
    case ENOSPC:
    case EDQUOT: throw Error(where, "the disk is full", "free some space, or write to another disk");
    case EFBIG:
        throw Error(where, "the file would exceed the size limit",
                    "raise the limit, or write a smaller image");
    case ELOOP: throw Error(where, "its symbolic links lead in a circle", "name another file");
    case ENAMETOOLONG: throw Error(where, "the name is too long", "choose a shorter one");
    case EISDIR: throw Error(where, "this is a folder", "name a file");
    default:
        throw Error(where, fmt::format("cannot be written ({})", std::strerror(cause)), "try another place");
    }
}

/// The file that a chain of symbolic links leads to, which need not exist; `file` itself if it is no link.
fs::path end_of_links(const fs::path& file) {
    constexpr int max_links = 40; // as in Linux
    fs::path end = file;
    std::error_code failure;
    for (int i = 0; i < max_links && fs::is_symlink(fs::symlink_status(end, failure)); ++i) {
        const fs::path next = fs::read_symlink(end, failure);
        if (failure) fail(file, end, failure.value());
        end = next.is_absolute() ? next : end.parent_path() / next;
    }
    if (fs::is_symlink(fs::symlink_status(end, failure))) fail(file, end, ELOOP);
    return end;
}

/// The status of the file that is to be replaced; absent if there is none.
/// @throws Error if it may not be replaced
std::optional<struct stat> status_of(const fs::path& target, const fs::path& name) {
    struct stat status {};
    if (stat(target.c_str(), &status) != 0) {
        if (errno == ENOENT) return std::nullopt;
        fail(name, target, errno);
    }
    if (S_ISDIR(status.st_mode)) fail(name, target, EISDIR);
    if (!S_ISREG(status.st_mode)) throw Error({name.string()}, "this is not a regular file", "name a file");
    if (access(target.c_str(), W_OK) != 0)
        throw Error({name.string()}, fmt::format("the file cannot be replaced ({})", std::strerror(errno)),
                    "change its permissions, or name another file");
    return status;
}

} // namespace

/// A file while it is being written: closed and removed unless it was renamed into place.
class WholeFiles::Temporary {
public:
    explicit Temporary(const fs::path& name) : name_(name), target_(end_of_links(name)) {
        static std::atomic<int> count{0};
        const auto before = status_of(target_, name_);
        path_ = folder_of(target_) / fmt::format(".steradian-{}-{}.tmp", getpid(), count++);
        descriptor_ = open(path_.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
        if (descriptor_ < 0) fail(name_, target_, errno);
        if (before) keep(*before);
    }
    Temporary(const Temporary&) = delete;
    Temporary& operator=(const Temporary&) = delete;
    ~Temporary() {
        if (descriptor_ >= 0) close(descriptor_);
        if (!is_in_place_) unlink(path_.c_str());
    }

    void write(std::span<const std::uint8_t> bytes) {
        while (!bytes.empty()) {
            const ssize_t written = ::write(descriptor_, bytes.data(), bytes.size());
            if (written < 0 && errno == EINTR) continue;
            if (written < 0) fail(name_, target_, errno);
            bytes = bytes.subspan(static_cast<std::size_t>(written));
        }
        const int closed = close(descriptor_); // some file systems tell here that the disk is full
        descriptor_ = -1;
        if (closed != 0) fail(name_, target_, errno);
    }

    const fs::path& path() const { return path_; }

    void put_in_place() {
        if (rename(path_.c_str(), target_.c_str()) != 0) fail(name_, target_, errno);
        is_in_place_ = true;
    }

private:
    /// Owner, group and mode of the file that is replaced, as far as this user may.
    void keep(const struct stat& before) const {
        constexpr mode_t permissions = 0777;
        [[maybe_unused]] const int owned = fchown(descriptor_, before.st_uid, before.st_gid);
        if (fchmod(descriptor_, before.st_mode & permissions) != 0) fail(name_, target_, errno);
    }

    fs::path name_;   // as the user says it
    fs::path target_; // where its links lead
    fs::path path_;
    int descriptor_ = -1;
    bool is_in_place_ = false;
};

WholeFiles::WholeFiles() = default;
WholeFiles::~WholeFiles() = default;

void WholeFiles::add(const fs::path& file, std::span<const std::uint8_t> bytes) {
    temporaries_.push_back(std::make_unique<Temporary>(file));
    temporaries_.back()->write(bytes);
}

fs::path WholeFiles::reserve(const fs::path& file) {
    temporaries_.push_back(std::make_unique<Temporary>(file));
    temporaries_.back()->write({});
    return temporaries_.back()->path();
}

void WholeFiles::put_in_place() {
    for (const auto& temporary : temporaries_) temporary->put_in_place();
    temporaries_.clear();
}

void write_whole(const fs::path& file, std::span<const std::uint8_t> bytes) {
    WholeFiles files;
    files.add(file, bytes);
    files.put_in_place();
}

void write_text(const fs::path& file, std::string_view text) {
    write_whole(file, {reinterpret_cast<const std::uint8_t*>(text.data()), text.size()});
}

void require_writable(const fs::path& file) {
    const fs::path target = end_of_links(file);
    status_of(target, file);
    const fs::path folder = folder_of(target);
    struct stat status {};
    if (stat(folder.c_str(), &status) != 0) fail(file, target, errno);
    if (!S_ISDIR(status.st_mode)) fail(file, target, ENOTDIR);
    if (access(folder.c_str(), W_OK | X_OK) != 0) fail(file, target, errno);
}

} // namespace sr::image
