#include "core/error.hpp"
#include "core/text.hpp"
#include "image/oiio/codec_functions.hpp"

#include <OpenImageIO/imageio.h>
#include <algorithm>
#include <fmt/format.h>

namespace sr::image::oiio {
namespace {

/// Returns whether the pixels of the file (its data window) fill its display window.
bool fills_display_window(const OIIO::ImageSpec& spec) {
    return spec.x == spec.full_x && spec.y == spec.full_y && spec.width == spec.full_width
           && spec.height == spec.full_height;
}

/// The pixels of the display window. Where the data window leaves it empty they are 0; what lies outside of
/// it is not shown (OpenEXR, "Technical Introduction", overscan).
Image in_display_window(const Image& data, const OIIO::ImageSpec& spec) {
    Image image(spec.full_width, spec.full_height, data.channels);
    const int left = std::max(spec.x, spec.full_x);
    const int right = std::min(spec.x + spec.width, spec.full_x + spec.full_width);
    for (int y = 0; y < data.height; ++y) {
        const int row = spec.y + y - spec.full_y;
        if (row < 0 || row >= image.height || left >= right) continue;
        std::copy_n(data.at(left - spec.x, y).data(),
                    static_cast<std::size_t>(right - left) * static_cast<std::size_t>(data.channels),
                    image.at(left - spec.full_x, row).data());
    }
    return image;
}

/// Returns whether both windows are small enough to be held, and near enough to the origin to be counted
/// with.
bool is_of_sane_size(const OIIO::ImageSpec& spec, std::uint64_t max_values) {
    constexpr int farthest = 1 << 28;
    const auto is_near = [](int value) { return value > -farthest && value < farthest; };
    if (spec.width <= 0 || spec.height <= 0 || spec.nchannels <= 0 || spec.depth > 1 || spec.deep
        || spec.full_width <= 0 || spec.full_height <= 0 || !is_near(spec.x) || !is_near(spec.y)
        || !is_near(spec.full_x) || !is_near(spec.full_y) || !is_near(spec.width) || !is_near(spec.height)
        || !is_near(spec.full_width) || !is_near(spec.full_height))
        return false;
    const auto channels = static_cast<std::uint64_t>(spec.nchannels);
    const std::uint64_t shown =
        static_cast<std::uint64_t>(spec.full_width) * static_cast<std::uint64_t>(spec.full_height);
    const std::uint64_t most = max_values / channels;
    return spec.image_pixels() <= most && shown <= most;
}

} // namespace

Image read(const std::filesystem::path& file, std::uint64_t max_values) {
    const Location where{file.string()};
    OIIO::ImageSpec config;
    config.attribute("oiio:UnassociatedAlpha", 1); // values as stored
    const auto input = OIIO::ImageInput::open(file.string(), &config);
    if (!input)
        throw Error(where, fmt::format("not a readable image ({})", one_line(OIIO::geterror())),
                    "check that it is an image and that it is whole");
    const OIIO::ImageSpec& spec = input->spec();
    if (!is_of_sane_size(spec, max_values))
        throw Error(where,
                    fmt::format("cannot take {} x {} pixels of {} channels{}", spec.width, spec.height,
                                spec.nchannels, spec.deep ? ", deep" : ""),
                    "use a flat image of an ordinary size, or allow more numbers with --limit pixels=N");
    Image image(spec.width, spec.height, spec.nchannels);
    image.channel_names = spec.channelnames;
    if (spec.format == OIIO::TypeDesc::UINT8) image.attributes.push_back({"steradian:integer_bits", "8"});
    if (spec.format == OIIO::TypeDesc::UINT16) image.attributes.push_back({"steradian:integer_bits", "16"});
    // Attributes of other types describe the format (screen window, pixel aspect), and could not be written
    // as text.
    for (const OIIO::ParamValue& attribute : spec.extra_attribs)
        if (attribute.type() == OIIO::TypeDesc::STRING)
            image.attributes.push_back({attribute.name().string(), attribute.get_string()});
    if (!input->read_image(0, 0, 0, spec.nchannels, OIIO::TypeDesc::FLOAT, image.pixels.data()))
        throw Error(where, fmt::format("a broken image ({})", one_line(input->geterror())), "make it again");
    if (fills_display_window(spec)) return image;
    Image shown = in_display_window(image, spec);
    shown.channel_names = std::move(image.channel_names);
    shown.attributes = std::move(image.attributes);
    return shown;
}

} // namespace sr::image::oiio
