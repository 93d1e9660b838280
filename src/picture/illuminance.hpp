#pragma once
// Illuminance on a receiver in a scene: the plane that a person states, its cells, and the samples that
// measure them.
#include "output/illuminance.hpp"
#include "output/illuminance_plan.hpp"
#include "render/renderer.hpp"
#include "scene/prepare.hpp"
#include "settings/render_settings.hpp"

#include <optional>
#include <string>
#include <vector>

namespace sr::picture {

inline constexpr int default_cells = 64;       // along the longer edge of a receiver
inline constexpr int max_cells = 4096;         // along an edge: the size of a picture that every driver takes
inline constexpr int illuminance_samples = 64; // of a cell, which is one pixel, so that they cost little
inline constexpr int isoline_count = 10;       // at most, where a person states no levels

/// A corner and two perpendicular edges in the file's world [m].
struct StatedPlane {
    glm::dvec3 corner{0.0};
    vec3 u{0.0f};
    vec3 v{0.0f};
};

/// Reads "X,Y,Z;UX,UY,UZ;VX,VY,VZ". @throws Error that says what is wrong
StatedPlane parse_plane(const std::string& text);

/// The receiver that a person chooses.
struct ReceiverChoice {
    std::optional<StatedPlane> plane; // absent: horizontal, as wide and deep as the scene, lit from above
    double height = 0.8;              // of the horizontal one above the scene's lowest point [m]
    double border = 0.0;              // strip that is left out along all edges [m]
};

/// The receiver in the coordinates of the scene. `file`: for messages. @throws Error if it has no area
scene::Receiver receiver_of(const ReceiverChoice& choice, const scene::Scene& scene, const std::string& file);

/// Columns and rows whose sides are at most `spacing` [m]; absent: default_cells along the longer edge.
/// @throws Error if they are more than max_cells
settings::Size cells_of(const scene::Receiver& receiver, std::optional<double> spacing);

/// Lamps with a place, seen along the receiver's normal.
std::vector<output::PlanMark> marks_of(const std::vector<scene::Light>& lights,
                                       const scene::Receiver& receiver);

/// A plan with isolines (output::plan_svg); `levels`: empty for round ones.
std::string plan_of(const output::IlluminanceGrid& grid, std::vector<double> levels,
                    const std::vector<scene::Light>& lights, const std::string& file);

/// Render of a receiver's cells, sample by sample.
class IlluminanceRender {
public:
    /// Puts the receiver into the scene, and uploads that. `rendering`: visibility and the like of the
    /// picture; its size is that of the cells. Needs a current context for as long as it lives. @throws
    /// Error, ShaderError
    IlluminanceRender(scene::RenderScene stage, const scene::Receiver& receiver,
                      const settings::RenderSettings& settings, const render::RenderOptions& rendering);
    IlluminanceRender(const IlluminanceRender&) = delete;
    IlluminanceRender& operator=(const IlluminanceRender&) = delete;

    /// Starts over with the lights [first, end).
    void begin(int first, int end);
    void begin() { begin(0, light_count()); }
    /// Renders the next `count` rows of a sample. @return whether the sample is complete
    bool add_rows(int count) { return renderer_.add_rows(count); }
    void add_sample() { renderer_.add_sample(); }
    int sample_count() const { return renderer_.sample_count(); }
    int rows() const { return renderer_.height(); }

    int light_count() const { return gpu_.light_count(); }
    const std::vector<scene::Light>& lights() const { return stage_.lights; }
    /// "light 3" for one without a name.
    std::string name_of_light(int index) const;

    /// E of the samples so far; at least one. @throws Error if a cell is not finite
    output::IlluminanceGrid grid() const;

private:
    scene::RenderScene stage_;
    scene::Receiver receiver_;
    scene::Camera camera_;
    render::GpuScene gpu_;
    render::Renderer renderer_;
};

} // namespace sr::picture
