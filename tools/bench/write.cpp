// Milliseconds to write a picture in each format, display transform aside.
#include "core/error.hpp"
#include "image/display.hpp"
#include "image/file.hpp"

#include <algorithm>
#include <chrono>
#include <filesystem>
#include <fmt/format.h>
#include <vector>

namespace {

using namespace sr::image;

void measure(const char* what, const Image& image, const char* extension, SampleType type) {
    constexpr int runs = 9;
    const auto file = std::filesystem::temp_directory_path() / fmt::format("steradian_bench{}", extension);
    std::vector<double> milliseconds;
    for (int i = 0; i < runs; ++i) {
        const auto begin = std::chrono::steady_clock::now();
        write(image, file, type);
        milliseconds.push_back(
            std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - begin).count());
    }
    std::sort(milliseconds.begin(), milliseconds.end());
    fmt::print("| {} | {:.0f} | {:.1f} MB |\n", what, milliseconds[runs / 2],
               static_cast<double>(std::filesystem::file_size(file)) / 1e6);
    std::filesystem::remove(file);
}

} // namespace

int main(int argc, char** argv) {
    if (argc != 2) {
        fmt::print(stderr, "usage: bench_write FILM.exr\n");
        return 2;
    }
    try {
        const Image film = read(argv[1]);
        const Image screen = displayed(film, auto_ev100(film));
        fmt::print("| format | ms, median | size |\n|---|---|---|\n");
        measure("EXR float", film, ".exr", SampleType::floating);
        measure("EXR half", film, ".exr", SampleType::half);
        measure("HDR", film, ".hdr", SampleType::floating);
        measure("PNG", screen, ".png", SampleType::integer8);
        measure("JPEG", screen, ".jpg", SampleType::integer8);
        return 0;
    } catch (const sr::Error& error) {
        fmt::print(stderr, "{}\n", error.what());
        return 3;
    }
}
