#include "viewer/compare_panel.hpp"

#include "compare/compare.hpp"
#include "compare/flip.hpp"
#include "compare/planes.hpp"
#include "core/error.hpp"
#include "image/file.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <filesystem>
#include <fmt/format.h>
#include <imgui.h>

namespace sr::viewer {
namespace {

gl::Texture uploaded(const image::Image& film) {
    std::vector<vec4> texels(static_cast<std::size_t>(film.width) * static_cast<std::size_t>(film.height));
    for (int y = 0; y < film.height; ++y)
        for (int x = 0; x < film.width; ++x) {
            const auto pixel = film.at(x, y);
            const vec3 rgb(pixel[0], pixel[1], pixel[2]);
            // GL's first row is the lowest.
            texels[static_cast<std::size_t>(film.height - 1 - y) * static_cast<std::size_t>(film.width)
                   + static_cast<std::size_t>(x)] = vec4(rgb, 1.0f);
        }
    gl::Texture texture(GL_TEXTURE_2D, "reference");
    glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA32F, film.width, film.height, 0, GL_RGBA, GL_FLOAT, texels.data());
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAX_LEVEL, 0);
    return texture;
}

/// Grey as RGB.
image::Image with_colors(image::Image film) {
    if (film.channels >= 3) return film;
    image::Image rgb(film.width, film.height, 3);
    for (std::size_t i = 0; i < rgb.pixels.size(); ++i)
        rgb.pixels[i] = film.pixels[i / 3 * static_cast<std::size_t>(film.channels)];
    return rgb;
}

template<class Value, std::size_t count>
std::optional<Value> choice(const char* label, Value now,
                            const std::array<std::pair<const char*, Value>, count>& all) {
    std::optional<Value> chosen;
    const char* name = "";
    for (const auto& [text, value] : all)
        if (value == now) name = text;
    if (!ImGui::BeginCombo(label, name)) return chosen;
    for (const auto& [text, value] : all)
        if (ImGui::Selectable(text, value == now) && value != now) chosen = value;
    ImGui::EndCombo();
    return chosen;
}

} // namespace

Reference::Reference(std::string name, image::Image film, bool is_displayed)
    : name_(std::move(name)),
      film_(std::move(film)),
      is_displayed_(is_displayed),
      texture_(uploaded(film_)) {}

bool is_picture(const std::string& file) {
    constexpr std::array endings{".exr", ".hdr", ".png", ".jpg", ".jpeg"};
    std::string ending = std::filesystem::path(file).extension().string();
    std::ranges::transform(ending, ending.begin(), [](unsigned char c) { return std::tolower(c); });
    return std::ranges::find(endings, ending) != endings.end();
}

Reference read_reference(const std::string& file) {
    const bool is_displayed = !image::is_scene_referred(file);
    image::Image film = with_colors(image::read(file));
    if (is_displayed)
        for (float& value : film.pixels) value = compare::srgb_decoded(value);
    return {std::filesystem::path(file).filename().string(), std::move(film), is_displayed};
}

namespace {

void require_same_size(const image::Image& film, const image::Image& reference) {
    if (film.width != reference.width || film.height != reference.height)
        throw Error(fmt::format("the pictures have {}x{} and {}x{} pixels", film.width, film.height,
                                reference.width, reference.height),
                    "give the window the size of the other picture: --size");
}

FlipMap map_of(const compare::Plane& plane, const image::Image& film) {
    FlipMap map{image::Image(film.width, film.height, 1), compare::mean(plane)};
    for (std::size_t i = 0; i < map.film.pixels.size(); ++i) map.film.pixels[i] = plane.values[i];
    return map;
}

} // namespace

FlipMap flip_of(const image::Image& film, const image::Image& reference) {
    require_same_size(film, reference);
    return map_of(compare::hdr_flip(film, reference, compare::exposures_for(reference),
                                    compare::CompareOptions{}.pixels_per_degree),
                  film);
}

FlipMap flip_of_displayed(const image::Image& film, const Look& look, const image::Image& reference) {
    require_same_size(film, reference);
    image::Image shown = image::displayed(film, look.ev100, look.curve);
    for (float& value : shown.pixels) value = compare::srgb_decoded(value);
    return map_of(compare::flip(shown, reference, compare::CompareOptions{}.pixels_per_degree), film);
}

CompareWish compare_panel(Look& look, const Reference* reference, const std::string& flip_result,
                          render::Estimator estimator, render::Visibility visibility) {
    CompareWish wish;
    if (!ImGui::CollapsingHeader("Compare")) return wish;
    using render::Estimator;
    using render::Visibility;
    wish.estimator = choice("estimator", estimator,
                            std::array<std::pair<const char*, Estimator>, 2>{
                                {{"sampled", Estimator::sampled}, {"analytic", Estimator::analytic}}});
    wish.visibility =
        choice("visibility", visibility,
               std::array<std::pair<const char*, Visibility>, 4>{{{"ray", Visibility::ray},
                                                                  {"ray-cpu", Visibility::ray_on_cpu},
                                                                  {"ray-glsl", Visibility::ray_in_glsl},
                                                                  {"none", Visibility::none}}});
    wish.keeps = ImGui::Button("keep this picture");
    ImGui::SameLine();
    wish.loads = ImGui::Button("load a picture");
    if (!reference) return wish;
    ImGui::TextDisabled("beside: %s", reference->name().c_str());
    constexpr std::array modes{"this alone", "wipe", "difference", "FLIP map"}; // the order of Comparison
    int mode = static_cast<int>(look.comparison);
    if (ImGui::Combo("show", &mode, modes.data(), static_cast<int>(modes.size()))) {
        look.comparison = static_cast<Comparison>(mode);
        wish.wants_flip = look.comparison == Comparison::flip;
    }
    if (look.comparison == Comparison::wipe) ImGui::SliderFloat("wipe", &look.wipe, 0.0f, 1.0f, "%.2f");
    if (look.comparison == Comparison::difference)
        ImGui::TextWrapped("blue: darker than the other, orange: brighter; full at half of it");
    if (look.comparison == Comparison::flip) {
        ImGui::TextWrapped("%s", flip_result.c_str());
        if (ImGui::Button("again")) wish.wants_flip = true;
    }
    return wish;
}

} // namespace sr::viewer
