#pragma once
// Textures and their samplers, and the images behind them, which are decoded on all cores.
#include "gltf/document.hpp"
#include "gltf/warnings.hpp"
#include "scene/material.hpp"

#include <atomic>
#include <exception>
#include <map>
#include <optional>
#include <set>
#include <thread>
#include <vector>

namespace sr::gltf {

/// Collects textures as materials ask for them. Equal (image, sampler, colour space) share an entry, and only
/// images that a material reads are listed.
class TextureTable {
public:
    TextureTable(const Document& document, Warnings& warnings);

    /// The number (in textures()) of an entry of the JSON's `textures`; negative where it has no image.
    int texture(int gltf_texture, scene::ColorSpace color_space);

    /// In the order of their numbers; Texture::image counts in image_sources().
    const std::vector<scene::Texture>& textures() const { return textures_; }
    /// Indices into Document::images.
    const std::vector<int>& image_sources() const { return sources_; }

private:
    const Document& document_;
    Warnings& warnings_;
    std::vector<scene::Texture> textures_;
    std::vector<int> sources_;
    std::map<int, int> image_of_source_; // Document::images → image_sources()
};

class Decoding {
public:
    /// Starts at once. `sources` are indices into `document.images`; the document must outlive this.
    /// @throws Error if they have more texels in all than the limit
    Decoding(const Document& document, std::vector<int> sources);
    /// Waits for the images that are being decoded, and skips the rest.
    ~Decoding();

    Decoding(const Decoding&) = delete;
    Decoding& operator=(const Decoding&) = delete;

    /// Waits, and gives the images in the order of `sources`. To be called once. An image that cannot be read
    /// or decoded costs a warning, is in `lost` (by its place in the result), and is a white texel.
    std::vector<scene::TextureImage> images(Warnings& warnings, std::set<int>& lost);

private:
    /// Reads what is to be decoded, and counts its texels before any are allocated.
    void read_files();
    void work();

    const Document& document_;
    std::vector<int> sources_;
    std::vector<std::vector<std::uint8_t>> files_;
    std::vector<Bytes> bytes_; // in files_ or in a buffer
    std::vector<scene::TextureImage> images_;
    std::vector<std::optional<Error>> errors_;
    std::vector<std::exception_ptr> failures_; // that no file is to blame for
    std::atomic<std::size_t> next_{0};
    std::vector<std::thread> workers_;
};

} // namespace sr::gltf
