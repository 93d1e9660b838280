#pragma once
// What a person edited, brought to another moment of the file or to another of its variants. Plain data: no
// GL.
#include "viewer/light_value.hpp"
#include "viewer/loaded_scene.hpp"

namespace sr::viewer {

/// Everything that can be edited; a copy of it is a step of undoing. What is said of each light or material
/// stands at its index.
struct LightingState {
    std::vector<scene::Light> lights; // the file's, in its order, then those that were added
    std::vector<bool> lights_on;
    std::vector<bool> lights_given; // whether its quantity is a person's and no longer the file's
    std::vector<bool> lights_there; // whether the file shows it at the moment
    std::vector<int> origins;  // which of the file's it is, as FileLights counts; negative if it was added
    std::vector<mat4> moved;   // from where the file has it to where it is, in the world
    std::vector<bool> resized; // whether one of its extents is a person's
    std::vector<int> removed;  // lights of the file that are gone

    std::vector<scene::Light> softboxes;
    std::vector<bool> softboxes_on;
    bool softboxes_changed = false;

    std::vector<vec3> emission; // of the file's materials
    std::vector<bool> emission_on;
    std::vector<bool> emission_given; // as lights_given
};

/// What the file says of its lights, at one moment and with one variant.
class FileLights {
public:
    std::vector<scene::Light> lights; // that are visible
    std::vector<int> numbers;         // of each, the same at every moment
    std::vector<vec3> emission;       // of each material
    std::vector<int> materials;       // the file's number of each; negative for glTF's default material

    /// Takes what `loaded` says before anything of it was edited.
    void take(const LoadedScene& loaded);

    /// The node that carries the light of this number, and whether it carries others too.
    int node_of(int number) const { return nodes_[static_cast<std::size_t>(number)]; }
    bool shares_its_node(int number) const;

private:
    std::vector<int> nodes_; // of every light that was seen so far
};

/// Brings a state from before to now: what a person gave a light stays, all else is the file's. A light that
/// was moved keeps its distance from where the file has it.
void follow(LightingState& state, const FileLights& now);

/// The same where materials have other places: those of `before` and of `now`.
void renumber(LightingState& state, const FileLights& before, const FileLights& now);

} // namespace sr::viewer
