#pragma once
// The failure of a setting that makes no sense, by itself or beside others.
#include <stdexcept>
#include <string>
#include <utility>

namespace sr::settings {

/// The caller's fault: a command ends with status 2. what() is the problem alone.
class BadSetting : public std::runtime_error {
public:
    /// `key`: Option::key
    BadSetting(std::string key, const std::string& problem)
        : std::runtime_error(problem), key_(std::move(key)) {}

    const std::string& key() const { return key_; }

private:
    std::string key_;
};

} // namespace sr::settings
