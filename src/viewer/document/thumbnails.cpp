#include "viewer/document/thumbnails.hpp"

#include "core/program.hpp"

#include <algorithm>
#include <array>
#include <csignal>
#include <cstdint>
#include <fcntl.h>
#include <fmt/format.h>
#include <spawn.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>
#include <utility>

extern char** environ; // NOLINT(readability-redundant-declaration): POSIX has programs declare it

namespace sr::viewer {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t max_pictures = 300;           // in the cache; the oldest go
constexpr auto patience = std::chrono::seconds(30); // with one file

/// FNV-1a, the same in every run and build (Fowler, Noll & Vo, RFC 9923).
std::uint64_t hash_of(const std::string& text) {
    std::uint64_t hash = 0xcbf29ce484222325u;
    for (const unsigned char c : text) hash = (hash ^ c) * 0x100000001b3u;
    return hash;
}

/// Another path, time or size of the file is another picture.
fs::path picture_in(const fs::path& folder, const std::string& file) {
    std::error_code failure;
    const fs::path whole = fs::absolute(file, failure).lexically_normal();
    const auto time = fs::last_write_time(whole, failure).time_since_epoch().count();
    const auto size = failure ? 0 : fs::file_size(whole, failure);
    if (failure) return {};
    return folder
           / fmt::format("{:016x}.png", hash_of(fmt::format("{}\n{}\n{}", whole.string(), time, size)));
}

void drop_old_ones(const fs::path& folder) {
    std::vector<std::pair<fs::file_time_type, fs::path>> all;
    std::error_code failure;
    for (fs::directory_iterator entry(folder, failure); !failure && entry != fs::directory_iterator();
         entry.increment(failure))
        if (entry->path().extension() == ".png")
            all.emplace_back(entry->last_write_time(failure), entry->path());
    if (all.size() <= max_pictures) return;
    std::ranges::sort(all);
    all.resize(all.size() - max_pictures);
    for (const auto& [time, file] : all) fs::remove(file, failure);
}

/// The picture while it is written; another window may write the same one.
fs::path unfinished(const fs::path& picture) {
    return fs::path(picture).replace_extension(fmt::format("{}.part.png", ::getpid()));
}

} // namespace

Thumbnails::Thumbnails(const std::vector<std::string>& files, fs::path folder) : folder_(std::move(folder)) {
    std::error_code failure;
    if (folder_.empty() || (fs::create_directories(folder_, failure), failure)) return;
    drop_old_ones(folder_);
    for (const std::string& file : files) {
        const fs::path picture = picture_in(folder_, file);
        if (picture.empty()) continue;
        if (fs::exists(picture, failure))
            pictures_[file] = picture;
        else
            wanted_.push_back(file);
    }
    std::ranges::reverse(wanted_);
}

Thumbnails::~Thumbnails() { stop(); }

void Thumbnails::stop() {
    if (process_ <= 0) return;
    ::kill(process_, SIGKILL); // it has nothing to tidy up but its unfinished file
    ::waitpid(process_, nullptr, 0);
    process_ = 0;
    std::error_code ignored;
    fs::remove(unfinished(picture_in(folder_, file_)), ignored);
}

/// Renders in a process of its own: a file that crashes or hangs a driver costs its picture alone.
void Thumbnails::start() {
    file_ = std::move(wanted_.back());
    wanted_.pop_back();
    const fs::path picture = picture_in(folder_, file_);
    if (picture.empty()) return; // the file is gone
    const std::string target = unfinished(picture).string(), size = fmt::format("{}x{}", width, height);
    std::vector<std::string> words{"steradian", "render", "--output", target, "--size", size,
                                   "--samples", "4",      "--time",   "10s",  "--",     file_};
    std::vector<char*> arguments;
    for (std::string& word : words) arguments.push_back(word.data());
    arguments.push_back(nullptr);
    posix_spawn_file_actions_t files;
    posix_spawn_file_actions_init(&files);
    for (const int stream : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO})
        posix_spawn_file_actions_addopen(&files, stream, "/dev/null", O_RDWR, 0);
    posix_spawnattr_t attributes;
    posix_spawnattr_init(&attributes);
    posix_spawnattr_setflags(&attributes, POSIX_SPAWN_SETPGROUP); // Ctrl-C is for us
    pid_t process = 0;
    const int refusal =
        posix_spawn(&process, program_to_start().c_str(), &files, &attributes, arguments.data(), environ);
    posix_spawnattr_destroy(&attributes);
    posix_spawn_file_actions_destroy(&files);
    if (refusal != 0) return wanted_.clear(); // the next one would fare alike
    process_ = process;
    ::setpriority(PRIO_PROCESS, static_cast<id_t>(process), 10); // the window comes first
    begun_ = Clock::now();
}

bool Thumbnails::update() {
    if (process_ <= 0) {
        if (!wanted_.empty()) start();
        return false;
    }
    int status = 0;
    if (::waitpid(process_, &status, WNOHANG) == 0) {
        if (Clock::now() - begun_ > patience) stop();
        return false;
    }
    process_ = 0;
    const fs::path picture = picture_in(folder_, file_), part = unfinished(picture);
    std::error_code failure;
    if (WIFEXITED(status) && WEXITSTATUS(status) == 0 && !picture.empty())
        fs::rename(part, picture, failure);
    else
        fs::remove(part, failure);
    const bool is_made = !failure && fs::exists(picture, failure);
    if (is_made) pictures_[file_] = picture;
    if (!wanted_.empty()) start();
    return is_made;
}

fs::path Thumbnails::picture_of(const std::string& file) const {
    const auto found = pictures_.find(file);
    return found == pictures_.end() ? fs::path() : found->second;
}

} // namespace sr::viewer
