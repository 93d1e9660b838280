#include "gltf/uri.hpp"

#include "core/error.hpp"
#include "core/file.hpp"
#include "gltf/text.hpp"

#include <algorithm>
#include <array>
#include <fmt/format.h>
#include <optional>

namespace sr::gltf {
namespace {

namespace fs = std::filesystem;

[[noreturn]] void fail(const UriPlace& place, std::string_view problem, std::string_view remedy) {
    throw Error({place.file}, fmt::format("{} {}", place.pointer, problem), remedy);
}

int hexadecimal(char c) {
    if (c >= '0' && c <= '9') return c - '0';
    if (c >= 'a' && c <= 'f') return c - 'a' + 10;
    if (c >= 'A' && c <= 'F') return c - 'A' + 10;
    return -1;
}

// RFC 3986, section 2.1. A percent sign that starts no code stands for itself, as exporters that forget to
// encode would have it.
std::string percent_decoded(std::string_view text) {
    std::string decoded;
    decoded.reserve(text.size());
    for (std::size_t i = 0; i < text.size(); ++i) {
        if (text[i] == '%' && i + 2 < text.size()) {
            const int high = hexadecimal(text[i + 1]);
            const int low = hexadecimal(text[i + 2]);
            if (high >= 0 && low >= 0) {
                decoded += static_cast<char>(high * 16 + low);
                i += 2;
                continue;
            }
        }
        decoded += text[i];
    }
    return decoded;
}

constexpr std::uint8_t no_digit = 255;

constexpr std::array<std::uint8_t, 256> base64_digits = [] {
    std::array<std::uint8_t, 256> digits{};
    digits.fill(no_digit);
    constexpr std::string_view alphabet = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    for (std::size_t i = 0; i < alphabet.size(); ++i)
        digits[static_cast<std::uint8_t>(alphabet[i])] = static_cast<std::uint8_t>(i);
    return digits;
}();

// RFC 4648, section 4; absent where the text is not base64.
std::optional<std::vector<std::uint8_t>> base64_decoded(std::string_view text) {
    for (int padding = 0; padding < 2 && text.ends_with('='); ++padding) text.remove_suffix(1);
    if (text.size() % 4 == 1) return std::nullopt;
    std::vector<std::uint8_t> bytes;
    bytes.reserve(text.size() / 4 * 3 + 2);
    std::uint32_t bits = 0;
    int bit_count = 0;
    for (const char c : text) {
        const std::uint8_t digit = base64_digits[static_cast<std::uint8_t>(c)];
        if (digit == no_digit) return std::nullopt;
        bits = bits << 6 | digit;
        bit_count += 6;
        if (bit_count < 8) continue;
        bit_count -= 8;
        bytes.push_back(static_cast<std::uint8_t>(bits >> bit_count & 0xFF));
    }
    return bytes;
}

std::vector<std::uint8_t> read_data_uri(std::string_view uri, const UriPlace& place) {
    const auto comma = uri.find(',');
    if (comma == std::string_view::npos)
        fail(place, "is a data URI without a comma", "export the file again");
    const std::string_view header = uri.substr(0, comma);
    const std::string_view body = uri.substr(comma + 1);
    if (!header.ends_with(";base64")) {
        const std::string text = percent_decoded(body);
        return {text.begin(), text.end()};
    }
    const bool is_encoded = body.find('%') != std::string_view::npos;
    auto bytes = base64_decoded(is_encoded ? percent_decoded(body) : body);
    if (!bytes) fail(place, "is not valid base64", "export the file again");
    return *std::move(bytes);
}

// RFC 3986, section 3.1: letters, digits, + - . before the first colon, which stands before any slash.
bool has_scheme(std::string_view uri) {
    const auto end = uri.find_first_of(":/?#");
    return end != std::string_view::npos && end > 0 && uri[end] == ':';
}

fs::path contained(std::string_view uri, const fs::path& folder, const UriPlace& place) {
    if (has_scheme(uri))
        fail(place, fmt::format("is {}, which is no file beside the glTF", in_quotes(uri)),
             "download the file, put it beside the glTF and name it there");
    std::string decoded = percent_decoded(uri);
    if (decoded.empty() || decoded.find('\0') != std::string::npos)
        fail(place, "names no file", "export the file again");
    // Both slashes separate on Windows; treating them alike keeps a scene from leaving its folder anywhere.
    std::string slashed = decoded;
    std::replace(slashed.begin(), slashed.end(), '\\', '/');
    const fs::path normal = fs::path(slashed).lexically_normal();
    if (fs::path(decoded).is_absolute() || normal.is_absolute() || normal.has_root_path()
        || *normal.begin() == "..")
        fail(place, fmt::format("is {}, which leaves the folder of the glTF", in_quotes(decoded)),
             "copy that file into the folder and name it there");
    return folder / fs::path(decoded);
}

} // namespace

std::vector<std::uint8_t> read_uri(std::string_view uri, const fs::path& folder, const UriPlace& place) {
    if (uri.starts_with("data:")) return read_data_uri(uri, place);
    const fs::path file = contained(uri, folder, place);
    return read_file(file, place.file,
                     fmt::format("{} names {}: ", place.pointer, in_quotes(file.filename().string())));
}

} // namespace sr::gltf
