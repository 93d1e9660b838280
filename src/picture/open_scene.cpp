#include "picture/open_scene.hpp"

#include "core/error.hpp"
#include "core/output.hpp"
#include "gltf/asset.hpp"
#include "gltf/read/environment.hpp"
#include "image/video.hpp"
#include "scene/look_at.hpp"
#include "settings/bad_setting.hpp"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fmt/format.h>
#include <future>
#include <numeric>
#include <variant>

namespace sr::picture {
namespace {

/// A file that is read, and its scene at the time of --at or of the first frame.
struct Opened {
    gltf::Asset asset;
    scene::Scene scene;
    std::vector<int> animations;
    std::vector<int> frames;
    std::optional<scene::Bounds> extent; // of all frames
    std::optional<scene::EnvironmentLight> environment;
    double seconds = 0.0; // that it took
};

std::vector<int> numbers(int first, int last) {
    std::vector<int> numbers(static_cast<std::size_t>(last - first) + 1);
    std::iota(numbers.begin(), numbers.end(), first);
    return numbers;
}

/// @throws BadSetting for pictures that a turn of so many does not have
std::vector<int> pictures_of_turn(const RenderSettings& settings) {
    const settings::FrameRange range = settings.frames.value_or(settings::FrameRange{});
    const int end = *settings.turntable - 1;
    if (range.first > end || range.last.value_or(end) > end)
        throw settings::BadSetting("frames", fmt::format("{} is beyond the {} pictures of --turntable: the "
                                                         "last one is {}",
                                                         text_of(range), *settings.turntable, end));
    return numbers(range.first, range.last.value_or(end));
}

/// @throws Error if the animation ends before
std::vector<int> frames_of(const gltf::Asset& asset, const std::vector<int>& animations,
                           const RenderSettings& settings) {
    const settings::FrameRange& range = *settings.frames;
    constexpr int max_frames = 1'000'000;
    const double end = asset.duration(animations);
    int last = range.last.value_or(static_cast<int>(std::min(end * settings.fps, 2.0 * max_frames)));
    // A last key that was rounded to 32 bits may lie just before its frame.
    const auto next_second = static_cast<float>(seconds_of(last + 1, settings));
    if (!range.last && next_second <= static_cast<float>(end)) ++last;
    if (last - range.first >= max_frames)
        throw Error({settings.scene},
                    fmt::format("frames {} to {} are more than {}", range.first, last, max_frames),
                    "name fewer with --frames A:B, or a lower --fps");
    for (const int frame : {range.first, std::max(last, range.first)})
        asset.require_within({animations, seconds_of(frame, settings)});
    return numbers(range.first, std::max(last, range.first));
}

/// Returns the bounds of the scene over these frames, or over 64 of them.
scene::Bounds extent_of(Opened& opened, const RenderSettings& settings) {
    constexpr std::size_t max_poses = 64;
    scene::Bounds all;
    const std::size_t count = std::min(opened.frames.size(), max_poses);
    for (std::size_t i = 0; i < count; ++i) {
        const std::size_t frame = count == 1 ? 0 : i * (opened.frames.size() - 1) / (count - 1);
        opened.scene = opened.asset.evaluate(std::move(opened.scene),
                                             {opened.animations, seconds_of(opened.frames[frame], settings)});
        const scene::Bounds bounds = scene::bounds_of(opened.scene);
        if (bounds.is_empty()) continue;
        all.extend(bounds.min);
        all.extend(bounds.max);
    }
    return all;
}

Opened open(const RenderSettings& settings) {
    PhaseTimes times;
    Opened opened{gltf::Asset(settings.scene, {settings.scene_index, settings.variant, settings.is_strict}),
                  {},
                  {},
                  {},
                  {},
                  {}};
    const bool moves = settings.frames && !settings.turntable;
    if (moves || settings.at) opened.animations = opened.asset.animations_named(settings.animation);
    if (settings.turntable) opened.frames = pictures_of_turn(settings);
    if (moves) opened.frames = frames_of(opened.asset, opened.animations, settings);
    opened.scene = gltf::build_scene(opened.asset, {{}, settings.at, settings.animation, {}});
    opened.environment = read_environment_light(settings);
    if (moves) opened.extent = extent_of(opened, settings);
    opened.seconds = times.total();
    return opened;
}

/// Prints the file's warnings that have not been printed yet: moments of an animation may have their own.
void tell_new_warnings(OpenScene& open) {
    for (const std::string& warning : open.asset.warnings())
        if (open.told.insert(warning).second) write_remark(warning);
}

} // namespace

void PhaseTimes::end(std::string phase) {
    const auto now = Clock::now();
    phases_.emplace_back(std::move(phase), std::chrono::duration<double>(now - last_).count());
    last_ = now;
}

Size picture_size(std::optional<float> aspect_ratio) {
    constexpr int rows = 720;
    const float aspect = aspect_ratio.value_or(16.0f / 9.0f);
    return {std::clamp(static_cast<int>(std::lround(rows * aspect)), 1, 16 * rows), rows};
}

std::vector<glsl::Root> shader_path(const std::vector<std::string>& folders, bool is_untrusted) {
    std::vector<glsl::Root> path;
    for (const std::string& folder : folders) {
        const glsl::Root root = glsl::Root::folder(folder);
        path.push_back(is_untrusted ? root.untrusted() : root);
    }
    path.push_back(glsl::embedded());
    for (const std::string& folder : folders)
        if (const auto remark = glsl::remark_on_overlay(folder, path.back(), folders)) write_remark(*remark);
    return path;
}

std::optional<scene::EnvironmentLight> read_environment_light(const RenderSettings& settings) {
    const std::string& source = settings.environment;
    if (source.empty()) return std::nullopt;
    scene::EnvironmentLight light;
    if (const auto color = settings::parse_color(source)) {
        light.name = "environment";
        if (std::min({color->r, color->g, color->b}) < 0.0f)
            throw settings::BadSetting("environment",
                                       "'" + source + "' is a negative radiance: choose 0 or more");
        light.L = *color;
    } else {
        light.name = std::filesystem::path(source).stem().string();
        std::vector<std::string> warnings;
        light.map = gltf::read_environment(source, warnings);
        for (const std::string& warning : warnings) print_remark("{}", warning);
    }
    light.L *= settings.environment_strength;
    light.rotation = glm::radians(settings.environment_rotation);
    light.is_visible = !settings.hide_environment;
    return light;
}

OpenScene open_scene(const RenderSettings& settings, PhaseTimes& times) {
    // The context first: the dynamic loader has one lock, and behind OpenImageIO a driver would wait for
    // long.
    auto context = gl::open_context({settings.backend, settings.gl_debug});
    times.end("start");
    auto loading = std::async(std::launch::async, open, std::cref(settings));
    // Last, since no thread can start while it has that lock.
    const auto is_slow = [](const std::string& file) {
        return !image::is_video(file) && image::loads_openimageio(file);
    };
    const auto preloading =
        std::ranges::any_of(settings.outputs, is_slow) ? image::preload() : std::future<void>();
    Opened opened = loading.get();
    times.end("wait for load");
    times.add("load (beside start)", opened.seconds);
    OpenScene result{std::move(context),
                     {},
                     {},
                     std::move(opened.asset),
                     prepare_options(settings, std::move(opened.environment)),
                     std::move(opened.animations),
                     std::move(opened.frames),
                     {}};
    result.stage_options.extent = opened.extent;
    tell_new_warnings(result);
    const scene::Bounds bounds = scene::bounds_of(opened.scene);
    result.stage.scene = std::move(opened.scene);
    if (result.frames.empty() || settings.turntable)
        result.stage =
            scene::prepare_scene(std::move(result.stage.scene), settings.scene, result.stage_options);
    if (settings.turntable) result.turn.emplace(result.stage.camera, bounds, settings);
    if (!result.frames.empty()) show_frame(result, settings, result.frames.front());
    result.stage_options.rig = result.stage.rig; // what lights the first frame lights all
    for (const std::string& remark : result.stage.remarks) write_remark(remark);
    remark_on_estimator(settings, result.stage);
    result.size = settings.size.value_or(picture_size(result.stage.camera.aspect_ratio()));
    times.end("stage");
    return result;
}

Turn::Turn(scene::Camera begin, const scene::Bounds& bounds, vec3 around, int count, scene::TurnAxis axis,
           bool fits_depths)
    : begin_(std::move(begin)),
      bounds_(bounds),
      around_(around),
      count_(count),
      axis_(axis),
      fits_depths_(fits_depths) {}

Turn::Turn(scene::Camera begin, const scene::Bounds& bounds, const RenderSettings& settings)
    : Turn(std::move(begin), bounds, bounds.is_empty() ? vec3(0.0f) : bounds.center(), *settings.turntable,
           settings.turn_axis, false) {
    fits_depths_ = begin_.name == "auto" && begin_.number < 0;
    if (!scene::is_look_at(settings.camera)) return;
    const scene::LookAt view = scene::parse_look_at(settings.camera);
    fits_depths_ = !view.znear && !view.zfar;
}

scene::Camera Turn::camera(int picture) const {
    if (picture == 0) return begin_;
    scene::Camera camera = scene::turned(begin_, around_, 360.0 * picture / count_, axis_);
    if (!fits_depths_) return camera;
    const mat4& m = camera.world_from_camera;
    scene::LookAt view;
    view.eye = vec3(m[3]);
    view.target = vec3(m[3] - m[2]);
    if (const auto* flat = std::get_if<scene::Orthographic>(&camera.projection)) view.ymag = flat->ymag;
    const scene::DepthRange depth = scene::depth_range(view, bounds_);
    std::visit(
        [&](auto& projection) {
            projection.znear = depth.near;
            projection.zfar = depth.far;
        },
        camera.projection);
    return camera;
}

double seconds_of(int frame, const RenderSettings& settings) { return frame / settings.fps; }

void show_frame(OpenScene& open, const RenderSettings& settings, int frame) {
    if (open.turn) {
        open.stage.camera = open.turn->camera(frame);
        return;
    }
    scene::Scene posed =
        open.asset.evaluate(std::move(open.stage.scene), {open.animations, seconds_of(frame, settings)});
    open.stage = scene::prepare_scene(std::move(posed), settings.scene, open.stage_options);
    tell_new_warnings(open);
}

void free_images(OpenScene& open) {
    for (scene::TextureImage& image : open.stage.scene.images) image.texels = {};
}

render::GpuScene upload(const OpenScene& open, const RenderSettings& settings) {
    return {open.stage.scene, open.stage.lights, settings.visibility, settings.has_energy_compensation,
            settings.texture_channels()};
}

scene::PrepareOptions prepare_options(const RenderSettings& settings,
                                      std::optional<scene::EnvironmentLight> environment) {
    scene::PrepareOptions options{settings.camera, settings.rig};
    if (settings.size)
        options.aspect_ratio =
            static_cast<float>(settings.size->width) / static_cast<float>(settings.size->height);
    options.hide_emitters = settings.hide_emitters;
    options.environment = std::move(environment);
    return options;
}

void remark_on_estimator(const RenderSettings& settings, const scene::RenderScene& stage) {
    if (settings.rendering.estimator != render::Estimator::analytic) return;
    for (const scene::Light& light : stage.lights) {
        if (const auto* environment = std::get_if<scene::EnvironmentLight>(&light))
            print_remark("{}: '{}' surrounds the scene: it is sampled{}", settings.scene, environment->name,
                         environment->map ? "" : ", but for Lambert's surfaces");
        const auto* mesh = std::get_if<scene::MeshLight>(&light);
        if (mesh && mesh->triangles.size() > render::max_outlined_triangles)
            print_remark("{}: '{}' has {} emissive triangles, more than {}: it is sampled", settings.scene,
                         mesh->name, mesh->triangles.size(), render::max_outlined_triangles);
    }
}

render::RenderOptions render_options(const RenderSettings& settings, Size size) {
    render::RenderOptions options = settings.rendering;
    options.width = size.width;
    options.height = size.height;
    options.samples = settings.stop.samples;
    options.estimates_error = settings.stop.asks_for_error() || settings.denoises;
    options.shader_path = shader_path(settings.shaders, settings.is_untrusted);
    if (!settings.shaders.empty()) options.trial = std::make_shared<gl::TrialCompiler>(settings.backend);
    if (settings.view) options.shader = settings.view->shader;
    return options;
}

} // namespace sr::picture
