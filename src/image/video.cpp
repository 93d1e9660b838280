#include "image/video.hpp"

#include "core/error.hpp"

#include <algorithm>
#include <cctype>
#include <cstdint>
#include <fmt/format.h>
#include <string>
#include <utility>
#include <vector>

namespace sr::image {
namespace {

namespace fs = std::filesystem;

std::string extension_of(const fs::path& file) {
    std::string extension = file.extension().string();
    std::ranges::transform(extension, extension.begin(),
                           [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    return extension;
}

/// The encoder's options: a quality at which pictures look like their PNGs, by each encoder's own scale.
std::vector<std::string> codec_words(const fs::path& file) {
    if (extension_of(file) == ".webm")
        return {"-c:v",      "libvpx-vp9", "-crf",    "18", "-b:v", "0",
                "-cpu-used", "3",          "-row-mt", "1",  "-f",   "webm"};
    return {"-c:v", "libx264", "-crf", "16", "-movflags", "+faststart", "-f", "mp4"};
}

int even(int edge) { return edge + edge % 2; }

/// RGB, 8 bits a value, with even edges.
std::vector<std::uint8_t> frame_of(const Image& picture) {
    const int width = even(picture.width), height = even(picture.height);
    std::vector<float> values;
    values.reserve(std::size_t{3} * static_cast<std::size_t>(width) * static_cast<std::size_t>(height));
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) {
            const auto pixel = picture.at(std::min(x, picture.width - 1), std::min(y, picture.height - 1));
            values.insert(values.end(), pixel.begin(), pixel.begin() + 3);
        }
    return as_bytes(values);
}

} // namespace

bool is_video(const fs::path& file) {
    const std::string extension = extension_of(file);
    return extension == ".mp4" || extension == ".webm";
}

void require_video_encoder(const fs::path& file) {
    if (!program_in_path("ffmpeg").empty()) return;
    throw Error({file.string()}, "ffmpeg, which encodes videos, is not in PATH",
                "install it (sudo apt-get install ffmpeg), or write pictures: NAME.####.png");
}

VideoFile::VideoFile(fs::path file, double rate) : file_(std::move(file)), rate_(rate) {
    require_video_encoder(file_);
}

/// Pictures of a screen are sRGB. A video has luma and chroma instead: the matrix of Rec. 709 (ITU-R BT.709,
/// item 3), in the range that players expect, and marks that say so.
void VideoFile::start(int width, int height) {
    std::vector<std::string> words{
        program_in_path("ffmpeg").string(),
        "-v",
        "error",
        "-nostdin",
        "-y",
        "-f",
        "rawvideo",
        "-pixel_format",
        "rgb24",
        "-video_size",
        fmt::format("{}x{}", even(width), even(height)),
        "-framerate",
        fmt::format("{}", rate_),
        "-i",
        "pipe:0",
        "-vf",
        "scale=out_color_matrix=bt709:out_range=tv:flags=accurate_rnd+full_chroma_int,format=yuv420p",
        "-colorspace",
        "bt709",
        "-color_primaries",
        "bt709",
        "-color_trc",
        "iec61966-2-1",
        "-color_range",
        "tv"};
    for (std::string& word : codec_words(file_)) words.push_back(std::move(word));
    words.push_back("file:" + fs::absolute(whole_.reserve(file_)).string());
    encoder_.emplace(std::move(words));
}

bool VideoFile::add(const Image& picture, const std::stop_token& stop) {
    require(picture.channels >= 3, "a picture of a video has three channels");
    if (!encoder_) start(picture.width, picture.height);
    if (encoder_->write(frame_of(picture), stop)) return true;
    if (stop.stop_requested()) return false;
    fail();
}

bool VideoFile::put_in_place(const std::stop_token& stop) {
    require(encoder_.has_value(), "a video has a picture");
    if (!encoder_->finish(stop)) {
        if (stop.stop_requested()) return false;
        fail();
    }
    whole_.put_in_place();
    return true;
}

void VideoFile::fail() {
    encoder_->finish();
    throw Error(
        {file_.string()}, fmt::format("ffmpeg does not encode it: {}", encoder_->complaint()),
        "see that there is room on the disk, and that `ffmpeg -encoders` lists libx264 and libvpx-vp9");
}

} // namespace sr::image
