#include "image/codec.hpp"

#include "core/error.hpp"

#include <dlfcn.h>

namespace sr::image {
namespace {

const Codec& open_module() {
    // By its bare name: the executable's run path says where, which is beside itself. Lazy and local, since
    // most of the symbols behind it are never used and none is anybody else's business.
    void* module = dlopen(STERADIAN_IMAGE_MODULE, RTLD_LAZY | RTLD_LOCAL);
    void* entry = module ? dlsym(module, codec_entry_name) : nullptr;
    if (!entry) {
        const char* reason = dlerror();
        throw Error({STERADIAN_IMAGE_MODULE}, reason ? reason : "the module does not load",
                    "keep it beside the program, and OpenImageIO installed");
    }
    return *reinterpret_cast<CodecEntry>(entry)();
}

} // namespace

const Codec& codec() {
    static const Codec& opened = open_module();
    return opened;
}

} // namespace sr::image
