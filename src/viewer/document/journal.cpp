#include "viewer/document/journal.hpp"

#include "core/error.hpp"
#include "core/file.hpp"
#include "viewer/config.hpp"

#include <algorithm>
#include <array>
#include <cerrno>
#include <charconv>
#include <csignal>
#include <fmt/format.h>
#include <functional>
#include <nlohmann/json.hpp>
#include <unistd.h>

namespace sr::viewer {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;
using Kind = LightEdit::Kind;

json json_of(vec3 v) { return {v.x, v.y, v.z}; }

vec3 vec3_in(const json& value) {
    const auto v = value.get<std::array<float, 3>>();
    return {v[0], v[1], v[2]};
}

/// Describes an added light, which is one of three kinds.
json shape_json(const scene::Light& light) {
    if (const auto* point = std::get_if<scene::PointLight>(&light))
        return {{"shape", "point"}, {"name", point->name}, {"at", json_of(point->position)}};
    if (const auto* sphere = std::get_if<scene::SphereLight>(&light))
        return {{"shape", "sphere"}, {"name", sphere->name}, {"at", json_of(sphere->center)}};
    const auto& rectangle = std::get<scene::RectangleLight>(light);
    return {{"shape", "rectangle"},
            {"name", rectangle.name},
            {"at", json_of(rectangle.center)},
            {"half_u", json_of(rectangle.half_u)},
            {"half_v", json_of(rectangle.half_v)}};
}

scene::Light shape_in(const json& shape) {
    const auto name = shape.at("name").get<std::string>();
    const vec3 at = vec3_in(shape.at("at"));
    if (shape.at("shape") == "point") return scene::PointLight{name, at};
    if (shape.at("shape") == "sphere") return scene::SphereLight{name, at};
    return scene::RectangleLight{name, at, vec3_in(shape.at("half_u")), vec3_in(shape.at("half_v"))};
}

json json_of(const LightEdit& edit) {
    json entry{{"kind", static_cast<int>(edit.kind)},
               {"source", edit.source},
               {"is_enabled", edit.is_enabled},
               {"is_removed", edit.is_removed}};
    if (edit.overrides_quantity)
        entry["quantity"] = json_of(edit.kind == Kind::material ? edit.emission : quantity_of(edit.light));
    if (edit.overrides_size || edit.is_added())
        for (const scene::LightSize& size : scene::sizes_of(edit.light)) entry["sizes"].push_back(size.size);
    std::array<float, 16> motion{};
    std::copy_n(&edit.motion[0][0], motion.size(), motion.begin());
    entry["motion"] = motion;
    if (edit.is_added()) entry["added"] = shape_json(edit.light);
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
    if (!entry.contains("quantity")) return;
    const vec3 quantity = vec3_in(entry.at("quantity"));
    edit.overrides_quantity = true;
    if (edit.kind == Kind::material)
        edit.emission = quantity;
    else
        scene::set_quantity(edit.light, quantity);
}

/// Brings the entries of a journal into the edits. @return how many of them the file has a light for
std::size_t recover(std::vector<LightEdit>& edits, const json& entries) {
    std::size_t count = 0;
    for (const json& entry : entries) {
        const auto kind = static_cast<Kind>(entry.at("kind").get<int>());
        const int source = entry.at("source").get<int>();
        auto known = std::ranges::find_if(
            edits, [&](const LightEdit& e) { return e.kind == kind && e.source == source; });
        const bool is_added = source < 0 && entry.contains("added");
        if (known == edits.end() && !is_added) continue;
        if (known == edits.end()) {
            LightEdit edit;
            edit.source = source;
            edit.light = shape_in(entry.at("added"));
            known = edits.insert(edits.end(), std::move(edit));
        }
        recover(*known, entry);
        ++count;
    }
    return count;
}

/// Time and size of the file, by which a change is noticed.
std::string stamp_of(const std::string& file) {
    std::error_code ignored;
    const auto time = fs::last_write_time(file, ignored).time_since_epoch().count();
    return fmt::format("{} {}", time, fs::file_size(file, ignored));
}

/// True unless the process that wrote the journal still runs. `name`: its file's, PREFIX-PROCESS.json.
bool is_lost(const std::string& name, const std::string& prefix) {
    int process = 0;
    const char* const end = name.data() + name.size();
    const auto read = std::from_chars(name.data() + prefix.size(), end, process);
    const bool is_number = read.ec == std::errc() && std::string_view(read.ptr, end) == ".json";
    return is_number && process > 0 && kill(process, 0) != 0 && errno == ESRCH;
}

} // namespace

Journal::Journal(const std::string& scene_file) : scene_file_(scene_file) {
    std::error_code failure;
    const fs::path whole = fs::weakly_canonical(scene_file, failure);
    const fs::path folder = state_folder();
    if (failure || folder.empty()) return;
    prefix_ = fmt::format("{}-{:016x}-", whole.stem().string(), std::hash<std::string>{}(whole.string()));
    file_ = folder / fmt::format("{}{}.json", prefix_, getpid());
}

std::optional<LostEdits> Journal::find(const std::vector<LightEdit>& fresh) const {
    if (file_.empty()) return std::nullopt;
    std::optional<fs::path> newest;
    std::error_code failure, ignored;
    for (fs::directory_iterator entry(file_.parent_path(), failure);
         !failure && entry != fs::directory_iterator(); entry.increment(failure)) {
        const std::string name = entry->path().filename().string();
        if (!name.starts_with(prefix_) || !is_lost(name, prefix_)) continue;
        if (!newest || fs::last_write_time(*newest, ignored) < fs::last_write_time(entry->path(), ignored))
            newest = entry->path();
    }
    if (!newest) return std::nullopt;
    try {
        const json journal = json::parse(read_text(*newest));
        LostEdits lost{*newest, fresh};
        lost.count = recover(lost.edits, journal.at("edits"));
        lost.has_file_changed = journal.at("stamp") != stamp_of(scene_file_);
        if (lost.count > 0) return lost;
    } catch (const Error&) {
    } catch (const json::exception&) {
    }
    return std::nullopt;
}

void Journal::write(const LightEditor& editor) const {
    if (!editor.is_unsaved()) return remove();
    json journal{{"file", scene_file_}, {"stamp", stamp_of(scene_file_)}, {"edits", json::array()}};
    for (const LightEdit& edit : editor.edits())
        if (edit.is_news()) journal["edits"].push_back(json_of(edit));
    write_lines(file_, {journal.dump()});
}

void Journal::remove() const {
    std::error_code ignored;
    if (!file_.empty()) fs::remove(file_, ignored);
}

} // namespace sr::viewer
