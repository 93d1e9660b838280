// Images as files bring them: what they claim to be, how they are embedded, what is wrong with them.
#include "../image/png_bytes.hpp"
#include "loading.hpp"

#include <algorithm>

using namespace sr;
using namespace sr::testing;
using sr::testing::Test;

namespace {

/// One texel of (10, 20, 30).
ByteVector texel_png() { return Png{1, 1, 8, 2, {0, 10, 20, 30}, {}, {}}.bytes(); }

/// A triangle whose base colour is this image.
MadeGltf with_image(const json& image) {
    MadeGltf made = MadeGltf::triangle();
    made.root["images"] = json::array({image});
    made.root["textures"] = json::array({{{"source", 0}}});
    made.root["materials"] =
        json::array({{{"pbrMetallicRoughness", {{"baseColorTexture", {{"index", 0}}}}}}});
    made.primitive()["material"] = 0;
    made.attributes()["TEXCOORD_0"] = made.floats({0, 0, 1, 0, 0, 1}, "VEC2");
    return made;
}

MadeGltf with_bytes(const ByteVector& bytes, const std::string& type = "image/png") {
    return with_image({{"uri", "data:" + type + ";base64," + base64(bytes)}});
}

void expect_texel(const gltf::Loaded& loaded, const std::string& what) {
    EXPECT_TRUE(loaded.warnings.empty()) << what << ": " << ::testing::PrintToString(loaded.warnings);
    EXPECT_EQ(std::get<ByteVector>(loaded.scene.images.at(0).texels), (ByteVector{10, 20, 30, 255})) << what;
}

void expect_texel(const MadeGltf& made, const std::string& what) { expect_texel(load(made), what); }

// The bytes say what they are; the specification, section 3.8.2, gives them the last word.
const Test types("unit.gltf.image.the_type_is_told_by_the_bytes", [] {
    for (const char* type :
         {"image/png", "image/jpeg", "image/ktx2", "application/octet-stream", "text/plain", ""})
        expect_texel(with_bytes(texel_png(), type), type);
    MadeGltf made = with_image({{"bufferView", 1}, {"mimeType", "image/jpeg"}});
    while (made.bytes.size() % 4 != 0) made.bytes.push_back(0);
    const ByteVector png = texel_png();
    made.root["bufferViews"].push_back(
        {{"buffer", 0}, {"byteOffset", made.bytes.size()}, {"byteLength", png.size()}});
    made.root["images"][0]["bufferView"] = made.root["bufferViews"].size() - 1;
    made.bytes.insert(made.bytes.end(), png.begin(), png.end());
    expect_texel(made, "in a buffer view");
    for (const char* name : {"named.jpg", "no_extension", "with space.png", "\xC3\xA4.PNG"}) {
        const auto folder = test_folder();
        write_bytes(folder / name, png);
        write_text(folder / "made.gltf", with_image({{"uri", name}}).gltf());
        expect_texel(gltf::load(folder / "made.gltf"), name);
    }
});

const Test data_uri_spellings("unit.gltf.image.data_uris_of_every_spelling", [] {
    // Until its base64 has both digits that URLs write otherwise.
    Png png{1, 1, 8, 2, {0, 10, 20, 30}, {}, {}};
    png.chunks.emplace_back("teXt",
                            ByteVector{'a', 0, 0xFB, 0xEF, 0xBE, 0xFF, 0xFF, 0xFF, 0xFB, 0xEF, 0xBE, 0xFF});
    std::string text = base64(png.bytes());
    ASSERT_NE(text.find('+'), std::string::npos);
    ASSERT_NE(text.find('/'), std::string::npos);
    expect_texel(with_image({{"uri", "data:image/png;charset=utf-8;base64," + text}}), "with a parameter");
    std::string broken;
    for (std::size_t i = 0; i < text.size(); i += 16) broken += text.substr(i, 16) + "\r\n ";
    expect_texel(with_image({{"uri", "data:image/png;base64,\n" + broken}}), "in lines");
    while (text.ends_with('=')) text.pop_back();
    expect_texel(with_image({{"uri", "data:image/png;base64," + text}}), "without padding");
    std::ranges::replace(text, '+', '-');
    std::ranges::replace(text, '/', '_');
    expect_texel(with_image({{"uri", "data:image/png;base64," + text}}), "safe in URLs");
});

const Test broken("unit.gltf.image.one_that_is_none_costs_its_texture", [] {
    const auto lost = [](const ByteVector& bytes) {
        const MadeGltf made = with_bytes(bytes);
        EXPECT_FALSE(load(made).scene.materials.at(0).base_color_texture.is_present());
        return loss_of(made);
    };
    const std::string place = "made.gltf: /images/0: ";
    EXPECT_TRUE(lost({}).starts_with(place + "neither PNG nor JPEG"));
    EXPECT_TRUE(lost({'G', 'I', 'F', '8', '9', 'a', 0, 0}).starts_with(place + "neither PNG nor JPEG"));
    EXPECT_TRUE(lost({'D', 'D', 'S', ' ', 124, 0, 0, 0}).starts_with(place + "a DDS image"));
    EXPECT_TRUE(lost(Png{0, 1, 8, 2, {0}, {}, {}}.bytes()).starts_with(place + "a broken or truncated PNG"));
    EXPECT_TRUE(lost(Png{1, 0, 8, 2, {}, {}, {}}.bytes()).starts_with(place + "a broken or truncated PNG"));
    EXPECT_TRUE(
        lost(Png{20000, 1, 8, 2, {0}, {}, {}}.bytes()).starts_with(place + "20000 x 1 texels are too many"));
    EXPECT_TRUE(lost(Png{1, 1, 7, 2, {0, 1, 2, 3}, {}, {}}.bytes()).starts_with(place + "cannot be decoded"));
    EXPECT_TRUE(lost(Png{4, 4, 8, 2, {0, 1, 2, 3}, {}, {}}.bytes()).starts_with(place + "cannot be decoded"))
        << "too few rows";
    ByteVector cut = texel_png();
    cut.resize(cut.size() - 14);
    EXPECT_TRUE(lost(cut).starts_with(place + "a broken or truncated PNG"));
});

} // namespace
