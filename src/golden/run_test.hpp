#pragma once
// One test of a suite.
#include "golden/run.hpp"

namespace sr::golden {

/// Makes the image and judges it. Whatever goes wrong becomes the result's outcome and message.
TestResult run_test(const Suite& suite, const GoldenTest& test, const RunOptions& options);

} // namespace sr::golden
