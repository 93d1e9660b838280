// truth_export FOLDER [PREFIX]: the scenes of the truth tests for Mitsuba, as FOLDER/SHAPE.VIEW/MATERIAL/,
// FOLDER/photograph.VIEW/rectangle/, FOLDER/balls.LIGHT/BRDF/ and FOLDER/shadow.NAME/picture/; of those
// folders that whose name begins with PREFIX.
#include "core/error.hpp"
#include "mitsuba/write.hpp"
#include "truth/ball_scenes.hpp"
#include "truth/scenes.hpp"
#include "truth/shadow_scenes.hpp"

#include <cstdio>
#include <fmt/format.h>
#include <fstream>

namespace {

using namespace sr::truth;

/// A folder of parts, which stand side by side in its picture in the order of the file `parts`.
class Picture {
public:
    Picture(const std::filesystem::path& folder, const std::string& name) : folder_(folder / name) {
        std::filesystem::create_directories(folder_);
    }
    /// @return whether Mitsuba can say all of it
    bool add(std::string_view part, const sr::mitsuba::Subject& subject) {
        std::ofstream(folder_ / "parts", std::ios::app) << part << "\n";
        const auto warnings = sr::mitsuba::write(subject, folder_ / part);
        for (const std::string& warning : warnings)
            std::fprintf(stderr, "%s: %s\n", folder_.filename().c_str(), warning.c_str());
        return warnings.empty();
    }

private:
    std::filesystem::path folder_;
};

void export_shadows(const std::filesystem::path& folder, std::string_view prefix) {
    for (const auto scene : shadow_scenes) {
        const std::string name = fmt::format("shadow.{}", scene);
        if (!name.starts_with(prefix)) continue;
        const ShadowScene s = shadow_scene(scene, Fence::boards);
        Picture(folder, name).add("picture", {s.scene, s.camera, shadow_picture_size, shadow_picture_size});
    }
}

void export_balls(const std::filesystem::path& folder, std::string_view prefix) {
    for (const auto light : ball_lights) {
        const std::string name = fmt::format("balls.{}", light);
        if (!name.starts_with(prefix)) continue;
        Picture picture(folder, name);
        for (const auto brdf : ball_brdfs)
            if (is_lit(brdf, light))
                sr::require(picture.add(brdf, {ball_scene(brdf, light), ball_camera(), ball_size, ball_size}),
                            "Mitsuba can say all of it");
    }
}

void export_photographs(const std::filesystem::path& folder, std::string_view prefix) {
    for (const auto view : views) {
        const std::string name = fmt::format("{}.{}", photograph, view);
        if (!name.starts_with(prefix)) continue;
        sr::require(Picture(folder, name)
                        .add("rectangle", {scene_of("rectangle", photograph, view), camera_of(view),
                                           cell_size, cell_size}),
                    "Mitsuba can say all of it");
    }
}

void export_matrix(const std::filesystem::path& folder, std::string_view prefix) {
    for (const auto shape : shapes) {
        for (const auto view : views) {
            const std::string name = fmt::format("{}.{}", shape, view);
            if (!name.starts_with(prefix)) continue;
            Picture picture(folder, name);
            for (const auto material : materials)
                sr::require(picture.add(material, {scene_of(shape, material, view), camera_of(view),
                                                   cell_size, cell_size}),
                            "Mitsuba can say all of it");
        }
    }
}

} // namespace

int main(int argc, char** argv) {
    if (argc != 2 && argc != 3) {
        std::fprintf(stderr, "usage: truth_export FOLDER [PREFIX]\n");
        return 2;
    }
    try {
        const std::string_view prefix = argc == 3 ? argv[2] : "";
        export_matrix(argv[1], prefix);
        export_photographs(argv[1], prefix);
        export_balls(argv[1], prefix);
        export_shadows(argv[1], prefix);
        return 0;
    } catch (const std::exception& error) {
        std::fprintf(stderr, "%s\n", error.what());
        return 3;
    }
}
