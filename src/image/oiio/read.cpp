#include "core/error.hpp"
#include "image/oiio/codec_functions.hpp"

#include <OpenImageIO/imageio.h>
#include <fmt/format.h>

namespace sr::image::oiio {
namespace {

// 4 GiB of floats: more than any image we make, less than what a broken header asks for.
constexpr std::uint64_t max_samples = 1ull << 30;

} // namespace

Image read(const std::filesystem::path& file) {
    const Location where{file.string()};
    OIIO::ImageSpec config;
    config.attribute("oiio:UnassociatedAlpha", 1); // values as stored
    const auto input = OIIO::ImageInput::open(file.string(), &config);
    if (!input)
        throw Error(where, fmt::format("not a readable image ({})", one_line(OIIO::geterror())),
                    "check that it is an image and that it is whole");
    const OIIO::ImageSpec& spec = input->spec();
    if (spec.width <= 0 || spec.height <= 0 || spec.nchannels <= 0 || spec.deep
        || spec.image_pixels() > max_samples / static_cast<std::uint64_t>(spec.nchannels))
        throw Error(where,
                    fmt::format("cannot take {} x {} pixels of {} channels{}", spec.width, spec.height,
                                spec.nchannels, spec.deep ? ", deep" : ""),
                    "use a flat image of an ordinary size");
    Image image(spec.width, spec.height, spec.nchannels);
    image.channel_names = spec.channelnames;
    // Attributes of other types describe the format (screen window, pixel aspect), and could not be written
    // as text.
    for (const OIIO::ParamValue& attribute : spec.extra_attribs)
        if (attribute.type() == OIIO::TypeDesc::STRING)
            image.attributes.push_back({attribute.name().string(), attribute.get_string()});
    if (!input->read_image(0, 0, 0, spec.nchannels, OIIO::TypeDesc::FLOAT, image.pixels.data()))
        throw Error(where, fmt::format("a broken image ({})", one_line(input->geterror())), "make it again");
    return image;
}

} // namespace sr::image::oiio
