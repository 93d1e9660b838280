// Animations in the viewer, and edits that a person made meanwhile.
#include "core/error.hpp"
#include "support/address.hpp"
#include "viewer/document/light_edits.hpp"
#include "viewer/document/playback.hpp"

#include <glm/gtc/matrix_transform.hpp>

using namespace sr;
using namespace sr::viewer;
using sr::testing::Test;

namespace {

const std::string motion = STERADIAN_SCENES "/motion.gltf";

Playback playing(double duration) {
    Playback playback;
    playback.animations = {0};
    playback.duration = duration;
    playback.is_playing = true;
    return playback;
}

const Test playback_ends("unit.viewer.playback.loops_or_stops_at_its_end", [] {
    Playback p = playing(2.0);
    EXPECT_TRUE(p.moment().animations.empty()) << "not begun: the rest pose";
    p.advance(1.5);
    EXPECT_DOUBLE_EQ(p.moment().seconds, 1.5);
    p.advance(1.5);
    EXPECT_DOUBLE_EQ(*p.seconds, 1.0) << "it restarts";
    p.speed = 0.5;
    p.is_reversed = true;
    p.advance(3.0);
    EXPECT_DOUBLE_EQ(*p.seconds, 1.5) << "backwards, over the beginning";
    p.loops = p.is_reversed = false;
    p.advance(7.0);
    EXPECT_DOUBLE_EQ(*p.seconds, 2.0);
    EXPECT_FALSE(p.is_playing);
    p.advance(1.0);
    EXPECT_DOUBLE_EQ(*p.seconds, 2.0);
    p.toggle();
    EXPECT_TRUE(p.is_playing && *p.seconds == 0.0) << "from the end it plays from the beginning";
    Playback still = playing(0.0); // one key
    still.advance(0.1);
    EXPECT_TRUE(!still.is_playing && *still.seconds == 0.0);
});

const Test playback_steps("unit.viewer.playback.steps_whole_frames_and_stays_within", [] {
    Playback p = playing(2.0);
    p.go_to(0.49);
    EXPECT_FALSE(p.is_playing);
    p.step(1);
    EXPECT_DOUBLE_EQ(*p.seconds, 12.0 / 24.0);
    for (int frame = 13; frame <= 40; ++frame) {
        p.step(1);
        EXPECT_DOUBLE_EQ(*p.seconds, frame / 24.0);
    }
    p.step(-1);
    EXPECT_DOUBLE_EQ(*p.seconds, 39.0 / 24.0);
    p.go_to(0.01);
    p.step(-1);
    EXPECT_DOUBLE_EQ(*p.seconds, 0.0);
    p.step(-1);
    EXPECT_DOUBLE_EQ(*p.seconds, 0.0);
    p.go_to(9.0);
    EXPECT_DOUBLE_EQ(*p.seconds, 2.0);
    p.choose({0}, 0.7);
    EXPECT_DOUBLE_EQ(*p.seconds, 0.7);
});

void show(LoadedScene& loaded, LightEditor& lighting, double seconds) {
    pose(loaded, {{0}, seconds});
    lighting.rebase(loaded);
    lighting.apply(loaded);
}

/// Evaluates the file's first light at a moment, by loading it separately.
scene::PointLight lamp_at(double seconds) {
    Options options;
    options.at = seconds;
    return std::get<scene::PointLight>(load_scene(motion, options, 1.0f).stage.lights[0]);
}

// motion.gltf: "lamp" walks and changes its intensity, "sign", an emissive surface, is hidden from 1.25 s
// to 1.75 s.
const Test edits_stay("unit.viewer.lights.edits_survive_another_moment", [] {
    LoadedScene loaded = load_scene(motion, {}, 1.0f);
    LightEditor lighting(loaded, false);
    const auto lamp = [&] { return std::get<scene::PointLight>(loaded.stage.lights[0]); };
    show(loaded, lighting, 0.6);
    ASSERT_NE(lamp().position, lamp_at(0.2).position);
    EXPECT_EQ(lamp().position, lamp_at(0.6).position);
    EXPECT_EQ(lamp().I, lamp_at(0.6).I);

    lighting.begin_step();
    lighting.set_quantity(0, vec3(7.0f));
    lighting.begin_step();
    lighting.transform(0, glm::translate(mat4(1.0f), vec3(0.0f, 2.0f, 0.0f)));
    lighting.begin_step();
    lighting.set_quantity(1, vec3(11.0f));
    show(loaded, lighting, 0.2);
    EXPECT_EQ(lamp().I, vec3(7.0f)) << "what a person gave it wins over the animation";
    EXPECT_LT(glm::distance(lamp().position, lamp_at(0.2).position + vec3(0.0f, 2.0f, 0.0f)), 1e-5f)
        << "it walks on, moved";
    const LightEntry sign = lighting.entries()[1];
    show(loaded, lighting, 1.5);
    EXPECT_EQ(loaded.stage.lights.size(), 1u) << "the sign is hidden";
    EXPECT_FALSE(lighting.entry_like(sign).has_value());
    show(loaded, lighting, 1.8);
    ASSERT_EQ(lighting.entry_like(sign), std::optional<std::size_t>(1));
    EXPECT_EQ(quantity_of(loaded.stage.lights[1]), vec3(11.0f));

    lighting.begin_step();
    lighting.set_size(0, 0, 0.3f);
    show(loaded, lighting, 1.7);
    EXPECT_FLOAT_EQ(lamp().radius, 0.3f) << "its size is a person's";
    EXPECT_TRUE(lighting.undo());
    show(loaded, lighting, 1.8);
    EXPECT_EQ(lamp().radius, lamp_at(1.8).radius);
    EXPECT_TRUE(lighting.redo());
    EXPECT_FLOAT_EQ(std::get<scene::PointLight>(lighting.edits()[0].light).radius, 0.3f);
    EXPECT_TRUE(lighting.undo());

    EXPECT_TRUE(lighting.undo() && lighting.undo());
    lighting.apply(loaded);
    EXPECT_EQ(lamp().position, lamp_at(1.8).position) << "undone it is where the file has it now";
    EXPECT_EQ(lamp().I, vec3(7.0f));
    EXPECT_TRUE(lighting.undo());
    lighting.apply(loaded);
    EXPECT_EQ(lamp().I, lamp_at(1.8).I);

    lighting.remove(0);
    lighting.add(scene::PointLight{"spark", vec3(0.1f), vec3(2.0f)});
    show(loaded, lighting, 0.4);
    ASSERT_EQ(loaded.stage.lights.size(), 2u);
    EXPECT_EQ(lamp().name, "spark") << "what was removed does not come back";
});

const Test variant_keeps("unit.viewer.lights.edits_survive_another_variant", [] {
    LoadedScene loaded = load_scene(motion, {}, 1.0f);
    LightEditor lighting(loaded, false);
    lighting.begin_step();
    lighting.set_quantity(1, vec3(11.0f));
    lighting.begin_step();
    lighting.enable(0, false);
    Options options;
    options.variant = "gilded";
    LoadedScene gilded = load_scene(motion, options, 1.0f);
    ASSERT_NE(gilded.contents.material_numbers, loaded.contents.material_numbers);
    lighting.rebase(gilded);
    lighting.apply(gilded);
    ASSERT_EQ(gilded.stage.lights.size(), 2u);
    EXPECT_EQ(quantity_of(gilded.stage.lights[0]), vec3(0.0f));
    EXPECT_EQ(quantity_of(gilded.stage.lights[1]), vec3(11.0f));
    EXPECT_TRUE(lighting.undo() && lighting.undo());
    lighting.apply(gilded);
    EXPECT_EQ(quantity_of(gilded.stage.lights[1]), quantity_of(loaded.stage.lights[1]));
});

const Test reload_is_lenient("unit.viewer.loading.what_a_saved_file_lost_is_no_error", [] {
    Options options;
    options.at = 9.0;
    options.animation = "Walk";
    options.variant = "rusty";
    EXPECT_THROW(load_scene(motion, options, 1.0f), Error);
    options.is_reloading = true;
    const LoadedScene loaded = load_scene(motion, options, 1.0f);
    EXPECT_EQ(loaded.moment.seconds, 2.0);
    EXPECT_TRUE(loaded.variant.empty());
    EXPECT_GE(loaded.remarks.size(), 2u) << "it says what is gone";
});

} // namespace
