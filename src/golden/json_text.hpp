#pragma once
// A JSON file whose values know where they stand, so that an error can name line and column.
#include "core/error.hpp"

#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>

namespace sr::golden {

class JsonText {
public:
    /// Reads and parses. @throws Error if there is no such file, or with line and column if it is no JSON or
    /// is nested deeper than 64 levels.
    explicit JsonText(const std::filesystem::path& file);

    /// A text that stands for the file. @throws Error likewise
    JsonText(const std::filesystem::path& file, std::string text);

    const nlohmann::json& root() const { return root_; }

    /// Where the value at a JSON pointer begins ("/tests/3/name").
    Location place_of(const nlohmann::json::json_pointer& pointer) const;

private:
    Location place_of(std::size_t byte) const;

    std::string file_;
    std::string text_;
    nlohmann::json root_;
};

} // namespace sr::golden
