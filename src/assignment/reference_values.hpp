#pragma once
// Values of the reference and of typical mistakes, computed once for all submissions of a class.
#include <filesystem>
#include <map>
#include <string>
#include <vector>

namespace sr::assignment {

/// Numbers by keys. A key says all that the numbers depend on, but for the files of the assignment.
class ReferenceValues {
public:
    /// @return null if they are not known
    const std::vector<double>* find(const std::string& key) const;
    const std::vector<double>& add(const std::string& key, std::vector<double> numbers);

    /// Writes them to a file. @return the SHA-256 of its bytes, in hexadecimal. @throws Error
    std::string save(const std::filesystem::path& file) const;

    /// Reads a file of this SHA-256. @return false if the file has another, is not there or is damaged: then
    /// nothing is known
    bool load(const std::filesystem::path& file, const std::string& digest);

private:
    std::map<std::string, std::vector<double>> numbers_;
};

/// Joins what numbers depend on to a key.
std::string key_of(const std::vector<std::string>& parts);

} // namespace sr::assignment
