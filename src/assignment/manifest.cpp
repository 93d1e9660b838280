#include "assignment/manifest.hpp"

#include "assignment/regions.hpp"
#include "core/error.hpp"
#include "core/json.hpp"

#include <algorithm>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <fstream>
#include <limits>
#include <numeric>
#include <set>
#include <sstream>

namespace sr::assignment {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;

std::string text_of_file(const fs::path& file) {
    std::ifstream stream(file, std::ios::binary);
    std::ostringstream text;
    if (stream) text << stream.rdbuf();
    if (!stream) throw Error({file.string()}, "cannot be read", "put it there, as assignment.json says");
    return text.str();
}

bool is_identifier(const std::string& name) {
    return !name.empty() && !std::isdigit(static_cast<unsigned char>(name[0]))
           && std::ranges::all_of(name, [](unsigned char c) { return std::isalnum(c) || c == '_'; });
}

/// One of the names, as its index. @throws Error
template<std::size_t N>
std::size_t chosen(const JsonObject& entry, const char* key, const std::array<const char*, N>& names,
                   const char* fallback) {
    const std::string text = entry.text(key, fallback);
    const auto found = std::ranges::find(names, text);
    if (found == names.end())
        entry.fail_at(key, fmt::format("\"{}\" is \"{}\"", key, text),
                      fmt::format("write one of {}", fmt::join(names, ", ")));
    return static_cast<std::size_t>(found - names.begin());
}

void read_range(const JsonObject& entry, double& low, double& high) {
    low = entry.number("from", low, -1e30, 1e30);
    high = entry.number("to", high, -1e30, 1e30);
    if (low > high) entry.fail(fmt::format("\"from\" {} is above \"to\" {}", low, high), "exchange them");
}

Input read_input(const JsonObject& entry, const std::string& name) {
    entry.allow_only({"kind", "from", "to", "log", "values", "around"});
    Input input;
    input.name = name;
    constexpr std::array kinds{"number", "list", "integer", "color", "box", "sphere", "hemisphere", "square"};
    input.kind =
        static_cast<Input::Kind>(chosen(entry, "kind", kinds, entry.has("values") ? "list" : "number"));
    if (input.kind == Input::Kind::hemisphere) input.low = 0.02; // what grazes is for no check by default
    read_range(entry, input.low, input.high);
    input.is_log = entry.flag("log", false);
    if (input.is_log && input.low <= 0.0) entry.fail("\"log\" with \"from\" ≤ 0", "begin above 0");
    input.around = entry.text("around", "");
    if (input.kind == Input::Kind::list) {
        if (!entry.has("values") || entry.value().at("values").empty())
            entry.fail("no \"values\"", "add a list of numbers");
        input.values = entry.numbers("values", entry.value().at("values").size());
    }
    return input;
}

std::vector<Input> read_inputs(const JsonObject& entry) {
    std::vector<Input> inputs;
    if (!entry.has("inputs")) return inputs;
    const json& member = entry.value().at("inputs");
    if (!member.is_array()) entry.fail_at("inputs", "no list", "write [ { \"NAME\": { … } }, … ]");
    for (const JsonObject& one : entry.objects("inputs")) {
        if (one.value().size() != 1)
            one.fail("an input has one name", "write { \"NAME\": { \"kind\": …, … } }");
        const std::string name = one.value().begin().key();
        if (!is_identifier(name))
            one.fail(fmt::format("\"{}\" is no name of GLSL", name), "write letters, digits and _");
        inputs.push_back(read_input(one.object(name), name));
        const Input& input = inputs.back();
        const auto same = [&](const std::string& n) { return std::ranges::find(inputs, n, &Input::name); };
        if (!input.around.empty() && same(input.around) == inputs.end())
            one.fail(fmt::format("\"around\" names no input before: \"{}\"", input.around),
                     "put that input first");
    }
    const int floats =
        std::accumulate(inputs.begin(), inputs.end(), 0, [](int n, const Input& i) { return n + i.size(); });
    if (floats > 12)
        entry.fail_at("inputs", fmt::format("{} numbers in a row of inputs", floats), "use at most 12");
    return inputs;
}

void read_relation(Check& check, const JsonObject& entry) {
    constexpr std::array<std::pair<const char*, Check::Relation>, 3> relations{
        {{"equals", Check::Relation::equals},
         {"at_most", Check::Relation::at_most},
         {"at_least", Check::Relation::at_least}}};
    for (const auto& [key, relation] : relations)
        if (entry.has(key)) {
            if (!check.other.empty()) entry.fail_at(key, "a second relation", "keep one of them");
            check.relation = relation;
            check.other = entry.required_text(key);
        }
}

void read_sampling(Check& check, const JsonObject& entry) {
    if (check.kind == Check::Kind::samples) {
        check.other = entry.required_text("density");
        check.rows = entry.integer("rows", 3, 1, 16);
    }
    if (check.kind == Check::Kind::slope) {
        check.other = entry.required_text("exact");
        if (!entry.has("counts") || entry.value().at("counts").size() < 3)
            entry.fail("\"counts\" needs at least three numbers", "write e.g. [4, 16, 64, 256]");
        for (const double count : entry.numbers("counts", entry.value().at("counts").size()))
            check.counts.push_back(static_cast<int>(count));
        check.slope = entry.number("slope", -0.5, -4.0, 1.0);
        check.slope_within = entry.number("within", 0.1, 0.0, 2.0);
    }
}

void read_image(Check& check, const JsonObject& entry, const fs::path& folder) {
    check.scene = entry.required_text("scene");
    check.camera = entry.text("camera", "0");
    if (entry.has("size")) {
        const auto size = entry.numbers("size", 2);
        if (size[0] < 1 || size[1] < 1 || size[0] > 1024 || size[1] > 1024)
            entry.fail_at("size", "no size of a picture", "write [width, height] from 1 to 1024");
        check.width = static_cast<int>(size[0]);
        check.height = static_cast<int>(size[1]);
    }
    check.samples = entry.integer("samples", 1, 1, 4096);
    check.shader = entry.text("shader", check.shader);
    check.tolerances = entry.texts("tolerance");
    const auto visibility = render::visibility_named(entry.text("visibility", "ray"));
    if (!visibility)
        entry.fail_at("visibility", "no way to find shadows", "write ray, ray-glsl, map or none");
    check.visibility = *visibility;
    check.unit = entry.text("unit", "cd/m²");
    if (!fs::is_regular_file(folder / check.scene))
        entry.fail_at("scene", fmt::format("no file {}", (folder / check.scene).string()),
                      "name a glTF file");
}

Check read_check(const JsonObject& entry, const fs::path& folder) {
    entry.allow_only({"name",     "kind",     "points",   "hint",    "unit",      "value",     "type",
                      "equals",   "at_most",  "at_least", "inputs",  "rows",      "mean_over", "mean_count",
                      "relative", "absolute", "density",  "exact",   "counts",    "slope",     "within",
                      "scene",    "camera",   "size",     "samples", "tolerance", "shader",    "visibility"});
    Check check;
    check.name = entry.required_text("name");
    constexpr std::array kinds{"value", "samples", "slope", "image"};
    check.kind = static_cast<Check::Kind>(chosen(entry, "kind", kinds, "value"));
    check.points = entry.number("points", 1.0, 0.0, 1000.0);
    check.hint = entry.text("hint", "");
    if (check.kind == Check::Kind::image) {
        read_image(check, entry, folder);
        return check;
    }
    check.unit = entry.text("unit", "");
    check.value = entry.required_text("value");
    constexpr std::array types{"float", "vec2", "vec3", "vec4", "bool", "int"};
    check.type = types[chosen(entry, "type", types, "float")];
    read_relation(check, entry);
    check.inputs = read_inputs(entry);
    check.rows = entry.integer("rows", entry.has("mean_over") ? 16 : 256, 1, 1 << 16);
    check.mean_over = entry.text("mean_over", "");
    check.mean_count = entry.integer("mean_count", 4096, 1, 1 << 20);
    if (!check.mean_over.empty()
        && std::ranges::find(check.inputs, check.mean_over, &Input::name) == check.inputs.end())
        entry.fail_at("mean_over", fmt::format("no input \"{}\"", check.mean_over), "name one of the inputs");
    check.nearness.relative = entry.number("relative", check.nearness.relative, 0.0, 1.0);
    check.nearness.absolute = entry.number("absolute", check.nearness.absolute, 0.0, 1e30);
    read_sampling(check, entry);
    return check;
}

/// The file whose region is the task's.
std::string file_of(const std::string& task, const Assignment& assignment, const JsonObject& entry) {
    for (const auto& [name, text] : assignment.files)
        for (const Region& region : regions_of(text, assignment.place_of(name)))
            if (region.name == task) return name;
    entry.fail_at("id", fmt::format("no file has a region {}", task),
                  fmt::format("write // begin solution {} and // end around its functions", task));
}

Task read_task(const JsonObject& entry, const Assignment& assignment) {
    entry.allow_only({"id", "title", "extra", "functions", "checks", "hints"});
    Task task;
    task.id = entry.required_text("id");
    task.title = entry.required_text("title");
    task.is_extra = entry.flag("extra", false);
    task.file = file_of(task.id, assignment, entry);
    task.functions = entry.texts("functions");
    if (task.functions.empty()) entry.fail("no \"functions\"", "name the functions that the student writes");
    for (const JsonObject& check : entry.objects("checks"))
        task.checks.push_back(read_check(check, assignment.folder));
    if (task.checks.empty()) entry.fail("no \"checks\"", "add one");
    if (entry.has("hints")) {
        const JsonObject hints = entry.object("hints");
        for (const auto& [name, text] : hints.value().items()) task.hints[name] = hints.text(name, "");
    }
    const fs::path file = assignment.folder / "variants" / (task.id + ".glsl");
    if (fs::exists(file)) {
        task.variants_place = file.string();
        task.variants = variants_of(text_of_file(file), task.variants_place);
    }
    for (const Variant& variant : task.variants)
        if (variant.is_mistake && !task.hints.contains(variant.name))
            throw Error({task.variants_place, variant.line - 1},
                        fmt::format("the mistake {} has no hint", variant.name),
                        fmt::format("add it to \"hints\" of {} in assignment.json", task.id));
    return task;
}

Parameter read_parameter(const JsonObject& entry, const std::string& name) {
    entry.allow_only({"unit", "about", "values", "from", "to", "decimals"});
    Parameter parameter;
    parameter.name = name;
    if (!is_identifier(name))
        entry.fail(fmt::format("\"{}\" is no name of GLSL", name), "write letters, digits and _");
    parameter.unit = entry.text("unit", "");
    parameter.about = entry.text("about", "");
    if (entry.has("values")) parameter.values = entry.numbers("values", entry.value().at("values").size());
    read_range(entry, parameter.low, parameter.high);
    parameter.decimals = entry.integer("decimals", 2, 0, 9);
    return parameter;
}

} // namespace

