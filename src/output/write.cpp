#include "output/write.hpp"

#include "core/output.hpp"
#include "image/file.hpp"
#include "image/whole_file.hpp"

namespace sr::output {
namespace {

void warn_of_half_overflow(const image::Image& image, const std::string& output) {
    const std::size_t count = image::half_overflow_count(image);
    if (count == 0) return;
    const bool is_one = count == 1;
    print_remark("{}: {} value{} beyond 65504, the largest of --exr-type half, {} stored as that: "
                 "--exr-type float holds {}",
                 output, count, is_one ? "" : "s", is_one ? "is" : "are", is_one ? "it" : "them");
}

} // namespace

bool holds_layers(const std::string& file) { return file.ends_with(".exr") || file.ends_with(".EXR"); }

ScreenPicture shown(const image::Image& film, const FileSettings& settings) {
    if (settings.view && settings.view->display != Display::exposed)
        return {colors_of(*settings.view, film), std::nullopt};
    const float ev100 = settings.ev100 ? *settings.ev100 : image::auto_ev100(film);
    return {image::displayed(film, ev100, *settings.tone_curve), ev100};
}

std::optional<float> write(const image::Image& film, const image::Image* layers,
                           const std::vector<std::string>& files, const FileSettings& settings) {
    std::optional<ScreenPicture> screen;
    image::WholeFiles whole;
    for (const std::string& file : files) {
        if (image::is_scene_referred(file)) {
            const image::Image& written = layers && holds_layers(file) ? *layers : film;
            if (settings.exr_type == image::SampleType::half && holds_layers(file))
                warn_of_half_overflow(written, file);
            whole.add(written, file, settings.exr_type);
            continue;
        }
        if (!screen) {
            screen = shown(film, settings);
            screen->picture.attributes = film.attributes;
        }
        whole.add(screen->picture, file, image::SampleType::integer8);
    }
    whole.put_in_place();
    return screen ? screen->ev100 : std::nullopt;
}

} // namespace sr::output
