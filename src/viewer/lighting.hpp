#pragma once
// The lights as a person edits them, and the Stage that follows from them. Plain data: no GL.
#include "viewer/moment_lights.hpp"

namespace sr::viewer {

/// One entry of the list of lights.
struct Lamp {
    enum class Kind {
        light,   // a light of the file, or one that was added
        surface, // all surfaces of one emissive material: what is edited is the material
        softbox, // of the studio rig
    };
    Kind kind = Kind::light;
    std::size_t index = 0; // of the light, the material or the softbox
    std::string name;
    std::vector<int> lights; // which of the Stage's; empty for a surface that was switched to nothing
    bool is_on = true;
    int id = 0; // among its kind, the same at every moment
};

class Lighting {
public:
    /// As `loaded` has it now.
    explicit Lighting(const LoadedScene& loaded, bool hides_emitters);

    /// Lights, surfaces and softboxes, in this order. Indices stay until a light is added or removed, or
    /// another moment shows more or fewer.
    const std::vector<Lamp>& lamps() const { return lamps_; }
    /// The lamp that is the same light; absent: it is not there now.
    std::optional<std::size_t> lamp_like(const Lamp& lamp) const;
    std::optional<std::size_t> lamp_of_instance(const scene::Stage& stage, int instance) const;
    /// The lights that a lamp is, with their quantities whether it is on or not.
    std::vector<scene::Light> lights_of(std::size_t lamp) const;

    // Each of these changes the state; apply() brings it to the Stage. All can be undone.
    void set_quantity(std::size_t lamp, vec3 quantity);
    void switch_to(std::size_t lamp, bool is_on);
    void solo(std::size_t lamp); // it alone; all, if it already is alone
    /// Only lights and softboxes move; surfaces are the scene's. @return whether it does
    bool transform(std::size_t lamp, const mat4& by);
    /// Of an extent (extents.hpp) of a light or softbox [m].
    void set_size(std::size_t lamp, std::size_t extent, float size);
    bool can_move(std::size_t lamp) const { return lamps_[lamp].kind != Lamp::Kind::surface; }
    std::size_t add(scene::Light light); // @return its lamp
    bool remove(std::size_t lamp);       // a surface is only switched off
    bool undo();                         // @return false: there is nothing to undo
    bool redo();                         // likewise; what was undone last
    /// The next changes undo as one until it is called again: a drag is one step.
    void begin_step() { is_step_open_ = false; }
    /// As it was when the step began, which goes on.
    void take_back_step();
    /// As it was when the step began; as if it never had.
    void cancel_step();

    bool is_changed() const { return !history_.empty(); }
    const LightingState& state() const { return state_; }
    const FileLights& file() const { return file_; } // as it has them at the moment
    bool adds_or_removes() const;                    // lights of the file, or softboxes

    /// Rebuilds what depends on lights. Images, textures and the file's meshes stay.
    void apply(LoadedScene& loaded);

    /// The file shows another moment or another variant, before anything of it was edited: edits go along.
    /// apply() brings them to the Stage.
    void follow(const LoadedScene& loaded);

private:
    /// Takes the latest of `from` for the state, which goes to `to`. @return false: there is none
    bool step(std::vector<LightingState>& from, std::vector<LightingState>& to);
    void remember();
    scene::Light& light_of(const Lamp& lamp);
    std::vector<bool>& switches(Lamp::Kind kind);
    void name_materials(const scene::Scene& scene, std::size_t count);
    void list(const scene::Stage& stage, std::size_t first_softbox);

    LightingState state_;
    FileLights file_;
    std::vector<LightingState> history_;
    std::vector<LightingState> undone_; // the last one first to come back
    std::vector<Lamp> lamps_;
    std::vector<scene::Light> staged_; // the Stage's lights as if all were on
    std::vector<std::string> material_names_;
    bool hides_emitters_;
    bool is_step_open_ = false;
};

} // namespace sr::viewer
