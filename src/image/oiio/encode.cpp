// Images to the bytes of a file. OpenImageIO writes into memory: the disk and its errors are whole_file.hpp's
// business.
#include "core/error.hpp"
#include "core/text.hpp"
#include "image/oiio/codec_functions.hpp"

#include <OpenImageIO/filesystem.h>
#include <OpenImageIO/imageio.h>
#include <algorithm>
#include <fmt/format.h>

namespace sr::image::oiio {
namespace {

/// RGB alone, since the formats hold nothing else; one or two channels count as grey.
Image as_rgb(const Image& image) {
    Image rgb(image.width, image.height, 3);
    const std::size_t step = static_cast<std::size_t>(image.channels);
    const float* from = image.pixels.data();
    for (std::size_t i = 0; i < rgb.pixels.size(); i += 3, from += step)
        for (std::size_t c = 0; c < 3; ++c) rgb.pixels[i + c] = from[step >= 3 ? c : 0];
    return rgb;
}

OIIO::ImageSpec spec_of(const Image& image, bool is_jpeg) {
    using OIIO::TypeDesc;
    OIIO::ImageSpec spec(image.width, image.height, image.channels,
                         is_jpeg ? TypeDesc::UINT8 : TypeDesc::FLOAT);
    for (const Attribute& attribute : image.attributes) spec.attribute(attribute.name, attribute.value);
    spec.attribute("oiio:ColorSpace", is_jpeg ? "sRGB" : "Linear");
    spec.attribute("DateTime", ""); // or OpenImageIO writes the time of day, and no two files are the same
    if (is_jpeg) {                  // the level was measured, see README.md
        spec.attribute("Compression", "jpeg:95");
        spec.attribute("jpeg:subsampling", "4:4:4");
    }
    return spec;
}

} // namespace

std::vector<std::uint8_t> encode(const Image& given, Format format, const std::string& name) {
    const Location where{name};
    if (given.channels != 3) return encode(as_rgb(given), format, name);

    const bool is_jpeg = format == Format::jpeg;
    const char* const writer = is_jpeg ? "jpeg" : "hdr";
    std::vector<unsigned char> bytes;
    OIIO::Filesystem::IOVecOutput memory(bytes);
    const auto output = OIIO::ImageOutput::create(writer);
    if (!output || !output->supports("ioproxy"))
        throw Error(where, fmt::format("this OpenImageIO cannot write {}", writer),
                    "install one that can, or choose another format");
    output->set_ioproxy(&memory);
    bool is_done = output->open(name, spec_of(given, is_jpeg));
    if (is_done) {
        is_done = is_jpeg ? output->write_image(OIIO::TypeDesc::UINT8, as_bytes(given.pixels).data())
                          : output->write_image(OIIO::TypeDesc::FLOAT, given.pixels.data());
        is_done = output->close() && is_done;
    }
    if (!is_done)
        throw Error(where, fmt::format("cannot be encoded ({})", one_line(output->geterror())),
                    "write it in another format");
    return bytes;
}

} // namespace sr::image::oiio
