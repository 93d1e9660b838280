#include "support/made_gltf.hpp"

#include <fstream>

namespace sr::testing {
namespace {

void append_word(std::vector<std::uint8_t>& to, std::uint32_t word) {
    for (int shift = 0; shift < 32; shift += 8) to.push_back(static_cast<std::uint8_t>(word >> shift));
}

void append_chunk(std::vector<std::uint8_t>& to, std::uint32_t type, std::vector<std::uint8_t> data,
                  char padding) {
    while (data.size() % 4 != 0) data.push_back(static_cast<std::uint8_t>(padding));
    append_word(to, static_cast<std::uint32_t>(data.size()));
    append_word(to, type);
    to.insert(to.end(), data.begin(), data.end());
}

} // namespace

std::string base64(const std::vector<std::uint8_t>& bytes) {
    constexpr std::string_view alphabet = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    std::string text;
    for (std::size_t i = 0; i < bytes.size(); i += 3) {
        std::uint32_t group = static_cast<std::uint32_t>(bytes[i]) << 16;
        if (i + 1 < bytes.size()) group |= static_cast<std::uint32_t>(bytes[i + 1]) << 8;
        if (i + 2 < bytes.size()) group |= bytes[i + 2];
        for (int digit = 0; digit < 4; ++digit)
            text += i + static_cast<std::size_t>(digit) > bytes.size()
                        ? '='
                        : alphabet[group >> (18 - 6 * digit) & 63];
    }
    return text;
}

std::string png_uri() {
    return "data:image/png;base64,iVBORw0KGgoAAAANSUhEUgAAAAEAAAABCAYAAAAfFcSJAAAADUlEQVR4nGP4"
           "38DwHwAGgAJ/EEwb4QAAAABJRU5ErkJggg=="; // orange
}

MadeGltf::MadeGltf() { root["asset"] = {{"version", "2.0"}}; }

MadeGltf MadeGltf::triangle() {
    MadeGltf made;
    const int positions = made.floats({0, 0, 0, 1, 0, 0, 0, 1, 0}, "VEC3");
    made.root["meshes"] = json::array({{{"name", "Mesh"}, {"primitives", json::array({json::object()})}}});
    made.attributes()["POSITION"] = positions;
    made.root["nodes"] = json::array({{{"name", "Node"}, {"mesh", 0}}});
    made.root["scenes"] = json::array({{{"nodes", {0}}}});
    return made;
}

int MadeGltf::view(const void* data, std::size_t size) {
    while (bytes.size() % 4 != 0) bytes.push_back(0);
    root["bufferViews"].push_back({{"buffer", 0}, {"byteOffset", bytes.size()}, {"byteLength", size}});
    const auto* from = static_cast<const std::uint8_t*>(data);
    bytes.insert(bytes.end(), from, from + size);
    return static_cast<int>(root["bufferViews"].size()) - 1;
}

std::string MadeGltf::gltf() const {
    json whole = root;
    if (!bytes.empty() && !whole.contains("buffers"))
        whole["buffers"] = json::array({{{"byteLength", bytes.size()},
                                         {"uri", "data:application/octet-stream;base64," + base64(bytes)}}});
    return whole.dump();
}

std::vector<std::uint8_t> MadeGltf::glb() const {
    json whole = root;
    if (!bytes.empty() && !whole.contains("buffers"))
        whole["buffers"] = json::array({{{"byteLength", bytes.size()}}});
    const std::string text = whole.dump();
    std::vector<std::uint8_t> chunks;
    append_chunk(chunks, 0x4E4F534A, {text.begin(), text.end()}, ' ');
    if (!bytes.empty()) append_chunk(chunks, 0x004E4942, bytes, '\0');
    std::vector<std::uint8_t> file{'g', 'l', 'T', 'F'};
    append_word(file, 2);
    append_word(file, static_cast<std::uint32_t>(chunks.size()) + 12);
    file.insert(file.end(), chunks.begin(), chunks.end());
    return file;
}

void write_text(const std::filesystem::path& file, std::string_view text) {
    std::ofstream(file, std::ios::binary) << text;
}

void write_bytes(const std::filesystem::path& file, const std::vector<std::uint8_t>& bytes) {
    write_text(file, {reinterpret_cast<const char*>(bytes.data()), bytes.size()});
}

} // namespace sr::testing
