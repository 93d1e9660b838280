#include "viewer/document/journal.hpp"

#include "core/error.hpp"
#include "core/file.hpp"
#include "viewer/config.hpp"

#include <algorithm>
#include <array>
#include <fcntl.h>
#include <fmt/format.h>
#include <functional>
#include <nlohmann/json.hpp>
#include <sys/file.h>
#include <sys/stat.h>
#include <type_traits>
#include <unistd.h>
#include <utility>
#include <variant>

namespace sr::viewer {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;
using Kind = LightEdit::Kind;

json json_of(vec3 v) { return {v.x, v.y, v.z}; }

json json_of(const std::vector<vec3>& points) {
    json array = json::array();
    for (const vec3 point : points) array.push_back(json_of(point));
    return array;
}

vec3 vec3_in(const json& value) {
    const auto v = value.get<std::array<float, 3>>();
    return {v[0], v[1], v[2]};
}

void read_into(vec3& v, const json& value) { v = vec3_in(value); }

void read_into(std::vector<vec3>& points, const json& value) {
    points.clear();
    for (const json& point : value) points.push_back(vec3_in(point));
}

/// Calls act(key, member) for each member of an added light (gltf::is_addable()) but its quantity and its
/// sizes.
template<class L, class Act>
void for_each_member(L& light, const Act& act) {
    act("name", light.name);
    if constexpr (requires { light.position; }) act("at", light.position);
    if constexpr (requires { light.center; }) act("at", light.center);
    if constexpr (requires { light.direction; }) act("direction", light.direction);
    if constexpr (requires { light.half_u; }) {
        act("half_u", light.half_u);
        act("half_v", light.half_v);
    }
    if constexpr (requires { light.corners; }) act("corners", light.corners);
    if constexpr (requires { light.is_two_sided; }) act("is_two_sided", light.is_two_sided);
    if constexpr (requires { light.half_axis; }) act("half_axis", light.half_axis);
    if constexpr (requires { light.radius; }) act("radius", light.radius);
    if constexpr (requires { light.angular_radius; }) act("angular_radius", light.angular_radius);
    if constexpr (requires { light.outer_angle; }) {
        act("inner_angle", light.inner_angle);
        act("outer_angle", light.outer_angle);
    }
    if constexpr (requires { light.range; }) act("range", light.range);
    if constexpr (requires { light.is_visible; }) act("is_visible", light.is_visible);
}

json shape_json(const scene::Light& light) {
    json shape{{"shape", scene::light_kind_names()[light.index()]}};
    const auto write = [&](const char* key, const auto& member) {
        if constexpr (requires { json_of(member); })
            shape[key] = json_of(member);
        else
            shape[key] = member; // JSON has no infinity: null
    };
    std::visit([&](const auto& l) { for_each_member(l, write); }, light);
    return shape;
}

scene::Light shape_in(const json& shape) {
    const auto read = [&](const char* key, auto& member) {
        if (!shape.contains(key) || shape.at(key).is_null()) return;
        if constexpr (requires { read_into(member, shape.at(key)); })
            read_into(member, shape.at(key));
        else
            member = shape.at(key).get<std::decay_t<decltype(member)>>();
    };
    scene::Light light;
    scene::for_each_light_kind([&]<class L>(std::type_identity<L>) {
        if (shape.at("shape") == L::kind) light = L();
    });
    std::visit([&](auto& l) { for_each_member(l, read); }, light);
    return light;
}

json json_of(const LightEdit& edit) {
    json entry{{"kind", static_cast<int>(edit.kind)},
               {"source", edit.source},
               {"is_enabled", edit.is_enabled},
               {"is_removed", edit.is_removed},
               {"in_file", edit.name},
               {"node", edit.node},
               {"shape", scene::light_kind_names()[edit.light.index()]}};
    if (edit.overrides_quantity)
        entry["quantity"] = json_of(edit.kind == Kind::material ? edit.emission : quantity_of(edit.light));
    if (edit.overrides_size || edit.is_added())
        for (const scene::LightSize& size : scene::sizes_of(edit.light)) entry["sizes"].push_back(size.size);
    std::array<float, 16> motion{};
    std::copy_n(&edit.motion[0][0], motion.size(), motion.begin());
    entry["motion"] = motion;
    if (edit.is_added()) entry["added"] = shape_json(edit.light);
    if (edit.overrides_name) entry["name"] = name_of(edit.light);
    const MaterialFactors& factors = edit.factors;
    if (const auto& c = factors.base_color) entry["base_color"] = {c->x, c->y, c->z, c->w};
    if (factors.metallic) entry["metallic"] = *factors.metallic;
    if (factors.roughness) entry["roughness"] = *factors.roughness;
    for (const auto& [index, value] : factors.others)
        entry["factors"][std::string(gltf::editable_factors[index].key)] = json_of(value);
    return entry;
}

/// Changes an edit to what the journal says.
void recover(LightEdit& edit, const json& entry) {
    edit.is_enabled = entry.at("is_enabled").get<bool>();
    edit.is_removed = entry.at("is_removed").get<bool>();
    const auto motion = entry.at("motion").get<std::array<float, 16>>();
    std::copy_n(motion.begin(), motion.size(), &edit.motion[0][0]);
    if (edit.kind == Kind::softbox) edit.light = transformed(edit.light, edit.motion);
    if (entry.contains("sizes")) {
        const auto sizes = entry.at("sizes").get<std::vector<float>>();
        const std::size_t count = std::min(sizes.size(), scene::sizes_of(edit.light).size());
        for (std::size_t i = 0; i < count; ++i)
            if (sizes[i] > 0.0f) scene::set_size(edit.light, i, sizes[i]);
        edit.overrides_size = !edit.is_added();
    }
    if (entry.contains("name")) {
        scene::set_name(edit.light, entry.at("name").get<std::string>());
        edit.overrides_name = true;
    }
    if (entry.contains("base_color")) {
        const auto c = entry.at("base_color").get<std::array<float, 4>>();
        edit.factors.base_color = vec4(c[0], c[1], c[2], c[3]);
    }
    if (entry.contains("metallic")) edit.factors.metallic = entry.at("metallic").get<float>();
    if (entry.contains("roughness")) edit.factors.roughness = entry.at("roughness").get<float>();
    for (std::size_t i = 0; entry.contains("factors") && i < gltf::editable_factors.size(); ++i) {
        const std::string key(gltf::editable_factors[i].key);
        if (entry.at("factors").contains(key)) edit.factors.others[i] = vec3_in(entry.at("factors").at(key));
    }
    if (!entry.contains("quantity")) return;
    const vec3 quantity = vec3_in(entry.at("quantity"));
    edit.overrides_quantity = true;
    if (edit.kind == Kind::material)
        edit.emission = quantity;
    else
        scene::set_quantity(edit.light, quantity);
}

bool have_same_name(const LightEdit& a, const LightEdit& b) {
    return a.kind == b.kind && a.is_added() == b.is_added() && a.name == b.name;
}

/// True if an edit is of the light or the material of an entry, in a file whose JSON has not changed since.
/// Numbers of lights depend on the time at which they were seen first; their nodes do not.
bool is_of(const LightEdit& edit, const json& entry) {
    if (static_cast<int>(edit.kind) != entry.at("kind").get<int>()) return false;
    if (edit.node != entry.at("node").get<int>()) return false;
    return edit.node < 0 ? edit.source == entry.at("source").get<int>()
                         : edit.name == entry.at("in_file").get<std::string>();
}

/// The same in a file that has changed: numbers may be those of others.
bool is_named_by(const LightEdit& edit, const json& entry) {
    const bool is_numbered = edit.kind == Kind::softbox || edit.source < 0; // by us, not by the file
    if (is_numbered) return is_of(edit, entry);
    return static_cast<int>(edit.kind) == entry.at("kind").get<int>() && !edit.name.empty()
           && edit.name == entry.at("in_file").get<std::string>() && entry.at("is_only_name").get<bool>()
           && entry.at("shape") == scene::light_kind_names()[edit.light.index()];
}

/// The same for an entry of a journal that named nodes not yet.
bool is_of_number(const LightEdit& edit, const json& entry) {
    return static_cast<int>(edit.kind) == entry.at("kind").get<int>()
           && edit.source == entry.at("source").get<int>();
}

/// The name of an entry's light or material, or what is known of it.
std::string name_in(const json& entry) {
    return entry.contains("in_file") ? entry.at("in_file").get<std::string>()
                                     : fmt::format("number {}", entry.at("source").get<int>());
}

/// Brings the entries of a journal into the edits of `lost`.
void recover(LostEdits& lost, const json& entries) {
    std::vector<LightEdit>& edits = lost.edits;
    for (const json& entry : entries) {
        const auto matches = [&](const LightEdit& edit) {
            if (!entry.contains("node")) return is_of_number(edit, entry);
            return lost.has_file_changed ? is_named_by(edit, entry) : is_of(edit, entry);
        };
        auto known = std::ranges::find_if(edits, matches);
        const int source = entry.at("source").get<int>();
        const bool is_added = source < 0 && entry.contains("added");
        const bool is_ambiguous = std::ranges::count_if(edits, matches) > 1;
        if (is_ambiguous || (known == edits.end() && !is_added)) {
            lost.missing.push_back(name_in(entry));
            continue;
        }
        if (known == edits.end()) {
            LightEdit edit;
            edit.source = source;
            edit.light = shape_in(entry.at("added"));
            known = edits.insert(edits.end(), std::move(edit));
        }
        recover(*known, entry);
        ++lost.count;
    }
}

/// Moves a damaged journal to where no run looks for it. @return its new path, or the old one if it cannot be
/// moved
fs::path moved_aside(const fs::path& journal) {
    fs::path aside = journal.string() + ".damaged";
    std::error_code failure;
    for (int number = 2; fs::exists(aside, failure); ++number)
        aside = fmt::format("{}.damaged{}", journal.string(), number);
    fs::rename(journal, aside, failure);
    return failure ? journal : aside;
}

/// Time and size of a scene file, by which older journals noticed a change.
std::string stamp_of(const std::string& file) {
    std::error_code ignored;
    const auto time = fs::last_write_time(file, ignored).time_since_epoch().count();
    return fmt::format("{} {}", time, fs::file_size(file, ignored));
}

/// Reads a journal of `scene_file`. @throws Error if it cannot be read; json::exception if it is damaged
LostEdits read_journal(const fs::path& journal, const std::string& scene_file,
                       const std::vector<LightEdit>& fresh, std::size_t json_hash) {
    const json root = json::parse(read_text(journal));
    LostEdits lost{journal, fresh};
    lost.has_file_changed = root.is_object() && root.contains("stamp")
                                ? root.at("stamp") != stamp_of(scene_file)
                                : root.at("json_hash").get<std::size_t>() != json_hash;
    recover(lost, root.at("edits"));
    return lost;
}

fs::path lock_of(fs::path journal) { return journal.replace_extension(".lock"); }

/// Locks the lock of a journal. @return its descriptor; -1 if another run holds it or it cannot be made
int locked(const fs::path& journal) {
    const fs::path file = lock_of(journal);
    const int descriptor = open(file.c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0600);
    if (descriptor < 0) return -1;
    struct stat held {
    }, named{};
    const bool is_held = flock(descriptor, LOCK_EX | LOCK_NB) == 0 && fstat(descriptor, &held) == 0;
    // A run that has ended meanwhile may have removed the file that was opened.
    if (is_held && stat(file.c_str(), &named) == 0 && held.st_ino == named.st_ino) return descriptor;
    close(descriptor);
    return -1;
}

void unlock(const fs::path& journal, int descriptor) {
    std::error_code ignored;
    fs::remove(lock_of(journal), ignored); // while it is held, so that nobody else's is removed
    close(descriptor);
}

/// True unless the run that wrote the journal still lives.
bool is_lost(const fs::path& journal) {
    const int descriptor = locked(journal);
    if (descriptor >= 0) unlock(journal, descriptor);
    return descriptor >= 0;
}

} // namespace

