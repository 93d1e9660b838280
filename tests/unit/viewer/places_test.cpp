// Views that are typed and kept: points, lengths and lenses with units, and bookmarks of a file.
#include "core/error.hpp"
#include "support/address.hpp"
#include "viewer/document/bookmarks.hpp"
#include "viewer/document/view_history.hpp"
#include "viewer/view/camera_values.hpp"

#include <cmath>
#include <csignal>
#include <filesystem>
#include <fstream>
#include <numbers>
#include <sys/resource.h>

using namespace sr::viewer;
using sr::testing::Test;

namespace {

const Test points("unit.viewer.places.a_point_has_three_numbers_with_units", [] {
    EXPECT_EQ(parse_point("1, -2.5, 3e1"), glm::dvec3(1.0, -2.5, 30.0));
    EXPECT_EQ(parse_point(" 1 2 3 km "), glm::dvec3(1000.0, 2000.0, 3000.0)) << "a unit at the end is of all";
    EXPECT_EQ(parse_point("1 m, 50cm, 2 ft"), glm::dvec3(1.0, 0.5, 0.6096)) << "each has its own";
    EXPECT_EQ(parse_point("1 cm, 2, 3"), glm::dvec3(0.01, 2.0, 3.0));
    EXPECT_EQ(parse_point(text_of_point({0.1, -20.0, 3e5})), glm::dvec3(0.1, -20.0, 3e5));
    for (const char* wrong : {"", "1, 2", "1, 2, 3, 4", "1, 2, x", "1, 2, 3 kg", "1, 2, nan", "1, 2, inf m"})
        EXPECT_THROW(parse_point(wrong), sr::Error) << wrong;
});

const Test lenses("unit.viewer.places.a_field_of_view_is_an_angle_or_a_focal_length", [] {
    EXPECT_DOUBLE_EQ(parse_field_of_view("90"), 0.5 * std::numbers::pi);
    EXPECT_DOUBLE_EQ(parse_field_of_view("60 °"), std::numbers::pi / 3.0);
    EXPECT_DOUBLE_EQ(parse_field_of_view("0.7 rad"), 0.7);
    EXPECT_DOUBLE_EQ(parse_field_of_view("12 mm"), 0.5 * std::numbers::pi) << "film of 24 mm height";
    EXPECT_NEAR(parse_field_of_view(text_of_field_of_view(0.7)), 0.7, 1e-6);
    EXPECT_DOUBLE_EQ(parse_length("25 cm"), 0.25);
    for (const char* wrong : {"", "0", "180", "-5", "7 rad", "-50 mm", "40 m", "wide"})
        EXPECT_THROW(parse_field_of_view(wrong), sr::Error) << wrong;
});

const Test kept("unit.viewer.places.bookmarks_are_kept_for_each_file", [] {
    const auto folder = std::filesystem::temp_directory_path() / "steradian_bookmarks_test";
    std::filesystem::remove_all(folder);
    std::filesystem::create_directories(folder);
    const auto store = folder / "bookmarks.json";
    {
        Bookmarks first("a.gltf", store), other("b.gltf", store);
        EXPECT_EQ(first.keep("eye=1,0,0;target=0,0,0"), "view 1");
        EXPECT_EQ(other.keep("eye=5,0,0;target=0,0,0"), "view 1");
        EXPECT_EQ(first.keep("eye=2,0,0;target=0,0,0"), "view 2");
        first.remove(0);
        EXPECT_EQ(first.keep("eye=3,0,0;target=0,0,0"), "view 1") << "a free name is used again";
    }
    const Bookmarks again("./a.gltf", store);
    ASSERT_EQ(again.all().size(), 2u);
    EXPECT_EQ(again.all()[0], (Bookmark{"view 2", "eye=2,0,0;target=0,0,0"}));
    EXPECT_EQ(Bookmarks("b.gltf", store).all().size(), 1u);
    std::ofstream(store) << R"({"a.gltf": 3, "x": [{"name": 1}]} and more)";
    Bookmarks broken("a.gltf", store);
    EXPECT_TRUE(broken.all().empty());
    broken.keep("eye=1,0,0;target=0,0,0");
    EXPECT_EQ(Bookmarks("a.gltf", store).all().size(), 1u);
    std::filesystem::remove_all(folder);
});

const Test full_disk("unit.viewer.places.a_full_disk_takes_no_bookmarks_away", [] {
    const auto folder = std::filesystem::temp_directory_path() / "steradian_full_disk_test";
    std::filesystem::remove_all(folder);
    std::filesystem::create_directories(folder);
    const auto store = folder / "bookmarks.json";
    Bookmarks bookmarks("a.gltf", store);
    bookmarks.keep("eye=1,0,0;target=0,0,0");
    EXPECT_TRUE(bookmarks.is_stored());
    rlimit before{};
    getrlimit(RLIMIT_FSIZE, &before);
    const rlimit full{0, before.rlim_max}; // a write then fails as on a full disk
    const auto handler = std::signal(SIGXFSZ, SIG_IGN);
    setrlimit(RLIMIT_FSIZE, &full);
    bookmarks.keep("eye=2,0,0;target=0,0,0");
    setrlimit(RLIMIT_FSIZE, &before);
    std::signal(SIGXFSZ, handler);
    EXPECT_FALSE(bookmarks.is_stored());
    EXPECT_EQ(bookmarks.all().size(), 2u) << "this run has it";
    EXPECT_EQ(Bookmarks("a.gltf", store).all().size(), 1u) << "the file is as it was";
    std::filesystem::remove_all(folder);
});

const Test history("unit.viewer.places.views_are_gone_back_to_and_forward_again", [] {
    ViewHistory views;
    EXPECT_FALSE(views.earlier());
    for (const char* view : {"a", "b", "b", "c"}) views.visit(view);
    EXPECT_FALSE(views.later());
    EXPECT_EQ(views.earlier(), "b");
    EXPECT_EQ(views.earlier(), "a");
    EXPECT_FALSE(views.earlier());
    EXPECT_EQ(views.later(), "b");
    views.visit("b"); // where it is already
    EXPECT_EQ(views.later(), "c");
    EXPECT_EQ(views.earlier(), "b");
    views.visit("d"); // in the place of what came after
    EXPECT_FALSE(views.later());
    EXPECT_EQ(views.earlier(), "b");
    for (int i = 0; i < 300; ++i) views.visit(std::to_string(i));
    int count = 1;
    while (views.earlier()) ++count;
    EXPECT_EQ(count, 200);
});

} // namespace
