#include "compare/compare.hpp"
#include "compare/pictures.hpp"
#include "image/display.hpp"
#include "image/file.hpp"
#include "image/whole_file.hpp"
#include "output/write.hpp"
#include "python/scene_file.hpp"
#include "python/values.hpp"
#include "settings/bad_setting.hpp"

#include <fmt/format.h>
#include <nanobind/stl/optional.h>
#include <nanobind/stl/string.h>
#include <nanobind/stl/tuple.h>
#include <nanobind/stl/vector.h>
#include <nlohmann/json.hpp>
#include <utility>

namespace sr::python {

nb::object view_of(const image::Image& image, std::size_t first, std::size_t count, nb::handle owner) {
    const auto width = static_cast<std::size_t>(image.width), height = static_cast<std::size_t>(image.height);
    const auto channels = static_cast<std::size_t>(image.channels);
    const auto across = static_cast<std::int64_t>(channels),
               down = static_cast<std::int64_t>(width * channels);
    const float* data = image.pixels.data() + first;
    if (count == 0) {
        const std::size_t shape[2] = {height, width};
        const std::int64_t strides[2] = {down, across};
        return nb::cast(nb::ndarray<nb::numpy, const float>(data, 2, shape, owner, strides));
    }
    const std::size_t shape[3] = {height, width, count};
    const std::int64_t strides[3] = {down, across, 1};
    return nb::cast(nb::ndarray<nb::numpy, const float>(data, 3, shape, owner, strides));
}

namespace {

using image::Image;
using Pixels = nb::ndarray<const float, nb::ndim<3>, nb::c_contig, nb::device::cpu>;

Image image_of(const Pixels& pixels, const std::vector<std::string>& channels, int integer_bits) {
    Image image(static_cast<int>(pixels.shape(1)), static_cast<int>(pixels.shape(0)),
                static_cast<int>(pixels.shape(2)));
    image.pixels.assign(pixels.data(), pixels.data() + pixels.size());
    image.channel_names = channels;
    if (integer_bits > 0)
        image.attributes.push_back({"steradian:integer_bits", std::to_string(integer_bits)});
    return image;
}

nb::dict attributes_of(const Image& image) {
    nb::dict attributes;
    for (const image::Attribute& attribute : image.attributes)
        attributes[nb::str(attribute.name.c_str())] = attribute.value;
    return attributes;
}

std::shared_ptr<Image> read(const std::string& file) {
    const auto image = std::make_shared<Image>();
    run_aside([=](Call&) { *image = image::read(file); });
    return image;
}

/// `type`: "float" or "half" for .exr, "8bit" for files that screens show.
void write(const Image& self, const std::string& file, const std::string& type) {
    image::write(self, file,
                 type == "half"    ? image::SampleType::half
                 : type == "float" ? image::SampleType::floating
                                   : image::SampleType::integer8);
}

// The comparison.

struct Limits {
    std::vector<std::string> tolerances;
    bool allows_nonfinite = false;
    std::optional<std::tuple<int, int, int, int>> region; // x, y, width, height
    std::shared_ptr<Image> mask;                          // null: none
    std::vector<std::shared_ptr<Image>> noise;
    std::string layer, encoding;
};

compare::CompareOptions options_of(const Limits& limits, const Image& test, const Image& reference) {
    compare::CompareOptions options;
    options.tolerances = compare::parse_tolerances(limits.tolerances);
    options.allow_nonfinite = limits.allows_nonfinite;
    if (limits.region) {
        const auto& [x, y, width, height] = *limits.region;
        options.region = compare::PixelRegion{x, y, width, height};
    }
    if (limits.mask) options.mask = *limits.mask;
    for (const auto& noise : limits.noise) options.noise.push_back(*noise);
    options.layer = limits.layer;
    compare::set_encoding(options, test, reference);
    if (limits.encoding == "linear") options.encoding = compare::Encoding::scene_referred;
    if (limits.encoding == "srgb") options.encoding = compare::Encoding::display_referred;
    return options;
}

/// A comparison and its pictures for people.
struct Compared {
    std::string json;
    Image error, heat_map, side_by_side;
};

std::shared_ptr<Compared> compare_images(const std::shared_ptr<Image>& test,
                                         const std::shared_ptr<Image>& reference, const Limits& limits) {
    const auto compared = std::make_shared<Compared>();
    run_aside([=](Call&) {
        const compare::CompareOptions options = options_of(limits, *test, *reference);
        const compare::Comparison comparison = compare::compare(*test, *reference, options);
        compared->json = compare::json_of(comparison).dump();
        compared->error = comparison.error;
        compared->heat_map = compare::heat_map(comparison);
        if (comparison.error.width > 0)
            compared->side_by_side = compare::side_by_side(*test, *reference, comparison, options);
    });
    return compared;
}

void bind_compare(nb::module_& m) {
    nb::class_<Limits>(m, "Limits")
        .def(nb::init<>())
        .def_rw("tolerances", &Limits::tolerances)
        .def_rw("allows_nonfinite", &Limits::allows_nonfinite)
        .def_rw("region", &Limits::region)
        .def_rw("mask", &Limits::mask)
        .def_rw("noise", &Limits::noise)
        .def_rw("layer", &Limits::layer)
        .def_rw("encoding", &Limits::encoding);
    nb::class_<Compared>(m, "Compared")
        .def_ro("json", &Compared::json)
        .def_ro("error", &Compared::error)
        .def_ro("heat_map", &Compared::heat_map)
        .def_ro("side_by_side", &Compared::side_by_side);
    m.def("compare", &compare_images);
}

// Pictures.

const Image& whole(const picture::Picture& picture) {
    return picture.layers ? *picture.layers : picture.film;
}

const image::ToneCurve* curve_of(const std::string& name) {
    const image::ToneCurve* curve = image::tone_curve_named(name);
    if (!curve) throw settings::BadSetting("tone_curve", fmt::format("'{}' is no tone curve", name));
    return curve;
}

/// Writes a picture as `render` does. @return the EV100 in use, if any was
std::optional<float> save(RenderedPicture& rendered, const std::vector<std::string>& files,
                          const std::optional<float>& ev100, const std::string& tone_curve,
                          const std::string& exr_type) {
    output::FileSettings settings{.ev100 = ev100 ? ev100 : rendered.settings.ev100,
                                  .tone_curve = rendered.settings.tone_curve,
                                  .exr_type = rendered.settings.exr_type,
                                  .view = rendered.settings.view};
    if (!tone_curve.empty()) settings.tone_curve = curve_of(tone_curve);
    if (exr_type == "half") settings.exr_type = image::SampleType::half;
    if (exr_type == "float") settings.exr_type = image::SampleType::floating;
    const picture::Picture& picture = rendered.picture;
    std::optional<float> used;
    GlThread::only().run([&](Call&) {
        used = output::write(picture.film, picture.layers ? &*picture.layers : nullptr, files, settings);
    });
    return used;
}

float exposure_of(const RenderedPicture& rendered) {
    return rendered.settings.ev100.value_or(image::auto_ev100(rendered.picture.film));
}

/// The colours for a screen, in 0 to 1.
Image displayed(const RenderedPicture& rendered, const std::optional<float>& ev100,
                const std::string& tone_curve) {
    const settings::RenderSettings& settings = rendered.settings;
    const Image& film = rendered.picture.film;
    if (settings.view && settings.view->display != output::Display::exposed)
        return output::colors_of(*settings.view, film);
    return image::displayed(film, ev100.value_or(exposure_of(rendered)),
                            tone_curve.empty() ? *settings.tone_curve : *curve_of(tone_curve));
}

void bind_pictures(nb::module_& m) {
    nb::class_<RenderedPicture>(m, "RenderedPicture")
        .def_prop_ro("summary", [](const RenderedPicture& self) { return self.summary; })
        .def_prop_ro("image",
                     [](const RenderedPicture& self) { return std::make_shared<Image>(whole(self.picture)); })
        .def_prop_ro("exposure", &exposure_of)
        .def("save", &save, nb::arg("files"), nb::arg("exposure").none(), nb::arg("tone_curve"),
             nb::arg("exr_type"))
        .def("displayed", &displayed, nb::arg("exposure").none(), nb::arg("tone_curve"));
}

} // namespace

void bind_images(nb::module_& m) {
    nb::class_<Image>(m, "Image")
        .def("__init__", [](Image* self, const Pixels& pixels, const std::vector<std::string>& channels,
                            int integer_bits) { new (self) Image(image_of(pixels, channels, integer_bits)); })
        .def_ro("width", &Image::width)
        .def_ro("height", &Image::height)
        .def_ro("channel_names", &Image::channel_names)
        .def_prop_ro("attributes", &attributes_of)
        .def("channels",
             [](nb::handle self, std::size_t first, std::size_t count) {
                 const auto& image = nb::cast<const Image&>(self);
                 if (first + std::max<std::size_t>(count, 1) > static_cast<std::size_t>(image.channels))
                     throw nb::index_error("no such channels");
                 return view_of(image, first, count, self);
             })
        .def("write", &write, nb::arg("file"), nb::arg("type"));
    m.def("read_image", &read);
    bind_compare(m);
    bind_pictures(m);
}

} // namespace sr::python
