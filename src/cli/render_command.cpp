#include "cli/commands.hpp"
#include "cli/interruption.hpp"
#include "cli/progress.hpp"
#include "cli/render_checks.hpp"
#include "core/output.hpp"
#include "image/video.hpp"
#include "output/write.hpp"
#include "picture/summary.hpp"
#include "render/adaptive/convergence.hpp"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <fmt/format.h>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <utility>
#include <vector>
#ifdef __GLIBC__
#include <malloc.h>
#endif

namespace sr::cli {
namespace {

using nlohmann::ordered_json;
using picture::Picture;
using render::max_samples;
using render::StoppedBy;

/// Says why a picture has fewer samples, or a greater error, than the options state.
void remark_on_stop(const Picture& picture, const RenderCommand& command) {
    if (picture.stop.by != StoppedBy::interruption) return picture::remark_on_error(picture, command);
    print_remark("interrupted after {} of {} samples: what there is was written{}", picture.samples.max,
                 command.stop.samples,
                 command.has_light_layers || !command.aovs.empty() ? ", not all layers" : "");
}

/// Inputs of a rendering, and a record of what it wrote.
struct Rendering {
    const RenderCommand& command;
    picture::OpenScene& open;
    render::GpuScene& scene;
    render::RenderOptions options;
    render::Renderer& renderer;
    picture::PhaseTimes& times;
    std::vector<std::string> pictures{}; // of the outputs, those that hold one frame
    std::vector<std::unique_ptr<image::VideoFile>> videos{};
    std::vector<std::string> written{};
    std::optional<Picture> last{};
};

/// Shows a bar for each of the works that a picture consists of.
picture::Progress shown_as_bars() {
    return [bar = std::make_shared<std::optional<Progress>>(),
            last = std::string()](const std::string& what, double share, const std::string& state) mutable {
        if (!*bar || what != last) bar->emplace(what);
        last = what;
        (*bar)->update(share, state);
        if (share >= 1.0) bar->reset();
    };
}

picture::Work work_of(const Rendering& rendering, const RenderCommand& command, std::stop_token stop,
                      std::string what) {
    return {command,         rendering.open.stage, rendering.scene, rendering.options, rendering.renderer,
            std::move(stop), shown_as_bars(),      rendering.times, std::move(what)};
}

/// Says what a sequence leaves that was interrupted in one of its frames.
void remark_on_interruption(const Rendering& rendering, const std::string& what) {
    print_remark("interrupted in {}: {}", what,
                 rendering.pictures.empty() ? "no video is written"
                 : rendering.videos.empty() ? "the frames before are written"
                                            : "the frames before are written, and no video");
}

/// Adds a picture to the videos. @return false if the stop has come
bool add_to_videos(const Rendering& rendering, const output::ScreenPicture& shown,
                   const std::stop_token& stop) {
    return std::ranges::all_of(rendering.videos,
                               [&](const auto& video) { return video->add(shown.picture, stop); });
}

/// Draws, and writes the files. @return absent if nothing was: half a frame of a sequence is not
std::optional<Picture> make_picture(const Rendering& rendering, const RenderCommand& command,
                                    const Interruption& interruption, const std::string& what) {
    Picture picture = picture::draw(work_of(rendering, command, interruption.token(), what));
    if (interruption.asks_to_leave()) {
        print_remark("asked to leave after {} samples: nothing was written",
                     rendering.renderer.sample_count());
        return std::nullopt;
    }
    if (!rendering.open.frames.empty() && interruption.has_come()) {
        remark_on_interruption(rendering, what);
        return std::nullopt;
    }
    rendering.open.context->require_silence();
    picture::remark_on(picture.film, command, rendering.open.stage);
    picture::describe(picture, command, rendering.open.stage, rendering.open.context->info());
    output::FileSettings settings{.ev100 = command.ev100,
                                  .tone_curve = command.tone_curve,
                                  .exr_type = command.exr_type,
                                  .view = command.view};
    picture.ev100 =
        output::write(picture.film, picture.layers ? &*picture.layers : nullptr, command.outputs, settings);
    if (!rendering.videos.empty()) {
        if (picture.ev100) settings.ev100 = picture.ev100;
        const output::ScreenPicture shown = output::shown(picture.film, settings);
        picture.ev100 = shown.ev100;
        if (!add_to_videos(rendering, shown, interruption.token())) {
            remark_on_interruption(rendering, what);
            return std::nullopt;
        }
    }
    rendering.times.end("write");
    remark_on_stop(picture, command);
    return picture;
}

/// Renders and writes the frames. @return whether all are written; `rendering` lists those that are
bool make_frames(Rendering& rendering) {
    auto& [command, open, scene, options, renderer, times, pictures, videos, written, last] = rendering;
    const Interruption interruption;
    for (const std::string& output : command.outputs) {
        if (image::is_video(output))
            videos.push_back(std::make_unique<image::VideoFile>(output, command.fps));
        else
            pictures.push_back(output);
    }
    RenderCommand picture = command;
    picture.outputs = pictures;
    for (const int frame : open.frames) {
        if (frame != open.frames.front()) {
            picture::show_frame(open, command, frame);
            times.end("pose");
            if (!open.turn) scene.relight(open.stage.scene, open.stage.lights, 0, true);
            renderer.resize(open.size.width, open.size.height, command.stop.samples);
            renderer.look_from(open.stage.camera);
            times.end("update");
        }
        if (open.turn)
            picture.frames = settings::FrameRange{frame, frame};
        else
            picture.at = picture::seconds_of(frame, command);
        for (std::size_t i = 0; i < pictures.size(); ++i) picture.outputs[i] = *numbered(pictures[i], frame);
        const auto what = fmt::format("frame {} of {} to {}", frame, open.frames.front(), open.frames.back());
        auto made = make_picture(rendering, picture, interruption, what);
        if (!made) return false;
        if (made->ev100) picture.ev100 = made->ev100; // that of the first frame for all of them
        last = std::move(made);
        written.insert(written.end(), picture.outputs.begin(), picture.outputs.end());
    }
    for (const auto& video : videos) {
        if (!video->put_in_place(interruption.token())) {
            remark_on_interruption(rendering, fmt::format("the encoding of {}", video->file().string()));
            return false;
        }
        written.push_back(video->file().string());
    }
    return true;
}

bool make_single(Rendering& rendering) {
    const Interruption interruption;
    rendering.last = make_picture(rendering, rendering.command, interruption, "rendering");
    if (rendering.last) rendering.written = rendering.command.outputs;
    return rendering.last.has_value();
}

void print_summary(const Rendering& rendering) {
    ordered_json json = picture::summary_of(work_of(rendering, rendering.command, {}, {}),
                                            *rendering.open.context, *rendering.last);
    json["outputs"] = rendering.written;
    write_json(json.dump(2, ' ', false, ordered_json::error_handler_t::replace));
}

/// Has large blocks go back to the system when they are freed. By itself glibc learns from the first one,
/// such as a decoded image: blocks of up to 32 MiB then come from the heap, whose end keeps up to twice as
/// much. Smaller bounds than these would have the system take and clear the driver's memory in every sample.
void return_freed_memory() {
#ifdef __GLIBC__
    constexpr int large = 4 << 20; // [bytes]
    mallopt(M_MMAP_THRESHOLD, large);
    mallopt(M_TRIM_THRESHOLD, large);
#endif
}

ExitStatus render(const RenderCommand& command) {
    return_freed_memory();
    picture::PhaseTimes times;
    check(command);
    picture::OpenScene open = picture::open_scene(command, times);
    render::GpuScene gpu_scene = picture::upload(open, command);
    if (open.frames.empty() || open.turn) picture::free_images(open); // no other moment is uploaded
    glFinish();
    times.end("upload");
    if (gpu_scene.visibility_backend())
        times.add("bvh (in upload)", gpu_scene.visibility_backend()->build_seconds());
    const render::RenderOptions options = picture::render_options(command, open.size);
    render::Renderer renderer(gpu_scene, open.stage.camera, options);
    renderer.compile();
    times.end("compile");
    if (options.lights == render::LightSampling::one && renderer.light_choices() == 0)
        print_remark("{}: a folder of --shaders sums over the lights itself: its samples visit all lights",
                     command.scene);
    Rendering rendering{command, open, gpu_scene, options, renderer, times};
    if (!(open.frames.empty() ? make_single(rendering) : make_frames(rendering))) return interrupted;
    if (command.json) print_summary(rendering);
    return rendering.last->stop.by == StoppedBy::interruption ? interrupted : done;
}

} // namespace

void add_render_command(CLI::App& app) {
    const auto options = std::make_shared<RenderCommand>();
    CLI::App* command = app.add_subcommand("render", "render a glTF scene offscreen, lit by its own lights");
    command->add_option("SCENE", options->scene, "a .gltf or .glb file")->required();
    command
        ->add_option(
            "-o,--output", options->outputs,
            "OUT.exr or .hdr for radiance, OUT.png or .jpg for a picture, OUT.mp4 or .webm for a video "
            "of all frames, which ffmpeg encodes (repeatable)")
        ->type_name("OUT")
        ->allow_extra_args(false) // one a flag: what follows may be the scene
        ->required();
    command->add_flag("--json", options->json,
                      "print a summary as JSON: times by phase, triangles, samples, …");
    declare(*command, settings::by_render, *options);
    command->get_option("--turn-axis")->needs(command->get_option("--turntable"));
    command->footer(
        "Examples:\n"
        "  steradian render scene.glb -o picture.png\n"
        "  steradian render scene.glb -o radiance.exr -o picture.png --samples 256 --size 1920x1080\n"
        "  steradian render scene.glb -o converged.exr --error 0.5%\n"
        "  steradian render city.glb -o night.png --lights one     (each sample visits a few of its "
        "thousand lights)\n"
        "  steradian render scene.glb -o quick.png --time 2s --error 2%    (whichever comes first)\n"
        "  steradian render scene.glb -o layers.exr --layers lights --aov depth,normal,object\n"
        "  steradian render scene.glb -o luminance.png --view luminance\n"
        "  steradian render scene.glb -o front.png --camera auto --exposure 9.5 --tone-curve agx\n"
        "  steradian render dancer.glb -o pose.png --animation Walk --at 0.5\n"
        "  steradian render dancer.glb -o walk.####.png --frames 0:47 --fps 24\n"
        "  steradian render vase.glb -o vase.###.png --turntable 120\n"
        "  steradian render vase.glb -o vase.mp4 --turntable 120 --fps 30 --turn-axis x\n"
        "  steradian render scene.glb -o mine.png --shaders my_shaders    (my_shaders/brdf/f_r.glsl wins)");
    command->callback([options, command] {
        if (command->count("--samples") == 0 && options->stop.asks_for_error())
            options->stop.samples = max_samples;
        options->has_rate = command->count("--fps") > 0;
        const ExitStatus status = render(*options);
        if (status != done) throw CLI::RuntimeError(status);
    });
}

} // namespace sr::cli
