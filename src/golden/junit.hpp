#pragma once
// JUnit XML, which CI systems read.
#include "golden/result.hpp"

namespace sr::golden {

/// The run as JUnit XML: what differs or has no golden is a <failure>, what made no image is an <error>.
std::string junit_xml(const RunResult& result);

} // namespace sr::golden
