#pragma once
// JSON files, with the line and column of each value for error messages.
#include "core/error.hpp"

#include <cstdint>
#include <filesystem>
#include <initializer_list>
#include <nlohmann/json.hpp>
#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

namespace sr {

/// The extent of a JSON text, counted before a parser allocates memory for it.
struct JsonExtent {
    std::uint64_t values = 0; // an upper bound
    int depth = 0;            // of objects and arrays
};

/// Counts on the text, which need not be valid. (With nlohmann's parser callback, which is told the depth,
/// parsing takes quadratic time in the length of arrays: 3.11 visits all earlier siblings after each
/// element.)
JsonExtent json_extent(std::string_view text);

/// Finds the first number that no double can hold, which nlohmann does not report; returns its offset.
std::optional<std::size_t> overflowing_number(std::string_view text);

/// A JSON text that cannot be parsed. what() is nlohmann's message.
struct JsonError : std::runtime_error {
    enum class Kind { nesting, syntax, number };
    JsonError(Kind error_kind, std::size_t at, const char* message)
        : std::runtime_error(message), kind(error_kind), byte(at) {}

    Kind kind;
    std::size_t byte; // from 0; of the text
};

/// Parses a text. Json is nlohmann::json or nlohmann::ordered_json. `name` is what errors call the file.
/// @throws JsonError if it is no JSON, or nested deeper than `max_depth` (recursive readers would exhaust
/// their stack); Error if it has more values than the limit json-values
template<class Json>
Json parse_json(std::string_view text, int max_depth, const std::string& name);

/// Line and column of a byte of a text.
Location location_of(std::size_t byte, std::string_view text, const std::string& file);

/// A JSON file and its text.
class JsonFile {
public:
    using Pointer = nlohmann::json::json_pointer;

    /// Reads and parses a file. @throws Error if there is no such file, or with line and column if it is no
    /// JSON or is nested deeper than 64 levels.
    explicit JsonFile(const std::filesystem::path& file);

    /// A text that stands for the file. @throws Error likewise
    JsonFile(const std::filesystem::path& file, std::string text);

    const nlohmann::json& root() const { return root_; }

    /// Finds where the value at a JSON pointer begins ("/tests/3/name").
    Location place_of(const Pointer& pointer) const;
    /// Finds where the key of that value begins; of an array's element the value.
    Location place_of_key(const Pointer& pointer) const;

private:
    std::string file_;
    std::string text_;
    nlohmann::json root_;
};

/// One object of a JSON file, with typed access to its members. A wrong value is an Error with line and
/// column.
class JsonObject {
public:
    using Pointer = JsonFile::Pointer;

    /// @throws Error if the value there is no object.
    JsonObject(const JsonFile& file, Pointer place);

    bool has(const std::string& key) const { return value().contains(key); }
    /// The member's value; `fallback` if there is none. @throws Error for a value of another type.
    std::string text(const std::string& key, const std::string& fallback) const;
    double number(const std::string& key, double fallback, double low, double high) const;
    int integer(const std::string& key, int fallback, int low, int high) const;
    bool flag(const std::string& key, bool fallback) const;
    /// A list of texts; one text alone is a list of one.
    std::vector<std::string> texts(const std::string& key) const;
    /// Exactly `count` numbers.
    std::vector<double> numbers(const std::string& key, std::size_t count) const;
    /// The objects of a list; none if there is no such member.
    std::vector<JsonObject> objects(const std::string& key) const;
    /// The member, which is an object. @throws Error if it is none.
    JsonObject object(const std::string& key) const { return {*file_, place_ / key}; }
    /// A required text.
    std::string required_text(const std::string& key) const;
    /// `text`, which stands at `key`, as a path in `folder`. @throws Error if the system takes no such path
    std::filesystem::path path(const std::string& key, const std::string& text,
                               const std::filesystem::path& folder) const;

    /// @throws Error at the first member that is not among `keys`.
    void allow_only(const std::vector<const char*>& keys) const;

    const nlohmann::json& value() const { return file_->root().at(place_); }
    [[noreturn]] void fail(const std::string& what, const std::string& what_to_do) const;
    [[noreturn]] void fail_at(const std::string& key, const std::string& what,
                              const std::string& what_to_do) const;

private:
    void refuse_nul(const std::string& key, const nlohmann::json& text) const;

    const JsonFile* file_;
    Pointer place_;
};

} // namespace sr
