#include "golden/init.hpp"

#include "core/error.hpp"
#include "core/file.hpp"
#include "image/file.hpp"
#include "support/address.hpp"
#include "support/models.hpp"
#include "unit/golden/suite_support.hpp"

using namespace sr;
using namespace sr::testing;
using sr::testing::Test;
namespace fs = std::filesystem;

namespace {

const Test scenes("unit.golden.init.each_scene_becomes_a_test", [] {
    const auto folder = scratch_folder("init_scenes");
    fs::create_directories(folder / "scenes/sub");
    for (const char* file :
         {"a.gltf", "texture.png", "sub/a b.glb", "sub/a_b.gltf", "sub/a:b.glb", ".hidden.glb"})
        written(folder / "scenes" / file, "{}");
    const auto made = golden::write_first_suite({{folder / "scenes"}, folder / "golden"});
    EXPECT_EQ(made.tests, 4);
    EXPECT_FALSE(made.is_of_pictures);
    const auto suite = golden::load_suite(made.suite);
    std::vector<std::string> names;
    for (const auto& test : suite.tests) {
        names.push_back(test.name);
        EXPECT_TRUE(fs::exists(suite.folder / test.scene)) << test.scene;
    }
    EXPECT_EQ(names, (std::vector<std::string>{"a", "sub_a_b", "sub_a_b_2", "sub_a_b_3"}));
    for (const char* file : {"github-actions.yml", "gitlab-ci.yml"}) {
        const std::string text = read_text(folder / "golden" / file);
        EXPECT_NE(text.find("golden/suite.json --shard"), std::string::npos) << file;
        EXPECT_NE(text.find("--times golden-times/run.json"), std::string::npos) << file;
        EXPECT_EQ(text.find("@suite@"), std::string::npos) << file;
        EXPECT_EQ(text.find("@folder@"), std::string::npos) << file;
    }
    EXPECT_NE(error_of([&] {
                  golden::write_first_suite({{folder / "scenes"}, folder / "golden"});
              }).find("is there already"),
              std::string::npos);
});

const Test once("unit.golden.init.finds_each_file_once_and_no_goldens", [] {
    const auto folder = scratch_folder("init_once");
    fs::create_directories(folder / "made/golden/goldens");
    fs::create_directories(folder / "made/out/candidates");
    written(folder / "made/golden/suite.json", "{}");
    written(folder / "made/out/results.json", "{}");
    for (const char* file : {"a.png", "golden/goldens/a.png", "out/candidates/a.png"})
        image::write(plain(0.5f), folder / "made" / file, image::SampleType::integer8);
    fs::create_symlink("a.png", folder / "made/b.png");
    const auto made = golden::write_first_suite(
        {{folder / "made", folder / "made/a.png", folder / "made/../made"}, folder / "golden"});
    EXPECT_EQ(made.tests, 1);
});

const Test quotes("unit.golden.init.refuses_a_path_that_needs_quotes", [] {
    const auto folder = scratch_folder("init_quotes");
    image::write(plain(0.5f), folder / "a.png", image::SampleType::integer8);
    for (const char* name : {"two words", "it's", "a;b", "$(x)", "a#b", "é"}) {
        const std::string error = error_of([&] {
            golden::write_first_suite({{folder / "a.png"}, folder / name});
        });
        EXPECT_NE(error.find("without quotes"), std::string::npos) << name << ": " << error;
        EXPECT_FALSE(fs::exists(folder / name)) << name;
    }
    fs::create_directories(folder / "project/.git"); // where CI systems start their commands
    golden::write_first_suite({{folder / "a.png"}, folder / "project/tests/golden"});
    const std::string text = read_text(folder / "project/tests/golden/github-actions.yml");
    EXPECT_NE(text.find(" golden run tests/golden/suite.json "), std::string::npos) << text;
});

const Test pictures("unit.golden.init.a_suite_of_pictures_can_be_run_and_approved", [] {
    const auto folder = scratch_folder("init_pictures");
    fs::create_directories(folder / "made");
    image::Image picture = plain(0.5f);
    picture.attributes.clear();
    image::write(picture, folder / "made/one.exr", image::SampleType::floating);
    image::write(picture, folder / "made/two.png", image::SampleType::integer8);
    const auto made = golden::write_first_suite({{folder / "made"}, folder / "golden"});
    EXPECT_TRUE(made.is_of_pictures);
    const auto suite = golden::load_suite(made.suite);
    EXPECT_EQ(run_and_keep(suite, folder / "out").count(golden::Outcome::missing), 2);
    golden::ApproveOptions options;
    options.output = folder / "out";
    const auto plan = golden::plan_approval(suite, options);
    ASSERT_TRUE(plan.is_allowed(false));
    golden::carry_out(plan);
    EXPECT_TRUE(run_and_keep(suite, folder / "out").passed());
    EXPECT_NE(error_of([&] {
                  golden::write_first_suite({{folder / "none"}, folder / "x"});
              }).find("no such"),
              std::string::npos);
    fs::create_directories(folder / "empty");
    EXPECT_NE(error_of([&] {
                  golden::write_first_suite({{folder / "empty"}, folder / "x"});
              }).find("neither"),
              std::string::npos);
    EXPECT_FALSE(fs::exists(folder / "x")) << "a refused suite left a folder";
});

} // namespace
