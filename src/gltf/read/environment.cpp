#include "gltf/read/environment.hpp"

#include "core/error.hpp"
#include "gltf/read/emission.hpp"
#include "gltf/uri.hpp"
#include "image/file.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

namespace sr::gltf {
namespace {

/// @throws Error
void require_picture(const image::Image& picture, const std::filesystem::path& file) {
    constexpr long long max_texels = 1 << 25;
    if (static_cast<long long>(picture.width) * picture.height > max_texels)
        throw Error({file.string()},
                    fmt::format("an environment of {}×{} texels", picture.width, picture.height),
                    fmt::format("make it smaller: {} texels are allowed", max_texels));
}

/// The counts of a picture's values that are replaced, one for each fault.
struct Mended {
    std::size_t dark = 0;     // negative or no number
    std::size_t infinite = 0; // or beyond a float's range once they are summed up

    float operator()(float value) {
        if (!(value >= 0.0f)) return ++dark, 0.0f;
        if (std::isinf(value)) return ++infinite, image::max_half;
        return value;
    }
};

} // namespace

std::shared_ptr<const scene::EnvironmentMap> read_environment(const std::filesystem::path& file,
                                                              std::vector<std::string>& warnings) {
    if (!image::is_scene_referred(file))
        throw Error({file.string()}, "is no picture of radiance", "use an equirectangular .hdr or .exr");
    const image::Image picture = image::read(file);
    require_picture(picture, file);
    Mended mended;
    std::vector<vec3> texels;
    const auto channels = static_cast<std::size_t>(picture.channels);
    texels.reserve(picture.pixels.size() / channels);
    for (std::size_t i = 0; i < picture.pixels.size(); i += channels) {
        const float* p = &picture.pixels[i];
        if (channels < 3)
            texels.emplace_back(mended(p[0]));
        else
            texels.emplace_back(mended(p[0]), mended(p[1]), mended(p[2]));
    }
    if (mended.dark > 0)
        warnings.push_back(fmt::format("{}: {} values are negative or no numbers: they count as 0",
                                       file.string(), mended.dark));
    if (mended.infinite > 0)
        warnings.push_back(fmt::format("{}: {} values are infinite: they count as {}", file.string(),
                                       mended.infinite, image::max_half));
    return std::make_shared<const scene::EnvironmentMap>(picture.width, picture.height, std::move(texels));
}

std::optional<scene::EnvironmentLight> parse_environment(const Document& document, std::optional<int> scene,
                                                         Warnings& warnings) {
    const int index = scene.value_or(integer_in(document.root, "scene", 0));
    if (index < 0 || static_cast<std::size_t>(index) >= document.count("scenes")) return std::nullopt;
    const json* own = steradian_in(document.entry("scenes", index));
    if (!own || !own->contains("environment")) return std::nullopt;
    const json& stated = own->at("environment");
    scene::EnvironmentLight light;
    light.name = "environment";
    if (stated.contains("file") == stated.contains("radiance"))
        document.fail("the scene's environment has no file and no radiance, or both",
                      R"(state one, as in "file": "sky.hdr" or "radiance": [1, 1, 1])");
    light.L = vec3(three_in(stated, "radiance", glm::dvec3(1.0)));
    light.L *= static_cast<float>(number_in(stated, "strength", 1.0));
    if (!(light.L.r >= 0.0f && light.L.g >= 0.0f && light.L.b >= 0.0f)
        || !std::isfinite(light.L.r + light.L.g + light.L.b))
        document.fail("the scene's environment has a radiance or a strength that is negative or too large",
                      "use numbers from 0 up");
    light.rotation = static_cast<float>(number_in(stated, "rotation", 0.0));
    light.is_visible = flag_in(stated, "visible", true);
    if (stated.contains("file")) {
        const std::string uri = text_in(stated, "file");
        if (uri.empty() || uri.starts_with("data:"))
            document.fail("the scene's environment does not name its file",
                          R"(name one beside the glTF, as in "file": "sky.hdr")");
        std::vector<std::string> heard;
        light.map = read_environment(
            resolve_file(uri, document.folder, {document.name, "the scene's environment"}), heard);
        light.name = std::filesystem::path(uri).stem().string();
        for (const std::string& line : heard) warnings.add("environment", line);
    }
    return light;
}

} // namespace sr::gltf
