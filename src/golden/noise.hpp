#pragma once
// Noise images of a suite: the standard errors of its tests' pictures, from renderings with several seeds.
#include "golden/run.hpp"

namespace sr::golden {

/// A noise image that was made.
struct MadeNoise {
    std::string test;
    std::filesystem::path file;
};

/// Renders each chosen test that names noise with the seeds 1 to `seeds`, and writes the first noise image
/// that it names. A scene's seed is replaced; an external command has "{seed}" where the seed belongs.
/// @return absent if it was interrupted
/// @throws Error if no chosen test names noise, a command has no "{seed}" or fails, or a file cannot be
/// written
std::optional<std::vector<MadeNoise>> make_noise(const Suite& suite, const RunOptions& options, int seeds);

} // namespace sr::golden
