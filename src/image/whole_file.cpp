#include "image/whole_file.hpp"

#include "core/error.hpp"

#include <atomic>
#include <cerrno>
#include <cstring>
#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

namespace sr::image {
namespace {

namespace fs = std::filesystem;

[[noreturn]] void fail(const fs::path& file, int cause) {
    const Location where{file.string()};
    const fs::path folder = file.has_parent_path() ? file.parent_path() : fs::path(".");
    switch (cause) {
    case ENOENT:
    case ENOTDIR:
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
    case EISDIR: throw Error(where, "this is a folder", "name a file");
    default:
        throw Error(where, fmt::format("cannot be written ({})", std::strerror(cause)), "try another place");
    }
}

/// The file while it is being written: closed and removed unless it was renamed into place.
class Temporary {
public:
    explicit Temporary(const fs::path& target) : target_(target) {
        static std::atomic<int> count{0};
        const std::string name = fmt::format(".steradian-{}-{}.tmp", getpid(), count++);
        path_ = target.parent_path() / name;
        descriptor_ = open(path_.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
        if (descriptor_ < 0) fail(target_, errno);
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
            if (written < 0) fail(target_, errno);
            bytes = bytes.subspan(static_cast<std::size_t>(written));
        }
    }

    void put_in_place() {
        const int closed = close(descriptor_); // some file systems tell here that the disk is full
        descriptor_ = -1;
        if (closed != 0) fail(target_, errno);
        if (rename(path_.c_str(), target_.c_str()) != 0) fail(target_, errno);
        is_in_place_ = true;
    }

private:
    fs::path target_;
    fs::path path_;
    int descriptor_ = -1;
    bool is_in_place_ = false;
};

} // namespace

void write_whole(const fs::path& file, std::span<const std::uint8_t> bytes) {
    Temporary temporary(file);
    temporary.write(bytes);
    temporary.put_in_place();
}

} // namespace sr::image
