#include "assignment/pictures.hpp"

#include "compare/compare.hpp"
#include "core/error.hpp"
#include "core/file.hpp"
#include "gltf/asset.hpp"

#include <algorithm>

#include <cmath>
#include <fmt/format.h>
#include <fstream>
#include <sstream>

namespace sr::assignment {
namespace {

namespace fs = std::filesystem;

/// The scene with the student's own numbers in the place of "{{name}}", which takes the quotation marks
/// along.
scene::Scene scene_of(const fs::path& file, const Parameters& parameters) {
    if (file.extension() != ".gltf") return gltf::load(file).scene;
    std::ifstream stream(file, std::ios::binary);
    std::ostringstream bytes;
    bytes << stream.rdbuf();
    const std::string text = bytes.str();
    if (text.find("{{") == std::string::npos) return gltf::load(file).scene;
    const ScratchFolder folder("scene");
    std::ofstream(folder.path() / file.filename(), std::ios::binary)
        << substituted_json(text, parameters, file.string());
    return gltf::load(folder.path() / file.filename()).scene;
}

compare::Comparison compare_images(const image::Image& picture, const image::Image& reference,
                                   const Check& check) {
    compare::CompareOptions options;
    options.tolerances = compare::parse_tolerances(check.tolerances);
    options.other_layers.emplace(); // the reference has layers that tell mistakes
    return compare::compare(picture, reference, options);
}

/// Where two pictures differ most, relative to the larger value there and no less than a hundredth of the
/// largest.
std::pair<int, int> furthest(const image::Image& a, const image::Image& b) {
    double largest = 0.0;
    for (int y = 0; y < b.height; ++y)
        for (int x = 0; x < b.width; ++x)
            for (int c = 0; c < 3; ++c)
                largest =
                    std::max(largest, std::abs(static_cast<double>(b.at(x, y)[static_cast<std::size_t>(c)])));
    std::pair<int, int> place{0, 0};
    double worst = -1.0;
    for (int y = 0; y < b.height; ++y)
        for (int x = 0; x < b.width; ++x)
            for (std::size_t c = 0; c < 3; ++c) {
                const double t = a.at(x, y)[c], r = b.at(x, y)[c];
                double error = std::abs(t - r) / std::max({std::abs(t), std::abs(r), 0.01 * largest, 1e-30});
                if (!std::isfinite(t)) error = 1e30;
                if (error > worst) {
                    worst = error;
                    place = {x, y};
                }
            }
    return place;
}

bool is_magenta_anywhere(const image::Image& picture) {
    for (int y = 0; y < picture.height; ++y)
        for (int x = 0; x < picture.width; ++x)
            if (const auto p = picture.at(x, y); p[0] == 1.0f && p[1] == 0.0f && p[2] == 1.0f) return true;
    return false;
}

std::string pixel_text(const image::Image& picture, std::pair<int, int> at) {
    const auto p = picture.at(at.first, at.second);
    return text_of({p[0], p[1], p[2], 0.0}, "vec3");
}

} // namespace

const Pictures::Shown& Pictures::shown(const Check& check) {
    const std::string key = fmt::format("{} {} {}x{} {}", check.scene, check.camera, check.width,
                                        check.height, static_cast<int>(check.visibility));
    const auto found = shown_.find(key);
    if (found != shown_.end()) return found->second;
    const fs::path file = assignment_.folder / check.scene;
    scene::PrepareOptions options;
    options.camera = check.camera;
    options.aspect_ratio = static_cast<float>(check.width) / static_cast<float>(check.height);
    Shown& made = shown_[key];
    made.stage = scene::prepare_scene(scene_of(file, parameters_), file.string(), options);
    made.gpu = std::make_unique<render::GpuScene>(made.stage.scene, made.stage.lights, check.visibility);
    return made;
}

image::Image Pictures::render(const Check& check, const Codes& codes) {
    const Shown& scene = shown(check);
    render::RenderOptions options;
    options.width = check.width;
    options.height = check.height;
    options.samples = check.samples;
    options.shader = check.shader;
    options.shader_path = shader_path(assignment_, parameters_, codes);
    render::Renderer renderer(*scene.gpu, scene.stage.camera, options);
    for (int i = 0; i < check.samples; ++i) renderer.add_sample();
    return renderer.read_film();
}

/// A picture of trusted code, from `known_` if it is there.
image::Image Pictures::known_picture(const Check& check, const Codes& codes) {
    std::vector<std::string> parts = identity_of(assignment_, parameters_, codes);
    parts.push_back(fmt::format("{} {} {} {}x{} {} {}", check.scene, check.camera, check.shader, check.width,
                                check.height, check.samples, static_cast<int>(check.visibility)));
    const std::string key = key_of(parts);
    const std::vector<double>* numbers = known_.find(key);
    if (!numbers) try {
            const image::Image made = render(check, codes);
            numbers = &known_.add(key, {made.pixels.begin(), made.pixels.end()});
        } catch (const glsl::LoopError&) {
            numbers = &known_.add(key, {});
        }
    if (numbers->empty()) throw glsl::LoopError({codes.empty() ? "" : codes.begin()->second.place});
    image::Image picture(check.width, check.height, 4);
    require(picture.pixels.size() == numbers->size(), "a film has four channels");
    std::ranges::transform(*numbers, picture.pixels.begin(), [](double x) { return static_cast<float>(x); });
    return picture;
}

void Pictures::compute_references(const Task& task, const Check& check, bool mistakes) {
    reference(check);
    for (const Variant& variant : task.variants)
        if (mistakes && variant.is_mistake && !check.is_hidden) mistaken(task, check, variant);
}

const image::Image& Pictures::reference(const Check& check) {
    const auto found = references_.find(&check);
    if (found != references_.end()) return found->second;
    return references_.emplace(&check, known_picture(check, {})).first->second;
}

const image::Image* Pictures::mistaken(const Task& task, const Check& check, const Variant& variant) {
    const auto [found, is_new] = mistakes_.try_emplace({&check, &variant});
    if (is_new) try {
            found->second =
                known_picture(check, {{task.id, {task.variants_place, variant.line, variant.text}}});
        } catch (const glsl::LoopError&) { // it has no picture
        }
    return found->second ? &*found->second : nullptr;
}

Finding Pictures::check(const Check& check, const Codes& codes) {
    Finding finding;
    finding.reference = reference(check);
    finding.picture = render(check, codes);
    const compare::Comparison comparison = compare_images(*finding.picture, *finding.reference, check);
    finding.passed = comparison.passed;
    const auto place = furthest(*finding.picture, *finding.reference);
    finding.got = pixel_text(*finding.picture, place);
    finding.expected = pixel_text(*finding.reference, place);
    finding.at = fmt::format("pixel {},{}", place.first, place.second);
    if (finding.passed) return finding;
    finding.is_implemented = !is_magenta_anywhere(*finding.picture);
    for (const compare::Verdict& verdict : comparison.verdicts)
        if (!verdict.passed && finding.message.empty()) finding.message = verdict.line;
    if (!finding.is_implemented) finding.message = "not implemented";
    return finding;
}

std::optional<Named> Pictures::diagnose(const Task& task, const Check& check, const Finding& finding) {
    for (const Variant& variant : task.variants) {
        if (!variant.is_mistake) continue;
        const image::Image* picture = mistaken(task, check, variant);
        if (picture && compare_images(*finding.picture, *picture, check).passed
            && !compare_images(*picture, *finding.reference, check).passed)
            return Named{variant.name, task.hints.at(variant.name)};
    }
    const compare::Comparison comparison = compare_images(*finding.picture, *finding.reference, check);
    if (!comparison.diagnosis) return std::nullopt;
    return Named{comparison.diagnosis->name, comparison.diagnosis->statement};
}

} // namespace sr::assignment