int Input::size() const {
    switch (kind) {
    case Kind::color:
    case Kind::box:
    case Kind::sphere:
    case Kind::hemisphere: return 3;
    case Kind::square: return 2;
    default: return 1;
    }
}

const char* Input::type() const {
    if (kind == Kind::integer) return "int";
    return size() == 3 ? "vec3" : size() == 2 ? "vec2" : "float";
}

double Task::points() const {
    return std::accumulate(checks.begin(), checks.end(), 0.0,
                           [](double sum, const Check& check) { return sum + check.points; });
}

std::string Assignment::place_of(const std::string& file) const {
    return (folder / "shaders" / file).string();
}

const Task& Assignment::task(const std::string& wanted) const {
    const auto found = std::ranges::find(tasks, wanted, &Task::id);
    if (found == tasks.end())
        throw Error({folder.string()}, fmt::format("no task {}", wanted), "name one of its tasks");
    return *found;
}

double Assignment::points() const {
    double sum = 0.0;
    for (const Task& task : tasks) sum += task.is_extra ? 0.0 : task.points();
    return sum;
}

Assignment load(const fs::path& folder) {
    const JsonFile text(folder / "assignment.json");
    const JsonObject root(text, JsonObject::Pointer(""));
    root.allow_only({"$schema", "title", "summary", "scene", "files", "parameters", "tasks"});
    Assignment assignment;
    assignment.folder = folder;
    assignment.id = fs::weakly_canonical(folder).filename().string();
    assignment.title = root.required_text("title");
    assignment.summary = root.text("summary", "");
    assignment.scene = root.text("scene", "");
    for (const std::string& name : root.texts("files"))
        assignment.files[name] = text_of_file(folder / "shaders" / name);
    if (assignment.files.empty())
        root.fail("no \"files\"", "name the GLSL files of shaders/ that students get");
    if (root.has("parameters")) {
        const JsonObject parameters = root.object("parameters");
        for (const auto& [name, value] : parameters.value().items())
            assignment.parameters.push_back(read_parameter(parameters.object(name), name));
    }
    std::set<std::string> ids;
    for (const JsonObject& entry : root.objects("tasks")) {
        assignment.tasks.push_back(read_task(entry, assignment));
        if (!ids.insert(assignment.tasks.back().id).second)
            entry.fail_at("id", fmt::format("the task {} is there twice", assignment.tasks.back().id),
                          "keep one");
    }
    if (assignment.tasks.empty()) root.fail("no \"tasks\"", "add one");
    return assignment;
}

void add_hidden_checks(Assignment& assignment, const fs::path& folder) {
    const JsonFile text(folder / "hidden.json");
    const JsonObject root(text, JsonObject::Pointer(""));
    root.allow_only({"$schema", "seed", "tasks"});
    const int seed = root.integer("seed", 2, 0, std::numeric_limits<int>::max());
    if (!root.has("tasks")) root.fail("no \"tasks\"", "write { \"A1.1\": [ checks ] }");
    const JsonObject tasks = root.object("tasks");
    for (const auto& [id, list] : tasks.value().items()) {
        const auto task = std::ranges::find(assignment.tasks, id, &Task::id);
        if (task == assignment.tasks.end())
            tasks.fail_at(id, fmt::format("{} has no task {}", assignment.id, id), "name one of its tasks");
        for (const JsonObject& entry : tasks.objects(id)) {
            Check check = read_check(entry, folder);
            check.is_hidden = true;
            check.seed = static_cast<unsigned int>(seed);
            if (check.kind == Check::Kind::image) check.scene = fs::absolute(folder / check.scene).string();
            task->checks.push_back(std::move(check));
        }
    }
}

} // namespace sr::assignment
