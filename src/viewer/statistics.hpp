#pragma once
// Timings of a run, for --json.
#include "viewer/view/progressive_render.hpp"

#include <chrono>
#include <ctime>
#include <string>
#include <utility>
#include <vector>

namespace sr::viewer {

/// Time of the parts of a frame [s], while they are measured.
struct FrameTimes {
    double sampling = 0.0; // for the render
    double display = 0.0;  // of the film: exposure, tone curve
    double panels = 0.0;   // and marks over the picture
};

struct Statistics {
    using Clock = std::chrono::steady_clock;

    Clock::time_point begin = Clock::now();
    /// Seconds until the first picture of the first scene, by part. Loading runs beside opening the window.
    std::vector<std::pair<std::string, double>> start;
    std::vector<double> moving_frames;  // [s] between two frames of an interactive render
    std::vector<double> moving_cpu;     // [s] of all threads in each of them, independent of other programs
    std::vector<double> moving_samples; // [s] of the sample in each of them
    std::vector<double> moving_scales;  // of the sides, in each of them
    bool measures_frames = false;       // the GPU is waited for after each part
    FrameTimes last_frame;
    int reloads = 0;
    int drawn_frames = 0;
    std::string renderer; // GL_RENDERER

    /// Processor time of all threads so far [s].
    static double cpu() { return static_cast<double>(std::clock()) / CLOCKS_PER_SEC; }
    double since_begin() const { return std::chrono::duration<double>(Clock::now() - begin).count(); }

    /// The first scene has loaded, in `seconds`.
    void loaded(double seconds) {
        start.emplace_back("load (beside the window)", seconds);
        start.emplace_back("until loaded", since_begin());
    }
    /// The first scene is on the GPU.
    void uploaded(double upload_seconds, double compile_seconds) {
        start.emplace_back("upload", upload_seconds);
        start.emplace_back("compile", compile_seconds);
    }
    /// A frame begins, `seconds` after the one before.
    void frame(const ProgressiveRender& render, double seconds) {
        if (was_interactive && render.is_interactive()) {
            moving_frames.push_back(seconds);
            moving_samples.push_back(render.seconds_per_sample());
            moving_scales.push_back(render.scale());
            moving_cpu.push_back(cpu() - last_cpu);
        }
        was_interactive = render.is_interactive();
        last_cpu = cpu();
    }
    /// A frame is in the window.
    void presented(bool has_scene) {
        ++drawn_frames;
        constexpr std::size_t parts_before = 5;
        if (!has_scene || start.size() != parts_before) return;
        start.emplace_back("first picture", since_begin());
        start.emplace_back("first picture, processor time", cpu());
    }

    bool was_interactive = false; // at the last frame
    double last_cpu = 0.0;        // [s] at the last frame
};

} // namespace sr::viewer
