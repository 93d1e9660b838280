// Copies with edits: they are made of the file as it was read, whatever another program does to it since.
#include "core/file.hpp"
#include "gltf/write/edited_copy.hpp"
#include "loading.hpp"

#include <algorithm>
#include <functional>
#include <string>

using namespace sr;
using namespace sr::testing;

namespace {

namespace fs = std::filesystem;

const std::vector<std::string> nothing;

/// A triangle and three lamps, at the nodes in this order.
MadeGltf made_with_lamps(const std::vector<std::string>& names) {
    MadeGltf made = MadeGltf::triangle();
    for (std::size_t i = 0; i < names.size(); ++i) {
        made.root["nodes"].push_back(
            {{"name", names[i]},
             {"extras",
              {{"steradian",
                {{"shape", "sphere"}, {"radius", 0.1}, {"quantity", {{"value", 100}, {"unit", "lm"}}}}}}}});
        made.root["scenes"][0]["nodes"].push_back(i + 1);
    }
    return made;
}

/// An edit of the lamp of this name.
gltf::Edits edits_of(const gltf::Asset& asset, const std::string& name) {
    gltf::NodeLightEdit edit;
    const auto& nodes = asset.contents().nodes;
    edit.node =
        static_cast<int>(std::ranges::find(nodes, name, &gltf::Contents::NodeInfo::name) - nodes.begin());
    edit.emission = gltf::StatedEmission{700.0, "lm", vec3(1.0f)};
    edit.name = name + " edited";
    gltf::Edits edits;
    edits.lights.push_back(edit);
    return edits;
}

const std::vector<std::string> in_order{"key", "fill", "rim"}, in_other_order{"rim", "key", "fill"};

struct Change {
    const char* what;
    std::function<void(const fs::path&)> act;
};

const Test as_read("unit.gltf.edited_copy.is_of_the_file_as_it_was_read", [] {
    const fs::path folder = test_folder();
    const std::vector<Change> changes{
        {"other nodes",
         [](const fs::path& file) {
             const MadeGltf made = made_with_lamps(in_other_order);
             if (file.extension() == ".glb")
                 write_bytes(file, made.glb());
             else
                 write_text(file, made.gltf());
         }},
        {"removed", [](const fs::path& file) { fs::remove(file); }},
        {"broken", [](const fs::path& file) { write_text(file, "{"); }},
        {"a folder", [](const fs::path& file) { fs::remove(file), fs::create_directory(file); }},
        {"cut off", [](const fs::path& file) { fs::resize_file(file, 100); }}};
    for (const char* extension : {".gltf", ".glb"})
        for (const Change& change : changes) {
            const fs::path file = folder / (std::string("lamps") + extension),
                           before = folder / ("before" + file.extension().string()),
                           after = folder / ("after" + file.extension().string());
            fs::remove_all(file);
            const MadeGltf made = made_with_lamps(in_order);
            if (file.extension() == ".glb")
                write_bytes(file, made.glb());
            else
                write_text(file, made.gltf());
            const gltf::Asset asset(file);
            const gltf::Edits edits = edits_of(asset, "fill");
            EXPECT_EQ(gltf::write_edited_copy(asset.source(), edits, before), nothing);
            EXPECT_TRUE(asset.source().is_unchanged());
            change.act(file);
            EXPECT_FALSE(asset.source().is_unchanged()) << change.what;
            EXPECT_EQ(gltf::write_edited_copy(asset.source(), edits, after), nothing);
            EXPECT_EQ(read_file(after, ""), read_file(before, "")) << extension << ' ' << change.what;
            const gltf::Loaded copy = gltf::load(after);
            for (const scene::Light& light : copy.scene.lights)
                EXPECT_NEAR(luminance(*scene::flux_of(light, {})),
                            scene::name_of(light) == "fill edited" ? 700.0f : 100.0f, 0.1f)
                    << scene::name_of(light) << ' ' << change.what;
            EXPECT_EQ(copy.scene.lights.size(), 3u);
        }
});

// Exporters write the .gltf and its .bin together.
const Test buffers("unit.gltf.edited_copy.has_the_buffers_that_were_read", [] {
    const fs::path folder = test_folder();
    fs::create_directories(folder / "elsewhere");
    MadeGltf made = made_with_lamps(in_order);
    made.root["buffers"] = json::array({{{"byteLength", made.bytes.size()}, {"uri", "a%20b.bin"}}});
    write_text(folder / "lamps.gltf", made.root.dump());
    write_bytes(folder / "a b.bin", made.bytes);
    const gltf::Asset asset(folder / "lamps.gltf");
    const gltf::Edits edits = edits_of(asset, "rim");
    const auto uri_of_copy = [&](const fs::path& copy) {
        EXPECT_EQ(gltf::write_edited_copy(asset.source(), edits, copy), nothing);
        EXPECT_EQ(gltf::load(copy).scene.meshes.at(0).positions.at(1), vec3(1, 0, 0)) << copy;
        return json::parse(read_text(copy))["buffers"][0]["uri"].get<std::string>();
    };
    EXPECT_EQ(uri_of_copy(folder / "copy.gltf"), "a%20b.bin");
    std::vector<std::uint8_t> others = made.bytes;
    std::ranges::reverse(others);
    others.push_back(0);
    write_bytes(folder / "a b.bin", others);
    EXPECT_TRUE(uri_of_copy(folder / "copy.gltf").starts_with("data:")) << "it has changed";
    EXPECT_TRUE(uri_of_copy(folder / "elsewhere" / "copy.gltf").starts_with("data:"));
    fs::remove(folder / "a b.bin");
    EXPECT_TRUE(uri_of_copy(folder / "copy.gltf").starts_with("data:")) << "it is gone";
});

const Test named("unit.gltf.edited_copy.tells_which_other_files_are_not_those_that_were_read", [] {
    const fs::path folder = test_folder();
    MadeGltf made = made_with_lamps(in_order);
    made.root["images"] = {{{"uri", "wood.png"}}, {{"uri", "wood.png"}}, {{"uri", "never.png"}}};
    made.root["textures"] = {{{"source", 0}}};
    made.root["materials"] = {{{"pbrMetallicRoughness", {{"baseColorTexture", {{"index", 0}}}}}}};
    made.primitive()["material"] = 0;
    write_text(folder / "lamps.gltf", made.gltf());
    write_text(folder / "wood.png", "no picture: a texture is lost, not the file");
    const gltf::Asset asset(folder / "lamps.gltf");
    const fs::path copy = folder / "copy.gltf";
    const auto save = [&] { return gltf::write_edited_copy(asset.source(), edits_of(asset, "key"), copy); };
    EXPECT_EQ(save(), nothing);
    write_text(folder / "wood.png", "another one");
    EXPECT_EQ(save(), std::vector<std::string>{"wood.png has changed since it was read."});
    fs::remove(folder / "wood.png");
    EXPECT_EQ(save(), std::vector<std::string>{"wood.png is gone: put it beside " + copy.string() + "."});
    EXPECT_TRUE(fs::exists(copy));
});

} // namespace
