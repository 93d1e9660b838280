#pragma once
// List of kept pictures: which two are compared, their names, and what the comparison measures.
#include "compare/metrics.hpp"
#include "viewer/document/kept_pictures.hpp"

#include <array>
#include <optional>
#include <string>

namespace sr::viewer {

/// Choices of a person in the list.
struct KeptPicturesOutcome {
    bool has_changed = false; // another pair of pictures, or fewer of them
    bool measures = false;
};

class KeptPicturesList {
public:
    /// Draws a row for the render and for each picture.
    KeptPicturesOutcome draw(KeptPictures& pictures);

private:
    std::optional<std::size_t> named_; // picture whose name is typed
    std::array<char, 128> name_{};
};

/// Draws a table of what was measured of two pictures. `what`: which ones.
void draw_metrics(const compare::Metrics& metrics, const std::string& what, const std::string& unit);

} // namespace sr::viewer
