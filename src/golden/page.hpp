#pragma once
// Pages that need nothing from outside: HTML, style, scripts, data and pixels in one file.
#include "image/image.hpp"

#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace sr::golden {

/// Escapes JSON for an HTML script element: no '<' is left that could end it.
std::string escape_script_json(std::string_view json);

/// A command as one line that a POSIX shell reads back as these words.
std::string shell_line(const std::vector<std::string>& words);

/// Packs R, G, B and, where there is one, A of an image; of an image of one channel that channel: {"width",
/// "height", "channels", "scale", "data"}. The values times `scale` (a power of two that uses the range of
/// half floats well) are halves, for each channel all high bytes and then all low bytes, deflated (RFC 1950),
/// base64. A half has 11 significant bits: the error is within 0.05 %.
nlohmann::ordered_json pack_pixels(const image::Image& image);

/// The inverse of pack_pixels(). Absent for JSON of another form, or of more than 2²⁴ values.
std::optional<image::Image> unpack_pixels(const nlohmann::ordered_json& packed);

/// A PNG of values in 0..1 that are encoded for display, as base64.
std::string png_data(const image::Image& shown);

/// RFC 4648 section 4.
std::string base64(std::string_view bytes);

/// The inverse. Absent for text that base64() does not make.
std::optional<std::string> decoded_base64(std::string_view text);

/// The *.css and *.js files of a folder as they were when the program was built, in the order of their names.
struct ReportPage {
    std::string style;
    std::string script;
};

/// The style, pixel decoding and image viewer of all reports (report/).
ReportPage report_base();

/// The page of a suite's run (report/suite/).
ReportPage suite_page();

/// One HTML file whose script element "data" holds the JSON text `data`. `page` comes after report_base().
/// Its Content-Security-Policy allows that one style and that one script by their SHA-256, and no address.
/// `plain` is markup that shows where the script may not run.
std::string offline_page(const std::string& title, const std::string& plain, const std::string& data,
                         const ReportPage& page);

} // namespace sr::golden
