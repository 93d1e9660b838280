#pragma once
// Messages of the driver (KHR_debug).
#include <string>
#include <vector>

namespace sr::gl {

/// Collects the errors and warnings of the context that is current when it is made, for as long as it lives.
/// Without KHR_debug it stays empty.
class DebugLog {
public:
    DebugLog();
    ~DebugLog();
    DebugLog(const DebugLog&) = delete;
    DebugLog& operator=(const DebugLog&) = delete;

    /// Every message above notification level, oldest first. Performance hints are not among them.
    const std::vector<std::string>& messages() const { return messages_; }

private:
    std::vector<std::string> messages_;
};

} // namespace sr::gl
