#include "python/scene_file.hpp"

#include "core/error.hpp"
#include "core/output.hpp"
#include "picture/checks.hpp"
#include "picture/open_scene.hpp"
#include "picture/summary.hpp"
#include "settings/bad_setting.hpp"

#include <algorithm>
#include <atomic>
#include <filesystem>
#include <fmt/format.h>
#include <nlohmann/json.hpp>
#include <utility>

namespace sr::python {

using picture::PhaseTimes;
using settings::RenderSettings;

namespace {

namespace fs = std::filesystem;

std::atomic<int> file_count = 0;

} // namespace

struct SceneFile::OnGpu {
    render::GpuScene scene;
    render::Visibility visibility;
    bool has_energy_compensation;
    /// Programs by what they depend on besides the scene; users' shaders may change and have none here.
    std::map<std::pair<render::Estimator, int>, std::shared_ptr<render::ShaderLibrary>> programs{};
};

struct SceneFile::Staged {
    Staged(SceneFile& file, const RenderSettings& settings, const SceneEdits& edits) : file_(file) {
        gltf::AnimationTime time;
        if (settings.at) {
            time = {file.asset_.animations_named(settings.animation), *settings.at};
            file.asset_.require_within(time);
        }
        file.asset_.evaluate_into(file.scene_, time);
        apply(edits, file.scene_, file.light_numbers(), !settings.at);
        const auto options = picture::prepare_options(settings, picture::read_environment_light(settings));
        scene::chosen_camera(file.scene_, file.file_, options); // throws before the scene is moved
        const scene::Bounds bounds = scene::bounds_of(file.scene_);
        stage = scene::prepare_scene(std::move(file.scene_), file.file_, options);
        if (settings.turntable && settings.frames)
            stage.camera = picture::Turn(stage.camera, bounds, settings).camera(settings.frames->first);
        for (const std::string& remark : stage.remarks) write_remark(remark);
        picture::remark_on_estimator(settings, stage);
    }
    ~Staged() { file_.scene_ = std::move(stage.scene); }
    Staged(const Staged&) = delete;
    Staged& operator=(const Staged&) = delete;

