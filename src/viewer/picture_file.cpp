#include "viewer/picture_file.hpp"

#include "settings/provenance.hpp"

#include <utility>

namespace sr::viewer {

PictureFile picture_file(const Workspace& workspace, image::Image film, const FilmFacts& facts,
                         std::string file) {
    const output::Variable* const view = workspace.display.view;
    if (view) film = output::numbers_of(*view, film);
    film.channel_names = {"R", "G", "B", "A"};
    settings::RenderSettings settings = workspace.options;
    settings.at = workspace.playback.seconds;
    settings.stop = facts.rule;
    settings.view = view;
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

} // namespace sr::viewer
