// FLIP against the package of its authors and SSIM against scikit-image, on stored cases
// (tools/golden/flip_cases.py made them).
#include "compare/flip.hpp"
#include "compare/metrics.hpp"
#include "compare/planes.hpp"
#include "support/address.hpp"
#include "support/models.hpp"

#include <fstream>
#include <nlohmann/json.hpp>

using namespace sr::compare;
using nlohmann::json;
using sr::image::Image;
using sr::testing::Test;

namespace {

json stored() {
    return json::parse(
        std::ifstream(sr::testing::source_folder() / "tests/unit/compare/data/appearance.json"));
}

Image image_of(const json& cases, const json& values, float scale) {
    Image image(cases["width"], cases["height"], 3);
    for (std::size_t i = 0; i < image.pixels.size(); ++i) image.pixels[i] = values[i].get<float>() * scale;
    return image;
}

void expect_stored(const Plane& map, const json& expected) {
    for (std::size_t i = 0; i < map.values.size(); ++i)
        ASSERT_NEAR(map.values[i], expected["flip"][i].get<double>(), 1e-3) << expected["name"] << " " << i;
    EXPECT_NEAR(mean(map), expected["mean"].get<double>(), 2e-4) << expected["name"];
}

const Test ldr_flip("unit.golden.flip.ldr_as_the_package", [] {
    const json cases = stored();
    int count = 0;
    for (const json& expected : cases["cases"]) {
        if (!expected["codes"]) continue;
        const Image test = screen_light(image_of(cases, expected["test"], 1.0f / 255.0f));
        const Image reference = screen_light(image_of(cases, expected["reference"], 1.0f / 255.0f));
        expect_stored(flip(test, reference, expected["ppd"]), expected);
        ++count;
    }
    EXPECT_EQ(count, 5);
});

const Test hdr("unit.golden.flip.hdr_as_the_package", [] {
    const json cases = stored();
    int count = 0;
    for (const json& expected : cases["cases"]) {
        if (expected["codes"]) continue;
        const Image test = image_of(cases, expected["test"], 1.0f);
        const Image reference = image_of(cases, expected["reference"], 1.0f);
        const Exposures exposures{expected["start"], expected["stop"], expected["count"]};
        expect_stored(hdr_flip(test, reference, exposures, expected["ppd"]), expected);
        ++count;
    }
    EXPECT_EQ(count, 4);
});

const Test ssim_as_scikit("unit.golden.ssim.as_scikit_image", [] {
    const json cases = stored();
    for (const json& expected : cases["cases"]) {
        if (!expected["codes"]) continue;
        const Plane test = luma(image_of(cases, expected["test"], 1.0f / 255.0f));
        const Plane reference = luma(image_of(cases, expected["reference"], 1.0f / 255.0f));
        EXPECT_NEAR(ssim(test, reference), expected["ssim"].get<double>(), 1e-3) << expected["name"];
    }
});

/// The paper's own rule takes the median of all pixels, which is 0 here, and an exposure of infinity.
const Test exposures_of_mostly_black("unit.golden.flip.exposures_of_mostly_black", [] {
    Image image(20, 20, 3);
    for (float& value : image.at(7, 7)) value = 8.0f;
    for (float& value : image.at(9, 7)) value = 0.5f;
    for (float& value : image.at(11, 7)) value = 0.5f;
    const Exposures exposures = exposures_for(image);
    EXPECT_NEAR(exposures.stop - exposures.start, 4.0, 1e-5); // log2(8 / 0.5)
    EXPECT_EQ(exposures.count, 4);
    EXPECT_EQ(exposures_for(Image(4, 4, 3)).count, 1); // nothing is lit
});

} // namespace
