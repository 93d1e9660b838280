#pragma once
// Layout of the window: panels at its sides, and the picture in what they leave.
#include "core/math.hpp"

namespace sr::viewer {

/// Rectangle in the window, from its upper left [unit of the pointer].
struct Area {
    vec2 from{0.0f};
    vec2 size{0.0f};

    bool contains(vec2 at) const {
        return at.x >= from.x && at.y >= from.y && at.x < from.x + size.x && at.y < from.y + size.y;
    }
    bool operator==(const Area&) const = default;
};

/// The largest area of this width / height in the middle of `room`.
Area fitted_into(const Area& room, float aspect_ratio);

/// Panels take areas while a frame is drawn; the picture of the next frame has what they leave. In a window
/// that is too small for both, panels float over the picture.
class Layout {
public:
    static constexpr float default_column = 290.0f; // width of the left column [pixels, before scaling]

    // Each of these is called at the beginning of every frame, and at its end.
    /// `has_panels`: false leaves the whole window to the picture. `scale`: of a HiDPI screen.
    void begin(vec2 window, float scale, bool has_panels);
    void end();

    bool is_docked() const { return is_docked_; }
    /// Width of the left column [pixels, before scaling].
    float column() const { return column_; }
    void set_column(float width) { column_ = width; }
    /// Narrowest and widest left column [unit of the pointer].
    vec2 column_range() const;

    // The areas of docked panels, in the order in which they are taken.
    Area take_top(float height);
    /// Takes a strip above the ones that were taken before. Of its height, the film makes room for `steady`
    /// alone: where the strip needs more for a while, the picture is shown smaller, and is not rendered
    /// again.
    Area take_bottom(float height, float steady);
    Area left() const;
    /// Takes a part of the right column, which is divided among all that took a part of it in the last frame.
    Area take_right();
    /// Takes a strip between the columns. The picture is shown smaller, and is not rendered again.
    Area take_below_picture(float height);

    /// The window without the strips.
    Area rest() const { return rest_; }
    /// The area that the film is rendered for, and the one that shows it.
    Area film() const { return film_; }
    Area picture() const { return picture_; }

private:
    Area middle() const;

    float column_ = default_column;
    float scale_ = 1.0f;
    bool is_docked_ = false;
    bool has_panels_ = false;
    vec2 window_{1.0f};
    Area rest_;           // of the window, columns included
    float below_ = 0.0f;  // height that the picture misses between the columns
    float excess_ = 0.0f; // height of strips that the film makes no room for
    vec2 insets_{0.0f};   // of the film from the top and the bottom of the window, in the last docked frame
    int right_parts_ = 0; // taken so far
    int right_count_ = 0; // taken in the last frame
    Area film_;
    Area picture_;
};

} // namespace sr::viewer
