// The journal of unsaved edits: every kind of edit comes back, from any path, even if another process has its
// number now.
#include "core/error.hpp"
#include "support/address.hpp"
#include "viewer/document/journal.hpp"
#include "viewer/document/new_light.hpp"

#include <algorithm>
#include <chrono>
#include <cstdlib>
#include <fstream>
#include <glm/gtc/matrix_transform.hpp>
#include <nlohmann/json.hpp>
#include <string>
#include <unistd.h>
#include <vector>

using namespace sr;
using namespace sr::viewer;
using sr::testing::Test;

namespace {

namespace fs = std::filesystem;

/// A state folder of its own, and a copy of a bundled scene.
struct Place {
    explicit Place(const char* scene, const std::string& name = "scene.gltf")
        : folder(fs::temp_directory_path() / ("steradian_journal_" + std::to_string(getpid()))),
          file((folder / name).string()) {
        fs::remove_all(folder);
        fs::create_directories(folder);
        for (const fs::path& part : {fs::path(scene), fs::path("downlight.ies")})
            fs::copy_file(fs::path(STERADIAN_SCENES) / part,
                          folder / (part == scene ? fs::path(name) : part));
        setenv("XDG_STATE_HOME", folder.c_str(), 1);
    }
    ~Place() { fs::remove_all(folder); }
    Place(const Place&) = delete;
    Place& operator=(const Place&) = delete;

