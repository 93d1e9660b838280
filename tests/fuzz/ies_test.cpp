// Broken IES files: reading them succeeds with a profile that can be used, or throws Error with one line.
#include "core/error.hpp"
#include "scene/ies.hpp"
#include "scene/spectrum.hpp"
#include "support/address.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <random>

using namespace sr;
using sr::testing::Test;

namespace {

const std::string files[] = {
    "IESNA:LM-63-2002\n[TEST] x\nTILT=NONE\n1 -1 1 3 3 1 2 0 0 0\n1 1 10\n0 45 90\n0 45 90\n9 8 7 6 5 4 3 2 "
    "1\n",
    "Old\r\nTILT=INCLUDE\r\n1\r\n2\r\n0 90\r\n1 0.5\r\n1 900 2 3 1 1 1 0 0 0\r\n1 1 10\r\n0 45 90\r\n0\r\n9 "
    "8 7\r\n",
    "IES:LM-63-2019\nTILT=NONE\n1 -1 1 3 2 2 2 0 0 0 1 1 10 -90 0 90 -90 90 1 2 3 4 5 6\n",
};

std::string mutated(std::string text, std::mt19937& random) {
    const auto below = [&](std::size_t end) {
        return static_cast<std::size_t>(random()) % std::max<std::size_t>(end, 1);
    };
    static const std::string words[] = {" ",      "\n",     "-1",    "0", "1e308", "nan",
                                        "100000", "1e-320", "TILT=", ",", "9",     "\0"};
    for (std::size_t times = 1 + below(3); times > 0 && !text.empty(); --times) {
        const std::size_t place = below(text.size());
        switch (below(4)) {
        case 0: text[place] = static_cast<char>(below(256)); break;
        case 1: text.resize(place); break;
        case 2: text.insert(place, words[below(std::size(words))]); break;
        default: text.replace(place, 1 + below(3), words[below(std::size(words))]);
        }
    }
    return text;
}

const Test damaged("fuzz.ies.mutated", [] {
    const char* wanted = std::getenv("STERADIAN_FUZZ_RUNS");
    const int runs = wanted ? std::atoi(wanted) : 4000;
    int errors = 0;
    std::mt19937 random(1);
    for (int run = 0; run < runs && !::testing::Test::HasFailure(); ++run) {
        const std::string text = mutated(files[static_cast<std::size_t>(run) % std::size(files)], random);
        SCOPED_TRACE(text);
        try {
            const scene::LightProfile profile = scene::read_ies(text, "f.ies").profile;
            ASSERT_GE(profile.gamma.size(), 2u);
            ASSERT_GE(profile.phi.size(), 2u);
            ASSERT_EQ(profile.I.size(), profile.gamma.size() * profile.phi.size());
            EXPECT_EQ(profile.phi.front(), 0.0f);
            EXPECT_NEAR(profile.phi.back(), 2.0f * pi, 1e-5f);
            EXPECT_TRUE(std::is_sorted(profile.phi.begin(), profile.phi.end()));
            EXPECT_TRUE(std::isfinite(scene::flux_of(profile)));
            EXPECT_GE(scene::flux_of(profile), 0.0);
        } catch (const Error& error) {
            ++errors;
            EXPECT_EQ(std::string(error.what()).find('\n'), std::string::npos) << error.what();
        }
    }
    EXPECT_GT(errors, runs / 4);
    EXPECT_LT(errors, runs * 19 / 20);
});

} // namespace
