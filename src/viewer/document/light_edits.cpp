#include "viewer/document/light_edits.hpp"

#include "core/error.hpp"
#include "gltf/write/edited_copy.hpp"
#include "scene/lights/light.hpp"
#include "scene/prepare.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <utility>

namespace sr::viewer {
namespace {

using Kind = LightEdit::Kind;

gltf::StatedEmission emission_of(const LightEdit& edit, const scene::Scene& scene) {
    const auto stated = [&](double value, scene::Quantity quantity, vec3 color) {
        return gltf::StatedEmission{value, scene::name_of({quantity, scene.units}), color};
    };
    const bool is_on = edit.is_enabled;
    if (edit.kind == Kind::material) {
        const vec3 L = is_on ? edit.emission : vec3(0.0f);
        return stated(scene::luminance(L), scene::Quantity::radiance, L);
    }
    const vec3 quantity = is_on ? quantity_of(edit.light) : vec3(0.0f);
    if (!has_profile(edit.light))
        return stated(scene::luminance(quantity), quantity_kind_of(edit.light), quantity);
    const double flux = is_on ? scene::luminance(*scene::flux_of(edit.light, scene.profiles)) : 0.0;
    return stated(flux, scene::Quantity::flux, quantity);
}

bool is_scaled(const mat4& by) {
    constexpr float rounding = 1e-4f; // of a few turns
    return std::abs(glm::determinant(mat3(by)) - 1.0f) > rounding;
}

/// Edits to a light of the file; absent if there are none.
std::optional<gltf::NodeLightEdit> node_edit(const LightEdit& edit, const scene::Scene& scene) {
    gltf::NodeLightEdit written;
    written.is_removed = edit.is_removed;
    if (edit.is_removed) return written;
    // A flux makes another radiance of another size, so a new size restates the emission.
    const bool is_resized = edit.overrides_size || is_scaled(edit.motion);
    if (edit.overrides_quantity || !edit.is_enabled || is_resized)
        written.emission = emission_of(edit, scene);
    if (edit.overrides_size) written.sizes = scene::sizes_of(edit.light);
    written.motion = edit.motion;
    if (edit.overrides_name) written.name = name_of(edit.light);
    if (!written.emission && !written.name && written.motion == mat4(1.0f)) return std::nullopt;
    return written;
}

/// Edits to a material of the file; absent if there are none.
std::optional<gltf::MaterialEdit> material_edit(const LightEdit& edit, const scene::Scene& scene) {
    const bool is_stated = edit.overrides_quantity || !edit.is_enabled;
    if (edit.source < 0 || !(is_stated || edit.factors.any())) return std::nullopt;
    gltf::MaterialEdit written;
    written.material = edit.source;
    if (is_stated) written.emission = emission_of(edit, scene);
    written.is_specular_glossiness = edit.is_present && scene.materials[edit.material].is_specular_glossiness;
    written.base_color = edit.factors.base_color;
    written.metallic = edit.factors.metallic;
    written.roughness = edit.factors.roughness;
    written.others = edit.factors.others;
    return written;
}

} // namespace

LightEditor::LightEditor(const LoadedScene& loaded, bool hides_emitters) : hides_emitters_(hides_emitters) {
    const scene::Scene& scene = loaded.stage.scene;
    int emitters = static_cast<int>(scene.lights.size());
    for (std::size_t i = 0; i < loaded.base.instances; ++i)
        emitters = std::max(emitters, scene.instances[i].emits_as.end);
    file_.read(loaded);
    rebase_edits(edits_, file_);
    for (int i = emitters; i < static_cast<int>(loaded.stage.lights.size()); ++i) {
        LightEdit edit;
        edit.kind = Kind::softbox;
        edit.source = i - emitters;
        edit.light = loaded.stage.lights[static_cast<std::size_t>(i)];
        edits_.push_back(std::move(edit));
    }
    staged_ = loaded.stage.lights;
    list(loaded.stage, emitters);
}

std::optional<LightEntry> LightEditor::entry_of(const LightEdit& edit, const scene::RenderScene& stage,
                                                int& staged, int first_softbox) const {
    if (!edit.is_shown()) return std::nullopt;
    LightEntry entry{edit.kind, edit.source, 0, edit.name, {}, edit.is_enabled};
    if (edit.kind != Kind::material) {
        entry.name = name_of(edit.light);
        entry.lights.push_back(edit.kind == Kind::softbox ? first_softbox + staged : staged);
        ++staged;
        return entry;
    }
    for (const scene::Instance& instance : stage.scene.instances) {
        const auto material = stage.scene.meshes[static_cast<std::size_t>(instance.mesh)].material;
        if (static_cast<std::size_t>(material) != edit.material) continue;
        for (int k = instance.emits_as.first; k < instance.emits_as.end; ++k) entry.lights.push_back(k);
        if (entry.name.empty()) entry.name = instance.name;
    }
    return entry.lights.empty() ? std::nullopt : std::optional(entry);
}

void LightEditor::list(const scene::RenderScene& stage, int first_softbox) {
    entries_.clear();
    for (const Kind kind : {Kind::light, Kind::material, Kind::softbox}) {
        int staged = 0;
        for (std::size_t i = 0; i < edits_.size(); ++i) {
            if (edits_[i].kind != kind) continue;
            auto entry = entry_of(edits_[i], stage, staged, first_softbox);
            if (!entry) continue;
            entry->edit = i;
            if (entry->name.empty()) entry->name = fmt::format("light {}", entries_.size());
            entries_.push_back(*std::move(entry));
        }
    }
}

std::optional<std::size_t> LightEditor::entry_like(const LightEntry& entry) const {
    const auto same = std::ranges::find_if(entries_, [&](const LightEntry& other) {
        return other.kind == entry.kind && other.source == entry.source;
    });
    if (same == entries_.end()) return std::nullopt;
    return static_cast<std::size_t>(same - entries_.begin());
}

std::optional<std::size_t> LightEditor::entry_of_instance(const scene::RenderScene& stage,
                                                          int instance) const {
    const scene::LightRange range = stage.scene.instances[static_cast<std::size_t>(instance)].emits_as;
    for (std::size_t i = 0; i < entries_.size(); ++i)
        if (std::ranges::any_of(entries_[i].lights, [&](int k) { return range.contains(k); })) return i;
    return std::nullopt;
}

std::vector<scene::Light> LightEditor::lights_of(std::size_t entry) const {
    std::vector<scene::Light> lights;
    for (const int k : entries_[entry].lights) lights.push_back(staged_[static_cast<std::size_t>(k)]);
    return lights;
}

void LightEditor::remember(std::string what) {
    if (is_step_open_) return;
    constexpr std::size_t max_steps = 200;
    if (undo_.size() == max_steps) undo_.erase(undo_.begin());
    if (!step_name_.empty()) what = std::exchange(step_name_, {});
    undo_.push_back({edits_, std::exchange(revision_, last_revision_ + 1), std::move(what)});
    ++last_revision_;
    redo_.clear();
    is_step_open_ = true;
}

/// Describes an edit of an entry, or of all lights of a step.
std::string LightEditor::of(const char* what, std::size_t entry) const {
    if (step_lights_ > 1) return fmt::format("{} {} lights", what, step_lights_);
    return fmt::format("{} {}", what, entries_[entry].name);
}

bool LightEditor::is_unsaved() const {
    return revision_ != saved_ && std::ranges::any_of(edits_, &LightEdit::is_news);
}

void LightEditor::recover(std::vector<LightEdit> edits) {
    begin_step();
    remember("recovered edits");
    begin_step();
    edits_ = std::move(edits);
    rebase_edits(edits_, file_);
}

void LightEditor::set_quantity(std::size_t entry, vec3 quantity) {
    if (quantity == vec3(0.0f)) return enable(entry, false); // a material without emission would be no light
    remember(of("value of", entry));
    LightEdit& edit = edit_of(entry);
    edit.is_enabled = edit.overrides_quantity = true;
    if (edit.kind == Kind::material)
        edit.emission = quantity;
    else
        scene::set_quantity(edit.light, quantity);
}

void LightEditor::brighten(std::size_t entry, float by) {
    const bool was_enabled = entries_[entry].is_enabled;
    const vec3 quantity = by * quantity_of(lights_of(entry).front());
    if (quantity == vec3(0.0f)) return; // it is too faint for a float
    set_quantity(entry, quantity);
    edit_of(entry).is_enabled = was_enabled;
}

void LightEditor::enable(std::size_t entry, bool is_enabled) {
    if (edit_of(entry).is_enabled == is_enabled) return;
    remember(of(is_enabled ? "enabling" : "disabling", entry));
    edit_of(entry).is_enabled = is_enabled;
}

void LightEditor::solo(const std::vector<std::size_t>& alone) {
    const auto is_one = [&](std::size_t i) { return std::ranges::find(alone, i) != alone.end(); };
    bool are_alone = true;
    for (std::size_t i = 0; i < entries_.size(); ++i)
        are_alone = are_alone && entries_[i].is_enabled == is_one(i);
    if (are_alone && entries_.size() == alone.size()) return; // they stay as they are
    remember(of("enabling alone", alone.front()));
    for (std::size_t i = 0; i < entries_.size(); ++i) edit_of(i).is_enabled = are_alone || is_one(i);
}

bool LightEditor::transform(std::size_t entry, const mat4& by) {
    if (!can_move(entry)) return false;
    remember(of("transform of", entry));
    LightEdit& edit = edit_of(entry);
    edit.light = transformed(edit.light, by);
    edit.motion = by * edit.motion;
    return true;
}

void LightEditor::set_size(std::size_t entry, std::size_t extent, float size) {
    require(can_move(entry), "surfaces keep their sizes");
    remember(of("size of", entry));
    LightEdit& edit = edit_of(entry);
    scene::set_size(edit.light, extent, size);
    edit.overrides_size = true;
}

std::size_t LightEditor::edit_of_material(std::size_t material) const {
    const auto known = std::ranges::find_if(edits_, [&](const LightEdit& e) {
        return e.kind == Kind::material && e.is_present && e.material == material;
    });
    require(known != edits_.end(), "each material of the file has an edit");
    return static_cast<std::size_t>(known - edits_.begin());
}

const MaterialFactors& LightEditor::factors_of(std::size_t material) const {
    return edits_[edit_of_material(material)].factors;
}

void LightEditor::set_factors(std::size_t material, const MaterialFactors& factors) {
    remember("material " + stated(material).name);
    edits_[edit_of_material(material)].factors = factors;
}

void LightEditor::set_emission(std::size_t material, vec3 emission) {
    remember("emission of " + stated(material).name);
    LightEdit& edit = edits_[edit_of_material(material)];
    edit.is_enabled = true;
    edit.overrides_quantity = emission != vec3(0.0f);
    edit.emission = edit.overrides_quantity ? emission : file_.materials[material].emission;
}

bool LightEditor::rename(std::size_t entry, const std::string& name) {
    if (!can_move(entry)) return false;
    remember(of("name of", entry));
    LightEdit& edit = edit_of(entry);
    scene::set_name(edit.light, name);
    edit.overrides_name = true;
    return true;
}

std::size_t LightEditor::add(scene::Light light) {
    remember(step_lights_ > 1 ? fmt::format("adding {} lights", step_lights_) : "adding " + name_of(light));
    LightEdit edit;
    edit.source = -1 - static_cast<int>(std::ranges::count_if(edits_, &LightEdit::is_added));
    edit.light = std::move(light);
    edit.overrides_quantity = true;
    edits_.push_back(std::move(edit));
    const auto lights = std::ranges::count_if(
        edits_, [](const LightEdit& e) { return e.kind == Kind::light && e.is_shown(); });
    return static_cast<std::size_t>(lights) - 1; // lights come first in the list
}

bool LightEditor::remove(std::size_t entry) {
    if (!can_move(entry)) {
        enable(entry, false);
        return false;
    }
    remember(of("removing", entry));
    edit_of(entry).is_removed = true;
    return true;
}

std::optional<std::string> LightEditor::undo() { return step(undo_, redo_); }
std::optional<std::string> LightEditor::redo() { return step(redo_, undo_); }

std::optional<std::string> LightEditor::step(std::vector<Step>& from, std::vector<Step>& to) {
    is_step_open_ = false;
    if (from.empty()) return std::nullopt;
    Step step = std::move(from.back());
    from.pop_back();
    to.push_back(
        {std::exchange(edits_, std::move(step.edits)), std::exchange(revision_, step.revision), step.what});
    rebase_edits(edits_, file_); // the step may be of another time
    return step.what;
}

void LightEditor::restart_step() {
    if (!is_step_open_) return;
    edits_ = undo_.back().edits;
    rebase_edits(edits_, file_);
}

void LightEditor::cancel_step() {
    if (!is_step_open_) return;
    restart_step();
    revision_ = undo_.back().revision;
    undo_.pop_back();
    is_step_open_ = false;
}

void LightEditor::return_to(const State& shown) {
    if (revision_ != shown.revision) {
        for (std::vector<Step>* const steps : {&undo_, &redo_})
            steps->erase(std::ranges::find(*steps, shown.revision, &Step::revision), steps->end());
        is_step_open_ = false;
    }
    edits_ = shown.edits;
    revision_ = shown.revision;
    rebase_edits(edits_, file_);
}

void LightEditor::rebase(const LoadedScene& loaded) {
    file_.read(loaded);
    rebase_edits(edits_, file_);
}

/// Gives a material of the scene the values of its edit.
void LightEditor::change(scene::Material& material, const LightEdit& edit) const {
    const scene::Material& file = stated(edit.material);
    material.emission = edit.emission;
    material.base_color = edit.factors.base_color.value_or(file.base_color);
    material.metallic = edit.factors.metallic.value_or(file.metallic);
    material.roughness = edit.factors.roughness.value_or(file.roughness);
    for (std::size_t i = 0; i < gltf::editable_factors.size(); ++i) {
        const gltf::EditableFactor& factor = gltf::editable_factors[i];
        const auto edited = edit.factors.others.find(i);
        const bool is_edited = edited != edit.factors.others.end();
        set_value(factor, material, is_edited ? edited->second : value_of(factor, file));
    }
}

void LightEditor::apply(LoadedScene& loaded) {
    scene::Scene& scene = loaded.stage.scene;
    scene.instances.resize(loaded.base.instances);
    scene.materials.resize(loaded.base.materials);
    scene.meshes.resize(loaded.base.meshes);
    for (scene::Instance& instance : scene.instances)
        instance.is_hidden = loaded.hidden.contains({instance.node, instance.mesh});
    scene.lights.clear();
    std::vector<scene::Light> softboxes;
    for (const LightEdit& edit : edits_) {
        if (!edit.is_shown()) continue;
        if (edit.kind == Kind::light) scene.lights.push_back(edit.light);
        if (edit.kind == Kind::material) change(scene.materials[edit.material], edit);
        if (edit.kind == Kind::softbox) softboxes.push_back(edit.light);
    }
    std::vector<scene::Light>& lights = loaded.stage.lights;
    lights = scene::assign_emitters(scene);
    const int first_softbox = static_cast<int>(lights.size());
    lights.insert(lights.end(), softboxes.begin(), softboxes.end());
    staged_ = lights;
    list(loaded.stage, first_softbox);
    // A disabled light keeps its place, so that all others keep their indices.
    for (const LightEntry& entry : entries_) {
        if (entry.is_enabled) continue;
        for (const int k : entry.lights) scene::set_quantity(lights[static_cast<std::size_t>(k)], vec3(0.0f));
        if (entry.kind == Kind::material) scene.materials[edits_[entry.edit].material].emission = vec3(0.0f);
        if (entry.kind == Kind::light) // its surface goes dark, too
            scene::set_quantity(scene.lights[static_cast<std::size_t>(entry.lights.front())], vec3(0.0f));
    }
    if (hides_emitters_)
        for (scene::Material& material : scene.materials) material.emission = vec3(0.0f);
    else
        scene::add_light_surfaces(scene);
}

std::vector<std::string> LightEditor::save(const LoadedScene& loaded, const scene::Camera* view,
                                           const std::string& target) const {
    const scene::Scene& scene = loaded.stage.scene;
    gltf::Edits written;
    written.scene_index = loaded.scene_index;
    written.origin = scene.origin;
    if (view) written.first_camera = *view;
    // A file with lights of its own gets no softboxes, so they are written once a light or one of them was
    // edited.
    const bool has_softboxes = std::ranges::any_of(edits_, [](const LightEdit& edit) {
        return edit.kind == Kind::softbox ? edit.is_edited() || !edit.is_enabled
                                          : edit.is_added() != edit.is_removed;
    });
    Edits ordered = edits_; // softboxes last
    std::ranges::stable_sort(ordered, {}, [](const LightEdit& edit) { return edit.kind == Kind::softbox; });
    for (const LightEdit& edit : ordered) {
        if (edit.kind == Kind::material) {
            if (auto edited = material_edit(edit, scene)) written.materials.push_back(*std::move(edited));
        } else if (edit.kind == Kind::softbox || edit.is_added()) {
            // The environment of the studio comes by itself.
            const bool is_written = !edit.is_removed && (edit.is_added() || has_softboxes)
                                    && !std::holds_alternative<scene::EnvironmentLight>(edit.light);
            if (is_written) written.added_lights.push_back({edit.light, emission_of(edit, scene)});
        } else if (auto edited = node_edit(edit, scene)) {
            edited->node = file_.node_of(edit.source);
            if (file_.shares_its_node(edit.source))
                throw Error(
                    {loaded.file},
                    fmt::format("/nodes/{} has several lights, and one of them was edited", edited->node),
                    "give each light a node of its own");
            written.lights.push_back(*std::move(edited));
        }
    }
    return gltf::write_edited_copy(loaded.source, written, target);
}

} // namespace sr::viewer
