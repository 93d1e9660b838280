#include "image/oiio/codec_functions.hpp"

#include <OpenImageIO/imageio.h>

extern "C" __attribute__((visibility("default"))) const sr::image::Codec* steradian_image_codec() {
    namespace oiio = sr::image::oiio;
    static const sr::image::Codec codec{oiio::encode_hdr, oiio::read};
    // OpenImageIO finds its formats at the first use; that belongs to loading, too.
    static const std::string formats = OIIO::get_string_attribute("format_list");
    return &codec;
}
