#include "image/image.hpp"

#include "core/error.hpp"

namespace sr::image {

Image::Image(int image_width, int image_height, int channel_count)
    : width(image_width), height(image_height), channels(channel_count) {
    require(width > 0 && height > 0 && channels > 0, "an image has a positive size");
    pixels.resize(offset(0, height));
}

} // namespace sr::image
