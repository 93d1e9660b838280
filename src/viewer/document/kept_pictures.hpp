#pragma once
// Pictures that are kept to be compared: renders and files, each with a letter.
#include "image/image.hpp"
#include "viewer/view/presenter.hpp"

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace sr::viewer {

/// A picture to compare with: a render that was kept, or a file.
class Reference {
public:
    /// Uploads `film`, which has at least three channels.
    /// `camera`: as `render --camera` takes it; empty if unknown.
    Reference(std::string name, image::Image film, std::string camera = {}, bool is_display_referred = false);

    const std::string& name() const { return name_; }
    void rename(std::string name) { name_ = std::move(name); }
    const image::Image& film() const { return film_; }
    const std::string& camera() const { return camera_; }
    bool is_display_referred() const { return is_display_referred_; }
    FilmSum sum() const { return {&texture_, 1, film_.width, film_.height, nullptr, is_display_referred_}; }

private:
    std::string name_;
    image::Image film_;
    std::string camera_;
    bool is_display_referred_; // linear light of a screen, 0 to 1
    gl::Texture texture_;
};

/// A picture keeps its letter until it is removed.
struct KeptPicture {
    char letter = 'A';
    Reference picture;
};

/// Up to eight pictures. One of them is the reference; one can be shown in place of the render, so that any
/// two are compared.
class KeptPictures {
public:
    static constexpr std::size_t most = 8;

    const std::vector<KeptPicture>& all() const { return all_; }
    bool is_full() const { return all_.size() == most; }
    /// Keeps one more, by the first letter that is free, as the reference. There is room for it.
    /// @return its letter
    char keep(Reference picture);
    void remove(std::size_t index);
    void rename(std::size_t index, std::string name) { all_[index].picture.rename(std::move(name)); }

    /// Index of the picture that is compared with; absent if none is kept.
    std::optional<std::size_t> reference_index() const { return reference_; }
    const KeptPicture* reference() const { return reference_ ? &all_[*reference_] : nullptr; }
    void compare_with(std::size_t index) { reference_ = index; }

    /// Index of the picture that is shown; absent: the render.
    std::optional<std::size_t> shown_index() const { return shown_; }
    const KeptPicture* shown() const { return shown_ ? &all_[*shown_] : nullptr; }
    void show(std::optional<std::size_t> index) { shown_ = index; }
    /// Shows the next one, and after the last one the render.
    void show_next();

private:
    std::vector<KeptPicture> all_; // in the order of their letters
    std::optional<std::size_t> reference_;
    std::optional<std::size_t> shown_;
};

} // namespace sr::viewer
