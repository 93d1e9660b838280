#include "golden/page.hpp"

#include "compare/align.hpp"
#include "core/error.hpp"
#include "core/markup.hpp"
#include "golden/sha256.hpp"
#include "image/texture_formats.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <fmt/format.h>
#include <glm/gtc/packing.hpp>
#include <nlohmann/json.hpp>
#include <zlib.h>

namespace sr::golden {
namespace {

bool is_plain_word(std::string_view word) {
    constexpr std::string_view plain = "-_./=:,+@%^";
    return !word.empty() && std::ranges::all_of(word, [&](unsigned char c) {
        return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9')
               || plain.find(static_cast<char>(c)) != std::string_view::npos;
    });
}

} // namespace

std::string escape_script_json(std::string_view json) {
    std::string result;
    for (const char c : json) result += c == '<' ? std::string("\\u003c") : std::string(1, c);
    return result;
}

std::string shell_line(const std::vector<std::string>& words) {
    std::string line;
    for (const std::string& word : words) {
        if (!line.empty()) line += ' ';
        if (is_plain_word(word)) {
            line += word;
            continue;
        }
        line += '\'';
        for (const char c : word) line += c == '\'' ? std::string("'\\''") : std::string(1, c);
        line += '\'';
    }
    return line;
}

namespace {

/// 2^k that brings the largest finite magnitude to [2^14, 2^15): halves end at 65504.
float scale_of(const image::Image& image) {
    float largest = 0.0f;
    for (const float value : image.pixels)
        if (std::isfinite(value)) largest = std::max(largest, std::abs(value));
    return largest > 0.0f ? std::ldexp(1.0f, std::clamp(14 - std::ilogb(largest), -120, 120)) : 1.0f;
}

/// R, G, B and A if it is there; the one channel of an image that has but one.
std::vector<std::size_t> packed_channels(const image::Image& image) {
    if (image.channels == 1) return {0};
    const auto colors = compare::color_channels(image);
    std::vector<std::size_t> channels(colors.begin(), colors.end());
    const auto alpha = std::ranges::find(image.channel_names, "A");
    if (alpha != image.channel_names.end())
        channels.push_back(static_cast<std::size_t>(alpha - image.channel_names.begin()));
    else if (image.channel_names.empty() && image.channels == 4)
        channels.push_back(3);
    return channels;
}

std::string byte_planes(const image::Image& image, const std::vector<std::size_t>& channels, float scale) {
    const std::size_t count = static_cast<std::size_t>(image.width) * static_cast<std::size_t>(image.height);
    const auto stride = static_cast<std::size_t>(image.channels);
    std::string planes(2 * channels.size() * count, '\0');
    for (std::size_t c = 0; c < channels.size(); ++c)
        for (std::size_t i = 0; i < count; ++i) {
            const std::uint16_t half = glm::packHalf1x16(image.pixels[i * stride + channels[c]] * scale);
            planes[2 * c * count + i] = static_cast<char>(half >> 8);
            planes[(2 * c + 1) * count + i] = static_cast<char>(half & 0xFF);
        }
    return planes;
}

std::string deflated(const std::string& bytes) {
    uLongf size = compressBound(bytes.size());
    std::string result(size, '\0');
    const int status =
        compress2(reinterpret_cast<Bytef*>(result.data()), &size,
                  reinterpret_cast<const Bytef*>(bytes.data()), bytes.size(), Z_BEST_COMPRESSION);
    require(status == Z_OK, "zlib compresses into a buffer of its own bound");
    result.resize(size);
    return result;
}

} // namespace

nlohmann::ordered_json pack_pixels(const image::Image& image) {
    const float scale = scale_of(image);
    const std::vector<std::size_t> channels = packed_channels(image);
    return {{"width", image.width},
            {"height", image.height},
            {"channels", channels.size()},
            {"scale", scale},
            {"data", base64(deflated(byte_planes(image, channels, scale)))}};
}

namespace {

/// The bytes that zlib inflates to exactly this size.
std::optional<std::string> inflated(const std::string& bytes, std::size_t size) {
    std::string result(size, '\0');
    uLongf length = size;
    const int status = uncompress(reinterpret_cast<Bytef*>(result.data()), &length,
                                  reinterpret_cast<const Bytef*>(bytes.data()), bytes.size());
    if (status != Z_OK || length != size) return std::nullopt;
    return result;
}

} // namespace

std::optional<image::Image> unpack_pixels(const nlohmann::ordered_json& packed) {
    constexpr std::int64_t max_values = 1 << 24, max_side = 1 << 14;
    if (!packed.is_object()) return std::nullopt;
    const auto whole = [&](const char* key) {
        const auto found = packed.find(key);
        return found != packed.end() && found->is_number_integer() ? found->get<std::int64_t>() : 0;
    };
    const std::int64_t width = whole("width"), height = whole("height"), channels = whole("channels");
    const auto scale = packed.find("scale"), data = packed.find("data");
    if (width < 1 || width > max_side || height < 1 || height > max_side || channels < 1 || channels > 4
        || width * height * channels > max_values || scale == packed.end() || !scale->is_number()
        || data == packed.end() || !data->is_string())
        return std::nullopt;
    const auto count = static_cast<std::size_t>(width * height), stride = static_cast<std::size_t>(channels);
    const auto bytes = decoded_base64(data->get_ref<const std::string&>());
    const auto planes = bytes ? inflated(*bytes, 2 * stride * count) : std::nullopt;
    if (!planes) return std::nullopt;
    image::Image image(static_cast<int>(width), static_cast<int>(height), static_cast<int>(channels));
    const auto byte = [&](std::size_t i) { return static_cast<unsigned char>((*planes)[i]); };
    for (std::size_t c = 0; c < stride; ++c)
        for (std::size_t i = 0; i < count; ++i) {
            const int half = byte(2 * c * count + i) << 8 | byte((2 * c + 1) * count + i);
            image.pixels[i * stride + c] =
                glm::unpackHalf1x16(static_cast<std::uint16_t>(half)) / scale->get<float>();
        }
    return image;
}

std::string png_data(const image::Image& shown) {
    const auto bytes = image::encode_png(shown, "picture of a report");
    return base64({reinterpret_cast<const char*>(bytes.data()), bytes.size()});
}

namespace {

constexpr std::string_view base64_digits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";

} // namespace

std::optional<std::string> decoded_base64(std::string_view text) {
    if (text.size() % 4 != 0) return std::nullopt;
    const std::size_t padding = text.ends_with("==") ? 2 : text.ends_with("=") ? 1 : 0;
    std::string bytes;
    bytes.reserve(text.size() / 4 * 3);
    for (std::size_t i = 0; i < text.size(); i += 4) {
        std::uint32_t group = 0;
        for (std::size_t k = i; k < i + 4; ++k) {
            const std::size_t digit = k < text.size() - padding ? base64_digits.find(text[k]) : 0;
            if (digit == std::string_view::npos) return std::nullopt;
            group = group << 6 | static_cast<std::uint32_t>(digit);
        }
        for (const int shift : {16, 8, 0}) bytes += static_cast<char>(group >> shift & 0xff);
    }
    bytes.resize(bytes.size() - padding);
    return bytes;
}

std::string base64(std::string_view bytes) {
    constexpr std::string_view digits = base64_digits;
    std::string text;
    text.reserve((bytes.size() + 2) / 3 * 4);
    for (std::size_t i = 0; i < bytes.size(); i += 3) {
        const std::size_t count = std::min<std::size_t>(3, bytes.size() - i);
        std::uint32_t group = 0;
        for (std::size_t k = 0; k < 3; ++k)
            group = group << 8 | (k < count ? static_cast<unsigned char>(bytes[i + k]) : 0u);
        for (std::size_t k = 0; k < 4; ++k) text += k <= count ? digits[group >> (18 - 6 * k) & 63] : '=';
    }
    return text;
}

namespace {

std::string csp_hash(std::string_view text) {
    const Digest digest = sha256(text);
    return "'sha256-" + base64({reinterpret_cast<const char*>(digest.data()), digest.size()}) + "'";
}

} // namespace

std::string offline_page(const std::string& title, const std::string& plain, const std::string& data,
                         const ReportPage& page) {
    const ReportPage base = report_base();
    const std::string style = base.style + page.style, script = base.script + page.script;
    std::string html = "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n";
    html += fmt::format(
        "<meta http-equiv=\"Content-Security-Policy\" content=\"default-src 'none'; img-src data:; "
        "style-src {}; script-src {}; base-uri 'none'; form-action 'none'\">\n",
        csp_hash(style), csp_hash(script));
    html += "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n<link rel=\"icon\" "
            "href=\"data:,\">\n";
    html +=
        fmt::format("<title>{}</title>\n<style>{}</style>\n</head>\n<body>\n", escape_markup(title), style);
    html += fmt::format("<main id=\"page\">\n<h1>{}</h1>\n{}</main>\n", escape_markup(title), plain);
    html += fmt::format(
        "<script type=\"application/json\" id=\"data\">{}</script>\n<script>{}</script>\n</body>\n</html>\n",
        escape_script_json(data), script);
    return html;
}

} // namespace sr::golden