    scene::RenderScene stage;

private:
    SceneFile& file_;
};

SceneFile::SceneFile(const std::string& file, const RenderSettings& settings)
    : file_(file),
      number_(++file_count),
      scene_index_(settings.scene_index),
      asset_(file, {settings.scene_index, settings.variant, settings.is_strict}),
      scene_(asset_.rest_pose()),
      contents_(asset_.contents()),
      origin_(scene_.origin) {}

SceneFile::~SceneFile() {
    if (!gpu_) return;
    const std::shared_ptr<OnGpu> last = std::move(gpu_); // std::function is copied
    GlThread::only().discard([last] {});
}

std::vector<int> SceneFile::light_numbers() const {
    // The lights of a node come one after the other, and all or none of them are shown.
    std::vector<int> numbers;
    auto from = contents_.light_nodes.begin();
    int last = -1;
    for (const int node : asset_.light_nodes()) {
        if (node != last) from = contents_.light_nodes.begin();
        const auto found = std::find(from, contents_.light_nodes.end(), node);
        const bool is_known = found != contents_.light_nodes.end();
        numbers.push_back(is_known ? static_cast<int>(found - contents_.light_nodes.begin()) : -1);
        from = is_known ? found + 1 : found;
        last = node;
    }
    return numbers;
}

SceneFile::OnGpu& SceneFile::upload(const RenderSettings& settings, const scene::RenderScene& stage) {
    if (gpu_ && gpu_->visibility == settings.visibility
        && gpu_->has_energy_compensation == settings.has_energy_compensation) {
        gpu_->scene.relight(stage.scene, stage.lights, 0, true);
    } else {
        gpu_.reset();
        gpu_.reset(
            new OnGpu{{stage.scene, stage.lights, settings.visibility, settings.has_energy_compensation},
                      settings.visibility,
                      settings.has_energy_compensation});
    }
    return *gpu_;
}

RenderedPicture SceneFile::render(RenderSettings settings, const SceneEdits& edits, Call& call) {
    PhaseTimes times;
    settings.scene = file_;
    picture::check(settings);
    gl::Context& context = GlThread::only().context(settings.backend, settings.gl_debug);
    times.end("start");
    const Staged staged(*this, settings, edits);
    const scene::RenderScene& stage = staged.stage;
    const settings::Size size = settings.size.value_or(picture::picture_size(stage.camera.aspect_ratio()));
    times.end("stage");
    OnGpu& gpu = upload(settings, stage);
    glFinish();
    times.end("upload");
    const render::RenderOptions options = picture::render_options(settings, size);
    std::shared_ptr<render::ShaderLibrary> programs;
    if (settings.shaders.empty()) {
        auto& known = gpu.programs[{options.estimator, options.analytic_points}];
        if (!known) known = render::Renderer::programs(options);
        programs = known;
    }
    render::Renderer renderer(gpu.scene, stage.camera, options, std::move(programs));
    renderer.compile();
    times.end("compile");
    const picture::Work work{settings,
                             stage,
                             gpu.scene,
                             options,
                             renderer,
                             call.stop(),
                             [&](const std::string& what, double share, const std::string& state) {
                                 call.tell(what, share, state);
                             },
                             times};
    RenderedPicture rendered{picture::draw(work), settings, {}};
    context.require_silence();
    picture::remark_on(rendered.picture.film, settings, stage);
    picture::remark_on_error(rendered.picture, settings);
    picture::describe(rendered.picture, settings, stage, context.info());
    rendered.summary = picture::summary_of(work, context, rendered.picture)
                           .dump(-1, ' ', false, nlohmann::ordered_json::error_handler_t::replace);
    return rendered;
}

std::optional<ProbedPicture> SceneFile::probe(RenderSettings settings, const SceneEdits& edits, int column,
                                              int row, Call& call) {
    settings.scene = file_;
    gl::Context& context = GlThread::only().context(settings.backend, settings.gl_debug);
    const Staged staged(*this, settings, edits);
    const scene::RenderScene& stage = staged.stage;
    const settings::Size size = settings.size.value_or(picture::picture_size(stage.camera.aspect_ratio()));
    if (column < 0 || row < 0 || column >= size.width || row >= size.height)
        throw settings::BadSetting("pixel", fmt::format("{}, {} is outside the picture of {}x{}", column, row,
                                                        size.width, size.height));
    OnGpu& gpu = upload(settings, stage);
    auto terms = render::probe(gpu.scene, stage.camera, picture::render_options(settings, size), column, row,
                               call.stop());
    context.require_silence();
    if (!terms) return std::nullopt;
    if (terms->coverage == 0.0f) write_remark("no surface covers this pixel: it shows the background");
    return ProbedPicture{*std::move(terms), stage.lights, stage.scene.origin, size, stage.camera.name};
}

scene::Camera SceneFile::camera(const std::string& camera, const SceneEdits& edits) {
    RenderSettings settings;
    settings.camera = camera;
    asset_.evaluate_into(scene_, {});
    apply(edits, scene_, light_numbers(), true);
    return scene::chosen_camera(scene_, file_, picture::prepare_options(settings, std::nullopt));
}

void SceneFile::save(const std::string& target, const SceneEdits& edits, const std::string& camera) {
    std::error_code ignored;
    if (fs::equivalent(target, file_, ignored))
        throw Error({target}, "is the file of the scene, which edits start from",
                    "give the copy another name");
    gltf::Edits written = file_edits(edits, contents_, scene_.units, file_);
    if (!camera.empty()) written.first_camera = this->camera(camera, edits);
    written.scene_index = scene_index_;
    written.origin = origin_;
    for (const std::string& remark : gltf::write_edited_copy(asset_.source(), written, target))
        write_remark(remark);
}

} // namespace sr::python
