#include "assignment/reference_values.hpp"

#include "core/error.hpp"
#include "core/file.hpp"
#include "golden/sha256.hpp"
#include "image/whole_file.hpp"

#include <cstdint>
#include <cstring>
#include <fmt/format.h>
#include <utility>

namespace sr::assignment {
namespace {

constexpr std::size_t key_bytes = 64;

} // namespace

std::string key_of(const std::vector<std::string>& parts) {
    std::string text;
    for (const std::string& part : parts) text += fmt::format("{} {}\n", part.size(), part);
    return golden::sha256_text(text);
}

const std::vector<double>* ReferenceValues::find(const std::string& key) const {
    const auto found = numbers_.find(key);
    return found == numbers_.end() ? nullptr : &found->second;
}

const std::vector<double>& ReferenceValues::add(const std::string& key, std::vector<double> numbers) {
    return numbers_[key] = std::move(numbers);
}

// A record: the key, the count (64 bits), the numbers, in the machine's own order of bytes.
std::string ReferenceValues::save(const std::filesystem::path& file) const {
    std::string bytes;
    for (const auto& [key, numbers] : numbers_) {
        const std::uint64_t count = numbers.size();
        bytes += key;
        bytes.append(reinterpret_cast<const char*>(&count), sizeof count);
        bytes.append(reinterpret_cast<const char*>(numbers.data()), numbers.size() * sizeof(double));
    }
    image::write_text(file, bytes);
    return golden::sha256_text(bytes);
}

bool ReferenceValues::load(const std::filesystem::path& file, const std::string& digest) {
    std::string bytes;
    try {
        bytes = read_text(file);
    } catch (const Error&) {
        return false;
    }
    if (golden::sha256_text(bytes) != digest) return false;
    for (std::size_t at = 0; at < bytes.size();) {
        std::uint64_t count = 0;
        if (bytes.size() - at < key_bytes + sizeof count) return false;
        const std::string key = bytes.substr(at, key_bytes);
        std::memcpy(&count, bytes.data() + at + key_bytes, sizeof count);
        at += key_bytes + sizeof count;
        if ((bytes.size() - at) / sizeof(double) < count) return false;
        std::vector<double> numbers(count);
        std::memcpy(numbers.data(), bytes.data() + at, count * sizeof(double));
        at += count * sizeof(double);
        numbers_[key] = std::move(numbers);
    }
    return true;
}

} // namespace sr::assignment
