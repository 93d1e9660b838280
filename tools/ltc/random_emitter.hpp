#pragma once
// Emitters drawn at random, and rays that find them; in doubles.
#include "ltc/trial.hpp"

#include <functional>
#include <glm/glm.hpp>

namespace sr::ltc {

/// Numbers in [0, 1), the same on every machine. Knuth's MMIX generator (TAOCP 2, section 3.3.4, table 1).
class Random {
public:
    explicit Random(std::uint64_t seed) : state_(seed * 2 + 1) {}
    double operator()() {
        state_ = state_ * 6364136223846793005ULL + 1442695040888963407ULL;
        return static_cast<double>(state_ >> 11) * 0x1p-53;
    }

private:
    std::uint64_t state_;
};

struct RandomEmitter {
    scene::Light light;
    std::function<bool(glm::dvec3 w)> meets; // whether a ray from the origin does
};

/// Half to three and a half units away, a fifth to two units in radius; parts of it may be below the horizon.
RandomEmitter random_emitter(Shape shape, Random& random);

} // namespace sr::ltc
