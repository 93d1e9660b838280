#include "viewer/document/thumbnails.hpp"

#include "core/program.hpp"

#include <algorithm>
#include <array>
#include <csignal>
#include <cstdint>
#include <fcntl.h>
#include <fmt/format.h>
#include <fstream>
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

/// The messages of the process that writes a picture.
fs::path log_of(const fs::path& picture) {
    return fs::path(picture).replace_extension(fmt::format("{}.part.log", ::getpid()));
}

/// Says why pictures cannot be written into a folder, which is made; empty if they can.
std::string problem_of(const fs::path& folder) {
    if (folder.empty())
        return "The cache folder ($XDG_CACHE_HOME or ~/.cache) cannot be made, so the first page has no new "
               "pictures.";
    std::error_code failure;
    fs::create_directories(folder, failure);
    const fs::path trial = folder / fmt::format("{}.part.log", ::getpid());
    const bool is_written = !failure && std::ofstream(trial).put('\n').flush().good();
    fs::remove(trial, failure);
    return is_written
               ? ""
               : fmt::format("{} cannot be written, so the first page has no new pictures.", folder.string());
}

/// The last line of a log, which is the error of a process that has failed, without the name of its file.
std::string reason_in(const fs::path& log, const std::string& file) {
    std::ifstream in(log);
    std::string last;
    for (std::string line; std::getline(in, line);)
        if (!line.empty()) last = line;
    const std::string name = file + ":";
    if (last.starts_with(name)) last.erase(0, last.find_first_not_of(' ', name.size()));
    return last.empty() ? "It cannot be rendered." : last;
}

} // namespace

Thumbnails::Thumbnails(const std::vector<std::string>& files, fs::path folder) : folder_(std::move(folder)) {
    std::error_code failure;
    problem_ = problem_of(folder_);
    if (!folder_.empty()) drop_old_ones(folder_);
    for (const std::string& file : files) {
        const fs::path picture = picture_in(folder_, file);
        if (picture.empty())
            faults_[file] = "The file is not there.";
        else if (fs::exists(picture, failure))
            pictures_[file] = picture;
        else if (problem_.empty())
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
    const fs::path picture = picture_in(folder_, file_);
    fs::remove(unfinished(picture), ignored);
    fs::remove(log_of(picture), ignored);
}

/// Renders in a process of its own: a file that crashes or hangs a driver costs its picture alone.
void Thumbnails::start() {
    file_ = std::move(wanted_.back());
    wanted_.pop_back();
    const fs::path picture = picture_in(folder_, file_);
    if (picture.empty()) {
        faults_[file_] = "The file is not there any more.";
        return;
    }
    const std::string target = unfinished(picture).string(), size = fmt::format("{}x{}", width, height);
    std::vector<std::string> words{"steradian", "render", "--output", target, "--size", size,
                                   "--samples", "4",      "--time",   "10s",  "--",     file_};
    std::vector<char*> arguments;
    for (std::string& word : words) arguments.push_back(word.data());
    arguments.push_back(nullptr);
    posix_spawn_file_actions_t files;
    posix_spawn_file_actions_init(&files);
    for (const int stream : {STDIN_FILENO, STDOUT_FILENO})
        posix_spawn_file_actions_addopen(&files, stream, "/dev/null", O_RDWR, 0);
    constexpr mode_t for_its_owner = 0600;
    posix_spawn_file_actions_addopen(&files, STDERR_FILENO, log_of(picture).c_str(),
                                     O_WRONLY | O_CREAT | O_TRUNC, for_its_owner);
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
        if (Clock::now() - begun_ <= patience) return false;
        stop();
        faults_[file_] = fmt::format("Its picture takes longer than {} s.", patience.count());
        return true;
    }
    process_ = 0;
    end(status);
    if (!wanted_.empty()) start();
    return true;
}

/// Takes the picture of a process that has ended, or the reason why there is none.
void Thumbnails::end(int status) {
    const fs::path picture = picture_in(folder_, file_), part = unfinished(picture), log = log_of(picture);
    std::error_code failure;
    if (picture.empty()) {
        faults_[file_] = "The file is not there any more.";
    } else if (WIFSIGNALED(status)) {
        faults_[file_] = fmt::format("Rendering it ended with signal {}.", WTERMSIG(status));
    } else if (WEXITSTATUS(status) != 0) {
        faults_[file_] = reason_in(log, file_);
    } else {
        fs::rename(part, picture, failure);
        if (failure)
            faults_[file_] = "Its picture cannot be written: " + failure.message() + ".";
        else
            pictures_[file_] = picture;
    }
    fs::remove(part, failure);
    fs::remove(log, failure);
}

std::string Thumbnails::fault_of(const std::string& file) const {
    const auto found = faults_.find(file);
    return found == faults_.end() ? std::string() : found->second;
}

fs::path Thumbnails::picture_of(const std::string& file) const {
    const auto found = pictures_.find(file);
    return found == pictures_.end() ? fs::path() : found->second;
}

} // namespace sr::viewer
