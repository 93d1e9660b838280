#pragma once
// What mistake would turn the reference into the test image.
#include <string>

namespace sr::golden {

/// A mistake that explains the difference.
struct Diagnosis {
    std::string name;      // "pi_missing", "flipped_y", "light_missing", …: README.md lists them
    std::string statement; // one sentence for people: "test = 3.1416 × reference everywhere: …"
    double residual = 1.0; // what is left of the difference once the mistake is applied to the reference:
                           // 0 all is explained, 1 nothing; claimed up to 0.2, fits up to 0.1
    std::string layer;     // the light, where the mistake is one light's ("key"); else empty
};

} // namespace sr::golden
