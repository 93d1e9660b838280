#pragma once
// The film in the window: shaders/display/screen.frag.
#include "core/math.hpp"
#include "gl/object.hpp"
#include "gl/program.hpp"
#include "image/colormap.hpp"
#include "image/display.hpp"

#include <map>
#include <optional>
#include <tuple>

namespace sr::viewer {

enum class Comparison { none, wipe, difference, flip };

/// What the screen shows of a film, and how.
struct Look {
    float ev100 = 0.0f;
    image::ToneCurve curve = image::ToneCurve::neutral;
    bool is_false_color = false;
    image::Decades decades; // of the false colours
    Comparison comparison = Comparison::none;
    float wipe = 0.5f; // where the other picture begins, 0 to 1
};

/// A film as a sum of samples.
struct FilmSum {
    const gl::Texture* sum = nullptr;
    int samples = 1;
    int width = 0;
    int height = 0;
    /// 1 / the samples of each pixel that rests, 0 for the others; null: none rests.
    const gl::Texture* rest_weights = nullptr;
    bool is_displayed =
        false; // the light of a screen, 0 to 1, instead of a scene's: it goes through no curve
};

class Screen {
public:
    /// Covers the window, whose framebuffer is width × height pixels. A film of another size that is not
    /// compared is enlarged as code values, which costs a third of doing it in linear light.
    void draw(const FilmSum& film, const FilmSum& other, const Look& look, int width, int height);

private:
    /// Which constants a program has: curve, false colour, comparison, whether films are scaled, and whether
    /// the other one is displayed, and whether pixels rest.
    using Choice = std::tuple<image::ToneCurve, bool, Comparison, bool, bool, bool>;
    const gl::Program& program(const Choice& choice);
    void cover(const FilmSum& film, const FilmSum& other, const Look& look, int width, int height);

    /// Code values of a film's size.
    struct Codes {
        Codes(int width, int height);

        int width;
        int height;
        gl::Texture texture{GL_TEXTURE_2D, "code values"};
        gl::Framebuffer framebuffer{"code values"};
    };

    /// Of the embedded shaders: overlays change the equation, not the screen.
    std::map<Choice, gl::Program> programs_;
    gl::VertexArray no_vertices_{"no vertices"};
    std::optional<Codes> codes_;
};

} // namespace sr::viewer
