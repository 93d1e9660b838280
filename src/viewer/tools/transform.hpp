#pragma once
// Transform tool: moves, turns and resizes the selected lights by handles, or by keys and typed numbers.
#include "scene/lights/light.hpp"
#include "viewer/tools/tool.hpp"

#include <array>
#include <chrono>
#include <string>
#include <vector>

namespace sr::viewer {

enum class TransformMode { move, turn, scale };

/// A drag of a light. Plain data.
struct TransformDrag {
    TransformMode mode{};
    /// Axis of the world; of scaling, the index of the extent. Absent: across the view, around the view, all
    /// extents.
    std::optional<int> axis{};
    bool is_free = false; // begun by a key: a click or Enter ends it, not the release of a button
    vec3 center{0.0f};    // fixed point of turning and scaling [m]
    std::vector<scene::LightSize> extents{}; // at the beginning
    vec2 from{0.0f};                         // the pointer at the beginning, in the window
    std::string typed{};       // a number: metres, degrees; of an extent metres, of all extents a factor
    std::string description{}; // of the change so far; empty if there is none

    /// Constrains the drag to an axis, or releases it if it is constrained to that axis already.
    void constrain_to(int other);
};

/// Change of a light by a drag.
struct TransformDelta {
    mat4 transform{1.0f};      // of the world, from the beginning of the drag
    float size = 0.0f;         // of the extent that is dragged [m]; 0 if none is
    std::string description{}; // "turned by 30.0 deg about Y"
};

/// Evaluates a drag for a place of the pointer. A typed number wins over the pointer. `snaps`: in steps of 15
/// degrees, 0.1 m, a tenth.
TransformDelta evaluate(const TransformDrag& drag, const Projection& projection, vec2 pointer, bool snaps);

/// Adds a key to the number that is typed. @return false if the key is no part of a number
bool type_digit(std::string& typed, int key);

/// A part of the gizmo that a drag begins at.
struct Handle {
    TransformMode mode{};
    int axis = 0; // as TransformDrag::axis; -1: across the view
};

/// Gizmo of a light: arrows that move it, rings that turn it, squares that resize it.
struct Handles {
    std::optional<vec2> middle;              // moves across the view
    std::vector<Arrow> arrows;               // none for a light without a place
    std::array<std::vector<vec2>, 3> rings;  // the half of each ring that faces the camera, in the window
    std::vector<std::pair<vec2, int>> sizes; // centre of each square, and its extent
};

/// Handles of a light around `center`; none behind the camera. `has_place`: the light can be moved. `scale`:
/// of a HiDPI screen.
Handles handles_of(const std::vector<scene::LightSize>& extents, vec3 center, bool has_place,
                   const Projection& projection, float scale);

/// The handle under the pointer; absent if there is none.
std::optional<Handle> handle_under(vec2 pointer, const Handles& handles);

class Transform : public Tool {
public:
    using Tool::Tool;

    std::optional<Changes> handle(const Event& event) override;
    Changes update(double seconds) override;
    Changes draw(const Overlay& overlay) override;
    bool holds_pointer() const override { return drag_.has_value(); }

private:
    std::optional<Changes> handle_pointer(const Event& event);
    std::optional<Changes> handle_key(const KeyEvent& event);
    std::optional<Changes> handle_refused(const KeyEvent& event);
    std::optional<Changes> execute(Command command);
    vec3 center() const;
    std::optional<Handles> handles() const;
    void begin(TransformMode mode, std::optional<int> axis, bool is_free);
    std::string refusal(TransformMode mode) const;
    std::vector<scene::LightSize> extents() const;
    Changes drag_to(vec2 pointer);
    Changes end(bool keeps);
    Changes changes() const;

    std::optional<TransformDrag> drag_;               // of the selected lights
    std::chrono::steady_clock::time_point refused_{}; // the last key of a transform that was refused
    /// Beginnings of the frame at hand and of the one before, after which its events came.
    std::chrono::steady_clock::time_point frame_{}, frame_before_{};
    vec2 pointer_{0.0f};
};

} // namespace sr::viewer
