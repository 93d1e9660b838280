#pragma once
// Preview of a texture image, whole or one channel of it.
#include "gl/object.hpp"
#include "scene/material.hpp"

#include <optional>
#include <utility>

namespace sr::viewer {

class TexturePreview {
public:
    /// Draws the image as its texels are stored, as wide as the room, with buttons for its channels.
    /// `key`: the same for the same image of the same scene.
    void draw(const scene::TextureImage& image, std::pair<const void*, int> key, float max_height);

private:
    enum class Channel { all, red, green, blue, alpha };

    void upload(const scene::TextureImage& image);
    void choose(Channel channel);

    std::optional<gl::Texture> texture_;
    std::pair<const void*, int> key_{nullptr, -1};
    Channel channel_ = Channel::all;
};

} // namespace sr::viewer
