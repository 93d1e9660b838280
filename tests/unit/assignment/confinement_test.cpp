// A process that confines itself, and then tries what it must not.
#include "assignment/confinement.hpp"
#include "support/address.hpp"

#include <cerrno>
#include <csignal>
#include <cstdlib>
#include <fcntl.h>
#include <filesystem>
#include <fstream>
#include <functional>
#include <string>
#include <sys/socket.h>
#include <sys/wait.h>
#include <thread>
#include <unistd.h>
#include <vector>

using namespace sr::assignment;
using sr::testing::Test;

namespace {

namespace fs = std::filesystem;

/// A folder with a secret beside the folders that may be read and written.
struct Place {
    fs::path root;

    Place() {
        std::string name = (fs::temp_directory_path() / "steradian-confinement-XXXXXX").string();
        root = mkdtemp(name.data());
        for (const char* part : {"given", "results", "secret"}) {
            fs::create_directory(root / part);
            std::ofstream(root / part / "text") << part;
        }
    }
    ~Place() { fs::remove_all(root); }
    Place(const Place&) = delete;
    Place& operator=(const Place&) = delete;
};

/// Runs a confined child. @return bit i for claim i that holds; -1 if it did not end by itself
int told_by_child(const Place& place, const std::vector<std::function<bool()>>& claims, bool& lacks_files,
                  bool& lacks_calls) {
    const pid_t child = fork();
    if (child == 0) {
        int told = confine_files({{place.root / "given"}, place.root / "results", 5, 4096}).empty() ? 0 : 64;
        if (!confine_calls().empty()) told |= 128;
        for (std::size_t i = 0; i < claims.size(); ++i)
            if (claims[i]()) told |= 1 << i;
        _exit(told);
    }
    int status = 0;
    waitpid(child, &status, 0);
    if (!WIFEXITED(status)) return -1;
    lacks_files = (WEXITSTATUS(status) & 64) != 0;
    lacks_calls = (WEXITSTATUS(status) & 128) != 0;
    return WEXITSTATUS(status) & 63;
}

bool opens(const fs::path& file, int flags) {
    const int descriptor = open(file.c_str(), flags, 0666);
    if (descriptor >= 0) close(descriptor);
    return descriptor >= 0;
}

const Test files("unit.assignment.confinement.files", [] {
    const Place place;
    bool lacks_files = false, lacks_calls = false;
    const int told = told_by_child(place,
                                   {[&] { return opens(place.root / "given" / "text", O_RDONLY); },
                                    [&] { return opens(place.root / "results" / "new", O_WRONLY | O_CREAT); },
                                    [&] { return !opens(place.root / "secret" / "text", O_RDONLY); },
                                    [&] { return !opens(place.root / "given" / "new", O_WRONLY | O_CREAT); },
                                    [&] { return !opens("/tmp/steradian-escaped", O_WRONLY | O_CREAT); }},
                                   lacks_files, lacks_calls);
    if (lacks_files) GTEST_SKIP() << "this system has no Landlock or no namespaces";
    EXPECT_EQ(told, 0b11111);
});

const Test calls("unit.assignment.confinement.calls", [] {
    const Place place;
    bool lacks_files = false, lacks_calls = false;
    const int told = told_by_child(place,
                                   {[] { return fork() < 0 && errno == EPERM; },
                                    [] { return socket(AF_INET, SOCK_STREAM, 0) < 0 && errno == EPERM; },
                                    [] { return execl("/bin/true", "true", nullptr) < 0 && errno == EPERM; },
                                    [] { return kill(getppid(), 0) < 0 && errno == EPERM; },
                                    [] {
                                        bool ran = false;
                                        std::thread([&] { ran = true; }).join();
                                        return ran;
                                    }},
                                   lacks_files, lacks_calls);
    if (lacks_calls) GTEST_SKIP() << "this build or this system has no seccomp";
    EXPECT_EQ(told, 0b11111);
});

const Test disk("unit.assignment.confinement.a_full_disk", [] {
    const Place place;
    bool lacks_files = false, lacks_calls = false;
    const int told = told_by_child(place, {[&] {
                                       std::ofstream(place.root / "results" / "large")
                                           << std::string(1 << 20, 'x') << std::flush;
                                       return false;
                                   }},
                                   lacks_files, lacks_calls);
    EXPECT_EQ(told, -1) << "the system ends a process that writes more than it may";
    EXPECT_LE(fs::file_size(place.root / "results" / "large"), 4096u);
});

} // namespace
