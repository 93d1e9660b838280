#pragma once
// Light editor with undo and redo: the lights of a file, what a person changed, and the RenderScene that
// follows. Plain data: no GL.
#include "gltf/editable_factors.hpp"
#include "viewer/document/loaded_scene.hpp"
#include "viewer/light_value.hpp"

namespace sr::viewer {

/// Factors of a material that a person sets. What is absent is as the file states it.
struct MaterialFactors {
    std::optional<vec4> base_color{}; // linear, alpha in w
    std::optional<float> metallic{};
    std::optional<float> roughness{};
    gltf::FactorValues others{}; // of gltf::editable_factors

    bool any() const { return base_color || metallic || roughness || !others.empty(); }
    bool operator==(const MaterialFactors&) const = default;
};

/// A light, or an emission and other factors of a material, as a person edits it.
struct LightEdit {
    enum class Kind {
        light,    // a light of the file, or an added one
        material, // a material of the file, on all its surfaces
        softbox,  // a light of the studio rig
    };
    Kind kind = Kind::light;
    /// Number that stays at every time: FileLights::Light::number, or negative for an added light; the file's
    /// number of the material; index of the softbox in the rig.
    int source = 0;
    scene::Light light;              // current value, of lights and softboxes
    vec3 emission{0.0f};             // current value, of materials
    MaterialFactors factors{};       // of materials
    std::size_t material = 0;        // index in the scene, of materials
    std::string name{};              // in the file, before any edit
    int node = -1;                   // of a light of the file
    bool is_enabled = true;          // a disabled light emits nothing and stays where it is
    bool is_present = true;          // the file shows it at this time, in this variant
    bool is_removed = false;         // by a person
    bool overrides_quantity = false; // the quantity is a person's, at every time
    bool overrides_size = false;     // likewise a size
    bool overrides_name = false;     // likewise its name
    mat4 motion{1.0f};               // from the place in the file to the current place, in the world

    bool is_added() const { return kind == Kind::light && source < 0; }
    bool is_shown() const { return is_present && !is_removed; }
    bool is_edited() const {
        return is_removed || overrides_quantity || overrides_size || overrides_name || factors.any()
               || motion != mat4(1.0f);
    }
    /// True if the file does not say it.
    bool is_news() const { return is_added() ? !is_removed : is_edited() || !is_enabled; }
};

/// True if the same lights are there, at the same places and of the same sizes, and materials have the same
/// factors: at most quantities differ.
bool are_at_same_places(const std::vector<LightEdit>& a, const std::vector<LightEdit>& b);

/// The lights of a file at one time, in one variant, before any edit.
class FileLights {
public:
    struct Light {
        scene::Light light;
        int number = 0; // the same at every time
    };
    struct Material {
        int number = 0; // in the file; negative for the default material of glTF
        vec3 emission{0.0f};
        std::string name{};
        scene::Material stated{}; // as the file states it
    };
    std::vector<Light> lights; // the visible ones
    std::vector<Material> materials;

    /// Takes the lights of `loaded`, which has no edits yet.
    void read(const LoadedScene& loaded);

    /// The node of a light.
    int node_of(int number) const { return nodes_[static_cast<std::size_t>(number)]; }
    /// True if the node has several lights.
    bool shares_its_node(int number) const;

private:
    std::vector<int> nodes_; // of every light that was seen so far
};

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
    void set_quantity(std::size_t entry, vec3 quantity); // zero disables
    void enable(std::size_t entry, bool is_enabled);
    /// Disables all other lights; if they are disabled already, enables all.
    void solo(std::size_t entry);
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
    /// Begins an undo step, which lasts until the next call: a drag is one step.
    /// `name`: of all edits in it; empty: that of the first one.
    void begin_step(std::string name = {}) {
        is_step_open_ = false;
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
};

} // namespace sr::viewer
