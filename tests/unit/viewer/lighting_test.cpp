// Editing lights: what a person types, and that a saved file has the lights that were seen.
#include "core/error.hpp"
#include "support/address.hpp"
#include "viewer/document/light_selection.hpp"
#include "viewer/document/new_light.hpp"

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <glm/gtc/matrix_transform.hpp>
#include <nlohmann/json.hpp>

using namespace sr;
using namespace sr::viewer;
using sr::testing::Test;

namespace {

namespace fs = std::filesystem;

const fs::path scenes = fs::path(STERADIAN_SCENES);

float luminance_of(const scene::Light& light) {
    return static_cast<float>(scene::luminance(quantity_of(light)));
}

LightGroup alone(const std::vector<scene::Light>& lights) {
    static const std::vector<scene::LightProfile> none;
    return {lights, none};
}

const Test typed("unit.viewer.lights.typed_values_are_what_they_say", [] {
    const std::vector<scene::Light> point{scene::PointLight{}};
    const auto Y = [&](const char* text, const std::vector<scene::Light>& lights) {
        return scene::luminance(parse_quantity(text, alone(lights)));
    };
    EXPECT_NEAR(Y("800 lm", point), 800.0 / (4.0 * pi), 1e-4);
    EXPECT_NEAR(Y(" 12.5 ", point), 12.5, 1e-5);
    EXPECT_NEAR(Y("1 W", point), 683.0 / (4.0 * pi), 1e-3);
    const std::vector<scene::Light> plate{scene::RectangleLight{}}; // 4 m²
    EXPECT_NEAR(Y("800 lm", plate), 800.0 / (4.0 * pi), 1e-4);
    EXPECT_NEAR(Y("100 cd", plate), 25.0, 1e-5);
    std::vector<scene::Light> two(2, scene::RectangleLight{});
    EXPECT_NEAR(Y("800 lm", two), 800.0 / (8.0 * pi), 1e-4) << "the flux is that of both";
    const vec3 warm = parse_quantity("2700 K", alone(point));
    EXPECT_NEAR(scene::luminance(warm), 1.0, 1e-5) << "a colour keeps the luminance";
    EXPECT_GT(warm.r, 2.0f * warm.b);
    EXPECT_NEAR(Y("+1 EV", point), 2.0 * Y("0 EV", point), 1e-5);
    EXPECT_NEAR(Y("-0.5 EV", plate), std::exp2(-0.5) * Y("0EV", plate), 1e-5);
    for (const char* wrong : {"+31 EV", "EV", "", "bright", "-3 lm", "3 apples", "20 K", "5 lx"})
        EXPECT_THROW(Y(wrong, point), Error) << wrong;
});

/// All that makes two lights the same.
void expect_same(const scene::Light& a, const scene::Light& b) {
    ASSERT_EQ(a.index(), b.index());
    EXPECT_LT(glm::distance(quantity_of(a), quantity_of(b)), 1e-5f * (1.0f + glm::length(quantity_of(a))));
    const scene::Bounds x = bounds_of(a, 0.0f), y = bounds_of(b, 0.0f);
    EXPECT_EQ(x.is_empty(), y.is_empty());
    if (!x.is_empty()) {
        EXPECT_LT(glm::distance(x.min, y.min) + glm::distance(x.max, y.max), 1e-4f);
    }
    std::visit(
        [&](const auto& l) {
            const auto& other = std::get<std::decay_t<decltype(l)>>(b);
            if constexpr (requires { l.direction; }) {
                EXPECT_LT(glm::distance(l.direction, other.direction), 1e-5f);
            }
            if constexpr (requires { l.half_u; }) {
                EXPECT_LT(glm::distance(l.normal(), other.normal()), 1e-5f);
            }
            if constexpr (requires { l.radius; }) {
                EXPECT_NEAR(l.radius, other.radius, 1e-5f);
            }
        },
        a);
}

/// A copy of a bundled scene in a folder of its own.
fs::path copied(const fs::path& scene, const fs::path& folder) {
    fs::create_directories(folder);
    for (const fs::path& name : {scene, fs::path("downlight.ies")})
        fs::copy_file(scenes / name, folder / name, fs::copy_options::overwrite_existing);
    return folder / scene;
}

const Test saved("unit.viewer.lights.a_saved_file_has_the_lights_that_were_seen", [] {
    const fs::path folder = fs::temp_directory_path() / "steradian_saved_lights";
    for (const char* name : {"zoo.gltf", "emitters.gltf"}) {
        const std::string file = copied(name, folder);
        LoadedScene loaded = load_scene(file, {}, 1.0f);
        LightEditor lighting(loaded, false);
        const std::size_t lights = loaded.stage.scene.lights.size();
        ASSERT_GE(lights, 4u);
        const mat4 by = glm::rotate(glm::translate(mat4(1.0f), vec3(0.1f, 0.2f, -0.3f)), 0.4f, vec3(0, 1, 0));
        for (std::size_t i = 0; i < lights; ++i)
            if (i != 1) lighting.transform(i, by);
        lighting.set_quantity(0, 3.0f * quantity_of(lighting.edits()[0].light));
        lighting.set_quantity(lighting.entries().size() - 1, vec3(7.0f, 5.0f, 3.0f));
        lighting.enable(3, false);
        lighting.remove(2);
        lighting.add(scene::SphereLight{"more", vec3(0.5f), 0.2f, vec3(10.0f)});
        lighting.add(scene::PointLight{"spark", vec3(0.1f), vec3(2.0f)});
        scene::RectangleLight plate;
        plate.L = vec3(30.0f, 20.0f, 10.0f);
        lighting.add(plate);
        lighting.apply(loaded);
        const std::string copy = folder / (std::string("relit_") + name);
        lighting.save(loaded, &loaded.stage.camera, copy);

        const LoadedScene again = load_scene(copy, {}, 1.0f);
        EXPECT_EQ(again.stage.camera.name, "view");
        // Lights that moved come back where their nodes are: after those that did not.
        ASSERT_EQ(again.stage.lights.size(), loaded.stage.lights.size());
        for (const scene::Light& light : loaded.stage.lights) {
            const auto same = std::ranges::find_if(again.stage.lights, [&](const scene::Light& other) {
                const auto a = center_of(light), b = center_of(other);
                return light.index() == other.index() && (!a || glm::distance(*a, *b) < 1e-4f);
            });
            ASSERT_NE(same, again.stage.lights.end()) << name;
            expect_same(light, *same);
        }
    }
    fs::remove_all(folder);
});

const Test resized("unit.viewer.lights.a_saved_file_has_the_sizes_that_were_seen", [] {
    const fs::path folder = fs::temp_directory_path() / "steradian_saved_sizes";
    std::size_t pulled = 0;
    for (const char* name : {"zoo.gltf", "emitters.gltf"}) {
        LoadedScene loaded = load_scene(copied(name, folder), {}, 1.0f);
        LightEditor lighting(loaded, false);
        const std::size_t lights = loaded.stage.scene.lights.size();
        const mat4 by = glm::scale(glm::rotate(mat4(1.0f), 0.3f, vec3(0, 0, 1)), vec3(0.8f));
        for (std::size_t i = 0; i < lights; ++i) {
            if (i % 2 == 0) lighting.transform(i, by);
            const std::vector<scene::LightSize> extents = scene::sizes_of(lighting.edits()[i].light);
            for (std::size_t k = 0; k < extents.size(); ++k, ++pulled)
                lighting.set_size(i, k, extents[k].size * (1.5f + 0.2f * static_cast<float>(k)));
        }
        lighting.apply(loaded);
        lighting.save(loaded, nullptr, folder / "resized.gltf");
        const LoadedScene again = load_scene(folder / "resized.gltf", {}, 1.0f);
        ASSERT_EQ(again.stage.scene.lights.size(), lights);
        for (const scene::Light& light : loaded.stage.scene.lights) {
            const auto same = std::ranges::find_if(again.stage.scene.lights, [&](const scene::Light& other) {
                const auto a = center_of(light), b = center_of(other);
                return light.index() == other.index() && (!a || glm::distance(*a, *b) < 1e-4f);
            });
            ASSERT_NE(same, again.stage.scene.lights.end()) << name;
            expect_same(light, *same);
        }
    }
    EXPECT_GE(pulled, 8u);
    fs::remove_all(folder);
});

const Test added_kinds("unit.viewer.lights.each_new_kind_and_each_new_name_is_saved", [] {
    const fs::path folder = fs::temp_directory_path() / "steradian_saved_kinds";
    const fs::path file = copied("zoo.gltf", folder);
    LoadedScene loaded = load_scene(file.string(), {}, 1.0f);
    LightEditor lighting(loaded, false);
    const NewLightPlace place{vec3(0.3f, 2.0f, -0.4f), vec3(1.0f, 0.1f, 0.5f), 0.4f, 80.0f};
    std::size_t last = 0;
    for (const NewLightKind& row : new_light_kinds) last = lighting.add(new_light(row.kind, place));
    lighting.apply(loaded);
    scene::DiskLight ellipse{"ellipse", vec3(1.0f), vec3(0.5f, 0, 0), vec3(0, 0, 0.2f), vec3(9.0f)};
    ellipse.is_two_sided = true;
    ellipse.is_visible = false;
    const auto copy = duplicate_of(ellipse, 0.25f);
    ASSERT_TRUE(copy);
    EXPECT_EQ(name_of(*copy), "ellipse copy");
    EXPECT_NEAR(center_of(*copy)->x, 1.25f, 1e-6f);
    lighting.add(*copy);
    lighting.rename(0, "renamed");
    lighting.apply(loaded);
    EXPECT_EQ(lighting.entries()[0].name, "renamed");
    EXPECT_EQ(lighting.entries()[last].name, "new tube");
    loaded = load_scene(file.string(), {}, 1.0f);
    lighting.rebase(loaded); // as at another time: the name stays
    lighting.apply(loaded);
    EXPECT_EQ(lighting.entries()[0].name, "renamed");
    lighting.save(loaded, nullptr, folder / "more.gltf");
    const LoadedScene again = load_scene((folder / "more.gltf").string(), {}, 1.0f);
    ASSERT_EQ(again.stage.scene.lights.size(), loaded.stage.scene.lights.size());
    for (const scene::Light& light : loaded.stage.scene.lights) {
        const auto same = std::ranges::find_if(again.stage.scene.lights, [&](const scene::Light& other) {
            return name_of(light) == name_of(other);
        });
        ASSERT_NE(same, again.stage.scene.lights.end()) << name_of(light);
        expect_same(light, *same);
        EXPECT_EQ(visibility_of(light), visibility_of(*same)) << name_of(light);
        if (const auto* spot = std::get_if<scene::SpotLight>(&light)) {
            EXPECT_NEAR(spot->inner_angle, std::get<scene::SpotLight>(*same).inner_angle, 1e-6f);
            EXPECT_NEAR(spot->outer_angle, std::get<scene::SpotLight>(*same).outer_angle, 1e-6f);
        }
        if (const auto* disk = std::get_if<scene::DiskLight>(&light)) {
            EXPECT_EQ(disk->is_two_sided, std::get<scene::DiskLight>(*same).is_two_sided);
        }
    }
    EXPECT_TRUE(lighting.undo());
    EXPECT_FALSE(duplicate_of(scene::EnvironmentLight{}, 1.0f));
    scene::PointLight profiled;
    profiled.profile = 0;
    EXPECT_FALSE(duplicate_of(profiled, 1.0f));
    fs::remove_all(folder);
});

const Test untouched("unit.viewer.lights.saving_keeps_what_was_not_edited", [] {
    const fs::path folder = fs::temp_directory_path() / "steradian_saved_same";
    const fs::path file = copied("emitters.gltf", folder);
    const LoadedScene loaded = load_scene(file, {}, 1.0f);
    const LightEditor lighting(loaded, false);
    lighting.save(loaded, nullptr, folder / "same.gltf");
    const auto text = [](const fs::path& path) {
        std::ifstream in(path);
        return nlohmann::json::parse(in);
    };
    EXPECT_EQ(text(file), text(folder / "same.gltf"));
    // Elsewhere and in the other container the file brings what it refers to.
    const fs::path elsewhere = folder.parent_path() / "steradian_saved_elsewhere.gltf";
    for (const fs::path& copy : {elsewhere, folder / "same.glb"}) {
        lighting.save(loaded, nullptr, copy);
        const LoadedScene again = load_scene(copy, {}, 1.0f);
        EXPECT_EQ(again.stage.scene.images.size(), loaded.stage.scene.images.size());
        EXPECT_EQ(again.stage.scene.meshes.size(), loaded.stage.scene.meshes.size());
        EXPECT_EQ(again.stage.lights.size(), loaded.stage.lights.size());
    }
    EXPECT_THROW(lighting.save(loaded, nullptr, folder / "same.obj"), Error);
    fs::remove(elsewhere);
    fs::remove_all(folder);
});

const Test undone("unit.viewer.lights.undoing_goes_back_step_by_step", [] {
    LoadedScene loaded = load_scene(scenes / "zoo.gltf", {}, 1.0f);
    LightEditor lighting(loaded, false);
    const float first = luminance_of(lighting.edits()[0].light);
    lighting.begin_step();
    lighting.enable(0, true); // as it is
    EXPECT_FALSE(lighting.undo()) << "nothing was changed";
    lighting.begin_step();
    lighting.set_quantity(0, vec3(5.0f));
    lighting.set_quantity(0, vec3(6.0f)); // the same drag
    lighting.begin_step();
    lighting.solo({1});
    lighting.apply(loaded);
    EXPECT_EQ(luminance_of(loaded.stage.lights[0]), 0.0f);
    EXPECT_GT(luminance_of(loaded.stage.lights[1]), 0.0f);
    EXPECT_TRUE(lighting.undo());
    lighting.apply(loaded);
    EXPECT_NEAR(luminance_of(loaded.stage.lights[0]), 6.0f, 1e-5f);
    EXPECT_TRUE(lighting.undo());
    lighting.apply(loaded);
    EXPECT_EQ(luminance_of(loaded.stage.lights[0]), first);
    EXPECT_FALSE(lighting.undo());
    EXPECT_TRUE(lighting.redo());
    lighting.apply(loaded);
    EXPECT_NEAR(luminance_of(loaded.stage.lights[0]), 6.0f, 1e-5f);
    lighting.begin_step();
    lighting.set_quantity(0, vec3(7.0f));
    EXPECT_FALSE(lighting.redo()) << "a new edit drops what was undone";
    lighting.begin_step();
    lighting.set_quantity(0, vec3(8.0f));
    lighting.cancel_step();
    lighting.apply(loaded);
    EXPECT_NEAR(luminance_of(loaded.stage.lights[0]), 7.0f, 1e-5f);
    lighting.begin_step(2, "value of lamp, 2 lights"); // a group
    lighting.set_quantity(0, vec3(1.0f));
    lighting.set_quantity(1, vec3(1.0f));
    EXPECT_EQ(lighting.undo(), "value of lamp, 2 lights");
});

const Test several("unit.viewer.lights.several_are_selected_as_in_a_list", [] {
    using Entries = std::vector<std::size_t>;
    LightSelection selected;
    EXPECT_FALSE(selected);
    selected.toggle(3);
    selected.toggle(5);
    EXPECT_EQ(*selected, 5u);
    EXPECT_TRUE(selected.contains(3));
    selected.toggle(5);
    EXPECT_EQ(selected.entries(), Entries{3});
    selected.extend_to(5);
    EXPECT_EQ(selected.entries(), (Entries{3, 4, 5}));
    selected.extend_to(2);
    EXPECT_EQ(selected.entries(), (Entries{3, 2})) << "the range begins where it began";
    EXPECT_EQ(*selected, 2u);
    selected.keep_below(3);
    EXPECT_EQ(selected.entries(), Entries{2});
    selected = 7;
    EXPECT_EQ(selected.entries(), Entries{7});
});

const Test together("unit.viewer.lights.an_edit_of_several_is_one_step", [] {
    LoadedScene loaded = load_scene((scenes / "zoo.gltf").string(), {}, 1.0f);
    LightEditor lighting(loaded, false);
    lighting.apply(loaded);
    const std::vector<LightEntry> listed = lighting.entries();
    ASSERT_GT(listed.size(), 3u);
    const std::vector<LightEdit> before = lighting.edits();
    const auto quantity = [&](std::size_t i) { return luminance_of(lighting.lights_of(i).front()); };
    const float first = quantity(0), second = quantity(1);
    lighting.begin_step();
    lighting.enable(1, false);
    lighting.apply(loaded);
    lighting.begin_step(2);
    for (const std::size_t i : {0, 1}) lighting.brighten(i, 2.0f);
    lighting.apply(loaded);
    EXPECT_NEAR(quantity(0), 2.0f * first, 1e-4f * first);
    EXPECT_NEAR(quantity(1), 2.0f * second, 1e-4f * second);
    EXPECT_FALSE(lighting.entries()[1].is_enabled) << "one that is off stays off";
    lighting.begin_step(2);
    for (const std::size_t i : {0, 2}) lighting.remove(i);
    LightSelection selected;
    selected.select({0, 3});
    lighting.apply(loaded);
    EXPECT_EQ(lighting.entries().size(), listed.size() - 2);
    selected.follow(listed, lighting);
    EXPECT_EQ(selected.entries(), std::vector<std::size_t>{1}) << "the same light, two places before";
    EXPECT_EQ(lighting.undo(), "removing 2 lights");
    EXPECT_EQ(lighting.undo(), "value of 2 lights");
    lighting.apply(loaded);
    EXPECT_NEAR(quantity(0), first, 1e-4f * first);
    EXPECT_TRUE(lighting.undo());
    EXPECT_TRUE(are_at_same_places(lighting.edits(), before));
    EXPECT_FALSE(lighting.undo());
});

} // namespace
