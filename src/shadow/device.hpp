#pragma once
// Embree's device, its complaints as ours, and the call that Embree 3 and 4 spell differently.
#if STERADIAN_EMBREE >= 4
#include <embree4/rtcore.h>
#else
#include <embree3/rtcore.h>
#endif

namespace sr::shadow {

#if STERADIAN_EMBREE >= 4
using RayContext = RTCRayQueryContext;
#else
using RayContext = RTCIntersectContext;
#endif

/// Traces eight incoherent rays. Filters get the pointer to `context`.
inline void trace(const int* valid, RTCScene scene, RayContext& context, RTCRay8& rays) {
#if STERADIAN_EMBREE >= 4
    rtcInitRayQueryContext(&context);
    RTCOccludedArguments arguments;
    rtcInitOccludedArguments(&arguments); // incoherent by default
    arguments.context = &context;
    rtcOccluded8(valid, scene, &rays, &arguments);
#else
    rtcInitIntersectContext(&context);
    context.flags = RTC_INTERSECT_CONTEXT_FLAG_INCOHERENT;
    rtcOccluded8(valid, scene, &context, &rays);
#endif
}

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
