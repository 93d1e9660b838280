#pragma once
// Measured BRDFs that materials name, each read once for all moments of a file.
#include "gltf/document.hpp"
#include "scene/measured_brdf.hpp"

#include <map>
#include <string>
#include <vector>

namespace sr::gltf {

class MeasuredTable {
public:
    explicit MeasuredTable(const Document& document) : document_(document) {}

    /// The number (in brdfs()) of a MERL file beside the glTF; `title` says in errors who wants it.
    /// @throws Error if it cannot be read, or is cut short
    int number(const std::string& uri, const std::string& title);

    const std::vector<scene::MeasuredBrdf>& brdfs() const { return brdfs_; }

private:
    const Document& document_;
    std::vector<scene::MeasuredBrdf> brdfs_;
    std::map<std::string, int> number_of_; // by uri
};

} // namespace sr::gltf
