#include "assignment/questions.hpp"

#include "assignment/film_difference.hpp"
#include "assignment/probed_pixel.hpp"
#include "core/file.hpp"
#include "glsl/untrusted.hpp"
#include "image/whole_file.hpp"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fmt/format.h>

namespace sr::assignment {
namespace {

using nlohmann::ordered_json;

constexpr int view_width = 128, view_height = 96;
constexpr int max_tries = 10;            // changes that a question tries
constexpr double invisible_share = 5e-4; // of L_o: a light that adds no more adds nothing
constexpr std::size_t max_lights = 12;   // that the choice of a pixel looks at

/// A number of the seed, equal on every machine (FNV-1a).
unsigned int number_of(const std::string& seed) {
    unsigned int hash = 2166136261u;
    for (const char c : seed) hash = (hash ^ static_cast<unsigned char>(c)) * 16777619u;
    return hash;
}

/// std::shuffle differs between libraries.
template<class T>
void shuffle(std::vector<T>& values, std::mt19937& random) {
    for (std::size_t i = values.size(); i > 1; --i) std::swap(values[i - 1], values[random() % i]);
}

ordered_json pictures_of(const image::Image& before, const image::Image& after) {
    return {{{"caption", "before"}, {"png", png_of(before, before)}},
            {{"caption", "after"}, {"png", png_of(after, before)}}};
}

std::string file_name(const Code& code) { return std::filesystem::path(code.place).filename().string(); }

std::string line_text(const std::string& file, const CodeChange& change) {
    return fmt::format("{}:{} `{}`", file, change.line, change.from);
}

ordered_json json_of(const std::string& file, const CodeChange& change) {
    return {{"file", file},    {"line", change.line}, {"from", change.from},
            {"to", change.to}, {"kind", change.name}, {"part", change.part}};
}

/// Names of checks by whether they passed.
std::map<std::string, bool> passed_checks(const ordered_json& task) {
    std::map<std::string, bool> passed;
    for (const ordered_json& check : task["checks"]) passed[check["name"]] = check["passed"];
    return passed;
}

/// The scene of an assignment's last image check of it, which uses most of the code, or plain settings.
Check view_of(const Assignment& assignment) {
    Check view;
    view.kind = Check::Kind::image;
    view.scene = assignment.scene;
    for (const Task& task : assignment.tasks)
        for (const Check& check : task.checks)
            if (check.kind == Check::Kind::image && check.scene == assignment.scene
                && check.shader == view.shader)
                view = check;
    view.width = view_width;
    view.height = view_height;
    view.samples = std::max(4, std::min(view.samples, 16));
    return view;
}

/// States the law of a check.
std::string statement_of(const Check& check) {
    if (check.kind == Check::Kind::samples)
        return fmt::format("directions drawn by {} are as dense as {} says", check.value, check.other);
    if (check.kind == Check::Kind::slope)
        return fmt::format("the error of {} falls with the number of samples as n^{:g}", check.value,
                           check.slope);
    if (check.relation == Check::Relation::reference) return check.value + " is what the handout says";
    const char* sign = check.relation == Check::Relation::at_most    ? "≤"
                       : check.relation == Check::Relation::at_least ? "≥"
                                                                     : "=";
    const std::string mean =
        check.mean_over.empty() ? "" : fmt::format("the mean over {} of ", check.mean_over);
    return fmt::format("{}{} {} {}", mean, check.value, sign, check.other);
}

bool is_law(const Check& check) {
    return !check.is_hidden && check.kind != Check::Kind::image
           && (check.kind != Check::Kind::value || check.relation != Check::Relation::reference);
}

} // namespace

Examiner::Examiner(const Assignment& assignment, const Submission& submission, const std::string& student,
                   const std::vector<std::string>& tasks, const std::string& seed)
    : assignment_(assignment),
      student_(student),
      parameters_(parameters_of(assignment, student)),
      pictures_(assignment_, parameters_, known_),
      marker_(assignment, student),
      view_(view_of(assignment)),
      random_(number_of(seed.empty() ? student : seed)) {
    for (const auto& [region, code] : submission.codes)
        if (region == helpers_region || std::ranges::find(tasks, region) != tasks.end())
            codes_[region] = code;
    for (const Task& task : assignment.tasks)
        if (codes_.contains(task.id)) tasks_.push_back(&task);
    if (tasks_.empty()) throw Error("no task of this submission has code that runs", "ask about its plan");
}

/// Makes a submission of one task: its code, with a change, and the helpers.
Submission Examiner::alone(const Task& task, const CodeChange* change) const {
    Submission submission;
    for (const std::string& region : {task.id, std::string(helpers_region)})
        if (const auto found = codes_.find(region); found != codes_.end()) submission.codes.insert(*found);
    if (change) submission.codes[task.id] = changed(codes_.at(task.id), *change);
    return submission;
}

Codes Examiner::with(const TaskChange& change) const {
    Codes codes = codes_;
    codes[change.task->id] = changed(codes_.at(change.task->id), change.change);
    return codes;
}

std::vector<Examiner::TaskChange> Examiner::shuffled_changes(const Task* only) {
    std::vector<TaskChange> changes;
    for (const Task* task : tasks_)
        if (!only || task == only)
            for (const CodeChange& change : code_changes(codes_.at(task->id)))
                changes.push_back({task, change});
    shuffle(changes, random_);
    return changes;
}

render::RenderOptions Examiner::options_of(const Codes& codes) const {
    render::RenderOptions options;
    options.width = view_.width;
    options.height = view_.height;
    options.samples = view_.samples;
    options.shader = view_.shader;
    options.shader_path = shader_path(assignment_, parameters_, codes);
    return options;
}

const scene::RenderScene& Examiner::stage() { return pictures_.shown(view_).stage; }

/// Absent if the code does not compile, or one of its loops was stopped.
std::optional<image::Image> Examiner::rendered(const Codes& codes) {
    try {
        return pictures_.render(view_, codes);
    } catch (const gl::ShaderError&) {
    } catch (const glsl::LoopError&) {
    }
    return std::nullopt;
}

/// L_o at a pixel, by the lights [first, end) alone. Absent as rendered() is.
std::optional<vec3> Examiner::value_at(const Place& place, const Codes& codes, int first, int end) {
    try {
        render::RenderOptions options = options_of(codes);
        options.window = render::PixelRect{place.x, place.y, 1, 1};
        render::Renderer renderer(*pictures_.shown(view_).gpu, stage().camera, options);
        renderer.use_lights(first, end);
        for (int i = 0; i < view_.samples; ++i) renderer.add_sample();
        return rgb_at(renderer.read_film(), place.x, place.y);
    } catch (const gl::ShaderError&) {
    } catch (const glsl::LoopError&) {
    }
    return std::nullopt;
}

/// Chooses a pixel to which a light adds nothing while the picture has it elsewhere; if there is none, one
/// that is lit. Its neighbours are alike, so that it lies on no edge.
Examiner::Place Examiner::interesting_place() {
    render::Renderer renderer(*pictures_.shown(view_).gpu, stage().camera, options_of(codes_));
    const auto film_of = [&](std::size_t first, std::size_t end) {
        renderer.clear();
        renderer.use_lights(static_cast<int>(first), static_cast<int>(end));
        for (int i = 0; i < view_.samples; ++i) renderer.add_sample();
        return renderer.read_film();
    };
    const image::Image whole = film_of(0, stage().lights.size()), dark = film_of(0, 0);
    const double floor = 1e-4 * mean_of(whole);
    std::vector<Place> places, lit;
    const auto gather = [&](const image::Image& film, std::optional<std::size_t> light) {
        std::vector<Place> own_places, own_lit;
        const auto is_lit = [&](int x, int y) {
            if (!light) return luminance(rgb_at(film, x, y)) > floor;
            const double part = luminance(rgb_at(film, x, y)) - luminance(rgb_at(dark, x, y));
            return part > std::min(floor, invisible_share * luminance(rgb_at(whole, x, y)));
        };
        for (int y = 6; y + 6 < film.height; ++y)
            for (int x = 6; x + 6 < film.width; ++x) {
                bool is_plain = true; // the neighbours are surfaces alike, none of which emits
                for (int j = -2; j <= 2; j += 2)
                    for (int i = -2; i <= 2; i += 2)
                        is_plain = is_plain && whole.at(x + i, y + j)[3] > 0.999f
                                   && is_lit(x + i, y + j) == is_lit(x, y)
                                   && (!light || luminance(rgb_at(dark, x + i, y + j)) <= floor);
                if (is_plain) (is_lit(x, y) ? own_lit : own_places).push_back({x, y, light});
            }
        if (!light) lit = own_lit;
        // A light that adds nothing anywhere is no riddle.
        if (light && !own_lit.empty()) places.insert(places.end(), own_places.begin(), own_places.end());
    };
    gather(whole, std::nullopt);
    for (std::size_t k = 0; k < std::min(stage().lights.size(), max_lights); ++k)
        gather(film_of(k, k + 1), k);
    std::vector<Place>& from = places.empty() ? lit : places;
    if (from.empty()) throw Error("the picture is black", "ask which line makes it so");
    return from[random_() % from.size()];
}

/// Tries changes and adds an answer for each line that decides L_o at the place: it alters it by so much that
/// the pixel shows it. `before`: what the place has by its dark light alone, or else L_o.
ordered_json Examiner::deciding_lines(const Place& place, vec3 L_o, vec3 before, ordered_json& answer) {
    constexpr std::size_t max_found = 2;
    const int all = static_cast<int>(stage().lights.size());
    const int first = place.dark ? static_cast<int>(*place.dark) : 0, end = place.dark ? first + 1 : all;
    const double floor = std::max<double>(0.01 * mean_of(*film_), luminance(L_o));
    ordered_json found = ordered_json::array();
    const auto tried = [&](const TaskChange& change) {
        const std::string file = file_name(codes_.at(change.task->id));
        const auto value = value_at(place, with(change), first, end);
        if (!value || !std::isfinite(value->x + value->y + value->z) || !differs(*value, before, floor))
            return;
        answer.push_back(fmt::format(
            "{}: with `{}` {} becomes {} instead of {}.", line_text(file, change.change), change.change.to,
            place.dark ? "that light's part" : "L_o", rgb_text(*value), rgb_text(before)));
        ordered_json line = json_of(file, change.change);
        line["task"] = change.task->id;
        line["value"] = {value->x, value->y, value->z};
        found.push_back(line);
    };
    std::vector<TaskChange> changes = shuffled_changes();
    // The lines that make a cosine and cut it off come first.
    std::ranges::stable_partition(changes, [](const TaskChange& c) { return c.change.name == "remove_max"; });
    for (std::size_t i = 0; i < std::min<std::size_t>(changes.size(), max_tries); ++i)
        if (found.size() < max_found) tried(changes[i]);
    return found;
}

ordered_json Examiner::pixel_question() {
    film_ = rendered(codes_);
    if (!film_) throw Error("the scene cannot be rendered with this code", "ask about the marks");
    const Place place = interesting_place();
    const auto& shown = pictures_.shown(view_);
    const auto probed = [&](const Codes& codes) {
        return *render::probe(*shown.gpu, shown.stage.camera, options_of(codes), place.x, place.y);
    };
    const render::PixelTerms terms = probed(codes_), reference = probed({});
    ordered_json answer = ordered_json::array();
    if (place.dark)
        answer.push_back(reason_of_darkness(stage().lights[*place.dark], *place.dark, terms, reference));
    const vec3 before = place.dark ? terms.lights[*place.dark].L_r + terms.L_e : terms.L_o;
    const ordered_json lines = deciding_lines(place, terms.L_o, before, answer);
    if (lines.empty()) answer.push_back("No change that was tried alters this pixel.");
    const bool has_cosine =
        !lines.empty() && lines[0]["part"].get<std::string>().find("dot(n") != std::string::npos;
    const std::string light = place.dark ? name_at(stage().lights[*place.dark], *place.dark) : "";
    std::string ask = fmt::format("Which of your lines {} at the marked pixel ({}, {})",
                                  has_cosine ? "makes cosθ" : "decides L_o", place.x, place.y);
    ask += place.dark ? fmt::format(", and why does {} add nothing there?", light)
                      : fmt::format(", and why is L_o = {} there?", rgb_text(terms.L_o));
    ordered_json facts{{"pixel", {place.x, place.y}},
                       {"size", {view_.width, view_.height}},
                       {"samples", view_.samples},
                       {"visibility", render::name_of(view_.visibility)},
                       {"terms", terms_json(stage(), terms)},
                       {"lines", lines}};
    if (place.dark) facts["light"] = *place.dark;
    return {{"kind", "pixel"},
            {"task", lines.empty() ? "" : lines[0]["task"]},
            {"title", "A pixel"},
            {"ask", ask},
            {"answer", answer},
            {"facts", facts},
            {"pictures",
             {{{"caption", fmt::format("pixel {}, {}", place.x, place.y)},
               {"png", png_of(*film_, *film_, {{place.x, place.y}})}}}}};
}

namespace {

/// The factor by which a change alters the mean luminance.
double factor_of(const ordered_json& difference) {
    return difference["mean_after"].get<double>() / std::max(1e-30, difference["mean_before"].get<double>());
}

std::string effect_text(const ordered_json& difference) {
    const auto rgb = [&](const char* key) {
        const ordered_json& value = difference[key];
        return rgb_text(vec3(value[0].get<float>(), value[1].get<float>(), value[2].get<float>()));
    };
    return fmt::format(
        "The mean luminance goes from {:.4g} to {:.4g} cd/m² (× {:.3g}). {:.0f} % of the pixels "
        "change, pixel ({}, {}) most: from {} to {}.",
        difference["mean_before"].get<double>(), difference["mean_after"].get<double>(),
        factor_of(difference), 100.0 * difference["changed"].get<double>(), difference["pixel"][0].get<int>(),
        difference["pixel"][1].get<int>(), rgb("before"), rgb("after"));
}

} // namespace

/// Renders the scene with a change, by the student's code and by the reference. Absent if the picture does
/// not change by it.
std::optional<ordered_json> Examiner::effect_of(const SceneChange& change) {
    const auto file = std::filesystem::temp_directory_path() / "changed.gltf";
    Parameters parameters = parameters_;
    Check view = view_;
    if (!change.parameter.empty()) {
        parameters[change.parameter] = change.to;
    } else {
        const auto source = assignment_.folder / view_.scene;
        auto gltf = ordered_json::parse(substituted_json(read_text(source), parameters_, source.string()));
        gltf[ordered_json::json_pointer(change.pointer)] = change.to;
        image::write_text(file, gltf.dump());
        view.scene = file.string();
    }
    ReferenceValues known; // of these parameters
    Pictures changed_pictures(assignment_, parameters, known);
    std::optional<image::Image> after, reference_after;
    try {
        after = changed_pictures.render(view, codes_);
        reference_after = changed_pictures.render(view, {});
    } catch (const gl::ShaderError&) {
        return std::nullopt;
    } catch (const glsl::LoopError&) {
        return std::nullopt;
    }
    const ordered_json difference = difference_of(*film_, *after);
    const ordered_json must = difference_of(pictures_.render(view_, {}), *reference_after);
    if (difference["changed"].get<double>() < 0.02 && must["changed"].get<double>() < 0.02)
        return std::nullopt;
    ordered_json answer{effect_text(difference)};
    const bool agrees = !differs(factor_of(difference), factor_of(must), 0.0);
    answer.push_back(
        agrees ? "The reference's picture changes by the same factor."
               : fmt::format("It must be × {:.3g}: so the reference's picture changes.", factor_of(must)));
    if (change.is_linear && is_between_once_and_twice(*film_, *after))
        answer.push_back("L_o is linear in it: no pixel gets darker, and none more than twice as bright.");
    return ordered_json{
        {"kind", "parameter"},
        {"task", ""},
        {"title", "A parameter"},
        {"ask",
         fmt::format("I change one thing: {}. What must happen to the picture, and why?", change.what)},
        {"answer", answer},
        {"facts",
         {{"pointer", change.pointer},
          {"parameter", change.parameter},
          {"from", change.from},
          {"to", change.to},
          {"scene", view_.scene},
          {"size", {view_.width, view_.height}},
          {"samples", view_.samples},
          {"visibility", render::name_of(view_.visibility)},
          {"yours", difference},
          {"reference", must},
          {"agrees", agrees}}},
        {"pictures", pictures_of(*film_, *after)}};
}

ordered_json Examiner::parameter_question() {
    if (!film_) film_ = rendered(codes_);
    if (!film_) throw Error("the scene cannot be rendered with this code", "ask about the marks");
    const auto source = assignment_.folder / view_.scene;
    const std::string scene = read_text(source);
    std::vector<SceneChange> changes =
        scene_changes(ordered_json::parse(substituted_json(scene, parameters_, source.string())));
    shuffle(changes, random_);
    std::vector<SceneChange> others = parameter_changes(assignment_, parameters_);
    std::erase_if(others,
                  [&](const SceneChange& change) { // a number of the scene, which has changes of its own
                      return scene.find("{{" + change.parameter + "}}") != std::string::npos;
                  });
    shuffle(others, random_);
    changes.resize(std::min<std::size_t>(changes.size(), max_tries));
    changes.insert(changes.end(), others.begin(), others.end());
    for (const SceneChange& change : changes)
        if (const auto question = effect_of(change)) return *question;
    throw Error("no change of the scene that was tried alters its picture",
                "ask about a light of your choice");
}

/// Looks for the line that keeps a law: one whose change breaks it. Absent if no change does.
std::optional<ordered_json> Examiner::law_of(const Task& task, const Check& check) {
    Task one = task;
    one.checks = {check};
    const ordered_json now = marker_.mark(one, alone(task));
    if (now["checks"].empty()) return std::nullopt;
    const ordered_json& own = now["checks"][0];
    const bool holds = own["passed"];
    ordered_json answer{"The law: " + statement_of(check) + (check.hint.empty() ? "." : ". " + check.hint)};
    if (!holds)
        answer.push_back(fmt::format("Your code breaks it: {} instead of {}, at {}.",
                                     own["got"].get<std::string>(), own["expected"].get<std::string>(),
                                     own["at"].get<std::string>()));
    ordered_json line;
    const std::string file = file_name(codes_.at(task.id));
    int tries = 0;
    for (const TaskChange& change : shuffled_changes(&task)) {
        if (!holds || ++tries > max_tries) break;
        const ordered_json broken = marker_.mark(one, alone(task, &change.change));
        if (broken["checks"].empty() || broken["checks"][0]["passed"].get<bool>()) continue;
        const ordered_json& got = broken["checks"][0];
        line = json_of(file, change.change);
        answer.push_back(fmt::format(
            "{} keeps it. With `{}` it breaks: {} instead of {}{}{}.", line_text(file, change.change),
            change.change.to, got["got"].get<std::string>(), got["expected"].get<std::string>(),
            got["at"].get<std::string>().empty() ? "" : ", at ", got["at"].get<std::string>()));
        break;
    }
    if (holds && line.is_null()) return std::nullopt;
    return ordered_json{
        {"kind", "law"},
        {"task", task.id},
        {"title", "A law"},
        {"ask",
         fmt::format("{} {}: which law does the check “{}” hold your code to, and which line keeps it?",
                     task.id, task.title, check.name)},
        {"answer", answer},
        {"facts", {{"check", check.name}, {"holds", holds}, {"line", line}}},
        {"pictures", ordered_json::array()}};
}

ordered_json Examiner::law_question() {
    std::vector<std::pair<const Task*, const Check*>> laws, values;
    for (const Task* task : tasks_)
        for (const Check& check : task->checks)
            if (!check.is_hidden && check.kind != Check::Kind::image)
                (is_law(check) ? laws : values).emplace_back(task, &check);
    shuffle(laws, random_);
    shuffle(values, random_);
    laws.insert(laws.end(), values.begin(), values.end());
    for (std::size_t i = 0; i < std::min<std::size_t>(laws.size(), 4); ++i)
        if (const auto question = law_of(*laws[i].first, *laws[i].second)) return *question;
    throw Error("no change that was tried breaks a law", "ask about the one that matters most to you");
}

ordered_json Examiner::replacement_question() {
    int tries = 0;
    for (const TaskChange& change : shuffled_changes()) {
        if (++tries > max_tries) break;
        const Task& task = *change.task;
        const ordered_json before = marker_.mark(task, alone(task));
        const ordered_json after = marker_.mark(task, alone(task, &change.change));
        if (after["status"] != "failed") continue; // it does not compile, or changes nothing
        const auto passed_before = passed_checks(before);
        ordered_json breaks = ordered_json::array(), answer = ordered_json::array();
        for (const ordered_json& check : after["checks"]) {
            const std::string name = check["name"];
            if (check["passed"].get<bool>() || !passed_before.contains(name) || !passed_before.at(name))
                continue;
            breaks.push_back(name);
            const bool is_named = !check["diagnosis"].is_null();
            answer.push_back(fmt::format(
                "“{}” fails: {} instead of {}{}.", name, check["got"].get<std::string>(),
                check["expected"].get<std::string>(),
                is_named ? fmt::format(" ({})", check["diagnosis"]["name"].get<std::string>()) : ""));
        }
        if (breaks.empty()) continue;
        ordered_json holds = ordered_json::array();
        for (const auto& [name, passed] : passed_checks(after))
            if (passed) holds.push_back(name);
        if (!holds.empty())
            answer.push_back(
                fmt::format("Of {} checks {} still hold.", after["checks"].size(), holds.size()));
        const std::string file = file_name(codes_.at(task.id));
        const auto picture = film_ ? rendered(with(change)) : std::nullopt;
        const bool is_seen = picture && difference_of(*film_, *picture)["changed"].get<double>() > 0.0;
        answer.push_back(!picture  ? "The scene cannot be rendered with it."
                         : is_seen ? "The pictures show what becomes of the scene."
                                   : "The picture of the scene does not show it.");
        return {{"kind", "replacement"},
                {"task", task.id},
                {"title", "A replacement"},
                {"ask", fmt::format("{}: I replace `{}` by `{}`. What breaks?",
                                    fmt::format("{}:{}", file, change.change.line), change.change.from,
                                    change.change.to)},
                {"answer", answer},
                {"facts", {{"line", json_of(file, change.change)}, {"breaks", breaks}, {"holds", holds}}},
                {"pictures", picture ? pictures_of(*film_, *picture) : ordered_json::array()}};
    }
    throw Error("no change that was tried breaks a check that holds", "ask why the marks are as they are");
}

} // namespace sr::assignment
