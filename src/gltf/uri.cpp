#include "gltf/uri.hpp"

#include "core/error.hpp"
#include "core/file.hpp"
#include "gltf/container.hpp"
#include "gltf/warnings.hpp"

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

char lower(char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; }

constexpr std::uint8_t no_digit = 255;

constexpr std::array<std::uint8_t, 256> base64_digits = [] {
    std::array<std::uint8_t, 256> digits{};
    digits.fill(no_digit);
    constexpr std::string_view alphabet = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    for (std::size_t i = 0; i < alphabet.size(); ++i)
        digits[static_cast<std::uint8_t>(alphabet[i])] = static_cast<std::uint8_t>(i);
    digits[static_cast<std::uint8_t>('-')] = 62; // section 5: safe in URLs
    digits[static_cast<std::uint8_t>('_')] = 63;
    return digits;
}();

bool is_space(char c) { return c == ' ' || (c >= '\t' && c <= '\r'); }

// RFC 4648, sections 4 and 5, broken into lines or not; absent where the text is not base64.
std::optional<std::vector<std::uint8_t>> base64_decoded(std::string_view text) {
    int padding = 0;
    for (; !text.empty() && (is_space(text.back()) || (padding < 2 && text.back() == '='));
         text.remove_suffix(1))
        if (text.back() == '=') ++padding;
    std::vector<std::uint8_t> bytes;
    bytes.reserve(text.size() / 4 * 3 + 2);
    std::uint32_t bits = 0;
    int bit_count = 0;
    for (const char c : text) {
        const std::uint8_t digit = base64_digits[static_cast<std::uint8_t>(c)];
        if (digit == no_digit && is_space(c)) continue;
        if (digit == no_digit) return std::nullopt;
        bits = bits << 6 | digit;
        bit_count += 6;
        if (bit_count < 8) continue;
        bit_count -= 8;
        bytes.push_back(static_cast<std::uint8_t>(bits >> bit_count & 0xFF));
    }
    if (bit_count == 6) return std::nullopt; // one digit is no byte
    return bytes;
}

bool is_same_but_for_case(std::string_view a, std::string_view b) {
    return std::ranges::equal(a, b, [](char x, char y) { return lower(x) == lower(y); });
}

// RFC 2397: the header's ";base64" says how the data is written; without it it is percent-encoded text.
std::vector<std::uint8_t> read_data_uri(std::string_view uri, const UriPlace& place) {
    constexpr std::string_view base64 = ";base64";
    const auto comma = uri.find(',');
    if (comma == std::string_view::npos)
        fail(place, "is a data URI without a comma", "export the file again");
    const std::string_view header = uri.substr(0, comma);
    const std::string_view body = uri.substr(comma + 1);
    if (header.size() < base64.size()
        || !is_same_but_for_case(header.substr(header.size() - base64.size()), base64)) {
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

/// How a relative URI may be meant, the most literal reading of RFC 3986 first.
std::vector<std::string> readings_of(std::string_view uri) {
    std::vector<std::string> readings{percent_decoded(uri.substr(0, uri.find_first_of("?#"))),
                                      percent_decoded(uri), std::string(uri)};
    for (std::size_t i = 0; i < 3; ++i) {
        std::string slashed = readings[i];
        std::ranges::replace(slashed, '\\', '/');
        readings.push_back(std::move(slashed));
    }
    std::vector<std::string> different;
    for (std::string& reading : readings)
        if (std::ranges::find(different, reading) == different.end()) different.push_back(std::move(reading));
    return different;
}

bool leaves_folder(const std::string& reading) {
    // Both slashes separate on Windows; treating them alike keeps a scene from leaving its folder anywhere.
    std::string slashed = reading;
    std::ranges::replace(slashed, '\\', '/');
    const fs::path normal = fs::path(slashed).lexically_normal();
    return normal.is_absolute() || normal.has_root_path() || normal.empty() || *normal.begin() == "..";
}

/// Returns whether a symbolic link on the way leads out of the folder. A link to another place in the folder
/// does not.
bool is_linked_away(const fs::path& file, const fs::path& folder) {
    std::error_code failure;
    const fs::path root = fs::canonical(folder.empty() ? fs::path(".") : folder, failure);
    if (failure) return false; // so that reading it says what is wrong
    const fs::path target = fs::canonical(file, failure);
    if (failure) return false;
    return std::ranges::mismatch(root, target).in1 != root.end();
}

} // namespace

bool is_data_uri(std::string_view uri) {
    constexpr std::string_view scheme = "data:";
    return uri.size() >= scheme.size() && is_same_but_for_case(uri.substr(0, scheme.size()), scheme);
}

std::vector<fs::path> candidate_files(std::string_view uri, const fs::path& folder) {
    std::vector<fs::path> files;
    if (has_scheme(uri)) return files;
    for (const std::string& reading : readings_of(uri))
        if (!reading.empty() && reading.find('\0') == std::string::npos && !leaves_folder(reading))
            files.push_back(folder / fs::path(reading).lexically_normal()); // RFC 3986, section 5.2.4
    return files;
}

fs::path resolve_file(std::string_view uri, const fs::path& folder, const UriPlace& place) {
    if (has_scheme(uri))
        fail(place, fmt::format("is {}, which is no file beside the glTF", in_quotes(uri)),
             "download the file, put it beside the glTF and name it there");
    const std::string literal = readings_of(uri).front();
    if (literal.empty() || literal.find('\0') != std::string::npos)
        fail(place, "names no file", "export the file again");
    if (leaves_folder(literal))
        fail(place, fmt::format("is {}, which leaves the folder of the glTF", in_quotes(literal)),
             "copy that file into the folder and name it there");
    const std::vector<fs::path> files = candidate_files(uri, folder);
    std::error_code ignored;
    const auto found =
        std::ranges::find_if(files, [&](const fs::path& file) { return fs::exists(file, ignored); });
    const fs::path& file = found == files.end() ? files.front() : *found;
    if (is_linked_away(file, folder))
        fail(place, fmt::format("is {}, a symbolic link out of the folder of the glTF", in_quotes(literal)),
             "copy that file into the folder in its place");
    return file;
}

std::vector<std::uint8_t> read_uri(std::string_view uri, const fs::path& folder, const UriPlace& place) {
    if (is_data_uri(uri)) return read_data_uri(uri, place);
    const fs::path file = resolve_file(uri, folder, place);
    return read_file(file, place.file,
                     fmt::format("{} names {}: ", place.pointer, in_quotes(file.filename().string())));
}

namespace {

namespace fs = std::filesystem;
using nlohmann::json;

void collect(const json& value, const fs::path& folder, std::vector<fs::path>& files) {
    if (value.is_object())
        for (const char* key : {"uri", "file"}) // "file": extras.steradian of a material
            if (const auto uri = value.find(key); uri != value.end() && uri->is_string())
                for (fs::path& file : candidate_files(uri->get_ref<const std::string&>(), folder))
                    files.push_back(std::move(file));
    if (value.is_structured())
        for (const json& part : value) collect(part, folder, files);
}

} // namespace

std::vector<fs::path> named_files(const json& root, const fs::path& folder) {
    std::vector<fs::path> files;
    collect(root, folder, files);
    return files;
}

} // namespace sr::gltf
