#pragma once
// The picture beside another: one that was kept, or an EXR. Other estimators, visibilities and shaders are
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
    /// Uploads it; fewer than three channels count as grey.
    Reference(std::string name, image::Image film);

    const std::string& name() const { return name_; }
    const image::Image& film() const { return film_; }
    FilmSum sum() const { return {&texture_, 1, film_.width, film_.height}; }

private:
    std::string name_;
    image::Image film_;
    gl::Texture texture_;
};

/// HDR-ꟻLIP of the two, as a film whose red says how different a person sees them, 0..1; with its mean.
/// @throws Error if their sizes differ
struct FlipMap {
    image::Image film;
    double mean = 0.0;
};
FlipMap flip_of(const image::Image& film, const image::Image& reference);

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
