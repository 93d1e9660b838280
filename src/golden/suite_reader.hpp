#pragma once
// Typed access to a suite's JSON; whatever is wrong becomes an Error with line and column.
#include "golden/json_text.hpp"

#include <initializer_list>
#include <string>
#include <vector>

namespace sr::golden {

/// One object of the suite, and where it stands.
class SuiteReader {
public:
    using Pointer = nlohmann::json::json_pointer;

    /// @throws Error if the value there is no object.
    SuiteReader(const JsonText& text, Pointer place);

    bool has(const std::string& key) const { return value().contains(key); }
    /// The member's value; `fallback` if there is none. @throws Error for a value of another kind.
    std::string text(const std::string& key, const std::string& fallback) const;
    double number(const std::string& key, double fallback, double low, double high) const;
    int whole(const std::string& key, int fallback, int low, int high) const;
    bool flag(const std::string& key, bool fallback) const;
    /// A list of texts; one text alone is a list of one.
    std::vector<std::string> texts(const std::string& key) const;
    /// Exactly `count` numbers.
    std::vector<double> numbers(const std::string& key, std::size_t count) const;
    /// The objects of a list; none if there is no such member.
    std::vector<SuiteReader> objects(const std::string& key) const;
    /// The member, which is an object. @throws Error if it is none.
    SuiteReader object(const std::string& key) const { return {*text_, place_ / key}; }
    /// A required text.
    std::string required_text(const std::string& key) const;
    /// `text`, which stands at `key`, as a path in `folder`. @throws Error if the system takes no such path
    std::filesystem::path path(const std::string& key, const std::string& text,
                               const std::filesystem::path& folder) const;

    /// @throws Error at the first member that is not among `keys`.
    void allow_only(std::initializer_list<const char*> keys) const;

    const nlohmann::json& value() const { return text_->root().at(place_); }
    [[noreturn]] void fail(const std::string& what, const std::string& what_to_do) const;
    [[noreturn]] void fail_at(const std::string& key, const std::string& what,
                              const std::string& what_to_do) const;

private:
    void refuse_nul(const std::string& key, const nlohmann::json& text) const;

    const JsonText* text_;
    Pointer place_;
};

} // namespace sr::golden
