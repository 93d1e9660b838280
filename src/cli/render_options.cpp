#include "cli/render_options.hpp"
#include "core/output.hpp"

#include "gltf/environment.hpp"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fmt/format.h>
#include <fmt/ranges.h>

namespace sr::cli {
namespace {

/// An option whose text `parse` turns into a value, or refuses: then the user hears what was expected.
template<class Parse, class Take>
CLI::Option* parsed(CLI::App& command, const char* name, const char* help, const char* expected, Parse parse,
                    Take take) {
    return command
        .add_option_function<std::string>(
            name,
            [=](const std::string& text) {
                auto value = parse(text);
                if (!value) throw CLI::ValidationError(name, "'" + text + "' is not " + expected);
                take(std::move(*value));
            },
            help)
        ->type_name(expected);
}

std::optional<scene::Rig> rig_named(const std::string& name) {
    if (name == "auto") return scene::Rig::automatic;
    if (name == "studio") return scene::Rig::studio;
    if (name == "softboxes") return scene::Rig::softboxes;
    if (name == "none") return scene::Rig::none;
    return std::nullopt;
}

std::optional<render::Estimator> estimator_named(const std::string& name) {
    if (name == "sampled") return render::Estimator::sampled;
    if (name == "analytic") return render::Estimator::analytic;
    return std::nullopt;
}

std::optional<image::SampleType> exr_type_named(const std::string& name) {
    if (name == "half") return image::SampleType::half;
    if (name == "float") return image::SampleType::floating;
    return std::nullopt;
}

/// A number, or an absent one for "auto".
std::optional<std::optional<float>> parsed_exposure(const std::string& text) {
    if (text == "auto") return std::optional<float>{};
    char* end = nullptr;
    const float value = std::strtof(text.c_str(), &end);
    if (text.empty() || *end != '\0' || !std::isfinite(value)) return std::nullopt;
    return value;
}

std::string aov_help() {
    return fmt::format(
        "further channels of .exr files, separated by commas; src/output/README.md describes them: {}",
        fmt::join(output::aov_names(), ", "));
}

std::string view_help() {
    std::string text = "one term of the equation instead of radiance, as numbers in .exr and .hdr:";
    for (const output::Variable& variable : output::all_variables())
        if (output::view_named(variable.name)) text += fmt::format(" {} ({}),", variable.name, variable.what);
    text.back() = '.';
    return text;
}

void declare_picture(CLI::App& command, RenderCommand& o) {
    parsed(command, "--size", "size of the picture (default: 720 rows in the camera's aspect ratio, or 16:9)",
           "WIDTHxHEIGHT", parsed_size, [&o](Size size) { o.size = size; });
    command.add_option(
        "--camera", o.camera,
        "camera by name or index; auto, which frames the scene; or a view, eye=X,Y,Z;target=X,Y,Z with "
        "up=X,Y,Z fov=DEGREES near= far= if wanted, as the viewer copies it (default: the first, or auto)");
    command.add_option("--scene", o.scene_index, "which of the file's scenes (default: the file's choice)")
        ->check(CLI::NonNegativeNumber);
    command.add_flag("--strict", o.is_strict, strict_help);
    command
        .add_option("--samples", o.stop.samples,
                    "samples a pixel: sub-pixel positions and points on each emitter")
        ->check(CLI::Range(1, 1 << 24))
        ->capture_default_str();
    command.add_option("--seed", o.rendering.seed, "another seed is another, equally good set of samples")
        ->capture_default_str();
    parsed(command, "--visibility",
           "shadows: a ray to each sample, on the CPU in software GL, in GLSL elsewhere; depth maps from "
           "points on "
           "the emitters; or none (default: ray)",
           "ray|ray-cpu|ray-glsl|map|none", render::visibility_named,
           [&o](render::Visibility visibility) { o.visibility = visibility; });
    command
        .add_option(
            "--map-points", o.rendering.maps.points,
            "with --visibility map: points on each emitter that a sample has, each with its depth maps")
        ->check(CLI::Range(1, 32))
        ->capture_default_str();
    command
        .add_option(
            "--map-size", o.rendering.maps.size,
            "with --visibility map: texels on a map's side; halved until a sample's maps fit into 256 MiB")
        ->check(CLI::Range(16, 8192))
        ->capture_default_str();
    parsed(command, "--background", "radiance where there is no surface [cd/m²] (default: 0)", "L or R,G,B",
           parsed_color, [&o](vec3 color) { o.rendering.background = color; });
    declare_rig(command, o.rig, o.environment);
    command.add_flag(
        "--hide-emitters", o.hide_emitters,
        "emitters light the scene and are not seen: lights vanish, emissive surfaces only reflect");
}

void declare_moment(CLI::App& command, RenderCommand& o) {
    command
        .add_option("--at", o.at,
                    "show the animation at this time (default: the file's rest pose, without its animations)")
        ->type_name("SECONDS")
        ->check(refusal_of_number)
        ->check(CLI::NonNegativeNumber);
    command
        .add_option("--animation", o.animation,
                    "which one --at and --frames show: by name or index, or all at once (default: the first)")
        ->type_name("NAME|INDEX|all");
    command.add_option("--variant", o.variant, "which of the file's material variants (default: none)")
        ->type_name("NAME");
}

void declare_sequence(CLI::App& command, RenderCommand& o) {
    CLI::Option* frames = parsed(
        command, "--frames",
        "render frames A to B of the animation, or from A to its end; OUT has #### or %04d in its name",
        "A:B|A:", parsed_frames, [&o](FrameRange range) { o.frames = range; });
    frames->excludes(command.get_option("--at"));
    command.add_option("--fps", o.fps, "frames a second: frame n is at n / fps seconds")
        ->check(refusal_of_number)
        ->check(CLI::Range(1e-3, 1e6))
        ->needs(frames)
        ->capture_default_str();
}

void declare_denoising(CLI::App& command, RenderCommand& o) {
    command.add_flag(
        "--denoise", o.denoises,
        "with --estimator analytic: filter the shadows, the only noise it has, over pixels of the same "
        "surface. Looks smooth and is biased: no measurement");
}

void declare_estimator(CLI::App& command, RenderCommand& o) {
    parsed(command, "--estimator",
           "how area lights are integrated (default: sampled, which converges to the exact value; "
           "analytic is free of noise: exact for Lambert, an approximation for gloss)",
           "sampled|analytic", estimator_named,
           [&o](render::Estimator estimator) { o.rendering.estimator = estimator; });
    command.add_flag("--energy-compensation", o.has_energy_compensation,
                     "compensate GGX for energy lost to multiple scattering (not part of glTF)");
    command
        .add_option("--analytic-points", o.rendering.analytic_points,
                    "points the analytic estimator takes a lobe and emitter; 0: none, the fitted lobe alone")
        ->check(CLI::Range(0, 4096))
        ->capture_default_str();
}

void declare_output(CLI::App& command, RenderCommand& o) {
    declare_display(command, o);
    parsed(command, "--exr-type", "how .exr stores numbers (default: float)", "half|float", exr_type_named,
           [&o](image::SampleType type) { o.exr_type = type; });
    command
        .add_option_function<std::string>(
            "--layers", [&o](const std::string&) { o.light_layers = true; },
            "lights: .exr files get a layer for each light and one for emission, whose sum is the picture")
        ->check(CLI::IsMember({"lights"}))
        ->type_name("lights");
    parsed(command, "--aov", aov_help().c_str(), "NAME,NAME...", output::parsed_aovs,
           [&o](output::Variables aovs) { o.aovs = std::move(aovs); });
    parsed(
        command, "--view", view_help().c_str(), "NAME",
        [](const std::string& name) -> std::optional<const output::Variable*> {
            const output::Variable* view = output::view_named(name);
            return view ? std::optional(view) : std::nullopt;
        },
        [&o](const output::Variable* view) { o.view = view; });
    command.add_flag("--json", o.json, "print a summary as JSON: times by phase, triangles, samples, …");
}

void declare_machine(CLI::App& command, RenderCommand& o) {
    parsed(command, "--backend", "where OpenGL comes from (default: auto; see steradian info)",
           "auto|egl|osmesa|window", gl::backend_named, [&o](gl::Backend backend) { o.backend = backend; });
    command.add_option("--shaders", o.shaders, "look for shaders in this folder first (repeatable)")
        ->allow_extra_args(false)
        ->type_name("DIR");
    command.add_flag(
        "--untrusted", o.is_untrusted,
        "refuse in these folders what is no plain GLSL (links, images, recursion, …), and bound their loops");
    command.add_flag("--gl-debug", o.gl_debug, "fail on any error or warning of the driver");
}

} // namespace

void declare_rig(CLI::App& command, scene::Rig& rig, EnvironmentArguments& environment) {
    parsed(
        command, "--rig",
        "what lights the scene besides its own lamps: a studio; three softboxes; nothing; or the studio if "
        "almost nothing would be lit (default: auto)",
        "auto|studio|softboxes|none", rig_named, [&rig](scene::Rig given) { rig = given; });
    command
        .add_option(
            "--environment", environment.source,
            "light from outside, seen as the background: an equirectangular .hdr or .exr in cd/m² whose "
            "middle column is -Z, or one radiance for all directions")
        ->type_name("FILE|L|R,G,B");
    command
        .add_option("--environment-rotation", environment.degrees,
                    "turns it around +Y, counter-clockwise seen from above")
        ->type_name("DEGREES")
        ->check(refusal_of_number)
        ->check(CLI::Range(-36000.0, 36000.0));
    command.add_option("--environment-strength", environment.strength, "multiplies it")
        ->check(refusal_of_number)
        ->check(CLI::Range(0.0, 1e20))
        ->type_name("FACTOR");
    command.add_flag("--hide-environment", environment.is_hidden, "it lights the scene and is not seen");
}

std::optional<scene::EnvironmentLight> EnvironmentArguments::light() const {
    if (source.empty()) return std::nullopt;
    scene::EnvironmentLight light;
    if (const auto color = parsed_color(source)) {
        light.name = "environment";
        if (std::min({color->r, color->g, color->b}) < 0.0f)
            throw CLI::ValidationError("--environment", "'" + source + "' is a negative radiance");
        light.L = *color;
    } else {
        light.name = std::filesystem::path(source).stem().string();
        std::vector<std::string> warnings;
        light.map = gltf::read_environment(source, warnings);
        for (const std::string& warning : warnings) print_remark("{}", warning);
    }
    light.L *= strength;
    light.rotation = glm::radians(degrees);
    light.is_visible = !is_hidden;
    return light;
}

bool RenderCommand::asks_for_error() const {
    return stop.asks_for_error() || denoises || output::holds(aovs, output::Finish::error);
}

void declare_rendering(CLI::App& command, RenderCommand& options) {
    command.add_option("SCENE", options.scene, "a .gltf or .glb file")->required();
    declare_picture(command, options);
    declare_moment(command, options);
    declare_estimator(command, options);
    declare_machine(command, options);
}

void declare_display(CLI::App& command, RenderCommand& o) {
    parsed(command, "--exposure",
           "EV100 for .png, .jpg and windows (default: auto, the log-average becomes middle grey)", "EV|auto",
           parsed_exposure, [&o](std::optional<float> ev) { o.ev100 = ev; });
    parsed(command, "--tone-curve", "tone curve for .png, .jpg and windows (default: neutral)",
           "linear|aces|neutral|agx", image::tone_curve_named,
           [&o](image::ToneCurve curve) { o.tone_curve = curve; });
}

void declare_stopping(CLI::App& command, RenderCommand& o) {
    parsed(command, "--error",
           "stop when the picture is this near to what it converges to: √rel_mse of `steradian compare`, "
           "estimated "
           "from two independent halves of the samples; pixels that are near enough stop earlier. Then "
           "--samples is 65536 by default",
           "PERCENT%", parsed_percentage, [&o](double error) { o.stop.error = error; });
    parsed(command, "--time", "stop after this long; loading and --layers are not counted", "SECONDS|2s|5min",
           parsed_duration, [&o](double seconds) { o.stop.seconds = seconds; });
}

void declare(CLI::App& command, RenderCommand& options) {
    declare_rendering(command, options);
    command
        .add_option("-o,--output", options.outputs,
                    "OUT.exr or .hdr for radiance, OUT.png or .jpg for a picture (repeatable)")
        ->type_name("OUT")
        ->allow_extra_args(false) // one a flag: what follows may be the scene
        ->required();
    declare_sequence(command, options);
    declare_stopping(command, options);
    declare_denoising(command, options);
    declare_output(command, options);
    command.footer(
        "Examples:\n"
        "  steradian render scene.glb -o picture.png\n"
        "  steradian render scene.glb -o radiance.exr -o picture.png --samples 256 --size 1920x1080\n"
        "  steradian render scene.glb -o converged.exr --error 0.5%\n"
        "  steradian render scene.glb -o quick.png --time 2s --error 2%    (whichever comes first)\n"
        "  steradian render scene.glb -o layers.exr --layers lights --aov depth,normal,object\n"
        "  steradian render scene.glb -o luminance.png --view luminance\n"
        "  steradian render scene.glb -o front.png --camera auto --exposure 9.5 --tone-curve agx\n"
        "  steradian render dancer.glb -o pose.png --animation Walk --at 0.5\n"
        "  steradian render dancer.glb -o walk.####.png --frames 0:47 --fps 24\n"
        "  steradian render scene.glb -o mine.png --shaders my_shaders    (my_shaders/brdf/f_r.glsl wins)");
}

} // namespace sr::cli
