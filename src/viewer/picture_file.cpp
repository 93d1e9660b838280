#include "viewer/picture_file.hpp"

#include "settings/provenance.hpp"

#include <utility>

namespace sr::viewer {

PictureFile picture_file(const Workspace& workspace, image::Image film, const FilmFacts& facts,
                         std::string file) {
    const output::Variable* const view = workspace.display.view;
    if (view) film = output::numbers_of(*view, film);
    film.channel_names = {"R", "G", "B", "A"};
    settings::RenderSettings settings = workspace.seen_settings();
    settings.stop = facts.rule;
    film.attributes = settings::attributes_of(
        settings,
        {.unit = output::unit_of(view, workspace.scene->stage().scene.units),
         .camera = facts.camera,
         .samples = {static_cast<double>(facts.samples), facts.samples, facts.samples},
         .error = facts.error,
         .stopped_by = facts.stopped_by,
         .light_choices = facts.light_choices},
        workspace.window.info());
    if (const auto alone = workspace.scene->alone())
        film.attributes.push_back(
            {"steradian:light_alone", workspace.scene->lights().entries()[*alone].name});
    return {std::move(film),
            std::move(file),
            {.ev100 = workspace.display.ev100, .tone_curve = workspace.display.curve, .view = view}};
}

scene::Camera camera_for(const Workspace& workspace, settings::Size size) {
    const auto ratio = static_cast<float>(size.width) / static_cast<float>(size.height);
    return workspace.camera->argument() == "auto" ? workspace.scene->framing_camera(ratio)
                                                  : workspace.camera->camera();
}

std::unique_ptr<PictureRender> begin_picture(const Workspace& workspace, const PictureRequest& wanted,
                                             const scene::Camera& camera) {
    const auto [width, height] = wanted.size;
    Options options = workspace.options;
    // A view has no error of its own.
    options.stop = {wanted.samples, std::nullopt, workspace.display.view ? std::nullopt : wanted.error};
    const double ratio =
        static_cast<double>(width) * height / (static_cast<double>(workspace.width) * workspace.height);
    return std::make_unique<PictureRender>(workspace.scene->gpu(), camera,
                                           viewer::render_options(options, width, height), options.stop,
                                           ratio * workspace.scene->render().seconds_per_sample());
}

PictureFile picture_file(const Workspace& workspace, const PictureRender& render, const std::string& camera,
                         std::string file) {
    const render::StopMonitor& monitor = render.monitor();
    return picture_file(workspace, render.read_film(),
                        {.rule = monitor.rule(),
                         .samples = render.samples(),
                         .error = monitor.error(),
                         .stopped_by = monitor.stopped_by(),
                         .light_choices = render.light_choices(),
                         .camera = camera},
                        std::move(file));
}

} // namespace sr::viewer
