#include "image/codec.hpp"

#include "core/error.hpp"
#include "core/parallel.hpp"
#include "core/program.hpp"

#include <dlfcn.h>

namespace sr::image {
namespace {

namespace fs = std::filesystem;

/// Beside the program in a build folder, in the library folder once installed.
fs::path module_file() {
    const fs::path folder = program_file().parent_path(), beside = folder / STERADIAN_IMAGE_MODULE;
    const fs::path installed = folder / STERADIAN_MODULES_FROM_BIN / STERADIAN_IMAGE_MODULE;
    std::error_code ignored;
    return fs::exists(beside, ignored) ? beside : installed.lexically_normal();
}

const Codec& open_module() {
    require_threads();
    const fs::path file = module_file();
    // Lazy and local: most of the symbols behind it are never used, and none is anybody else's business.
    void* module = dlopen(file.c_str(), RTLD_LAZY | RTLD_LOCAL);
    void* entry = module ? dlsym(module, codec_entry_name) : nullptr;
    if (!entry) {
        const char* reason = dlerror();
        throw Error({file.string()}, reason ? reason : "the module does not load",
                    "install Steradian and OpenImageIO again");
    }
    return *reinterpret_cast<CodecEntry>(entry)();
}

} // namespace

const Codec& codec() {
    static const Codec& opened = open_module();
    return opened;
}

} // namespace sr::image
