#pragma once
// A comparison as JSON, the same for `compare --json` and for suites.
#include "golden/compare.hpp"

#include <nlohmann/json_fwd.hpp>

namespace sr::golden {

/// {"passed", "verdicts": [{"passed", "line"}], "metrics": {…}, "diagnosis": null | {…}}. A number that is
/// not finite becomes the string "nan", "inf" or "-inf", since JSON has none; one that was not measured is
/// absent.
nlohmann::ordered_json json_of(const Comparison& comparison);

} // namespace sr::golden
