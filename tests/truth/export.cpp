// truth_export FOLDER: the scenes of the truth tests for Mitsuba, as FOLDER/SHAPE.VIEW/MATERIAL/ and
// FOLDER/shadow.NAME/picture/.
#include "core/error.hpp"
#include "mitsuba/write.hpp"
#include "truth/scenes.hpp"
#include "truth/shadow_scenes.hpp"

#include <cstdio>
#include <fmt/format.h>

namespace {

using namespace sr::truth;

void export_shadows(const std::filesystem::path& folder) {
    for (const auto name : shadow_scenes) {
        const auto place = folder / fmt::format("shadow.{}", name);
        std::filesystem::create_directories(place);
        const ShadowScene s = shadow_scene(name, Fence::boards);
        for (const std::string& warning : sr::mitsuba::write(
                 {s.scene, s.camera, shadow_picture_size, shadow_picture_size}, place / "picture"))
            std::fprintf(stderr, "%s\n", warning.c_str());
    }
}

void export_all(const std::filesystem::path& folder) {
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
        export_shadows(argv[1]);
        return 0;
    } catch (const std::exception& error) {
        std::fprintf(stderr, "%s\n", error.what());
        return 3;
    }
}
