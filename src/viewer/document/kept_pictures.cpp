#include "viewer/document/kept_pictures.hpp"

#include <algorithm>
#include <utility>

namespace sr::viewer {
namespace {

gl::Texture reference_texture(const image::Image& film) {
    std::vector<vec4> texels(static_cast<std::size_t>(film.width) * static_cast<std::size_t>(film.height));
    for (int y = 0; y < film.height; ++y)
        for (int x = 0; x < film.width; ++x) {
            const auto pixel = film.at(x, y);
            const vec3 rgb(pixel[0], pixel[1], pixel[2]);
            // GL's first row is the lowest.
            texels[static_cast<std::size_t>(film.height - 1 - y) * static_cast<std::size_t>(film.width)
                   + static_cast<std::size_t>(x)] = vec4(rgb, pixel.size() > 3 ? pixel[3] : 1.0f);
        }
    gl::Texture texture(GL_TEXTURE_2D, "reference");
    glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA32F, film.width, film.height, 0, GL_RGBA, GL_FLOAT, texels.data());
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAX_LEVEL, 0);
    return texture;
}

/// The index after one entry was removed; absent if it was that one.
std::optional<std::size_t> without(std::optional<std::size_t> index, std::size_t removed) {
    if (!index || *index == removed) return std::nullopt;
    return *index > removed ? *index - 1 : *index;
}

} // namespace

Reference::Reference(std::string name, image::Image film, std::string camera, bool is_display_referred)
    : name_(std::move(name)),
      film_(std::move(film)),
      camera_(std::move(camera)),
      is_display_referred_(is_display_referred),
      texture_(reference_texture(film_)) {}

char KeptPictures::keep(Reference picture) {
    char letter = 'A';
    std::size_t at = 0;
    for (; at < all_.size() && all_[at].letter == letter; ++at) ++letter;
    all_.insert(all_.begin() + static_cast<std::ptrdiff_t>(at), {letter, std::move(picture)});
    if (shown_ && *shown_ >= at) ++*shown_;
    reference_ = at;
    return letter;
}

void KeptPictures::remove(std::size_t index) {
    all_.erase(all_.begin() + static_cast<std::ptrdiff_t>(index));
    shown_ = without(shown_, index);
    reference_ = without(reference_, index);
    if (!reference_ && !all_.empty()) reference_ = std::min(index, all_.size() - 1);
}

void KeptPictures::show_next() {
    const std::size_t next = shown_ ? *shown_ + 1 : 0;
    shown_ = next < all_.size() ? std::optional(next) : std::nullopt;
}

} // namespace sr::viewer
