#include "gltf/read/texture.hpp"

#include "core/error.hpp"
#include "core/limits.hpp"
#include "gltf/extensions.hpp"
#include "gltf/uri.hpp"
#include "gltf/warnings.hpp"
#include "image/file.hpp"
#include "image/texture_formats.hpp"

#include <algorithm>
#include <fmt/format.h>
#include <system_error>

namespace sr::gltf {
namespace {

// glTF 2.0 specification, section 5.26: OpenGL's numbers.
constexpr int nearest = 9728, linear = 9729, nearest_mipmap_nearest = 9984, linear_mipmap_nearest = 9985,
              nearest_mipmap_linear = 9986, clamp_to_edge = 33071, mirrored_repeat = 33648;

scene::Wrap wrap_of(int code) {
    if (code == clamp_to_edge) return scene::Wrap::clamp_to_edge;
    if (code == mirrored_repeat) return scene::Wrap::mirrored_repeat;
    return scene::Wrap::repeat;
}

scene::Sampler parse_sampler(const json& from) {
    scene::Sampler to;
    to.wrap_u = wrap_of(integer_in(from, "wrapS", 0));
    to.wrap_v = wrap_of(integer_in(from, "wrapT", 0));
    if (integer_in(from, "magFilter", 0) == nearest) to.magnification = scene::Filter::nearest;
    const int minification = integer_in(from, "minFilter", 0); // absent: ours to choose, so the best
    if (minification == nearest || minification == nearest_mipmap_nearest
        || minification == nearest_mipmap_linear)
        to.minification = scene::Filter::nearest;
    if (minification == nearest || minification == linear) to.mipmap = scene::Mipmap::none;
    if (minification == nearest_mipmap_nearest || minification == linear_mipmap_nearest)
        to.mipmap = scene::Mipmap::nearest;
    return to;
}

/// EXT_texture_webp names a WebP beside the PNG or JPEG, which those read that cannot decode it.
int source_of(const json& from) {
    const json* webp = extension(from, "EXT_texture_webp");
    return integer_in(webp && image::decodes_webp() ? *webp : from, "source", -1);
}

} // namespace

TextureTable::TextureTable(const Document& document, Warnings& warnings)
    : document_(document), warnings_(warnings) {}

int TextureTable::texture(int gltf_texture, scene::ColorSpace color_space) {
    const json& from = document_.entry("textures", gltf_texture);
    const std::string pointer = fmt::format("/textures/{}", gltf_texture);
    if (document_.is_lost(pointer)) return -1;
    const int source = source_of(from);
    const int count = static_cast<int>(document_.images.size());
    if (source < 0 || source >= count) {
        const bool is_ktx =
            source < 0 && (extension(from, "KHR_texture_basisu") || extension(from, "GOOGLE_texture_basis"));
        warnings_.add(source < 0 ? pointer + " has no image in a supported format"
                                 : fmt::format("{} has image {}, and there are {}", pointer, source, count),
                      is_ktx ? fmt::format("the material is shown without it; {}", convert_ktx)
                             : "the material is shown without it");
        return -1;
    }
    const auto [image, is_new] = image_of_source_.try_emplace(source, static_cast<int>(sources_.size()));
    if (is_new) sources_.push_back(source);

    scene::Texture texture;
    texture.image = image->second;
    if (const int sampler = integer_in(from, "sampler", -1); sampler >= 0)
        texture.sampler = parse_sampler(document_.entry("samplers", sampler));
    texture.color_space = color_space;
    const auto found = std::find(textures_.begin(), textures_.end(), texture);
    if (found != textures_.end()) return static_cast<int>(found - textures_.begin());
    textures_.push_back(texture);
    return static_cast<int>(textures_.size()) - 1;
}

namespace {

/// The bytes of an image's file, which `file` holds unless they are in a buffer.
Bytes bytes_of(const Document& document, int source, std::vector<std::uint8_t>& file) {
    const ImageSource& image = document.images[static_cast<std::size_t>(source)];
    const std::string pointer = fmt::format("/images/{}", source);
    if (image.buffer_view >= 0) return document.view(image.buffer_view, pointer);
    if (image.uri.empty()) document.fail(pointer + " has neither bufferView nor uri", export_again);
    file = read_uri(image.uri, document.folder, {document.name, pointer + "/uri"});
    return file;
}

scene::TextureImage decoded(const Document& document, int source, Bytes bytes) {
    const ImageSource& image = document.images[static_cast<std::size_t>(source)];
    const std::string name = image.name.empty() ? "" : fmt::format(" {}", in_quotes(image.name));
    const std::string what = fmt::format("{}: /images/{}{}", document.name, source, name);
    if (image::is_ktx2(bytes)) throw Error({what}, "a KTX2 image, which is not supported", convert_ktx);
    image::DecodedTexture texture = image::decode_texture(bytes, what);
    return {image.name, texture.width, texture.height, std::move(texture.texels)};
}

} // namespace

Decoding::Decoding(const Document& document, std::vector<int> sources)
    : document_(document),
      sources_(std::move(sources)),
      files_(sources_.size()),
      bytes_(sources_.size()),
      images_(sources_.size()),
      errors_(sources_.size()),
      failures_(sources_.size()) {
    read_files();
    const std::size_t cores = std::max(1u, std::thread::hardware_concurrency());
    try {
        for (std::size_t i = 0; i < std::min(cores, sources_.size()); ++i)
            workers_.emplace_back([this] { work(); });
    } catch (const std::system_error&) { // a limit on threads or memory: images() decodes what is left
    }
}

Decoding::~Decoding() {
    next_ = sources_.size();
    for (std::thread& worker : workers_)
        if (worker.joinable()) worker.join();
}

void Decoding::read_files() {
    Tally texels(Limit::texels, document_.name);
    for (std::size_t i = 0; i < sources_.size(); ++i) {
        try {
            bytes_[i] = bytes_of(document_, sources_[i], files_[i]);
        } catch (const Error& error) {
            errors_[i] = error;
        }
        texels.add(image::claimed_texels(bytes_[i]));
    }
}

void Decoding::work() {
    for (std::size_t i = next_++; i < sources_.size(); i = next_++) {
        try {
            if (errors_[i]) continue;
            images_[i] = decoded(document_, sources_[i], bytes_[i]);
            files_[i] = {};
        } catch (const Error& error) {
            errors_[i] = error;
        } catch (...) {
            failures_[i] = std::current_exception(); // rethrown by images(), on the caller's thread
        }
    }
}

std::vector<scene::TextureImage> Decoding::images(Warnings& warnings, std::set<int>& lost) {
    work(); // whatever no thread has begun
    for (std::thread& worker : workers_) worker.join();
    for (const std::exception_ptr& failure : failures_)
        if (failure) std::rethrow_exception(failure);
    for (std::size_t i = 0; i < sources_.size(); ++i) {
        const bool is_lost = document_.is_lost(fmt::format("/images/{}", sources_[i])); // warned of before
        if (!errors_[i] && !is_lost) continue;
        if (!is_lost) warnings.add_loss(*errors_[i], "materials are shown without textures of it");
        lost.insert(static_cast<int>(i));
        images_[i] = {images_[i].name, 1, 1, std::vector<std::uint8_t>{255, 255, 255, 255}};
    }
    return std::move(images_);
}

} // namespace sr::gltf
