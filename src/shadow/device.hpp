#pragma once
// Embree's device, and its complaints as ours.
#include <embree3/rtcore.h>

namespace sr::shadow {

/// Owns an Embree device.
class Device {
public:
    /// @throws Error if Embree does not work on this machine.
    Device();
    ~Device();
    Device(const Device&) = delete;
    Device& operator=(const Device&) = delete;

    RTCDevice handle() const { return device_; }

    /// @throws Error with what Embree complained of since the last call, if it did.
    void require_content() const;

private:
    RTCDevice device_ = nullptr;
};

} // namespace sr::shadow
