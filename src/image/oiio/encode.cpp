// Images to the bytes of a .hdr. OpenImageIO writes into memory: the disk and its errors are whole_file.hpp's
// business.
#include "core/error.hpp"
#include "core/text.hpp"
#include "image/oiio/codec_functions.hpp"

#include <OpenImageIO/filesystem.h>
#include <OpenImageIO/imageio.h>
#include <fmt/format.h>

namespace sr::image::oiio {
namespace {

OIIO::ImageSpec spec_of(const Image& image) {
    OIIO::ImageSpec spec(image.width, image.height, image.channels, OIIO::TypeDesc::FLOAT);
    spec.attribute("oiio:ColorSpace", "Linear");
    spec.attribute("DateTime", ""); // or OpenImageIO writes the time of day, and no two files are the same
    return spec;
}

} // namespace

std::vector<std::uint8_t> encode_hdr(const Image& image, const std::string& name) {
    const Location where{name};
    const Image rgb = as_rgb(image); // the format holds nothing else
    std::vector<unsigned char> bytes;
    OIIO::Filesystem::IOVecOutput memory(bytes);
    const auto output = OIIO::ImageOutput::create("hdr");
    if (!output || !output->supports("ioproxy"))
        throw Error(where, "this OpenImageIO cannot write hdr",
                    "install one that can, or choose another format");
    output->set_ioproxy(&memory);
    bool is_done = output->open(name, spec_of(rgb));
    if (is_done) {
        is_done = output->write_image(OIIO::TypeDesc::FLOAT, rgb.pixels.data());
        is_done = output->close() && is_done;
    }
    if (!is_done)
        throw Error(where, fmt::format("cannot be encoded ({})", one_line(output->geterror())),
                    "write it in another format");
    return bytes;
}

} // namespace sr::image::oiio
