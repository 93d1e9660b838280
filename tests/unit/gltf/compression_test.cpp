// Compressed meshes: what comes out, and what becomes of streams that are broken, cut short, or lie.
#include "loading.hpp"
#include "support/draco_stream.hpp"

#include <algorithm>
#include <meshoptimizer.h>

using namespace sr;
using namespace sr::testing;
using sr::testing::Test;

namespace {

using Stream = std::vector<std::uint8_t>;

const Stream draco_stream = draco_triangles();

MadeGltf with_draco(const Stream& stream, std::size_t count = 4) {
    MadeGltf made = MadeGltf::triangle();
    const int bytes = made.accessor(stream, "SCALAR", 5121);
    json& accessors = made.root["accessors"];
    accessors[0] = {{"componentType", 5126}, {"count", count}, {"type", "VEC3"}};
    made.primitive()["extensions"]["KHR_draco_mesh_compression"] = {
        {"bufferView", accessors[bytes]["bufferView"]}, {"attributes", {{"POSITION", 0}}}};
    made.root["extensionsRequired"] = {"KHR_draco_mesh_compression"};
    return made;
}

const Test draco("unit.gltf.draco.a_mesh_comes_out_as_it_went_in", [] {
    const scene::Scene scene = load(with_draco(draco_stream)).scene;
    const scene::Mesh& mesh = scene.meshes.at(0);
    EXPECT_EQ(mesh.indices.size(), 6u);
    double area = 0.0;
    for (std::size_t i = 0; i < 6; i += 3) {
        const auto corner = [&](std::size_t k) { return mesh.positions[mesh.indices[i + k]]; };
        area += 0.5 * glm::length(glm::cross(corner(1) - corner(0), corner(2) - corner(0)));
    }
    EXPECT_NEAR(area, 4.0 + 0.5 * std::sqrt(4.0 + 16.0 + 64.0), 1e-3); // |(4,2,0) x (0,2,1)| = |(2,-4,8)|
    const scene::Bounds bounds = scene::bounds_of(scene);
    EXPECT_LT(glm::length(bounds.max - vec3(4, 2, 1)), 1e-3f);
    EXPECT_LT(glm::length(bounds.min), 1e-3f);
});

const Test cut_draco("unit.gltf.draco.a_stream_that_is_cut_short_is_one_line", [] {
    for (std::size_t length = 0; length < draco_stream.size(); ++length) {
        const std::string error = error_of(with_draco(
            Stream(draco_stream.begin(), draco_stream.begin() + static_cast<std::ptrdiff_t>(length))));
        EXPECT_NE(error.find("/meshes/0/primitives/0 has Draco data that is broken, or cut short"),
                  std::string::npos)
            << length << ' ' << error;
        EXPECT_EQ(error.find('\n'), std::string::npos);
    }
});

const Test lying_draco("unit.gltf.draco.what_a_stream_claims_is_checked", [] {
    EXPECT_NE(error_of(with_draco(draco_stream, 5)).find("announces 5 of POSITION, and its Draco data has 4"),
              std::string::npos);
    Stream huge = draco_stream;
    huge.erase(huge.begin() + 13); // the number of triangles
    huge.insert(huge.begin() + 13, {0xff, 0xff, 0xff, 0xff, 0x0f});
    EXPECT_NE(error_of(with_draco(huge)).find("claims to hold 4294967295 triangles in 90 bytes"),
              std::string::npos);
    MadeGltf other = with_draco(draco_stream);
    other.primitive()["extensions"]["KHR_draco_mesh_compression"]["attributes"]["POSITION"] = 7;
    EXPECT_NE(error_of(other).find("has no POSITION in its Draco data"), std::string::npos);
});

/// Returns the extension's object for packed bytes in the file's first buffer.
json packed(MadeGltf& made, const Stream& bytes, std::size_t stride, std::size_t count,
            const std::string& mode) {
    const int accessor = made.accessor(bytes, "SCALAR", 5121);
    const json& view =
        made.root["bufferViews"][made.root["accessors"][accessor]["bufferView"].get<std::size_t>()];
    return {{"buffer", 0},
            {"byteOffset", view["byteOffset"]},
            {"byteLength", bytes.size()},
            {"byteStride", stride},
            {"count", count},
            {"mode", mode}};
}

struct Packs {
    Stream positions; // four, exponential
    Stream normals;   // four, octahedral
    Stream triangles;
};

Packs packs() {
    const std::vector<float> positions{0, 0, 0, 4, 0, 0, 4, 2, 0, 0, 2, 1};
    std::vector<std::uint32_t> exponential(12);
#if MESHOPTIMIZER_VERSION >= 190
    meshopt_encodeFilterExp(exponential.data(), 4, 12, 15, positions.data(), meshopt_EncodeExpSharedVector);
#else
    meshopt_encodeFilterExp(exponential.data(), 4, 12, 15, positions.data());
#endif
    const std::vector<std::int8_t> octahedral{0, 0, 127, 0, 127, 0, 127, 0, 0, 127, 127, 0, 0, 0, 127, 0};
    const std::vector<std::uint16_t> indices{0, 1, 2, 0, 2, 3};
    Packs result;
    const auto packed_vertices = [](const void* from, std::size_t count, std::size_t size) {
        Stream to(meshopt_encodeVertexBufferBound(count, size));
        to.resize(meshopt_encodeVertexBuffer(to.data(), to.size(), from, count, size));
        return to;
    };
    result.positions = packed_vertices(exponential.data(), 4, 12);
    result.normals = packed_vertices(octahedral.data(), 4, 4);
    result.triangles.resize(meshopt_encodeIndexBufferBound(indices.size(), 4));
    result.triangles.resize(meshopt_encodeIndexBuffer(result.triangles.data(), result.triangles.size(),
                                                      indices.data(), indices.size()));
    return result;
}

/// The views lie in a fallback buffer that is not there.
MadeGltf with_meshopt(const Packs& from) {
    MadeGltf made;
    const std::vector<json> extensions{packed(made, from.positions, 12, 4, "ATTRIBUTES"),
                                       packed(made, from.normals, 4, 4, "ATTRIBUTES"),
                                       packed(made, from.triangles, 2, 6, "TRIANGLES")};
    const std::size_t first = made.root["bufferViews"].size();
    for (const json& extension : extensions) {
        const auto size = extension["count"].get<std::size_t>() * extension["byteStride"].get<std::size_t>();
        made.root["bufferViews"].push_back(
            {{"buffer", 1}, {"byteLength", size}, {"extensions", {{"EXT_meshopt_compression", extension}}}});
    }
    made.root["bufferViews"][first]["extensions"]["EXT_meshopt_compression"]["filter"] = "EXPONENTIAL";
    made.root["bufferViews"][first + 1]["extensions"]["EXT_meshopt_compression"]["filter"] = "OCTAHEDRAL";
    made.root["bufferViews"][first + 1]["byteStride"] = 4;
    made.root["accessors"] =
        json::array({{{"bufferView", first}, {"componentType", 5126}, {"count", 4}, {"type", "VEC3"}},
                     {{"bufferView", first + 1},
                      {"componentType", 5120},
                      {"count", 4},
                      {"type", "VEC3"},
                      {"normalized", true}},
                     {{"bufferView", first + 2}, {"componentType", 5123}, {"count", 6}, {"type", "SCALAR"}}});
    made.root["meshes"] =
        json::parse(R"([{"primitives": [{"attributes": {"POSITION": 0, "NORMAL": 1}, "indices": 2}]}])");
    made.root["nodes"] = json::parse(R"([{"mesh": 0}])");
    made.root["buffers"] = json::array(
        {{{"byteLength", made.bytes.size()}, {"uri", "data:;base64," + base64(made.bytes)}},
         {{"byteLength", 1000}, {"extensions", {{"EXT_meshopt_compression", {{"fallback", true}}}}}}});
    made.root["extensionsRequired"] = {"EXT_meshopt_compression"};
    return made;
}

const Test meshopt("unit.gltf.meshopt.views_come_out_as_they_went_in", [] {
    const scene::Scene scene = load(with_meshopt(packs())).scene;
    const scene::Mesh& mesh = scene.meshes.at(0);
    EXPECT_EQ(mesh.indices.size(), 6u);
    const scene::Bounds bounds = scene::bounds_of(scene);
    EXPECT_LT(glm::length(bounds.max - vec3(4, 2, 1)), 1e-3f);
    for (const vec3 normal : {vec3(0, 0, 1), vec3(1, 0, 0), vec3(0, 1, 0)})
        EXPECT_TRUE(
            std::ranges::any_of(mesh.normals, [&](vec3 n) { return glm::length(n - normal) < 0.02f; }));
});

const Test cut_meshopt("unit.gltf.meshopt.a_view_that_is_cut_short_is_one_line", [] {
    const auto expect_broken = [](const Packs& broken) {
        const std::string error = error_of(with_meshopt(broken));
        const bool is_told =
            error.find("EXT_meshopt_compression has data that is broken, or cut short") != std::string::npos
            || error.find("claims to hold") != std::string::npos;
        EXPECT_TRUE(is_told) << error;
        EXPECT_EQ(error.find('\n'), std::string::npos);
    };
    const Packs whole = packs();
    for (Stream Packs::*part : {&Packs::positions, &Packs::normals, &Packs::triangles})
        for (std::size_t length = 1; length < (whole.*part).size(); ++length) {
            Packs cut = whole;
            (cut.*part).resize(length);
            expect_broken(cut);
        }
});

const Test lying_meshopt("unit.gltf.meshopt.what_a_view_claims_is_checked", [] {
    MadeGltf made = with_meshopt(packs());
    json& extension = made.root["bufferViews"][3]["extensions"]["EXT_meshopt_compression"];
    extension["count"] = 100000000;
    EXPECT_NE(error_of(made).find(
                  "/bufferViews/3/extensions/EXT_meshopt_compression claims to hold 1200000000 bytes"),
              std::string::npos);
    extension["count"] = 4;
    extension["byteStride"] = 6;
    EXPECT_NE(error_of(made).find(
                  "has 4 elements of 6 bytes, which mode ATTRIBUTES with filter EXPONENTIAL forbids"),
              std::string::npos);
    extension["byteStride"] = 12;
    extension["byteLength"] = 100000;
    EXPECT_NE(error_of(made).find("ends at byte"), std::string::npos);
});

} // namespace
