#pragma once
// Pixels panel: a loupe, statistics with a histogram, pinned pixels; and numbers in enlarged pixels.
#include "viewer/document/pixel_statistics.hpp"
#include "viewer/keymap.hpp"
#include "viewer/ui.hpp"
#include "viewer/view/presenter.hpp"

#include <optional>
#include <string>
#include <vector>

namespace sr::viewer {

/// A film with its values, as they are shown.
struct ShownFilm {
    image::Image numbers; // of the view that is shown, or radiance
    std::string source;   // whose numbers they are: "the render", "picture A"
    std::string unit;     // of `numbers`
    const DisplaySettings& display;
    Area shown;         // area of the window that shows it or a part of it
    Area picture;       // area that the whole film has
    float scale = 1.0f; // of a HiDPI screen

    /// The pixel at a place of the window; absent if none is shown there.
    std::optional<glm::ivec2> pixel_at(vec2 at) const;
    /// The area of a pixel in the window.
    Area area_of(glm::ivec2 pixel) const;
};

/// Choices of a person in the panel.
struct PixelsOutcome {
    std::optional<std::size_t> unpinned; // index of a pinned pixel
    bool drops_rectangle = false;
    bool closes = false;
};

/// Draws the panel. `rectangle`: that the statistics are of; absent: the whole film.
PixelsOutcome draw_pixels_panel(const ShownFilm& film, const std::optional<PixelRectangle>& rectangle,
                                const PixelStatistics& statistics, const std::vector<glm::ivec2>& pinned,
                                const std::optional<glm::ivec2>& pointed, const std::optional<Area>& area,
                                const Ui& ui, const Keymap& keys);

/// Draws red, green and blue into the pixels that are large enough for that.
void draw_pixel_numbers(const ShownFilm& film);

/// Draws marks of pinned pixels and the rectangle's edges over the picture.
void draw_pixel_marks(const ShownFilm& film, const std::optional<PixelRectangle>& rectangle,
                      const std::vector<glm::ivec2>& pinned);

} // namespace sr::viewer
