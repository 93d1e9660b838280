#pragma once
// Confinement of a process that runs the code of others: files, processes, network, time and memory.
#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

namespace sr::assignment {

struct Confinement {
    std::vector<std::filesystem::path> readable; // besides the system's folders
    std::filesystem::path writable;              // a folder, also for temporary files
    int processor_seconds = 600;
    std::uint64_t file_bytes = std::uint64_t{256} << 20; // of each file that is written
};

/// Limits this process for the rest of its life, before it has threads: it opens files below `readable` and
/// the system's folders, and writes below `writable` alone (Landlock); it has no network (a namespace of its
/// own); its processor time and its files have limits. @return the protections that this system lacks
std::vector<std::string> confine_files(const Confinement& confinement);

/// Refuses new processes, programs, sockets and signals to others, for all threads (seccomp). To be called
/// once the drivers are open. @return the protections that this system or this build lacks
std::vector<std::string> confine_calls();

} // namespace sr::assignment
