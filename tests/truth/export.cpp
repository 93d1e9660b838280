// truth_export FOLDER: the scenes of the truth tests for Mitsuba, as FOLDER/SHAPE.VIEW/MATERIAL/.
#include "core/error.hpp"
#include "mitsuba/write.hpp"
#include "truth/scenes.hpp"

#include <cstdio>
#include <fmt/format.h>

namespace {

void export_all(const std::filesystem::path& folder) {
    using namespace sr::truth;
    for (const auto shape : shapes) {
        for (const auto view : views) {
            const auto place = folder / fmt::format("{}.{}", shape, view);
            std::filesystem::create_directories(place);
            for (const auto material : materials) {
                const sr::scene::Scene scene = scene_of(shape, material, view);
                const auto warnings =
                    sr::mitsuba::write({scene, camera_of(view), cell_size, cell_size}, place / material);
                sr::require(warnings.empty(), "Mitsuba can say all of it");
            }
        }
    }
}

} // namespace

int main(int argc, char** argv) {
    if (argc != 2) {
        std::fprintf(stderr, "usage: truth_export FOLDER\n");
        return 2;
    }
    try {
        export_all(argv[1]);
        return 0;
    } catch (const std::exception& error) {
        std::fprintf(stderr, "%s\n", error.what());
        return 3;
    }
}
