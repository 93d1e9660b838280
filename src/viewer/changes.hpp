#pragma once
// Bit set of what an event, a frame or a panel changed. App::apply() is the one place that acts on it.

namespace sr::viewer {

enum class Change : unsigned {
    camera = 1,    // the camera of the view
    lights = 2,    // quantities of lights
    shadows = 4,   // something that casts shadows has moved, come or gone
    materials = 8, // shaders, estimator or materials; the render has restarted already
    display = 16,  // exposure, tone curve, comparison: how the render is shown
    redraw = 32,   // panels and overlays
};

class Changes {
public:
    constexpr Changes() = default;
    constexpr Changes(Change change) : bits_(static_cast<unsigned>(change)) {}

    constexpr bool has(Change change) const { return (bits_ & static_cast<unsigned>(change)) != 0; }
    constexpr bool any() const { return bits_ != 0; }

    constexpr Changes& operator|=(Changes other) {
        bits_ |= other.bits_;
        return *this;
    }
    friend constexpr Changes operator|(Changes a, Changes b) { return a |= b; }
    bool operator==(const Changes&) const = default;

private:
    unsigned bits_ = 0;
};

constexpr Changes operator|(Change a, Change b) { return Changes(a) | Changes(b); }

/// Another scene, or the same one loaded again.
inline constexpr Changes everything = Change::camera | Change::lights | Changes(Change::shadows)
                                      | Change::materials | Change::display | Change::redraw;

/// True if another picture than before is seen from the same place.
constexpr bool is_of_scene(Changes changes) {
    return changes.has(Change::lights) || changes.has(Change::shadows) || changes.has(Change::materials);
}

} // namespace sr::viewer
