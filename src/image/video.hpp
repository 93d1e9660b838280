#pragma once
// Videos, which the program ffmpeg encodes: H.264 in .mp4, VP9 in .webm.
#include "core/piped_program.hpp"
#include "image/image.hpp"
#include "image/whole_file.hpp"

#include <filesystem>
#include <optional>
#include <stop_token>

namespace sr::image {

/// Returns whether the extension names a video: .mp4 or .webm.
bool is_video(const std::filesystem::path& file);

/// @throws Error if ffmpeg is not in PATH
void require_video_encoder(const std::filesystem::path& file);

/// A video that is written whole or not at all: a temporary file beside it, then a rename.
class VideoFile {
public:
    /// Starts nothing yet. `rate`: pictures a second. @throws Error if ffmpeg is not in PATH
    VideoFile(std::filesystem::path file, double rate);

    const std::filesystem::path& file() const { return file_; }

    /// Appends a picture as write() puts it into a PNG: three or more channels in 0..1, all of one size. An
    /// odd edge gets its last row or column twice, because the encoder halves the resolution of colours.
    /// @return false if the stop has come; then the video is never put in place. @throws Error with what
    /// ffmpeg says
    bool add(const Image& picture, const std::stop_token& stop = {});
    /// Waits for the encoder and renames the file. @return false if the stop has come. @throws Error
    bool put_in_place(const std::stop_token& stop = {});

private:
    void start(int width, int height);
    [[noreturn]] void fail();

    std::filesystem::path file_;
    double rate_;
    WholeFiles whole_;
    std::optional<PipedProgram> encoder_; // from the first picture on
};

} // namespace sr::image
