#pragma once
// Writer of rendered pictures: radiance, views and further channels, in the form that a file's extension
// names.
#include "image/display.hpp"
#include "image/file.hpp"
#include "output/variables.hpp"

#include <optional>
#include <string>
#include <vector>

namespace sr::output {

struct FileSettings {
    std::optional<float> ev100; // absent: automatic
    const image::ToneCurve* tone_curve = &image::default_tone_curve();
    image::SampleType exr_type = image::SampleType::floating;
    const Variable* view = nullptr; // what the film holds; null: radiance
};

/// Returns true if the file's format has room for more than one picture (.exr).
bool holds_layers(const std::string& file);

/// A film as a screen shows it.
struct ScreenPicture {
    image::Image picture;       // 0..1, encoded for display
    std::optional<float> ev100; // that was used; absent: false colours have none
};
ScreenPicture shown(const image::Image& film, const FileSettings& settings);

/// Writes `film` (R, G, B, A) to all of `files`, or to none. `layers`: the film with further channels, for
/// the formats that hold them; null: none. Attributes are the images' own.
/// @return the EV100 in use, if any was. @throws Error
std::optional<float> write(const image::Image& film, const image::Image* layers,
                           const std::vector<std::string>& files, const FileSettings& settings);

} // namespace sr::output
