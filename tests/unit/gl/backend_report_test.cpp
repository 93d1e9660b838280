// The report of which backends work here. It has an executable of its own, since it opens and closes every
// one.
#include "gl/context.hpp"
#include "support/address.hpp"

using namespace sr;
using sr::testing::Test;

namespace {

// Whatever does not work says so in one line with a remedy.
const Test reported("unit.gl.backend.each_works_or_says_why", [] {
    const auto reports = gl::report_backends();
    ASSERT_EQ(reports.size(), 3u);
    bool any = false;
    for (const auto& report : reports) {
        if (report.info) {
            any = true;
            EXPECT_FALSE(report.info->renderer.empty());
        } else {
            EXPECT_NE(report.failure.find(": "), std::string::npos);
            EXPECT_EQ(report.failure.find('\n'), std::string::npos);
        }
    }
    EXPECT_TRUE(any);
});

} // namespace
