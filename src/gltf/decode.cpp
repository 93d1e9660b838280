#include "gltf/decode.hpp"

#include "core/error.hpp"
#include "core/limits.hpp"
#include "gltf/extensions.hpp"
#include "gltf/text.hpp"
#include "gltf/uri.hpp"
#include "image/file.hpp"

#include <algorithm>
#include <fmt/format.h>
#include <system_error>

namespace sr::gltf {
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
