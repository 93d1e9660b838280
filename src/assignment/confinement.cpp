#include "assignment/confinement.hpp"

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <fmt/format.h>
#ifdef __linux__
#include <fcntl.h>
#include <sched.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/syscall.h>
#include <unistd.h>
#if __has_include(<linux/landlock.h>)
#include <linux/landlock.h>
#define STERADIAN_HAS_LANDLOCK
#endif
#ifdef STERADIAN_HAS_SECCOMP
#include <seccomp.h>
#endif
#endif

namespace sr::assignment {
namespace {

namespace fs = std::filesystem;

#ifdef __linux__

void limit(int resource, rlim_t value) {
    struct rlimit limits {};
    getrlimit(static_cast<__rlimit_resource>(resource), &limits);
    limits.rlim_cur = limits.rlim_max = std::min(value, limits.rlim_max);
    setrlimit(static_cast<__rlimit_resource>(resource), &limits);
}

#ifdef STERADIAN_HAS_LANDLOCK

constexpr std::uint64_t reading = LANDLOCK_ACCESS_FS_READ_FILE | LANDLOCK_ACCESS_FS_READ_DIR;
constexpr std::uint64_t writing =
    LANDLOCK_ACCESS_FS_WRITE_FILE | LANDLOCK_ACCESS_FS_REMOVE_DIR | LANDLOCK_ACCESS_FS_REMOVE_FILE
    | LANDLOCK_ACCESS_FS_MAKE_CHAR | LANDLOCK_ACCESS_FS_MAKE_DIR | LANDLOCK_ACCESS_FS_MAKE_REG
    | LANDLOCK_ACCESS_FS_MAKE_SOCK | LANDLOCK_ACCESS_FS_MAKE_FIFO | LANDLOCK_ACCESS_FS_MAKE_BLOCK
    | LANDLOCK_ACCESS_FS_MAKE_SYM; // the first version of the interface, which every later one has
constexpr std::uint64_t running = LANDLOCK_ACCESS_FS_EXECUTE;

/// Allows `access` below a path; a path that is not there needs no rule.
void allow(int rules, const fs::path& path, std::uint64_t access) {
    const int parent = open(path.c_str(), O_PATH | O_CLOEXEC);
    if (parent < 0) return;
    std::error_code ignored;
    if (!fs::is_directory(path, ignored)) access &= ~std::uint64_t{LANDLOCK_ACCESS_FS_READ_DIR};
    struct landlock_path_beneath_attr rule {};
    rule.allowed_access = access;
    rule.parent_fd = parent;
    syscall(SYS_landlock_add_rule, rules, LANDLOCK_RULE_PATH_BENEATH, &rule, 0);
    close(parent);
}

/// @return whether this process reads and writes nothing else from now on
bool restrict_files(const Confinement& confinement) {
    struct landlock_ruleset_attr handled {};
    handled.handled_access_fs = reading | writing | running;
    const auto rules = static_cast<int>(syscall(SYS_landlock_create_ruleset, &handled, sizeof handled, 0));
    if (rules < 0) return false;
    for (const char* system : {"/usr", "/lib", "/lib64", "/etc", "/opt", "/sys", "/proc", "/run"})
        allow(rules, system, reading);
    allow(rules, "/dev", reading | LANDLOCK_ACCESS_FS_WRITE_FILE); // /dev/null, a GPU's device
    for (const fs::path& path : confinement.readable) allow(rules, path, reading);
    allow(rules, confinement.writable, reading | writing);
    const bool is_done = syscall(SYS_landlock_restrict_self, rules, 0) == 0;
    close(rules);
    return is_done;
}

#else

bool restrict_files(const Confinement&) { return false; }

#endif

#ifdef STERADIAN_HAS_SECCOMP

/// @return 0, or the negative errno of the first rule that fails
int filter_calls(scmp_filter_ctx filter) {
    constexpr std::array forbidden{SCMP_SYS(socket),
                                   SCMP_SYS(connect),
                                   SCMP_SYS(bind),
                                   SCMP_SYS(listen),
                                   SCMP_SYS(execve),
                                   SCMP_SYS(execveat),
                                   SCMP_SYS(fork),
                                   SCMP_SYS(vfork),
                                   SCMP_SYS(kill),
                                   SCMP_SYS(tkill),
                                   SCMP_SYS(rt_sigqueueinfo),
                                   SCMP_SYS(pidfd_send_signal),
                                   SCMP_SYS(ptrace),
                                   SCMP_SYS(process_vm_readv),
                                   SCMP_SYS(process_vm_writev),
                                   SCMP_SYS(mount),
                                   SCMP_SYS(umount2),
                                   SCMP_SYS(unshare),
                                   SCMP_SYS(setns),
                                   SCMP_SYS(bpf),
                                   SCMP_SYS(keyctl),
                                   SCMP_SYS(add_key),
                                   SCMP_SYS(request_key),
                                   SCMP_SYS(perf_event_open),
                                   SCMP_SYS(reboot),
                                   SCMP_SYS(init_module),
                                   SCMP_SYS(finit_module),
                                   SCMP_SYS(io_uring_setup)};
    const std::uint32_t refusal = SCMP_ACT_ERRNO(EPERM);
    if (const int failure = seccomp_attr_set(filter, SCMP_FLTATR_CTL_TSYNC, 1)) return failure;
    for (const int call : forbidden)
        if (const int failure = seccomp_rule_add(filter, refusal, call, 0)) return failure;
    // Threads stay; a process is a clone without CLONE_THREAD. What clone3 asks for cannot be seen here, and
    // the C library takes clone where there is no clone3.
    if (const int failure = seccomp_rule_add(filter, refusal, SCMP_SYS(clone), 1,
                                             SCMP_A0(SCMP_CMP_MASKED_EQ, CLONE_THREAD, 0)))
        return failure;
    if (const int failure = seccomp_rule_add(filter, SCMP_ACT_ERRNO(ENOSYS), SCMP_SYS(clone3), 0))
        return failure;
    // A signal to this process alone, by which MemoryWatch ends it.
    if (const int failure = seccomp_rule_add(filter, refusal, SCMP_SYS(tgkill), 1,
                                             SCMP_A0(SCMP_CMP_NE, static_cast<scmp_datum_t>(getpid()))))
        return failure;
    return seccomp_load(filter);
}

#endif

#endif

} // namespace

std::vector<std::string> confine_files(const Confinement& confinement) {
    std::vector<std::string> lacking;
#ifdef __linux__
    setenv("TMPDIR", confinement.writable.c_str(), 1);
    setenv("MESA_SHADER_CACHE_DISABLE", "true", 1); // it would write in the home folder
    limit(RLIMIT_CORE, 0);
    limit(RLIMIT_CPU, static_cast<rlim_t>(confinement.processor_seconds));
    limit(RLIMIT_FSIZE, confinement.file_bytes);
    limit(RLIMIT_NOFILE, 256);
    if (unshare(CLONE_NEWNET) != 0 && unshare(CLONE_NEWUSER | CLONE_NEWNET) != 0)
        lacking.push_back(fmt::format("a network namespace of its own ({})", std::strerror(errno)));
    prctl(PR_SET_NO_NEW_PRIVS, 1, 0, 0, 0);
    if (!restrict_files(confinement)) lacking.emplace_back("Landlock");
#else
    static_cast<void>(confinement);
    lacking.emplace_back("Landlock, seccomp and namespaces, which Linux has");
#endif
    return lacking;
}

std::vector<std::string> confine_calls() {
    std::vector<std::string> lacking;
#if defined(__linux__) && defined(STERADIAN_HAS_SECCOMP)
    const scmp_filter_ctx filter = seccomp_init(SCMP_ACT_ALLOW);
    const int failure = filter ? filter_calls(filter) : -ENOMEM;
    if (failure != 0) lacking.push_back(fmt::format("seccomp ({})", std::strerror(-failure)));
    if (filter) seccomp_release(filter);
#else
    lacking.emplace_back("seccomp (built without libseccomp-dev)");
#endif
    return lacking;
}

} // namespace sr::assignment
