#include "core/error.hpp"
#include "image/file.hpp"
#include "support/address.hpp"
#include "support/models.hpp"

#include <algorithm>
#include <cmath>
#include <csignal>
#include <fstream>
#include <limits>
#include <sys/resource.h>
#include <unistd.h>

using namespace sr;
using namespace sr::image;
using sr::testing::Test;
namespace fs = std::filesystem;

namespace {

constexpr float infinity = std::numeric_limits<float>::infinity();

/// Distinct values, of a wide range, in every sample.
Image ramp(int width, int height, int channels) {
    Image image(width, height, channels);
    float value = 0.001f;
    for (float& sample : image.pixels) sample = value *= 1.01f;
    return image;
}

std::string failure(const fs::path& file, const Image& image) {
    try {
        write(image, file, SampleType::floating);
    } catch (const Error& error) {
        return error.what();
    }
    return "no error";
}

std::size_t files_in(const fs::path& folder) {
    return static_cast<std::size_t>(std::distance(fs::directory_iterator(folder), fs::directory_iterator()));
}

const Test float_exr_is_exact("unit.image.file.float_exr_is_exact", [] {
    const auto file = sr::testing::scratch_folder("float_exr") / "a.exr";
    Image image = ramp(37, 19, 4);
    image.pixels[5] = 1e30f;
    image.pixels[6] = infinity;
    write(image, file, SampleType::floating);
    const Image back = read(file);
    EXPECT_EQ(back.width, 37);
    EXPECT_EQ(back.height, 19);
    EXPECT_EQ(back.channel_names, (std::vector<std::string>{"R", "G", "B", "A"}));
    EXPECT_EQ(back.pixels, image.pixels);
});

const Test alpha_does_not_touch_colour("unit.image.file.alpha_does_not_touch_colour", [] {
    const auto folder = sr::testing::scratch_folder("alpha");
    Image image(1, 1, 4);
    image.pixels = {0.8f, 0.6f, 0.4f, 0.2f};
    for (const char* name : {"a.exr", "a.png"}) {
        write(image, folder / name, SampleType::floating);
        const Image back = read(folder / name);
        for (std::size_t i = 0; i < 4; ++i) EXPECT_NEAR(back.pixels[i], image.pixels[i], 1e-6f) << name;
    }
});

const Test half_exr("unit.image.file.half_exr", [] {
    const auto file = sr::testing::scratch_folder("half_exr") / "a.exr";
    const Image image = ramp(16, 16, 3);
    write(image, file, SampleType::half);
    const Image back = read(file);
    for (std::size_t i = 0; i < image.pixels.size(); ++i)
        EXPECT_NEAR(back.pixels[i], image.pixels[i],
                    image.pixels[i] / 2048.0f); // 11 significant bits, rounded
});

const Test layers_keep_their_names("unit.image.file.layers_keep_their_names", [] {
    const auto file = sr::testing::scratch_folder("layers") / "a.exr";
    Image image = ramp(4, 4, 6);
    image.channel_names = {"R", "G", "B", "key.R", "key.G", "key.B"};
    write(image, file, SampleType::floating);
    const Image back = read(file);
    // A reader may sort channels: each must carry its own values.
    for (std::size_t c = 0; c < 6; ++c) {
        const auto found = std::ranges::find(back.channel_names, image.channel_names[c]);
        ASSERT_NE(found, back.channel_names.end()) << image.channel_names[c];
        EXPECT_EQ(back.at(2, 3)[static_cast<std::size_t>(found - back.channel_names.begin())],
                  image.at(2, 3)[c]);
    }
});

// OpenImageIO complains on stderr of attributes that it gave itself and gets back as text.
const Test read_is_writable("unit.image.file.what_is_read_can_be_written", [] {
    const auto folder = sr::testing::scratch_folder("written_back");
    Image image(2, 2, 3);
    image.attributes = {{"steradian:unit", "cd/m^2"}};
    write(image, folder / "a.exr", SampleType::floating);
    ::testing::internal::CaptureStderr();
    write(read(folder / "a.exr"), folder / "b.exr", SampleType::floating);
    EXPECT_EQ(::testing::internal::GetCapturedStderr(), "");
});

const Test attributes_come_back("unit.image.file.attributes_come_back", [] {
    const auto file = sr::testing::scratch_folder("attributes") / "a.exr";
    Image image = ramp(2, 2, 3);
    image.attributes = {
        {"steradian:unit", "cd/m²"}, {"steradian:samples", "64"}, {"Software", "Steradian 0.1.0"}};
    write(image, file, SampleType::half);
    const Image back = read(file);
    for (const Attribute& attribute : image.attributes) {
        const auto found = std::ranges::find(back.attributes, attribute.name, &Attribute::name);
        ASSERT_NE(found, back.attributes.end()) << attribute.name;
        EXPECT_EQ(found->value, attribute.value);
    }
});

const Test hdr_is_within_a_percent("unit.image.file.hdr_is_within_a_percent", [] {
    const auto file = sr::testing::scratch_folder("hdr") / "a.hdr";
    const Image image = ramp(16, 16, 4);
    write(image, file, SampleType::floating);
    const Image back = read(file);
    ASSERT_EQ(back.channels, 3);
    for (int x = 0; x < 16; ++x)
        for (std::size_t c = 0; c < 3; ++c)
            EXPECT_NEAR(back.at(x, 7)[c], image.at(x, 7)[c], 0.01f * image.at(x, 7)[c]);
});

const Test jpeg_is_near("unit.image.file.jpeg_is_within_two_codes", [] {
    const auto file = sr::testing::scratch_folder("jpeg") / "a.jpg";
    for (const int channels : {1, 3, 4}) {
        Image image(64, 48, channels);
        for (int y = 0; y < 48; ++y)
            for (int x = 0; x < 64; ++x) // a gradient, which JPEG keeps
                for (std::size_t c = 0; c < static_cast<std::size_t>(channels); ++c)
                    image.at(x, y)[c] = (static_cast<float>(x + y) + 20.0f * static_cast<float>(c)) / 255.0f;
        write(image, file, SampleType::integer8);
        const Image back = read(file);
        ASSERT_EQ(back.channels, 3);
        for (std::size_t c = 0; c < 3; ++c)
            EXPECT_NEAR(back.at(40, 7)[c], image.at(40, 7)[channels < 3 ? 0 : c], 2.0f / 255.0f) << channels;
    }
});

const Test jpeg_has_a_limit("unit.image.file.jpeg_says_what_is_too_long", [] {
    const auto file = sr::testing::scratch_folder("long_jpeg") / "a.jpg";
    EXPECT_NE(failure(file, ramp(70000, 1, 3)).find("a.jpg: cannot be encoded ("), std::string::npos);
    EXPECT_FALSE(fs::exists(file));
});

const Test png_rounds("unit.image.file.png_rounds", [] {
    const auto file = sr::testing::scratch_folder("png") / "a.PNG";
    Image image(6, 1, 1);
    image.pixels = {-1.0f, 0.0f, 127.4f / 255.0f, 127.6f / 255.0f, 2.0f, NAN};
    write(image, file, SampleType::integer8);
    const Image back = read(file);
    for (std::size_t i = 0; const float code : {0.0f, 0.0f, 127.0f, 128.0f, 255.0f, 0.0f})
        EXPECT_EQ(std::round(back.pixels[i++] * 255.0f), code);
});

const Test extension_chooses("unit.image.file.extension_chooses", [] {
    EXPECT_TRUE(is_scene_referred("a/b.EXR"));
    EXPECT_TRUE(is_scene_referred("b.hdr"));
    EXPECT_FALSE(is_scene_referred("b.png"));
    EXPECT_FALSE(is_scene_referred("b.jpeg"));
    EXPECT_THROW(is_scene_referred("b"), Error);
    EXPECT_EQ(failure("b.tif", ramp(1, 1, 3)),
              "b.tif: unknown image format .tif: use .exr, .hdr, .png, .jpg or .jpeg");
});

const Test missing_folder("unit.image.file.missing_folder", [] {
    const auto folder = sr::testing::scratch_folder("missing") / "none";
    EXPECT_EQ(failure(folder / "a.png", ramp(1, 1, 3)),
              (folder / "a.png").string() + ": there is no folder " + folder.string() + ": create it first");
});

const Test folder_takes_no_files("unit.image.file.a_folder_that_takes_no_files_is_named_so", [] {
    const char* const of_root = "/proc/a.png: the folder /proc takes no new files: choose another folder";
    const char* const of_others =
        "/proc/a.png: no permission to write in /proc: choose a folder of yours, or "
        "change its permissions";
    EXPECT_EQ(failure("/proc/a.png", ramp(1, 1, 3)), geteuid() == 0 ? of_root : of_others);
});

const Test link_into_a_missing_folder("unit.image.file.a_link_into_a_missing_folder_names_it", [] {
    const auto folder = sr::testing::scratch_folder("missing_link");
    fs::create_symlink(folder / "none" / "b.png", folder / "a.png");
    EXPECT_EQ(failure(folder / "a.png", ramp(1, 1, 3)), (folder / "a.png").string() + ": there is no folder "
                                                            + (folder / "none").string()
                                                            + ": create it first");
});

const Test target_is_a_folder("unit.image.file.target_is_a_folder", [] {
    const auto folder = sr::testing::scratch_folder("is_folder");
    fs::create_directory(folder / "a.png");
    EXPECT_EQ(failure(folder / "a.png", ramp(1, 1, 3)),
              (folder / "a.png").string() + ": this is a folder: name a file");
    EXPECT_EQ(files_in(folder), 1u) << "the temporary file was left behind";
});

const Test no_permission("unit.image.file.no_permission", [] {
    if (geteuid() == 0) GTEST_SKIP() << "root may write anywhere";
    const auto folder = sr::testing::scratch_folder("no_permission");
    fs::permissions(folder, fs::perms::owner_read | fs::perms::owner_exec);
    EXPECT_NE(failure(folder / "a.png", ramp(1, 1, 3)).find(": no permission to write in "),
              std::string::npos);
    fs::permissions(folder, fs::perms::owner_all);
});

const Test whole_or_not_at_all("unit.image.file.whole_or_not_at_all", [] {
    const auto folder = sr::testing::scratch_folder("whole");
    std::ofstream(folder / "a.exr") << "before";
    const auto old_handler = std::signal(SIGXFSZ, SIG_IGN);
    rlimit limit{};
    getrlimit(RLIMIT_FSIZE, &limit);
    const rlimit small{1000, limit.rlim_max};
    setrlimit(RLIMIT_FSIZE, &small); // fails a write halfway, as a full disk does
    const std::string error = failure(folder / "a.exr", ramp(64, 64, 3));
    setrlimit(RLIMIT_FSIZE, &limit);
    std::signal(SIGXFSZ, old_handler);
    EXPECT_NE(error.find("a.exr: the file would exceed the size limit: "), std::string::npos) << error;
    EXPECT_EQ(fs::file_size(folder / "a.exr"), 6u) << "the old file is gone";
    EXPECT_EQ(files_in(folder), 1u) << "the temporary file was left behind";
});

const Test writing_replaces("unit.image.file.writing_replaces", [] {
    const auto folder = sr::testing::scratch_folder("replaces");
    write(ramp(1, 1, 3), folder / "a.exr", SampleType::half);
    write(ramp(2, 3, 3), folder / "a.exr", SampleType::half);
    EXPECT_EQ(read(folder / "a.exr").height, 3);
    EXPECT_EQ(files_in(folder), 1u);
});

const Test broken_files("unit.image.file.broken_files", [] {
    const auto folder = sr::testing::scratch_folder("broken");
    EXPECT_THROW(read(folder / "none.exr"), Error);
    std::ofstream(folder / "a.exr") << "no image";
    EXPECT_THROW(read(folder / "a.exr"), Error);
    write(ramp(64, 64, 3), folder / "b.exr", SampleType::floating);
    fs::resize_file(folder / "b.exr", fs::file_size(folder / "b.exr") / 2);
    EXPECT_THROW(read(folder / "b.exr"), Error);
});

const Test preload_is_optional("unit.image.file.preload_is_optional", [] {
    auto loading = preload();
    auto again = preload();
    EXPECT_NO_THROW(loading.get());
    EXPECT_NO_THROW(again.get());
});

} // namespace
