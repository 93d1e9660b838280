#include "settings/options.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <type_traits>

namespace sr::settings {
namespace {

using S = RenderSettings;
using R = render::RenderOptions;
using Kind = Value::Kind;

/// The member that pointers lead to, one after the other.
template<auto... path>
auto& member(auto& settings) {
    return (settings.*....*path);
}

template<class T>
struct Bare {
    using type = T;
};
template<class T>
struct Bare<std::optional<T>> {
    using type = T;
};

/// Applies `write` to a value, or to that of an optional; an absent one is empty.
template<auto write, class T>
std::string written(const T& value) {
    return write(value);
}
template<auto write, class T>
std::string written(const std::optional<T>& value) {
    return value ? write(*value) : std::string();
}

template<auto... path>
constexpr Value flag() {
    return {.kind = Kind::flag,
            .read = [](const Value&, S& s, const std::string&) { return member<path...>(s) = true; },
            .write = [](const S& s) { return std::string(member<path...>(s) ? "true" : ""); }};
}

template<auto... path>
constexpr Value text(const char* type) {
    return {.type = type,
            .read =
                [](const Value&, S& s, const std::string& given) {
                    member<path...>(s) = given;
                    return true;
                },
            .write = [](const S& s) { return member<path...>(s); }};
}

template<auto... path>
constexpr Value list(const char* type) {
    return {.kind = Kind::list,
            .type = type,
            .read =
                [](const Value&, S& s, const std::string& given) {
                    member<path...>(s).push_back(given);
                    return true;
                },
            .write = [](const S& s) { return fmt::format("{}", fmt::join(member<path...>(s), " ")); },
            .entries = [](const S& s) { return member<path...>(s); }};
}

/// Reads a number of the type T in the value's range.
template<class T>
std::optional<T> parse_in_range(const Value& value, const std::string& given) {
    std::optional<double> number = parse_number(given);
    if constexpr (std::is_integral_v<T>) {
        long long whole = 0;
        const auto [end, failure] = std::from_chars(given.data(), given.data() + given.size(), whole);
        if (failure != std::errc{} || end != given.data() + given.size()) return std::nullopt;
        number = static_cast<double>(whole);
    }
    if (!number || *number < value.min || *number > value.max) return std::nullopt;
    return static_cast<T>(*number);
}

template<auto... path>
constexpr Value number(double min, double max, const char* type = "") {
    using T = typename Bare<std::remove_cvref_t<decltype(member<path...>(std::declval<S&>()))>>::type;
    return {.kind = std::is_integral_v<T> ? Kind::whole : Kind::number,
            .type = type,
            .min = min,
            .max = max,
            .read =
                [](const Value& value, S& s, const std::string& given) {
                    const auto parsed = parse_in_range<T>(value, given);
                    if (parsed) member<path...>(s) = *parsed;
                    return parsed.has_value();
                },
            .write =
                [](const S& s) {
                    return written<[](const T& x) { return fmt::format("{}", x); }>(member<path...>(s));
                }};
}

template<class T>
std::string_view name_of(const NamedValue<T>& row) {
    return row.name;
}

template<class T>
T value_of(const NamedValue<T>& row) {
    return row.value;
}
template<class T>
T value_of(const T& value) {
    return value;
}

/// One of `all`: rows of NamedValue, or values of an enumeration whose name_of() is in its namespace.
template<const auto& all, auto... path>
constexpr Value choice() {
    return {.words =
                [] {
                    std::vector<Word> words;
                    for (const auto& row : all) words.push_back({name_of(row)});
                    return words;
                },
            .read =
                [](const Value&, S& s, const std::string& given) {
                    const auto found =
                        std::ranges::find_if(all, [&](const auto& row) { return name_of(row) == given; });
                    if (found != all.end()) member<path...>(s) = value_of(*found);
                    return found != all.end();
                },
            .write =
                [](const S& s) {
                    for (const auto& row : all)
                        if (value_of(row) == member<path...>(s)) return std::string(name_of(row));
                    return std::string();
                }};
}

using Words = std::vector<Word> (*)();

/// A value with functions of its own for reading and writing; `parse` gives an optional or a pointer to a
/// row.
template<auto parse, auto write, auto... path>
constexpr Value parsed(const char* type, Words words = nullptr) {
    const auto read = [](const Value&, S& s, const std::string& given) {
        const auto value = parse(given);
        if constexpr (std::is_pointer_v<std::remove_cvref_t<decltype(value)>>) {
            if (value) member<path...>(s) = value;
        } else {
            if (value) member<path...>(s) = *value;
        }
        return static_cast<bool>(value);
    };
    return {.type = type, .words = words, .read = read, .write = [](const S& s) {
                return written<write>(member<path...>(s));
            }};
}

constexpr std::array exr_types{NamedValue<image::SampleType>{"half", image::SampleType::half},
                               NamedValue<image::SampleType>{"float", image::SampleType::floating}};
constexpr std::array visibilities{render::Visibility::ray, render::Visibility::ray_on_cpu,
                                  render::Visibility::ray_in_glsl, render::Visibility::map,
                                  render::Visibility::none};
constexpr std::array backends{gl::Backend::automatic, gl::Backend::egl, gl::Backend::osmesa,
                              gl::Backend::window};
constexpr std::array layers{NamedValue<bool>{"lights", true}};

/// EV100, or an absent one for "auto".
std::optional<std::optional<float>> parse_exposure(const std::string& given) {
    if (given == "auto") return std::optional<float>();
    const auto ev100 = parse_number(given);
    if (!ev100 || std::abs(*ev100) > 1e6) return std::nullopt;
    return static_cast<float>(*ev100);
}

std::string curve_text(const image::ToneCurve* curve) { return std::string(curve->name); }
std::vector<Word> curve_words() {
    std::vector<Word> words;
    for (const image::ToneCurve& curve : image::tone_curves()) words.push_back({curve.name});
    return words;
}

std::string aovs_text(const output::Variables& variables) {
    std::vector<std::string_view> names;
    for (const output::Variable* variable : variables) names.emplace_back(variable->name);
    return fmt::format("{}", fmt::join(names, ","));
}
std::vector<Word> aov_words() {
    std::vector<Word> words;
    for (const output::Variable& variable : output::all_variables())
        if (output::aov_named(variable.name)) words.push_back({variable.name});
    return words;
}

std::string view_text(const output::Variable* view) { return view ? view->name : ""; }
std::vector<Word> view_words() {
    std::vector<Word> words;
    for (const output::Variable& variable : output::all_variables())
        if (output::view_named(variable.name)) words.push_back({variable.name, variable.what});
    return words;
}

/// The angle of the camera of the first of the frames.
std::string turn_text(const S& s) {
    return s.turntable && s.frames ? fmt::format("{:.9g} degrees", 360.0 * s.frames->first / *s.turntable)
                                   : "";
}

constexpr double no_limit = 1e300;
constexpr unsigned by_all = by_render | by_view | by_probe;
constexpr unsigned by_picture = by_all | by_suites;
constexpr unsigned by_scene = by_all | by_export;
constexpr unsigned by_lit_scene = by_scene | by_illuminance;

constexpr std::array options{
    Option{
        "camera", "Scene", by_scene | by_suites, text<&S::camera>("TEXT"),
        "camera by name or index; auto, which frames the scene; or a view as the viewer copies it: "
        "eye=X,Y,Z;target=X,Y,Z with up=X,Y,Z fov=DEGREES near= far= if wanted (default: the first camera, "
        "or auto)"},
    Option{"scene", "Scene", by_lit_scene, number<&S::scene_index>(0, 2147483647, "INDEX"),
           "scene of the file (default: the file's choice)"},
    Option{"variant", "Scene", by_lit_scene, text<&S::variant>("NAME"),
           "material variant of the file (default: none)"},
    Option{"strict", "Scene", by_lit_scene | by_info | by_suites, flag<&S::is_strict>(),
           "parts of the file that are broken or not supported are errors (status 3), not warnings"},
    Option{"hide_emitters", "Scene", by_all, flag<&S::hide_emitters>(),
           "hide emitters, which still light the scene: lights vanish, emissive surfaces only reflect"},

    Option{"rig", "Light", by_lit_scene | by_suites, choice<rigs, &S::rig>(),
           "lamps besides the scene's own: a studio, three softboxes, or none; auto adds the studio where "
           "almost nothing would be lit"},
    Option{"environment", "Light", by_lit_scene, text<&S::environment>("FILE|L|R,G,B"),
           "light from outside, seen as the background: an equirectangular .hdr or .exr in cd/m², whose "
           "middle column is -Z, or one radiance for all directions"},
    Option{"environment_rotation", "Light", by_lit_scene,
           number<&S::environment_rotation>(-36000, 36000, "DEGREES"),
           "turn the environment around +Y, counter-clockwise seen from above"},
    Option{"environment_strength", "Light", by_lit_scene, number<&S::environment_strength>(0, 1e20, "FACTOR"),
           "multiply the environment's radiance"},
    Option{"hide_environment", "Light", by_scene, flag<&S::hide_environment>(),
           "hide the environment, which still lights the scene"},
    Option{"background", "Light", by_picture,
           parsed<parse_color, [](vec3 color) { return text_of(color); }, &S::rendering, &R::background>(
               "L|R,G,B"),
           "radiance where there is no surface [cd/m²]"},

    Option{"at",
           "Animation",
           by_lit_scene,
           number<&S::at>(0, no_limit, "SECONDS"),
           "time of the animation (default: the file's rest pose, without its animations)",
           "time at which the animation opens (default: the file's rest pose)",
           {"time", [](const S& s) { return s.at ? fmt::format("{:.9g} s", *s.at) : ""; }}},
    Option{"animation", "Animation", by_lit_scene, text<&S::animation>("NAME|INDEX|all"),
           "animation by name or index, or all at once (default: the first)"},
    Option{
        "frames", "Animation", by_render,
        parsed<parse_frames, [](const FrameRange& frames) { return text_of(frames); }, &S::frames>("A:B|A:"),
        "frames A to B of the animation or the turntable, or from A to its end; OUT has #### or %04d in its "
        "name"},
    Option{"fps", "Animation", by_render, number<&S::fps>(1e-3, 1e6),
           "frames a second, also of a video: frame n is at n / fps seconds"},
    Option{"turntable",
           "Animation",
           by_render,
           number<&S::turntable>(1, 1'000'000, "COUNT"),
           "COUNT pictures, 0 to COUNT - 1, from a camera that goes once around the middle of the scene, "
           "counter-clockwise seen from above; scene and lights stand still",
           nullptr,
           {"turn", turn_text}},
    Option{"turn_axis",
           "Animation",
           by_render,
           choice<turn_axes, &S::turn_axis>(),
           "axis that the camera of --turntable goes around: y is up in the scene; camera: what is up in the "
           "first picture",
           nullptr,
           {"turn_axis",
            [](const S& s) {
                const bool is_upright = s.turn_axis == scene::TurnAxis::y;
                return std::string(s.turntable && !is_upright ? name_in(turn_axes, s.turn_axis) : "");
            }}},

    Option{"size", "Picture", by_picture | by_export,
           parsed<parse_size, [](Size size) { return text_of(size); }, &S::size>("WIDTHxHEIGHT"),
           "size of the picture (default: 720 rows in the camera's aspect ratio, or 16:9)",
           "size of the window (default: its last size, or 1280x720)"},
    Option{"samples", "Picture", by_picture | by_illuminance,
           number<&S::stop, &render::StopRule::samples>(1, 1 << 24),
           "samples a pixel: positions in the pixel and points on each emitter",
           "samples a pixel of the converged picture; without --error and --time its error is not estimated "
           "(default: 256 or an --error of 0.5%, whichever comes first)"},
    Option{
        "error",
        "Picture",
        by_render | by_view,
        parsed<parse_percentage, percentage_text, &S::stop, &render::StopRule::error>("PERCENT%"),
        "stop at this distance from the converged picture: √rel_mse of `steradian compare`, estimated from "
        "two independent halves of the samples. Pixels that are near enough stop earlier. --samples is "
        "then 65536 by default",
        nullptr,
        {"error_target",
         [](const S& s) { return s.stop.error ? fmt::format("{:.4g}", *s.stop.error) : ""; }}},
    Option{"time", "Picture", by_render | by_view,
           parsed<parse_duration, duration_text, &S::stop, &render::StopRule::seconds>("SECONDS|2s|5min"),
           "stop after this long; loading and --layers do not count"},
    Option{"exposure", "Picture", by_render | by_view | by_suites,
           parsed<parse_exposure, [](float ev100) { return fmt::format("{}", ev100); }, &S::ev100>("EV|auto"),
           "EV100 for .png, .jpg and windows (default: auto, which makes the log-average middle grey)"},
    Option{"tone_curve", "Picture", by_render | by_view | by_suites,
           parsed<image::tone_curve_named, curve_text, &S::tone_curve>("", curve_words),
           "tone curve for .png, .jpg and windows"},
    Option{"exr_type", "Picture", by_render | by_suites, choice<exr_types, &S::exr_type>(),
           "type of the numbers in .exr; half keeps files small"},
    Option{"layers", "Picture", by_render | by_suites, choice<layers, &S::has_light_layers>(),
           "add a layer for each light and one for emission to .exr files; their sum is the picture"},
    Option{"aov", "Picture", by_render | by_suites,
           parsed<output::parse_aovs, aovs_text, &S::aovs>("NAME,NAME...", aov_words),
           "add channels to .exr files, separated by commas; src/output/README.md describes them"},
    Option{"view",
           "Picture",
           by_render,
           parsed<output::view_named, view_text, &S::view>("NAME", view_words),
           "one term of the equation instead of radiance, as numbers in .exr and .hdr",
           nullptr,
           {"view"}},

    Option{"estimator",
           "Method",
           by_picture | in_json,
           choice<estimators, &S::rendering, &R::estimator>(),
           "how area lights are integrated: sampled converges to the exact value; analytic has no noise, is "
           "exact for Lambert and an approximation for gloss",
           nullptr,
           {"estimator"}},
    Option{"seed",
           "Method",
           by_picture | by_illuminance | in_json,
           number<&S::rendering, &R::seed>(0, 4294967295.0),
           "seed of the samples: another seed is another, equally good set",
           nullptr,
           {"seed"}},
    Option{"lights", "Method", by_render | by_view | by_suites,
           choice<light_samplings, &S::rendering, &R::lights>(),
           "lights that a sample of a pixel visits: all, or one that a tree of the lights chooses, with more "
           "noise and in a time that hardly "
           "grows with their number; auto is one where there are many. All converge to the same picture"},
    Option{"light_choices", "Method", by_render | by_view | by_suites,
           number<&S::rendering, &R::light_choices>(1, 16),
           "lights that a sample chooses under --lights one, each with a shadow ray"},
    Option{"analytic_points",
           "Method",
           by_all,
           number<&S::rendering, &R::analytic_points>(0, 4096),
           "points that the analytic estimator takes for each lobe and emitter; 0: the fitted lobe alone",
           nullptr,
           {"analytic_points",
            [](const S& s) {
                const bool is_used = s.rendering.estimator == render::Estimator::analytic;
                return is_used ? std::to_string(s.rendering.analytic_points) : "";
            }}},
    Option{"energy_compensation", "Method", by_all, flag<&S::has_energy_compensation>(),
           "compensate GGX for energy lost to multiple scattering (not part of glTF)"},
    Option{"visibility",
           "Method",
           by_picture | by_illuminance,
           choice<visibilities, &S::visibility>(),
           "shadows: a ray to each sample, on the CPU in software GL, in GLSL elsewhere; depth maps from "
           "points on the emitters; or none",
           nullptr,
           {"visibility"}},
    Option{"map_points", "Method", by_all | by_illuminance,
           number<&S::rendering, &R::maps, &render::MapOptions::points>(1, 32),
           "with --visibility map: points on each emitter that a sample has, each with its depth maps"},
    Option{"map_size", "Method", by_all | by_illuminance,
           number<&S::rendering, &R::maps, &render::MapOptions::size>(16, 8192),
           "with --visibility map: texels on a map's side; halved until a sample's maps fit into 256 MiB"},
    Option{"denoise",
           "Method",
           by_render,
           flag<&S::denoises>(),
           "with --estimator analytic: filter the shadows, its only noise, over pixels of the same surface. "
           "The picture looks smooth and is biased: no measurement",
           nullptr,
           {"denoised", [](const S& s) { return std::string(s.denoises ? "visibility" : ""); }}},

    Option{"backend", "Machine", by_render | by_probe | by_illuminance | by_suites,
           choice<backends, &S::backend>(), "where OpenGL comes from; see steradian info"},
    Option{"shaders", "Machine", by_picture | by_illuminance, list<&S::shaders>("DIR"),
           "look for shaders in this folder first (repeatable)"},
    Option{
        "untrusted", "Machine", by_all | by_illuminance, flag<&S::is_untrusted>(),
        "refuse in these folders what is no plain GLSL (links, images, recursion, …), and bound their loops"},
    Option{"gl_debug", "Machine", by_all | by_illuminance, flag<&S::gl_debug>(),
           "fail on any error or warning of the driver"},
};

std::string joined(const Value& value, const char* separator) {
    std::vector<std::string_view> names;
    for (const Word& word : value.words()) names.push_back(word.name);
    return fmt::format("{}", fmt::join(names, separator));
}

bool has_range(const Value& value) {
    return (value.kind == Kind::number || value.kind == Kind::whole) && value.max < 2147483647;
}

} // namespace

std::string flag_of(std::string_view key) {
    std::string name = fmt::format("--{}", key);
    std::ranges::replace(name, '_', '-');
    return name;
}

std::span<const Option> all_options() { return options; }

std::string type_of(const Value& value) {
    if (*value.type) return value.type;
    if (value.words) return joined(value, "|");
    if (has_range(value)) return fmt::format("{}..{}", value.min, value.max);
    return value.kind == Kind::flag ? "" : "N";
}

std::string allowed_by(const Value& value) {
    if (value.words && value.words().size() == 1) return joined(value, "") + ", the only choice";
    if (value.words) return "one of " + joined(value, ", ");
    if (value.kind != Kind::number && value.kind != Kind::whole) return value.type;
    const char* const kind = value.kind == Kind::whole ? "a whole number" : "a number";
    if (value.max == no_limit) return fmt::format("{} of at least {}", kind, value.min);
    return fmt::format("{} from {} to {}", kind, value.min, value.max);
}

std::string shell_word(const std::string& word) {
    constexpr std::string_view plain =
        "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_-+.,:/%=@";
    if (!word.empty() && word.find_first_not_of(plain) == std::string::npos) return word;
    std::string quoted = "'";
    for (const char c : word) quoted += c == '\'' ? std::string("'\\''") : std::string(1, c);
    return quoted + "'";
}

std::string render_arguments(const RenderSettings& settings) {
    std::string text;
    for (const Option& option : options) {
        const Value& value = option.value;
        const std::string written = value.write(settings);
        if (!(option.takers & by_render) || option.key == std::string_view("gl_debug")) continue;
        if (written == default_of(option)) continue;
        std::vector<std::string> words{written};
        if (value.entries) words = value.entries(settings);
        for (const std::string& word : words) {
            text += " " + option.flag();
            if (value.kind != Kind::flag) text += " " + shell_word(word);
        }
    }
    return text;
}

std::string default_of(const Option& option) { return option.value.write(RenderSettings()); }

} // namespace sr::settings
