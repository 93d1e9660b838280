#include "core/file.hpp"

#include "core/error.hpp"
#include "core/limits.hpp"

#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

namespace sr {
namespace {

namespace fs = std::filesystem;

/// A regular file that is open for reading.
class OpenFile {
public:
    OpenFile(const fs::path& file, const std::string& name, const std::string& prefix)
        : name_(name), prefix_(prefix) {
        // O_NONBLOCK: a FIFO opens at once, so that its type can be checked.
        descriptor_ = open(file.c_str(), O_RDONLY | O_NONBLOCK | O_CLOEXEC | O_NOCTTY);
        std::error_code ignored;
        if (const int cause = errno; descriptor_ < 0 && cause == ENOENT && fs::is_symlink(file, ignored))
            fail("this symbolic link leads to no file", "name another file, or mend the link");
        else if (descriptor_ < 0)
            refuse(cause);
        struct stat status {};
        if (fstat(descriptor_, &status) != 0) refuse_open(errno);
        if (S_ISDIR(status.st_mode)) refuse_open(EISDIR);
        if (!S_ISREG(status.st_mode)) refuse_open(ENXIO);
        size_ = static_cast<std::uint64_t>(status.st_size);
    }
    ~OpenFile() { close(descriptor_); }
    OpenFile(const OpenFile&) = delete;
    OpenFile& operator=(const OpenFile&) = delete;

    std::uint64_t size() const { return size_; }

    void read(std::uint8_t* to, std::size_t count) const {
        while (count > 0) {
            const ssize_t got = ::read(descriptor_, to, count);
            if (got < 0 && errno == EINTR) continue;
            if (got <= 0) fail("the file cannot be read to its end", "check the disk");
            to += got;
            count -= static_cast<std::size_t>(got);
        }
    }

private:
    [[noreturn]] void refuse_open(int cause) const {
        close(descriptor_);
        refuse(cause);
    }

    [[noreturn]] void refuse(int cause) const {
        switch (cause) {
        case ENOENT:
        case ENOTDIR: fail("no such file", "check the path");
        case EISDIR: fail("this is a folder", "name a file");
        case ENXIO: // a socket, too
        case ENODEV: fail("this is not a regular file", "name a file");
        case EACCES:
        case EPERM: fail("the file cannot be opened", "check its permissions");
        default: fail(fmt::format("the file cannot be opened ({})", std::strerror(cause)), "check the path");
        }
    }

    [[noreturn]] void fail(const std::string& problem, const char* remedy) const {
        throw Error({name_}, prefix_ + problem, remedy);
    }

    const std::string& name_;
    const std::string& prefix_;
    int descriptor_ = -1;
    std::uint64_t size_ = 0;
};

} // namespace

std::vector<std::uint8_t> read_file(const fs::path& file, const std::string& name,
                                    const std::string& problem_prefix) {
    const OpenFile opened(file, name, problem_prefix);
    check_limit(Limit::file_bytes, opened.size(), name);
    std::vector<std::uint8_t> bytes(opened.size());
    opened.read(bytes.data(), bytes.size());
    return bytes;
}

std::string read_text(const fs::path& file) {
    const std::string name = file.string(), none;
    const OpenFile opened(file, name, none);
    check_limit(Limit::file_bytes, opened.size(), name);
    std::string text(opened.size(), '\0');
    opened.read(reinterpret_cast<std::uint8_t*>(text.data()), text.size());
    return text;
}

void require_regular_file(const fs::path& file) {
    const std::string name = file.string(), none;
    const OpenFile opened(file, name, none);
    check_limit(Limit::file_bytes, opened.size(), name);
}

ScratchFolder::ScratchFolder(std::string_view name) {
    const fs::path parent = fs::temp_directory_path();
    std::string made = (parent / fmt::format("steradian-{}-XXXXXX", name)).string();
    if (!mkdtemp(made.data()))
        throw Error({parent.string()}, "no folder can be made in it",
                    "name a folder that can be written in $TMPDIR");
    path_ = made;
}

ScratchFolder::~ScratchFolder() {
    std::error_code ignored;
    fs::remove_all(path_, ignored);
}

} // namespace sr
