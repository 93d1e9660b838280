// Files that nobody on this project wrote: each loads, with the warnings it deserves.
#include "core/error.hpp"
#include "gltf/asset.hpp"
#include "gltf/read/mikktspace.hpp"
#include "support/address.hpp"
#include "support/models.hpp"

#include <algorithm>
#include <map>

using namespace sr;
using sr::testing::Test;

namespace {

namespace fs = std::filesystem;

// Parts of the warnings that a file is expected to cause; the others load without warnings.
const std::map<std::string, std::vector<std::string>> expected_warnings{
    {"BoxBadNormals.glb", {"a normal is zero or not finite"}},
    {"BoxWithInfinites.glb",
     {"a triangle has a position that is not finite (12 times)", "there is nothing to see"}},
    {"issue-492.glb", {"there is nothing to see"}}, // a skeleton without a mesh
};

void expect_consistent(const scene::Scene& scene) {
    for (const scene::Mesh& mesh : scene.meshes) {
        const std::size_t count = mesh.positions.size();
        if (mesh.is_surface()) {
            EXPECT_EQ(mesh.normals.size(), count);
        }
        for (const std::size_t size :
             {mesh.tangents.size(), mesh.texcoords[0].size(), mesh.texcoords[1].size(), mesh.colors.size()})
            EXPECT_TRUE(size == 0 || size == count);
        EXPECT_EQ(mesh.indices.size() % 3, 0u);
        for (const std::uint32_t index : mesh.indices) ASSERT_LT(index, count);
        for (const vec3 normal : mesh.normals) ASSERT_NEAR(glm::length(normal), 1.0f, 1e-5f);
        for (const vec4 tangent : mesh.tangents) ASSERT_NEAR(glm::length(vec3(tangent)), 1.0f, 1e-5f);
        ASSERT_LT(static_cast<std::size_t>(mesh.material), scene.materials.size());
        EXPECT_EQ(!mesh.tangents.empty(),
                  scene::needs_tangents(scene.materials[static_cast<std::size_t>(mesh.material)]));
    }
    for (const scene::Texture& texture : scene.textures)
        ASSERT_LT(static_cast<std::size_t>(texture.image), scene.images.size());
}

void expect_loads(const fs::path& file) {
    const gltf::Loaded loaded = gltf::load(file);
    expect_consistent(loaded.scene);
    const auto found = expected_warnings.find(file.filename().string());
    const std::vector<std::string> expected =
        found == expected_warnings.end() ? std::vector<std::string>{} : found->second;
    ASSERT_EQ(loaded.warnings.size(), expected.size()) << ::testing::PrintToString(loaded.warnings);
    for (std::size_t i = 0; i < expected.size(); ++i)
        EXPECT_NE(loaded.warnings[i].find(expected[i]), std::string::npos) << loaded.warnings[i];
}

const Test every_file("real.models.each_loads_with_the_warnings_it_deserves", [] {
    const auto folder = sr::testing::models_folder();
    if (!folder) GTEST_SKIP() << "no folder of models: set STERADIAN_MODELS";
    int count = 0;
    for (const fs::directory_entry& entry : fs::directory_iterator(*folder)) {
        if (entry.path().extension() != ".glb" && entry.path().extension() != ".gltf") continue;
        SCOPED_TRACE(entry.path().filename().string());
        ++count;
        expect_loads(entry.path());
    }
    EXPECT_GT(count, 0);
});

/// Returns whether a file of the package is broken or too new or too old by its folder's name or its own.
bool is_made_to_be_refused(const fs::path& file) {
    static const std::vector<std::string> parts{"/glTF/",         "IndexOutOfRange", "MissingBin",
                                                "NoScene",        "RecursiveNodes",  "SchemaFailures",
                                                "techniqueWebGL", "wrongTypes"};
    const std::string name = file.generic_string();
    return std::ranges::any_of(parts,
                               [&](const std::string& part) { return name.find(part) != std::string::npos; });
}

// The content of a package differs from release to release: files that are not made to be broken load, and
// the rest may be refused, in one line that says what to do.
const Test packaged("real.models.each_packaged_one_loads_or_is_refused_in_one_line", [] {
    const auto folder = sr::testing::packaged_models_folder();
    if (!folder) GTEST_SKIP() << "no packaged models: install assimp-testmodels";
    int loaded_count = 0;
    for (const fs::path& file : sr::testing::models_below(*folder)) {
        SCOPED_TRACE(file.string());
        try {
            expect_consistent(gltf::load(file).scene);
            ++loaded_count;
        } catch (const Error& error) {
            const std::string line = error.what();
            EXPECT_TRUE(is_made_to_be_refused(file)) << line;
            EXPECT_TRUE(line.starts_with(file.parent_path().string())) << line;
            EXPECT_EQ(std::ranges::count(line, '\n'), 0) << line;
        }
    }
    EXPECT_GE(loaded_count, 10);
});

// The names and numbers in the file, read by hand.
const Test lights("real.models.lights_are_what_the_file_says", [] {
    const auto folder = sr::testing::models_folder();
    if (!folder || !fs::exists(*folder / "Lights.glb")) GTEST_SKIP() << "no Lights.glb: set STERADIAN_MODELS";
    const scene::Scene scene = gltf::load(*folder / "Lights.glb").scene;
    ASSERT_EQ(scene.lights.size(), 4u);
    EXPECT_EQ(std::get<scene::PointLight>(scene.lights[0]).I, vec3(5, 0, 0));
    EXPECT_LT(
        glm::length(std::get<scene::PointLight>(scene.lights[0]).position - vec3(2.5988f, 3.5685f, -1.0055f)),
        1e-4f);
    EXPECT_EQ(std::get<scene::SpotLight>(scene.lights[1]).I, vec3(0, 10, 0));
    EXPECT_LT(glm::length(std::get<scene::SpotLight>(scene.lights[1]).direction - vec3(0, -1, 0)), 1e-5f);
    EXPECT_NEAR(std::get<scene::SpotLight>(scene.lights[2]).outer_angle, 0.0786695f, 1e-6f);
    EXPECT_EQ(std::get<scene::DirectionalLight>(scene.lights[3]).E.x, 0.0f);
    EXPECT_EQ(scene.cameras.size(), 1u);
});

// The specification's tutorial: a strip whose upper joint turns by a quarter from 1.5 s to 2 s, about its
// middle.
const Test skin("real.models.a_skin_bends_as_its_animation_says", [] {
    const auto folder = sr::testing::models_folder();
    if (!folder || !fs::exists(*folder / "SimpleSkin.gltf"))
        GTEST_SKIP() << "no SimpleSkin.gltf: set STERADIAN_MODELS";
    gltf::LoadOptions options;
    options.at = 1.5;
    const scene::Scene scene = gltf::load(*folder / "SimpleSkin.gltf", options).scene;
    // The last triangle is 6, 9, 8; the joints' inverse bind matrices bring (0.5, 1) to their origin.
    const scene::Mesh& mesh = scene.meshes.at(0);
    const auto corner = [&](std::size_t i) { return mesh.positions[mesh.indices.at(i)]; };
    EXPECT_LT(glm::length(corner(0) - vec3(-0.5f, 0, 0)), 1e-5f);
    EXPECT_LT(glm::length(corner(23) - vec3(-1, 0.5f, 0)), 1e-5f); // was (0, 2)
    EXPECT_LT(glm::length(corner(22) - vec3(-1, 1.5f, 0)), 1e-5f); // was (1, 2)
});

const Test instancing("real.models.instances_are_where_the_file_says", [] {
    const auto folder = sr::testing::models_folder();
    if (!folder || !fs::exists(*folder / "simple-instancing.glb"))
        GTEST_SKIP() << "no simple-instancing.glb: set STERADIAN_MODELS";
    const scene::Scene scene = gltf::load(*folder / "simple-instancing.glb").scene;
    EXPECT_EQ(scene.meshes.size(), 1u);
    EXPECT_EQ(scene.instances.size(), 125u); // a lattice of 5 x 5 x 5
});

// Files whose exporters baked MikkTSpace tangents: ours agree in direction and in the sign of w.
const Test tangents("real.models.tangents_agree_with_the_exporters", [] {
    const auto folder = sr::testing::models_folder();
    if (!folder) GTEST_SKIP() << "no folder of models: set STERADIAN_MODELS";
    int corner_count = 0;
    for (const char* name : {"AnisotropyRotationTest.glb", "ClearCoatTest.glb"}) {
        if (!fs::exists(*folder / name)) continue;
        for (const scene::Mesh& mesh : gltf::load(*folder / name).scene.meshes) {
            if (mesh.tangents.empty()) continue;
            const std::vector<vec4> ours =
                gltf::mikktspace(mesh.positions, mesh.normals, mesh.texcoords[0], mesh.indices);
            for (std::size_t i = 0; i < ours.size(); ++i, ++corner_count) {
                const vec4 theirs = mesh.tangents[mesh.indices[i]];
                ASSERT_EQ(ours[i].w, theirs.w) << name << ", corner " << i;
                ASSERT_GT(glm::dot(vec3(ours[i]), vec3(theirs)), 0.999f) << name << ", corner " << i;
            }
        }
    }
    if (corner_count == 0) GTEST_SKIP() << "no model with tangents";
});

} // namespace
