#pragma once
// A light in the hand: moved, turned or scaled by the pointer, or by a number that is typed. Plain data, pure
// functions.
#include "scene/lights/light.hpp"
#include "viewer/gizmo.hpp"

#include <string>

namespace sr::viewer {

enum class Verb { move, turn, scale };

struct Grip {
    Verb verb{};
    /// Of the world; of scaling the number of the extent. Absent: across the view, around the view,
    /// everything.
    std::optional<int> axis{};
    bool is_free = false; // begun by a key: a click or Enter ends it, not the release of a button
    vec3 center{0.0f};    // what is turned and scaled around [m]
    std::vector<scene::LightSize> extents{}; // at the beginning
    vec2 from{0.0f};                         // where the pointer was, in the window
    std::string typed{}; // a number: metres, degrees; of an extent metres, of the whole a factor
    std::string words{}; // what was done so far; empty: nothing

    /// Takes another axis, or lets it go again; of scaling an extent that there is.
    void constrain_to(int other);
};

/// What became of it.
struct Pull {
    mat4 transform{1.0f}; // of the world, from the beginning on
    float size = 0.0f;    // of the extent, where one is pulled [m]
    std::string words{};  // "turned by 30.0 deg about Y"
};

/// `snaps`: in steps of 15°, 0.1 m, a tenth. A typed number wins over the pointer.
Pull pulled(const Grip& grip, const Projection& projection, vec2 pointer, bool snaps);

/// Takes a key of the number that is being typed. @return whether it was one
bool type_digit(std::string& typed, int key);

} // namespace sr::viewer
