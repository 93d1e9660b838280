#pragma once
// The picture beside another: one that was kept, or a file. Other estimators, visibilities and shaders are
// compared by keeping a picture and then changing them.
#include "image/image.hpp"
#include "render/occluders.hpp"
#include "render/renderer.hpp"
#include "viewer/screen.hpp"

#include <string>

namespace sr::viewer {

/// What the picture is compared with.
class Reference {
public:
    /// Uploads it. `film` has three channels at least.
    Reference(std::string name, image::Image film, bool is_displayed = false);

    const std::string& name() const { return name_; }
    const image::Image& film() const { return film_; }
    bool is_displayed() const { return is_displayed_; }
    FilmSum sum() const { return {&texture_, 1, film_.width, film_.height, nullptr, is_displayed_}; }

private:
    std::string name_;
    image::Image film_;
    bool is_displayed_; // a picture for screens: linear light of one, 0 to 1
    gl::Texture texture_;
};

/// Reads a picture to compare with: radiance from EXR and HDR, the light of a screen from PNG and JPEG.
/// @throws Error if it cannot be read, or has another ending
Reference read_reference(const std::string& file);
/// Whether the name ends like a picture that read_reference() takes.
bool is_picture(const std::string& file);

/// HDR-ꟻLIP of the two, as a film whose red says how different a person sees them, 0..1; with its mean.
/// @throws Error if their sizes differ
struct FlipMap {
    image::Image film;
    double mean = 0.0;
};
FlipMap flip_of(const image::Image& film, const image::Image& reference);
/// ꟻLIP of what a screen shows of `film` and a picture for screens, in linear light. @throws Error likewise
FlipMap flip_of_displayed(const image::Image& film, const Look& look, const image::Image& reference);

/// What a person wants of the comparison.
struct CompareWish {
    bool keeps = false; // this picture is what others are compared with
    bool loads = false; // an EXR
    bool wants_flip = false;
    std::optional<render::Estimator> estimator;
    std::optional<render::Visibility> visibility;
};
CompareWish compare_panel(Look& look, const Reference* reference, const std::string& flip_result,
                          render::Estimator estimator, render::Visibility visibility);

} // namespace sr::viewer
