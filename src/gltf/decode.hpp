#pragma once
// Decoding images on all cores while the caller reads meshes.
#include "gltf/document.hpp"
#include "scene/material.hpp"

#include <atomic>
#include <exception>
#include <optional>
#include <set>
#include <thread>
#include <vector>

namespace sr::gltf {

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
