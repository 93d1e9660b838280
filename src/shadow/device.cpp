#include "shadow/device.hpp"

#include "core/error.hpp"

#include <fmt/format.h>

namespace sr::shadow {
namespace {

const char* name_of(RTCError error) {
    switch (error) {
    case RTC_ERROR_NONE: return "no error";
    case RTC_ERROR_INVALID_ARGUMENT: return "invalid argument";
    case RTC_ERROR_INVALID_OPERATION: return "invalid operation";
    case RTC_ERROR_OUT_OF_MEMORY: return "out of memory";
    case RTC_ERROR_UNSUPPORTED_CPU: return "unsupported CPU";
    default: return "unknown error";
    }
}

} // namespace

Device::Device() : device_(rtcNewDevice(nullptr)) {
    if (!device_)
        throw Error(fmt::format("Embree does not start: {}", name_of(rtcGetDeviceError(nullptr))),
                    "render with --visibility none");
}

Device::~Device() { rtcReleaseDevice(device_); }

void Device::require_content() const {
    const RTCError error = rtcGetDeviceError(device_);
    if (error != RTC_ERROR_NONE)
        throw Error(fmt::format("Embree fails: {}", name_of(error)), "render with --visibility none");
}

} // namespace sr::shadow
