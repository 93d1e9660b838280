#pragma once
// What a session took, for --json.
#include <chrono>
#include <ctime>
#include <string>
#include <utility>
#include <vector>

namespace sr::viewer {

struct Statistics {
    using Clock = std::chrono::steady_clock;

    Clock::time_point begin = Clock::now();
    /// Seconds until the first picture of the first scene, by part; loading runs beside opening the window.
    std::vector<std::pair<std::string, double>> start;
    std::vector<double> moving_frames; // [s] from one drawn frame of a moving picture to the next
    std::vector<double>
        moving_cpu; // [s] of all threads in each of them, which other programs do not lengthen
    std::vector<double> moving_samples; // [s] of each of them that its sample took
    std::vector<double> moving_scales;  // of the picture's sides, in each of them
    int reloads = 0;
    int drawn_frames = 0;
    std::string renderer; // GL_RENDERER

    /// Processor time of all threads so far [s].
    static double cpu() { return static_cast<double>(std::clock()) / CLOCKS_PER_SEC; }
    double since_begin() const { return std::chrono::duration<double>(Clock::now() - begin).count(); }
};

} // namespace sr::viewer
