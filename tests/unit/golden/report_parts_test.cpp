#include "core/markup.hpp"
#include "golden/page.hpp"
#include "golden/report.hpp"
#include "golden/sha256.hpp"
#include "image/file.hpp"
#include "support/address.hpp"
#include "support/models.hpp"
#include "unit/golden/suite_support.hpp"

#include <limits>
#include <nlohmann/json.hpp>

using namespace sr;
using namespace sr::testing;
using sr::testing::Test;
namespace fs = std::filesystem;

namespace {

// NIST's examples for FIPS 180-4: no block, one, two, and many.
const Test nist("unit.golden.sha256.nist_examples", [] {
    EXPECT_EQ(golden::sha256_text(""), "e3b0c44298fc1c149afbf4c8996fb92427ae41e4649b934ca495991b7852b855");
    EXPECT_EQ(golden::sha256_text("abc"), "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad");
    EXPECT_EQ(golden::sha256_text("abcdbcdecdefdefgefghfghighijhijkijkljklmklmnlmnomnopnopq"),
              "248d6a61d20638b8e5c026930c3e6039a33ce45964ff2167f6ecedd419db06c1");
    EXPECT_EQ(golden::sha256_text(std::string(1000000, 'a')),
              "cdc76e5c9914fb9281a1c7e284d73e67f1809a48a497200e046d39ccc7112cd0");
});

const Test rfc4648("unit.golden.base64.rfc_examples", [] {
    const char* expected[] = {"", "Zg==", "Zm8=", "Zm9v", "Zm9vYg==", "Zm9vYmE=", "Zm9vYmFy"};
    for (std::size_t length = 0; length <= 6; ++length)
        EXPECT_EQ(golden::base64(std::string("foobar").substr(0, length)), expected[length]);
    EXPECT_EQ(golden::base64("\xfb\xff"), "+/8=");
});

const Test escapes("unit.golden.escape.nothing_gets_out", [] {
    EXPECT_EQ(escape_markup("<a href='\"&\">é\n"), "&lt;a href=&#39;&quot;&amp;&quot;&gt;é\n");
    EXPECT_EQ(escape_markup("\xc0\xaf\xed\xa0\x80"),
              "\xEF\xBF\xBD\xEF\xBF\xBD\xEF\xBF\xBD\xEF\xBF\xBD\xEF\xBF\xBD");
    EXPECT_EQ(golden::escape_script_json("\"</script><!--\""), "\"\\u003c/script>\\u003c!--\"");
    EXPECT_EQ(golden::shell_line({"a", "b c", "it's", "", "$x"}), "a 'b c' 'it'\\''s' '' '$x'");
});

const Test any_range("unit.golden.report.packs_any_range", [] {
    image::Image image(2, 1, 3);
    for (const float largest : {1e-30f, 1.0f, 1e30f}) {
        image.pixels = {largest, 0.0f, 0.0f, std::numeric_limits<float>::infinity(), 0.0f, 0.0f};
        const float scale = golden::pack_pixels(image)["scale"];
        EXPECT_GE(largest * scale, 16384.0f);
        EXPECT_LT(largest * scale, 32768.0f);
    }
});

const Test pixels_return("unit.golden.report.unpacks_what_it_packs", [] {
    image::Image image(3, 2, 4);
    for (std::size_t i = 0; i < image.pixels.size(); ++i) image.pixels[i] = static_cast<float>(i) * 1e4f;
    const auto packed = golden::pack_pixels(image);
    const auto same = golden::unpack_pixels(packed);
    ASSERT_TRUE(same);
    EXPECT_EQ(same->width, 3);
    for (std::size_t i = 0; i < image.pixels.size(); ++i)
        EXPECT_NEAR(same->pixels[i], image.pixels[i], 5e-4f * image.pixels[i]);
    EXPECT_EQ(golden::decoded_base64("Zm9vYg=="), "foob");
    EXPECT_FALSE(golden::decoded_base64("Zm9=Yg=="));
    for (const char* change : {"data", "width", "channels", "scale"}) {
        auto broken = packed;
        broken[change] =
            change == std::string("data") ? nlohmann::ordered_json("Zm9v") : nlohmann::ordered_json("3");
        EXPECT_FALSE(golden::unpack_pixels(broken)) << change;
    }
    auto large = packed;
    large["width"] = 1 << 14;
    large["height"] = 1 << 14;
    EXPECT_FALSE(golden::unpack_pixels(large));
    EXPECT_TRUE(golden::decoded_base64(golden::png_data(image))->starts_with("\x89PNG"));
});

const Test self_contained("unit.golden.report.needs_nothing_from_outside", [] {
    const auto folder = scratch_folder("report_parts");
    const auto suite = copying_suite(folder, {"a"});
    auto result = run_and_keep(suite, folder / "out");
    result.suite = "</title><script>alert(1)</script>";
    const std::string html = golden::report_html(result, suite, folder / "out");
    EXPECT_NE(html.find("default-src 'none'"), std::string::npos);
    for (const char* outside :
         {"http:", "https:", "src=\"", "unsafe-inline", " onclick=", "alert(1)</script>"})
        EXPECT_EQ(html.find(outside), std::string::npos) << outside;
});

const Test vanished("unit.golden.report.says_which_pictures_changed_or_vanished", [] {
    const auto folder = scratch_folder("report_vanished");
    const auto suite = copying_suite(folder, {"same", "changed", "gone", "golden_gone"});
    fs::create_directories(suite.goldens);
    for (const auto& test : suite.tests)
        image::write(plain(0.5f), suite.golden_of(test), image::SampleType::floating);
    const auto result = run_and_keep(suite, folder / "out");
    image::write(plain(0.6f), folder / "out/candidates/changed.exr", image::SampleType::floating);
    fs::remove(folder / "out/candidates/gone.exr");
    fs::remove(suite.golden_of(suite.tests[3]));
    const std::string html = golden::report_html(result, suite, folder / "out");
    std::size_t problems = 0;
    for (auto at = html.find("\"images_problem\":\""); at != std::string::npos;
         at = html.find("\"images_problem\":\"", at + 1))
        ++problems;
    EXPECT_EQ(problems, 3u);
    EXPECT_NE(html.find("changed.exr: the picture has changed since the run"), std::string::npos);
    EXPECT_NE(html.find("gone.exr: no such file"), std::string::npos);
});

} // namespace
