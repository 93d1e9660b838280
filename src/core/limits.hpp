#pragma once
// Limits on the memory that a file may take; users can raise them.
#include <array>
#include <cstdint>
#include <string>
#include <string_view>
#include <thread>

namespace sr {

/// README.md, "Limits", has the numbers.
enum class Limit {
    file_bytes,
    json_values,
    elements,
    materials,
    instances,
    vertices,
    values,
    names,
    texels,
    pixels
};

struct LimitDescription {
    const char* name; // as --limit takes it
    std::uint64_t value;
    const char* what; // "4294967296 bytes in one file"
};

/// In the order of Limit, with the values that hold unless they are set.
inline constexpr std::array<LimitDescription, 10> all_limits{{
    {"file-bytes", std::uint64_t{4} << 30, "bytes of one file"},
    {"json-values", std::uint64_t{4} << 20, "values in one JSON text"},
    {"elements", std::uint64_t{512} << 10, "entries in one of glTF's arrays"},
    {"materials", std::uint64_t{64} << 10, "materials of a glTF"},
    {"instances", std::uint64_t{1} << 20, "meshes that a scene draws, each as often as it is drawn"},
    {"vertices", std::uint64_t{32} << 20, "vertices that a scene draws, each as often as it is drawn"},
    {"values", std::uint64_t{256} << 20, "numbers that are read from accessors"},
    {"names", std::uint64_t{64} << 20, "bytes of names of what a scene draws"},
    {"texels", std::uint64_t{512} << 20, "texels of all textures of a glTF"},
    {"pixels", std::uint64_t{256} << 20, "numbers in one image that is compared"},
}};

/// The value that holds.
std::uint64_t limit(Limit limit);

/// Sets a limit for the whole process from "NAME=VALUE". @return what is wrong with the text, or empty
std::string set_limit(std::string_view text);

/// Sets the limits that the environment variable STERADIAN_LIMITS names, separated by commas, which children
/// of the process have too. @throws Error for what is none
void set_limits_from_environment();

/// A count that grows towards a limit.
class Tally {
public:
    Tally(Limit limit, std::string file) : limit_(limit), file_(std::move(file)) {}

    /// @throws Error naming the file once the limit is passed
    void add(std::uint64_t count);

private:
    Limit limit_;
    std::string file_;
    std::uint64_t sum_ = 0;
};

/// @throws Error naming the file if `count` is above the limit
void check_limit(Limit limit, std::uint64_t count, const std::string& file);

/// A limit on the memory of a process that runs the code of others. A limit of the system on address space
/// would not do: drivers reserve far more than they use.
///
/// Ends this process by SIGKILL once its resident memory has grown by more than `bytes`. Looks every 2 ms;
/// does nothing where there is no /proc/self/statm.
class MemoryWatch {
public:
    /// @throws std::system_error if no thread starts
    explicit MemoryWatch(std::uint64_t bytes);

private:
    std::jthread thread_;
};

} // namespace sr
