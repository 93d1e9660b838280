#pragma once
// Light editor with undo and redo: the lights of a file, what a person changed, and the RenderScene that
// follows. Plain data: no GL.
#include "viewer/document/file_lights.hpp"
#include "viewer/light_value.hpp"

namespace sr::viewer {

/// A row in the list of lights.
struct LightEntry {
    LightEdit::Kind kind{};
    int source = 0;
    std::size_t edit = 0; // index in LightEditor::edits()
    std::string name;
    std::vector<int> lights; // of the RenderScene
    bool is_enabled = true;
};

class LightEditor {
public:
    explicit LightEditor(const LoadedScene& loaded, bool hides_emitters);

    /// Lights, emissive materials and softboxes, in this order. Indices stay until a light is added or
    /// removed, or another time shows more or fewer.
    const std::vector<LightEntry>& entries() const { return entries_; }
    /// The entry of the same light; absent if it is not present now.
    std::optional<std::size_t> entry_like(const LightEntry& entry) const;
    std::optional<std::size_t> entry_of_instance(const scene::RenderScene& stage, int instance) const;
    /// The lights of an entry, enabled or not. A material has one for each surface.
    std::vector<scene::Light> lights_of(std::size_t entry) const;

    // Edits, each of which can be undone. apply() brings them to the RenderScene.
    void set_quantity(std::size_t entry, vec3 quantity); // zero disables, other values enable
    /// Multiplies the quantity. A disabled light stays disabled.
    void brighten(std::size_t entry, float by);
    void enable(std::size_t entry, bool is_enabled);
    /// Disables all lights but these; if that is so already, enables all.
    void solo(const std::vector<std::size_t>& alone);
    /// Moves a light or a softbox. @return false for a material, whose surfaces stay
    bool transform(std::size_t entry, const mat4& by);
    /// Sets the size of a light or a softbox along one of its extents (scene::sizes_of) [m].
    void set_size(std::size_t entry, std::size_t extent, float size);
    bool can_move(std::size_t entry) const { return entries_[entry].kind != LightEdit::Kind::material; }
    /// Sets factors of a material of the scene. Those that are absent are the file's again.
    void set_factors(std::size_t material, const MaterialFactors& factors);
    const MaterialFactors& factors_of(std::size_t material) const;
    /// Sets what a material of the scene emits, times its texture [the unit of radiance]. It is a light from
    /// then on; black is as the file has it.
    void set_emission(std::size_t material, vec3 emission);
    /// The material as the file states it.
    const scene::Material& stated(std::size_t material) const { return file_.materials[material].stated; }
    std::size_t material_count() const { return file_.materials.size(); }
    /// Gives a light or a softbox another name. @return false for a material, whose name stays
    bool rename(std::size_t entry, const std::string& name);
    /// `light`: gltf::is_addable(). @return the index of its entry once apply() has run
    std::size_t add(scene::Light light);
    /// Removes a light or a softbox. @return false for a material, which is disabled instead
    bool remove(std::size_t entry);

    /// Each @return says what was undone or redone ("value of lamp"); absent if there is nothing.
    std::optional<std::string> undo();
    std::optional<std::string> redo();
    /// Begins an undo step, which lasts until the next call: a drag is one step. `lights`: how many it edits.
    /// `name`: of all edits in it; empty: that of the first one.
    void begin_step(std::size_t lights = 1, std::string name = {}) {
        is_step_open_ = false;
        step_lights_ = lights;
        step_name_ = std::move(name);
    }
    /// Restores the state at the beginning of the step, which stays open.
    void restart_step();
    /// Restores the state at the beginning of the step and drops the step.
    void cancel_step();

    bool is_changed() const { return !undo_.empty(); }
    /// True if edits would be lost with this editor: neither the file nor a saved copy has them.
    bool is_unsaved() const;
    void mark_saved() { saved_ = revision_; }
    /// Replaces all edits by those of a journal, as one step that can be undone.
    void recover(std::vector<LightEdit> edits);
    const std::vector<LightEdit>& edits() const { return edits_; }

    /// All edits at a moment.
    struct State {
        std::vector<LightEdit> edits;
        int revision = 0; // each undo step has its own
    };
    State state() const { return {edits_, revision_}; }
    /// Goes back to a state that was shown, and forgets the steps that led away from it: the scene with them
    /// cannot be shown. An open step stays open if the state is of that step.
    void return_to(const State& shown);

    /// Rebuilds everything of `loaded` that depends on lights. Images, textures and meshes of the file stay.
    void apply(LoadedScene& loaded);

    /// Carries the edits over to another time or another variant. `loaded` has no edits yet; apply() brings
    /// them to its RenderScene.
    void rebase(const LoadedScene& loaded);

    /// Writes a copy of the file as it was read with the edits and, if `view` is given, a new first camera.
    /// What is edited is stated in extras.steradian.
    /// @return as gltf::write_edited_copy(). @throws Error as gltf::write_edited_copy(), and for an edited
    /// light that shares its node with another
    std::vector<std::string> save(const LoadedScene& loaded, const scene::Camera* view,
                                  const std::string& target) const;

private:
    using Edits = std::vector<LightEdit>;
    /// A state of all edits, and the edit that led away from it.
    struct Step {
        Edits edits;
        int revision = 0;
        std::string what;
    };

    std::optional<std::string> step(std::vector<Step>& from, std::vector<Step>& to);
    void remember(std::string what);
    std::string of(const char* what, std::size_t entry) const;
    std::size_t edit_of_material(std::size_t material) const;
    void change(scene::Material& material, const LightEdit& edit) const;
    LightEdit& edit_of(std::size_t entry) { return edits_[entries_[entry].edit]; }
    std::optional<LightEntry> entry_of(const LightEdit& edit, const scene::RenderScene& stage, int& staged,
                                       int first_softbox) const;
    void list(const scene::RenderScene& stage, int first_softbox);

    Edits edits_;
    FileLights file_;
    std::vector<Step> undo_;
    std::vector<Step> redo_; // the next one last
    int revision_ = 0;       // of edits_; 0: as the file is
    int last_revision_ = 0;
    int saved_ = 0; // revision that was saved last
    std::vector<LightEntry> entries_;
    std::vector<scene::Light> staged_; // the RenderScene's lights as if all were enabled
    bool hides_emitters_;
    bool is_step_open_ = false;
    std::string step_name_; // of the next step
    std::size_t step_lights_ = 1;
};

} // namespace sr::viewer
