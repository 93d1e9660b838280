#pragma once
// Presenter of a film in the window (shaders/display/screen.frag).
#include "core/math.hpp"
#include "gl/object.hpp"
#include "gl/program.hpp"
#include "image/colormap.hpp"
#include "image/display.hpp"
#include "output/variables.hpp"

#include <map>
#include <optional>
#include <string>
#include <tuple>

namespace sr::viewer {

enum class ComparisonMode { none, wipe, difference, flip };

/// A part of the picture, enlarged.
struct PixelZoom {
    int factor = 1;     // side of a pixel of the film in the window [pixels]
    glm::ivec2 from{0}; // the first pixel of the film that is seen, from its upper left
    glm::ivec2 size{1}; // of the whole film

    bool operator==(const PixelZoom&) const = default;
};

/// How a film is shown.
struct DisplaySettings {
    float ev100 = 0.0f;
    const image::ToneCurve* curve = &image::default_tone_curve();
    const output::Variable* view = nullptr; // what the film holds; null: radiance
    image::Decades decades;                 // of Display::false_color
    ComparisonMode comparison = ComparisonMode::none;
    float wipe = 0.5f; // where the reference begins, 0 to 1
    PixelZoom zoom;
};

/// Returns the GLSL constants of a view for shaders/display/view.glsl. Null: radiance.
std::string view_glsl(const output::Variable* view);

/// A film as a sum of samples.
struct FilmSum {
    const gl::Texture* sum = nullptr;
    int samples = 1;
    int width = 0;
    int height = 0;
    /// 1 / samples of each frozen (converged) pixel, 0 for the others, in GL's order of rows; null if none is
    /// frozen.
    const gl::Texture* frozen_weights = nullptr;
    bool is_display_referred = false; // linear light of a screen, 0 to 1: no exposure and no tone curve apply
};

/// Rectangle of a framebuffer, from its lower left [pixels].
struct ScreenRectangle {
    int x = 0;
    int y = 0;
    int width = 0;
    int height = 0;
};

class Presenter {
public:
    /// Fills a rectangle of the window. A film of another size that is not compared is scaled as code values,
    /// which costs a third of scaling in linear light.
    void draw(const FilmSum& film, const FilmSum& reference, const DisplaySettings& settings,
              const ScreenRectangle& place);

private:
    /// Constants of a program: curve, view, comparison, whether films are scaled, whether the film and the
    /// reference are display-referred, whether pixels are frozen.
    using Choice =
        std::tuple<const image::ToneCurve*, const output::Variable*, ComparisonMode, bool, bool, bool, bool>;
    const gl::Program& program(const Choice& choice);
    void fill(const FilmSum& film, const FilmSum& reference, const DisplaySettings& settings,
              const ScreenRectangle& place);

    /// Fills the framebuffer of code values.
    void fill_codes(const FilmSum& film, const FilmSum& reference, const DisplaySettings& settings);
    void enlarge(const FilmSum& film, const PixelZoom& zoom, const ScreenRectangle& place);

    /// Framebuffer of code values with the size of a film.
    struct Codes {
        Codes(int width, int height);

        int width;
        int height;
        gl::Texture texture{GL_TEXTURE_2D, "code values"};
        gl::Framebuffer framebuffer{"code values"};
    };

    /// Of the embedded shaders: overlays do not replace the display.
    std::map<Choice, gl::Program> programs_;
    gl::VertexArray no_vertices_{"no vertices"};
    std::optional<Codes> codes_;
};

} // namespace sr::viewer
