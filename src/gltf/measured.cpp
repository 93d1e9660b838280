#include "gltf/measured.hpp"

#include "gltf/uri.hpp"

#include <fmt/format.h>
#include <span>

namespace sr::gltf {

int MeasuredTable::number(const std::string& uri, const std::string& title) {
    if (const auto known = number_of_.find(uri); known != number_of_.end()) return known->second;
    if (uri.empty() || is_data_uri(uri))
        document_.fail(fmt::format("{} is measured, and its file is not named", title),
                       R"(name one beside the glTF, as in "file": "gold-paint.binary")");
    const std::vector<std::uint8_t> bytes = read_uri(uri, document_.folder, {document_.name, title});
    brdfs_.push_back(scene::read_merl(std::as_bytes(std::span(bytes)), (document_.folder / uri).string()));
    return number_of_[uri] = static_cast<int>(brdfs_.size()) - 1;
}

} // namespace sr::gltf