    fs::path folder;
    std::string file;
};

LoadedScene loaded_with(const std::string& file, scene::Rig rig = scene::Rig::automatic) {
    Options options;
    options.rig = rig;
    return load_scene(file, options, 1.0f);
}

constexpr std::size_t same_file = 1, other_file = 2; // hashes

/// Writes the edits as a run that ends without an answer does, and recovers them in the next one.
void recover_into(LightEditor& fresh, const LightEditor& edited, const std::string& file) {
    Journal(file).write(edited, same_file);
    const auto lost = Journal(file).find(fresh.edits(), same_file).newest;
    ASSERT_TRUE(lost.has_value());
    EXPECT_TRUE(lost->missing.empty());
    EXPECT_FALSE(lost->has_file_changed);
    fresh.recover(lost->edits);
}

void expect_same_edits(const LightEditor& a, const LightEditor& b) {
    ASSERT_EQ(a.edits().size(), b.edits().size());
    for (std::size_t i = 0; i < a.edits().size(); ++i) {
        const LightEdit &x = a.edits()[i], &y = b.edits()[i];
        EXPECT_TRUE(x.kind == y.kind && x.source == y.source) << i;
        EXPECT_EQ(x.is_enabled, y.is_enabled) << i;
        EXPECT_EQ(x.is_removed, y.is_removed) << i;
        EXPECT_EQ(x.is_news(), y.is_news()) << i;
        EXPECT_EQ(x.emission, y.emission) << i;
        EXPECT_EQ(x.motion, y.motion) << i;
        ASSERT_EQ(x.light.index(), y.light.index()) << i;
        if (x.is_removed && x.is_added()) continue;
        EXPECT_EQ(name_of(x.light), name_of(y.light));
        EXPECT_LT(glm::distance(quantity_of(x.light), quantity_of(y.light)),
                  1e-5f * (1.0f + glm::length(quantity_of(x.light))))
            << i;
        const scene::Bounds p = bounds_of(x.light, 0.0f), q = bounds_of(y.light, 0.0f);
        EXPECT_EQ(p.is_empty(), q.is_empty()) << i;
        if (p.is_empty()) continue;
        EXPECT_LT(glm::distance(p.min, q.min) + glm::distance(p.max, q.max), 1e-4f) << i;
    }
}

const Test kinds("unit.viewer.journal.every_kind_of_edit_comes_back", [] {
    const Place place("zoo.gltf");
    LoadedScene loaded = loaded_with(place.file);
    LightEditor edited(loaded, false), fresh(loaded, false);
    const std::size_t lights = loaded.stage.scene.lights.size();
    ASSERT_GE(lights, 4u);
    edited.set_quantity(0, 3.0f * quantity_of(edited.edits()[0].light));
    std::size_t resized = 0;
    for (std::size_t i = 1; i < lights; ++i)
        for (std::size_t k = 0; k < scene::sizes_of(edited.edits()[i].light).size(); ++k, ++resized)
            edited.set_size(i, k, 1.7f * scene::sizes_of(edited.edits()[i].light)[k].size);
    EXPECT_GE(resized, 2u);
    edited.transform(1,
                     glm::rotate(glm::translate(mat4(1.0f), vec3(0.1f, 0.2f, -0.3f)), 0.4f, vec3(0, 1, 0)));
    edited.remove(2);
    edited.enable(3, false);
    edited.set_quantity(edited.entries().size() - 1, vec3(7.0f, 5.0f, 3.0f));
    edited.add(scene::SphereLight{"more", vec3(0.5f), 0.2f, vec3(10.0f)});
    edited.add(scene::PointLight{"spark", vec3(0.1f), vec3(2.0f)});
    scene::RectangleLight plate;
    plate.name = "plate";
    plate.L = vec3(30.0f, 20.0f, 10.0f);
    const std::size_t added = edited.add(plate);
    edited.apply(loaded);
    edited.transform(added, glm::translate(mat4(1.0f), vec3(0.0f, 1.0f, 0.0f)));
    edited.set_size(added, 0, 0.75f);
    for (const NewLightKind& row : new_light_kinds)
        edited.add(new_light(row.kind, {vec3(0.3f, 2.0f, -0.4f), vec3(1.0f, 0.1f, 0.5f), 0.4f, 80.0f}));
    edited.add(scene::PolygonLight{"", {{0, 1, 0}, {0.5f, 1, 0}, {0, 1, 0.5f}}, vec3(4.0f), true, false});
    edited.rename(3, "renamed");
    edited.apply(loaded);
    recover_into(fresh, edited, place.file);
    expect_same_edits(fresh, edited);
    EXPECT_TRUE(fresh.is_unsaved());
    EXPECT_TRUE(fresh.undo()) << "recovering is a step";
    EXPECT_FALSE(fresh.is_unsaved());
});

const Test softboxes("unit.viewer.journal.softboxes_come_back", [] {
    const Place place("brdfs.gltf");
    const LoadedScene loaded = loaded_with(place.file, scene::Rig::softboxes);
    LightEditor edited(loaded, false), fresh(loaded, false);
    const auto box = std::ranges::find_if(
        edited.entries(), [](const LightEntry& e) { return e.kind == LightEdit::Kind::softbox; });
    ASSERT_NE(box, edited.entries().end()) << "the scene has none: choose another";
    const auto entry = static_cast<std::size_t>(box - edited.entries().begin());
    edited.set_quantity(entry, vec3(11.0f, 12.0f, 13.0f));
    edited.transform(entry, glm::translate(mat4(1.0f), vec3(0.0f, 0.5f, 0.25f)));
    edited.set_size(entry, 0, 2.5f);
    recover_into(fresh, edited, place.file);
    expect_same_edits(fresh, edited);
});

const Test any_path("unit.viewer.journal.any_path_and_name_will_do", [] {
    const Place place("cornell.gltf", "caf\xe9 " + std::string(200, 'x') + ".gltf"); // Latin-1, long
    const LoadedScene loaded = loaded_with(place.file);
    LightEditor edited(loaded, false), fresh(loaded, false);
    edited.add(scene::PointLight{"caf\xe9", vec3(0.0f), vec3(2.0f)});
    Journal(place.file).write(edited, same_file);
    const auto lost = Journal(place.file).find(fresh.edits(), same_file).newest;
    ASSERT_TRUE(lost.has_value());
    EXPECT_EQ(lost->count, 1u);
});

const Test alive("unit.viewer.journal.a_run_that_lives_has_lost_nothing", [] {
    const Place place("cornell.gltf");
    const LoadedScene loaded = loaded_with(place.file);
    LightEditor edited(loaded, false);
    const LightEditor fresh(loaded, false);
    edited.enable(0, false);
    {
        const Journal mine(place.file), other(place.file);
        mine.write(edited, same_file);
        EXPECT_FALSE(other.find(fresh.edits(), same_file).newest) << "the run that wrote it lives";
        other.write(fresh, same_file);
        EXPECT_FALSE(other.find(fresh.edits(), same_file).newest)
            << "a journal without edits removes its own file alone";
    }
    // The same process has no claim on it any more, so that a process id that is used again does no harm.
    const Journal next(place.file);
    EXPECT_TRUE(next.find(fresh.edits(), same_file).newest.has_value());
    next.write(edited, same_file);
    next.remove();
    EXPECT_TRUE(next.find(fresh.edits(), same_file).newest.has_value())
        << "a new run keeps what another one has lost";
});

/// Gives two lights the same name.
void make_twins(LoadedScene& loaded) {
    for (const std::size_t light : {2u, 3u}) set_name(loaded.stage.scene.lights[light], "twin");
}

const Test renumbered("unit.viewer.journal.a_file_that_has_changed_gets_edits_by_name", [] {
    const Place place("zoo.gltf");
    LoadedScene loaded = loaded_with(place.file);
    ASSERT_GE(loaded.stage.scene.lights.size(), 4u);
    make_twins(loaded);
    LightEditor edited(loaded, false);
    const LightEditor fresh(loaded, false);
    LoadedScene reordered = loaded_with(place.file); // as another exporter writes it
    make_twins(reordered);
    std::ranges::reverse(reordered.stage.scene.lights);
    std::ranges::reverse(reordered.light_nodes);
    const LightEditor other(reordered, false);
    const std::string name = name_of(edited.edits()[0].light);
    const vec3 quantity = 3.0f * quantity_of(edited.edits()[0].light);
    edited.set_quantity(0, quantity);
    edited.rename(0, "renamed");
    edited.enable(2, false);
    edited.add(scene::PointLight{"spark", vec3(0.1f), vec3(2.0f)});
    Journal(place.file).write(edited, same_file);
    const auto unchanged = Journal(place.file).find(fresh.edits(), same_file).newest.value();
    EXPECT_EQ(unchanged.count, 3u) << "nodes tell two lights of one name apart";
    EXPECT_FALSE(unchanged.has_file_changed);
    const auto lost = Journal(place.file).find(other.edits(), other_file).newest.value();
    EXPECT_TRUE(lost.has_file_changed);
    EXPECT_EQ(lost.count, 2u);
    EXPECT_EQ(lost.missing, std::vector<std::string>{"twin"}) << "nobody knows which of two";
    for (const LightEdit& edit : lost.edits)
        if (edit.kind == LightEdit::Kind::light) {
            EXPECT_EQ(edit.is_news(), edit.name == name || edit.is_added()) << edit.name;
            EXPECT_EQ(name_of(edit.light) == "renamed", edit.name == name);
        }
    const auto found = std::ranges::find(lost.edits, name, &LightEdit::name);
    ASSERT_NE(found, lost.edits.end());
    EXPECT_LT(glm::distance(quantity_of(found->light), quantity), 1e-4f * glm::length(quantity));
});

const Test older("unit.viewer.journal.one_of_an_older_run_is_read", [] {
    const Place place("cornell.gltf");
    const LoadedScene loaded = loaded_with(place.file);
    LightEditor edited(loaded, false);
    const LightEditor fresh(loaded, false);
    edited.enable(0, false);
    Journal(place.file).write(edited, same_file);
    const fs::path journal = fs::directory_iterator(place.folder / "steradian")->path();
    std::ifstream in(journal);
    auto root = nlohmann::json::parse(in);
    root.erase("json_hash"); // older journals had time and size of the file, and lights by their numbers
    for (auto& entry : root["edits"])
        for (const char* key : {"in_file", "node", "shape", "is_only_name"}) entry.erase(key);
    const auto time = fs::last_write_time(place.file).time_since_epoch().count();
    for (const bool is_same : {true, false}) {
        root["stamp"] = std::to_string(time) + " " + std::to_string(fs::file_size(place.file) + !is_same);
        std::ofstream(journal) << root;
        const FoundJournals found = Journal(place.file).find(fresh.edits(), other_file);
        EXPECT_TRUE(found.problems.empty());
        ASSERT_TRUE(found.newest.has_value());
        EXPECT_EQ(found.newest->has_file_changed, !is_same);
        LightEditor recovered(loaded, false);
        recovered.recover(found.newest->edits);
        expect_same_edits(recovered, edited);
    }
});

const Test damaged("unit.viewer.journal.a_damaged_one_is_moved_aside_and_said_once", [] {
    const Place place("cornell.gltf");
    const LoadedScene loaded = loaded_with(place.file);
    LightEditor edited(loaded, false);
    const LightEditor fresh(loaded, false);
    edited.enable(0, false);
    const fs::path folder = place.folder / "steradian";
    for (const char* text : {"", "{\"edits\": [", "[]", "{\"json_hash\": 1, \"edits\": [{\"kind\": 1}]}",
                             "{\"json_hash\": 1, \"edits\": 3}"}) {
        Journal(place.file).write(edited, same_file); // the good one, which is older
        const std::string good = fs::directory_iterator(folder)->path().filename().string();
        const fs::path bad = folder / (good.substr(0, good.rfind('-')) + "-7.json");
        std::ofstream(bad) << text;
        fs::last_write_time(bad, fs::last_write_time(folder / good) + std::chrono::seconds(5));
        FoundJournals found = Journal(place.file).find(fresh.edits(), same_file);
        ASSERT_EQ(found.problems.size(), 1u) << text;
        EXPECT_EQ(found.problems[0].find(bad.string() + ".damaged: is a damaged journal"), 0u)
            << found.problems[0];
        EXPECT_TRUE(found.newest.has_value()) << "the older one is found";
        EXPECT_TRUE(fs::exists(bad.string() + ".damaged"));
        found = Journal(place.file).find(fresh.edits(), same_file);
        EXPECT_TRUE(found.problems.empty()) << "once";
        fs::remove_all(folder);
    }
});

} // namespace
