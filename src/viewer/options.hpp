#pragma once
// Options of the viewer.
#include "glsl/root.hpp"
#include "settings/render_settings.hpp"

#include <string>
#include <vector>

namespace sr::viewer {

/// A bundled scene that the first page offers.
struct SampleScene {
    std::string name;
    std::string what; // it shows
    std::string file;
};

/// `rendering` and `stop` are those of the converging render.
struct Options : settings::RenderSettings {
    std::optional<scene::EnvironmentLight> environment_light; // that `environment` names
    std::vector<SampleScene> samples;                         // of the first page, where `scene` is empty
    bool plays = false;                                       // from `at` or the beginning on
    bool is_reloading = false; // parts that the file has lost are remarks instead of errors
    // Of an assignment.
    std::string submission;                 // a student's folder; empty if there is no assignment
    std::filesystem::path program;          // steradian, which checks the folder
    std::vector<glsl::Root> reference_path; // the reference's shaders
    bool is_examined = false;               // shows the questions of `assignment tick`
    std::string changed_code;               // folder with a changed file of the student's; empty: none
    bool shows_reference = false;           // renders with `reference_path` instead of `shaders`
    bool is_fullscreen = false;
    bool has_inertia = false; // a view that is released in motion glides on
    bool is_verbose = false;  // messages go to stderr, too
};

} // namespace sr::viewer
