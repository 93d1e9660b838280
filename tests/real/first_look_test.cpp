// The first look at somebody's own model: what no lamp of a file lights looks right under the studio, as a
// screen shows it.
#include "core/error.hpp"
#include "gltf/asset.hpp"
#include "image/display.hpp"
#include "scene/prepare.hpp"
#include "support/address.hpp"
#include "support/models.hpp"
#include "support/scenes.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <iterator>
#include <optional>
#include <set>

using namespace sr;
using namespace sr::testing;

namespace {

namespace fs = std::filesystem;

/// Shares of the covered pixels of the 8-bit picture.
struct Shares {
    int covered = 0;
    double burnt = 0.0; // with a channel at 255
    double black = 0.0; // with all channels below 8
    int brightest = 0;
};

Shares shares_of(const image::Image& film) {
    const image::Image screen = image::displayed(film, image::auto_ev100(film));
    Shares shares;
    for (int y = 0; y < film.height; ++y)
        for (int x = 0; x < film.width; ++x) {
            if (film.at(x, y)[3] < 0.5f) continue;
            const auto pixel = screen.at(x, y);
            const int code = static_cast<int>(std::lround(255.0f * std::ranges::max(pixel)));
            ++shares.covered;
            shares.burnt += code >= 255;
            shares.black += code < 8;
            shares.brightest = std::max(shares.brightest, code);
        }
    shares.burnt /= std::max(shares.covered, 1);
    shares.black /= std::max(shares.covered, 1);
    return shares;
}

/// The film at the automatic camera; absent for files that bring their own light or are no scene.
std::optional<image::Image> first_look(const fs::path& file) {
    try {
        gltf::Loaded loaded = gltf::load(file);
        scene::PrepareOptions options{"auto"};
        options.aspect_ratio = 1.0f;
        const scene::RenderScene stage =
            scene::prepare_scene(std::move(loaded.scene), file.string(), options);
        if (stage.rig != scene::Rig::studio) return std::nullopt;
        return picture(stage.scene, stage.lights, stage.camera, 96, 16);
    } catch (const Error&) {
        return std::nullopt; // other tests hold such files to their one line
    }
}

/// Returns the largest share of the covered pixels that may be below code 8, because the file's own materials
/// are black: rows of balls of black base colour and a specular factor of 0, and panels of nothing but a
/// coat.
double max_black(const fs::path& file) {
    if (file.stem() == "ClearCoatTest") return 0.22;
    if (file.stem() == "SpecularTest") return 0.35;
    return 0.10;
}

/// All glTF files below a folder, but not those that are made to break something.
std::vector<fs::path> files_below(const fs::path& folder) {
    std::vector<fs::path> files;
    const std::set<std::string> left_out{"hostile", "compare", "nan"};
    for (auto entry = fs::recursive_directory_iterator(folder); entry != fs::recursive_directory_iterator();
         ++entry) {
        if (left_out.contains(entry->path().filename().string())) entry.disable_recursion_pending();
        if (entry->path().extension() == ".glb" || entry->path().extension() == ".gltf")
            files.push_back(entry->path());
    }
    std::ranges::sort(files);
    return files;
}

const Test look("real.first_look.is_neither_burnt_nor_black", [] {
    const fs::path cases = source_folder().parent_path() / "shared" / "cases";
    std::vector<fs::path> files;
    for (const std::optional<fs::path>& folder :
         {models_folder(), packaged_models_folder(), std::optional(cases)})
        if (folder && fs::exists(*folder)) std::ranges::copy(files_below(*folder), std::back_inserter(files));
    if (files.empty()) GTEST_SKIP() << "no models: set STERADIAN_MODELS or install assimp-testmodels";
    int looked_at = 0;
    for (const fs::path& file : files) {
        const auto film = first_look(file);
        if (!film) continue;
        const Shares shares = shares_of(*film);
        fmt::print("{:<40} {:>6} covered, {:5.2f} % burnt, {:5.2f} % black, brightest {}\n",
                   file.filename().string(), shares.covered, 100.0 * shares.burnt, 100.0 * shares.black,
                   shares.brightest);
        if (shares.covered == 0) continue;
        ++looked_at;
        EXPECT_LE(shares.burnt, 0.02) << file;
        EXPECT_LE(shares.black, max_black(file)) << file;
        EXPECT_GE(shares.brightest, 64) << file << " is black as a whole";
    }
    EXPECT_GT(looked_at, 10);
});

} // namespace
