#include "cli/outputs.hpp"

#include "core/output.hpp"
#include "image/half.hpp"
#include "image/whole_file.hpp"
#include "render/provenance.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <fmt/format.h>

namespace sr::cli {

SampleCounts counted(const std::vector<int>& samples) {
    SampleCounts counts;
    if (samples.empty()) return counts;
    const auto [least, most] = std::ranges::minmax(samples);
    double sum = 0.0;
    for (const int count : samples) sum += count;
    return {sum / static_cast<double>(samples.size()), least, most};
}

std::string unit_of(const RenderCommand& command, scene::UnitSystem units) {
    if (!command.view || !command.view->unit) return std::string(scene::radiance_unit(units));
    const bool is_irradiance = std::string_view(command.view->unit) == "lx";
    return is_irradiance && units == scene::UnitSystem::radiometric ? "W/m^2" : command.view->unit;
}

void describe(Picture& picture, const RenderCommand& command, const scene::RenderScene& stage,
              const gl::ContextInfo& gl) {
    std::vector<image::Attribute> attributes =
        render::attributes_of({.unit = unit_of(command, stage.scene.units),
                               .camera = stage.camera.name,
                               .estimator = command.estimator,
                               .analytic_points = command.analytic_points,
                               .visibility = command.visibility,
                               .samples = picture.samples.most,
                               .seed = command.seed,
                               .error = picture.stop.error,
                               .seconds = command.at},
                              gl);
    const auto add = [&](const char* name, std::string value) {
        attributes.push_back({name, std::move(value)});
    };
    add("steradian:stopped_by", name_of(picture.stop.by));
    if (command.denoises) add("steradian:denoised", "visibility");
    if (command.view) add("steradian:view", command.view->name);
    if (picture.samples.least < picture.samples.most) {
        add("steradian:samples_mean", fmt::format("{:.1f}", picture.samples.mean));
        add("steradian:samples_min", std::to_string(picture.samples.least));
    }
    if (command.stop.error) add("steradian:error_target", fmt::format("{:.4g}", *command.stop.error));
    if (picture.stop.by == StoppedBy::interruption) add("steradian:interrupted", "yes");
    std::ranges::move(name_tables(command.aovs, stage.scene), std::back_inserter(attributes));
    picture.film.channel_names = {"R", "G", "B", "A"};
    picture.film.attributes = attributes;
    if (picture.layers) picture.layers->attributes = std::move(attributes);
}

void remark_on(const image::Image& film, const RenderCommand& command, const scene::RenderScene& stage) {
    std::size_t covered = 0, lit = 0, broken = 0;
    for (std::size_t i = 0; i < film.pixels.size(); i += 4) {
        const vec3 L(film.pixels[i], film.pixels[i + 1], film.pixels[i + 2]);
        covered += film.pixels[i + 3] > 0.0f;
        lit += L.r > 0.0f || L.g > 0.0f || L.b > 0.0f;
        broken += !std::isfinite(L.r + L.g + L.b);
    }
    const auto& file = command.scene;
    if (broken > 0)
        print_remark("{}: {} pixels are not finite: they are magenta in .png and .jpg", file, broken);
    if (stage.scene.instances.empty()) return; // the loader has said so
    if (covered == 0)
        print_remark("{}: camera '{}' sees no surface: --camera auto frames the scene", file,
                     stage.camera.name);
    else if (lit == 0)
        print_remark("{}: no light reaches what camera '{}' sees: the picture is black", file,
                     stage.camera.name);
}

bool holds_layers(const std::string& output) { return output.ends_with(".exr") || output.ends_with(".EXR"); }

namespace {

void warn_of_half_overflow(const image::Image& image, const std::string& output) {
    const std::size_t count = image::half_overflow_count(image);
    if (count == 0) return;
    const bool is_one = count == 1;
    print_remark("{}: {} value{} beyond 65504, the largest of --exr-type half, {} stored as that: "
                 "--exr-type float holds {}",
                 output, count, is_one ? "" : "s", is_one ? "is" : "are", is_one ? "it" : "them");
}

} // namespace

std::optional<float> write_outputs(const Picture& picture, const RenderCommand& command) {
    const image::Image& film = picture.film;
    std::optional<float> ev100;
    image::WholeFiles files;
    for (const std::string& output : command.outputs) {
        if (image::is_scene_referred(output)) {
            const image::Image& written = picture.layers && holds_layers(output) ? *picture.layers : film;
            if (command.exr_type == image::SampleType::half && holds_layers(output))
                warn_of_half_overflow(written, output);
            files.add(written, output, command.exr_type);
            continue;
        }
        if (command.view && command.view->kind != ViewKind::light) {
            image::Image shown = colors_of(*command.view, film);
            shown.attributes = film.attributes;
            files.add(shown, output, image::SampleType::integer8);
            continue;
        }
        if (!ev100) ev100 = command.ev100 ? *command.ev100 : image::auto_ev100(film);
        image::Image shown = image::displayed(film, *ev100, command.tone_curve);
        shown.attributes = film.attributes;
        files.add(shown, output, image::SampleType::integer8);
    }
    files.put_in_place();
    return ev100;
}

} // namespace sr::cli
