// The environment of a glTF scene: the picture that it names, and what is done without it.
#include "image/file.hpp"
#include "loading.hpp"

using namespace sr;
using namespace sr::testing;
using sr::testing::Test;

namespace {

MadeGltf under(const char* file) {
    MadeGltf made = MadeGltf::triangle();
    made.root["scenes"][0]["extras"]["steradian"]["environment"]["file"] = file;
    return made;
}

const Test found("unit.gltf.environment.its_picture_may_have_an_encoded_name", [] {
    const auto folder = test_folder();
    image::Image sky(2, 1, 3);
    sky.pixels = {1.0f, 2.0f, 3.0f, 4.0f, 5.0f, 6.0f};
    image::write(sky, folder / "a sky.exr", image::SampleType::floating);
    for (const char* name : {"a sky.exr", "a%20sky.exr", "./a%20sky.exr"}) {
        write_text(folder / "made.gltf", under(name).gltf());
        const gltf::Loaded loaded = gltf::load(folder / "made.gltf");
        EXPECT_TRUE(loaded.warnings.empty()) << ::testing::PrintToString(loaded.warnings);
        ASSERT_TRUE(loaded.scene.environment && loaded.scene.environment->map) << name;
        EXPECT_EQ(loaded.scene.environment->map->width(), 2);
    }
});

const Test lost("unit.gltf.environment.without_its_picture_there_is_none", [] {
    const auto folder = test_folder();
    write_text(folder / "torn.exr", "v/1\x01");
    write_text(folder / "words.txt", "sky");
    for (const char* name : {"no.hdr", "torn.exr", "words.txt", "../sky.hdr", ""}) {
        write_text(folder / "made.gltf", under(name).gltf());
        const gltf::Loaded loaded = gltf::load(folder / "made.gltf");
        EXPECT_TRUE(warns_once(loaded, "it has no environment")) << name;
        EXPECT_FALSE(loaded.scene.environment) << name;
        EXPECT_NE(error_at(folder / "made.gltf", {.is_strict = true}), "") << name;
    }
});

} // namespace
