#pragma once
// A limit on the memory of this process, for processes that run the code of others. A limit of the system on
// address space would not do: drivers reserve far more than they use.
#include <cstdint>
#include <thread>

namespace sr {

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
