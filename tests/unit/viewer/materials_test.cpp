// Factors of materials that a person sets: in the scene, undone, in the journal, and in a saved file.
#include "shadow/casters.hpp"
#include "support/address.hpp"
#include "viewer/document/journal.hpp"

#include <algorithm>
#include <array>
#include <cstdlib>
#include <filesystem>
#include <set>
#include <string>
#include <string_view>
#include <unistd.h>
#include <variant>

using namespace sr;
using namespace sr::viewer;
using sr::testing::Test;

namespace {

namespace fs = std::filesystem;

const std::string scene_file = STERADIAN_SCENES "/spheres.gltf";

const Test edited("unit.viewer.materials.factors_are_set_undone_and_saved", [] {
    LoadedScene loaded = load_scene(scene_file, Options(), 1.0f);
    LightEditor editor(loaded, false);
    const std::size_t last = loaded.base.materials - 1;
    const auto& materials = loaded.stage.scene.materials;
    const scene::Material file = materials[last];
    editor.set_factors(last, {vec4(0.25f, 0.5f, 0.75f, 1.0f), 0.5f, 0.125f});
    editor.begin_step();
    editor.apply(loaded);
    EXPECT_EQ(materials[last].base_color, vec4(0.25f, 0.5f, 0.75f, 1.0f));
    EXPECT_EQ(materials[last].metallic, 0.5f);
    EXPECT_EQ(materials[last].roughness, 0.125f);
    EXPECT_TRUE(editor.is_unsaved());
    const fs::path target =
        fs::temp_directory_path() / ("steradian_materials_" + std::to_string(getpid()) + ".gltf");
    editor.save(loaded, nullptr, target.string());
    const LoadedScene saved = load_scene(target.string(), Options(), 1.0f);
    fs::remove(target);
    for (std::size_t m = 0; m < loaded.base.materials; ++m) {
        EXPECT_EQ(saved.stage.scene.materials[m].base_color, materials[m].base_color) << m;
        EXPECT_EQ(saved.stage.scene.materials[m].metallic, materials[m].metallic) << m;
        EXPECT_EQ(saved.stage.scene.materials[m].roughness, materials[m].roughness) << m;
    }
    EXPECT_EQ(editor.undo(), "material " + file.name);
    editor.apply(loaded);
    EXPECT_EQ(materials[last].base_color, file.base_color);
    EXPECT_EQ(materials[last].roughness, file.roughness);
});

/// Sets a factor of a material: it is in the scene, in a saved copy that is read again, and gone after an
/// undo.
void try_factor(std::size_t i, std::size_t material, LoadedScene& loaded, LightEditor& editor) {
    const gltf::EditableFactor& factor = gltf::editable_factors[i];
    const auto& materials = loaded.stage.scene.materials;
    const fs::path target =
        fs::temp_directory_path() / ("steradian_factors_" + std::to_string(getpid()) + ".gltf");
    const vec3 before = value_of(factor, materials[material]);
    const bool is_number = std::holds_alternative<float scene::Material::*>(factor.member);
    const float middle = 0.375f * factor.min + 0.625f * factor.max;
    const vec3 value = is_number ? vec3(middle, 0.0f, 0.0f) : vec3(0.25f, 0.5f, 0.75f);
    MaterialFactors factors;
    factors.others[i] = value;
    editor.begin_step();
    editor.set_factors(material, factors);
    editor.apply(loaded);
    EXPECT_EQ(value_of(factor, materials[material]), value) << factor.key;
    editor.save(loaded, nullptr, target.string());
    const LoadedScene saved = load_scene(target.string(), Options(), 1.0f);
    EXPECT_EQ(value_of(factor, saved.stage.scene.materials[material]), value) << factor.key;
    EXPECT_TRUE(editor.undo()) << factor.key;
    editor.apply(loaded);
    EXPECT_EQ(value_of(factor, materials[material]), before) << factor.key;
    fs::remove(target);
}

const Test others("unit.viewer.materials.each_other_factor_is_saved_where_gltf_has_it", [] {
    std::set<std::string_view> tried;
    for (const char* file : {"brdfs.gltf", "glass.gltf"}) {
        LoadedScene loaded = load_scene(std::string(STERADIAN_SCENES "/") + file, Options(), 1.0f);
        for (scene::Material& material : loaded.stage.scene.materials) // as if it had a texture
            material.film_thickness_texture.texture = 0;
        LightEditor editor(loaded, false);
        for (std::size_t i = 0; i < gltf::editable_factors.size(); ++i)
            for (std::size_t m = 0; m < loaded.base.materials; ++m) {
                const gltf::EditableFactor& factor = gltf::editable_factors[i];
                if (!factor.is_of(loaded.stage.scene.materials[m]) || !tried.insert(factor.key).second)
                    continue;
                try_factor(i, m, loaded, editor);
            }
    }
    for (const gltf::EditableFactor& factor : gltf::editable_factors)
        EXPECT_TRUE(tried.contains(factor.key) || factor.pointer.ends_with("/scale")
                    || factor.key == "alpha_cutoff")
            << factor.key << ": no scene has such a material";
});

const Test anisotropic("unit.viewer.materials.a_normal_map_brings_the_tangents_of_anisotropy", [] {
    scene::Material material;
    const auto has_anisotropy = [&] {
        return std::ranges::any_of(gltf::editable_factors, [&](const gltf::EditableFactor& factor) {
            return factor.key == "anisotropy" && factor.is_of(material);
        });
    };
    EXPECT_FALSE(has_anisotropy());
    material.clearcoat = 1.0f; // which a person may have given it
    material.clearcoat_normal_texture.texture = 0;
    EXPECT_FALSE(has_anisotropy());
    material.normal_texture.texture = 0;
    EXPECT_TRUE(has_anisotropy());
});

const Test lit("unit.viewer.materials.one_that_gets_an_emission_is_a_light", [] {
    const fs::path folder = fs::temp_directory_path() / ("steradian_lit_" + std::to_string(getpid()));
    fs::create_directories(folder);
    setenv("XDG_STATE_HOME", folder.c_str(), 1);
    LoadedScene loaded = load_scene(STERADIAN_SCENES "/cornell.gltf", Options(), 1.0f);
    LightEditor editor(loaded, false), fresh(loaded, false);
    const std::size_t entries = editor.entries().size();
    const vec3 emission(40.0f, 20.0f, 10.0f);
    const auto is_lit = [&](const LoadedScene& scene) {
        return glm::distance(scene.stage.scene.materials[1].emission, emission) < 1e-4f;
    };
    ASSERT_FALSE(editor.stated(1).is_emissive());
    editor.set_emission(1, emission);
    editor.apply(loaded);
    EXPECT_TRUE(is_lit(loaded));
    ASSERT_EQ(editor.entries().size(), entries + 1);
    EXPECT_TRUE(editor.is_unsaved());
    const std::string copy = folder / "lit.gltf";
    editor.save(loaded, nullptr, copy);
    EXPECT_TRUE(is_lit(load_scene(copy, Options(), 1.0f)));
    Journal(loaded.file).write(editor, loaded.source.json_hash);
    fresh.recover(Journal(loaded.file).find(fresh.edits(), loaded.source.json_hash).newest.value().edits);
    EXPECT_TRUE(std::ranges::any_of(fresh.edits(), [&](const LightEdit& edit) {
        return edit.kind == LightEdit::Kind::material && edit.material == 1 && edit.emission == emission;
    }));
    EXPECT_TRUE(editor.undo());
    editor.apply(loaded);
    EXPECT_EQ(editor.entries().size(), entries);
    EXPECT_FALSE(editor.is_unsaved());
    EXPECT_TRUE(editor.redo());
    editor.begin_step();
    editor.set_emission(1, vec3(0.0f));
    editor.apply(loaded);
    EXPECT_EQ(editor.entries().size(), entries) << "black is as the file has it";
    EXPECT_FALSE(editor.is_unsaved());
    fs::remove_all(folder);
});

const Test recovered("unit.viewer.materials.a_journal_has_the_factors", [] {
    const fs::path folder =
        fs::temp_directory_path() / ("steradian_material_journal_" + std::to_string(getpid()));
    fs::create_directories(folder);
    setenv("XDG_STATE_HOME", folder.c_str(), 1);
    const LoadedScene loaded = load_scene(scene_file, Options(), 1.0f);
    LightEditor editor(loaded, false), fresh(loaded, false);
    editor.set_factors(1, {.metallic = 0.25f, .others = {{2, vec3(1.25f, 0.0f, 0.0f)}}});
    Journal(scene_file).write(editor, loaded.source.json_hash);
    const auto lost = Journal(scene_file).find(fresh.edits(), loaded.source.json_hash).newest;
    ASSERT_TRUE(lost.has_value());
    fresh.recover(lost->edits);
    EXPECT_EQ(fresh.factors_of(1), editor.factors_of(1));
    EXPECT_EQ(fresh.factors_of(0), MaterialFactors());
    fs::remove_all(folder);
});

const Test hidden("unit.viewer.materials.hidden_objects_emit_nothing_and_cast_no_shadow", [] {
    LoadedScene loaded = load_scene(STERADIAN_SCENES "/cornell.gltf", Options(), 1.0f);
    LightEditor editor(loaded, false);
    const std::size_t lights = loaded.stage.lights.size();
    std::size_t emitters = 0;
    for (const scene::Instance& instance : loaded.stage.scene.instances) {
        if (instance.emits_as.is_empty() || instance.node < 0) continue;
        ++emitters;
        loaded.hidden.insert({instance.node, instance.mesh});
    }
    ASSERT_GT(emitters, 0u);
    editor.apply(loaded);
    EXPECT_LT(loaded.stage.lights.size(), lights);
    const shadow::Casters casters = shadow::collect_casters(loaded.stage.scene, loaded.stage.lights);
    EXPECT_EQ(casters.triangle_count(), scene::triangle_count(loaded.stage.scene)) << "triangles are counted";
    for (std::size_t t = 0; t < casters.triangle_count(); ++t) {
        const auto [a, b, c] =
            std::to_array({casters.triangle(t)[0], casters.triangle(t)[1], casters.triangle(t)[2]});
        if (!loaded.stage.scene.instances[casters.caster_of[t]].is_hidden) continue;
        EXPECT_TRUE(a == b && b == c) << "a hidden triangle casts a shadow";
    }
    loaded.hidden.clear();
    editor.apply(loaded);
    EXPECT_EQ(loaded.stage.lights.size(), lights);
});

} // namespace
