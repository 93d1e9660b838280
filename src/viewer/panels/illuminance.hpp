#pragma once
// Illuminance panel: the plane and its cells, a plan with isolines, a table of the figures; and isolines over
// the picture.
#include "output/isolines.hpp"
#include "picture/illuminance.hpp"
#include "viewer/ui.hpp"
#include "viewer/view/projection.hpp"

#include <array>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace sr::viewer {

/// The numbers of a plane, ready to be drawn.
struct MeasuredIlluminance {
    MeasuredIlluminance(output::IlluminanceGrid measured, int count);

    output::IlluminanceGrid grid;
    output::IlluminanceSummary summary;
    std::vector<output::NamedGrid> parts;                                  // by light, once they are measured
    std::vector<std::pair<double, std::vector<output::Isoline>>> isolines; // by level
    int samples;                                                           // of each cell

    /// Place of a point in cells, of which (0, 0) is the centre of the first one, from 0 to 1 along the
    /// edges.
    vec2 place_of(vec2 cell) const;
    /// The cell at a place from 0 to 1 along the edges of the receiver; absent outside.
    std::optional<output::GridPlace> cell_at(vec2 place) const;
    /// The cell where a ray meets the plane; absent where it does not.
    std::optional<output::GridPlace> cell_on(const PickRay& ray) const;
    vec3 color(double E) const; // as code values, on a linear scale from 0 to the maximum
};

/// Choices of a person, which the panel edits.
struct IlluminanceChoice {
    picture::ReceiverChoice receiver;
    std::array<char, 96> plane{};       // as it is typed; empty: horizontal
    int cells = picture::default_cells; // along the longer edge
    bool has_parts = false;             // E by light
    bool is_over_picture = true;        // isolines
};

struct IlluminanceOutcome {
    bool measures_again = false;
    bool redraws = false;
    bool writes_csv = false;
    bool writes_plan = false;
    bool closes = false;
};

class IlluminancePanel {
public:
    /// Draws the panel. `measured`: null before the first samples. `problem`: empty if there is none.
    /// `pointed`: the cell under the pointer in the picture.
    IlluminanceOutcome draw(IlluminanceChoice& choice, const MeasuredIlluminance* measured,
                            const std::string& progress, const std::string& problem,
                            std::optional<output::GridPlace> pointed, const std::optional<Area>& area,
                            const Ui& ui);
    /// Is told that the numbers are others.
    void measured_again() { map_.reset(); }

private:
    void draw_choice(IlluminanceChoice& choice, IlluminanceOutcome& outcome);
    std::optional<output::GridPlace> draw_map(const MeasuredIlluminance& measured);
    void upload(const MeasuredIlluminance& measured);

    std::optional<gl::Texture> map_; // a texel a cell
};

/// Draws the edges of the plane and its isolines over the picture, faint where `hides` says that a surface
/// lies before them.
void draw_isolines(const MeasuredIlluminance& measured, const Projection& projection, float scale,
                   const std::function<bool(vec3 point)>& hides);

} // namespace sr::viewer