Journal::Journal(const std::string& scene_file) : scene_file_(scene_file) {
    std::error_code failure;
    const fs::path whole = fs::weakly_canonical(scene_file, failure);
    const fs::path folder = state_folder();
    if (failure || folder.empty()) return;
    constexpr std::size_t max_stem = 100; // of the 255 bytes that a file's name has
    prefix_ = fmt::format("{}-{:016x}-", whole.stem().string().substr(0, max_stem),
                          std::hash<std::string>{}(whole.string()));
    constexpr int max_runs = 1000; // journals that nobody has answered
    for (int run = 1; run <= max_runs; ++run) {
        const fs::path journal = folder / fmt::format("{}{}.json", prefix_, run);
        if (fs::exists(journal, failure)) continue; // another run's, which lives or has lost it
        lock_ = locked(journal);
        if (lock_ < 0) continue;
        file_ = journal;
        return;
    }
}

Journal::~Journal() {
    if (lock_ >= 0) unlock(file_, lock_);
}

FoundJournals Journal::find(const std::vector<LightEdit>& fresh, std::size_t json_hash) const {
    FoundJournals found;
    if (file_.empty()) return found;
    std::vector<std::pair<fs::file_time_type, fs::path>> journals;
    std::error_code failure, ignored;
    for (fs::directory_iterator entry(file_.parent_path(), failure);
         !failure && entry != fs::directory_iterator(); entry.increment(failure)) {
        const std::string name = entry->path().filename().string();
        const bool is_journal = name.starts_with(prefix_) && entry->path().extension() == ".json";
        if (is_journal && entry->path() != file_ && is_lost(entry->path()))
            journals.emplace_back(entry->last_write_time(ignored), entry->path());
    }
    std::ranges::sort(journals, std::greater());
    for (const auto& [time, journal] : journals) {
        if (found.newest) break;
        try {
            LostEdits lost = read_journal(journal, scene_file_, fresh, json_hash);
            if (lost.count > 0 || !lost.missing.empty()) found.newest = std::move(lost);
        } catch (const Error& error) {
            found.problems.emplace_back(error.what());
        } catch (const json::exception&) {
            found.problems.emplace_back(Error({moved_aside(journal).string()},
                                              "is a damaged journal of unsaved edits",
                                              "look into it, an entry is an edit, or remove it")
                                            .what());
        }
    }
    return found;
}

bool Journal::write(const LightEditor& editor, std::size_t json_hash) const {
    if (!editor.is_unsaved()) {
        remove();
        return true;
    }
    json journal{{"json_hash", json_hash}, {"edits", json::array()}};
    for (const LightEdit& edit : editor.edits()) {
        if (!edit.is_news()) continue;
        json entry = json_of(edit);
        entry["is_only_name"] =
            std::ranges::count_if(editor.edits(),
                                  [&](const LightEdit& other) { return have_same_name(other, edit); })
            == 1;
        journal["edits"].push_back(std::move(entry));
    }
    // A name of a light that is no UTF-8 loses those letters, not the edits.
    return write_lines(file_, {journal.dump(-1, ' ', false, json::error_handler_t::replace)});
}

void Journal::remove() const {
    std::error_code ignored;
    if (!file_.empty()) fs::remove(file_, ignored);
}

} // namespace sr::viewer
