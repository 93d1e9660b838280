#pragma once
// Layout of the window: panels at its sides, and the picture in what they leave.
#include "core/math.hpp"

#include <optional>
#include <string>
#include <vector>

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

/// Names of the panels beside the picture, in their titles and tabs.
namespace side {
inline constexpr const char* controls = "Controls"; // the sections of tools
inline constexpr const char* scene = "Scene";
inline constexpr const char* pixels = "Pixels";
inline constexpr const char* mixer = "Light mixer";
inline constexpr const char* illuminance = "Illuminance";
inline constexpr const char* times = "Time";
inline constexpr const char* assignment = "Assignment";
inline constexpr const char* examination = "Examination";
} // namespace side

/// Place of a panel.
struct PanelPlace {
    bool is_shown = true;       // false: it is behind the tab of another one
    std::optional<Area> area{}; // absent: it floats
};

/// Panels take areas while a frame is drawn; the picture of the next frame has what they leave, at least half
/// of the window's width. In a window that is too small for two columns, all panels share the left one by
/// tabs; in one that is too small for a column, they float over the picture.
class Layout {
public:
    static constexpr float default_column = 290.0f; // width of the left column [pixels, before scaling]

    // Each of these is called at the beginning of every frame, and at its end.
    /// `has_panels`: false leaves the whole window to the picture. `scale`: of a HiDPI screen.
    void begin(vec2 window, float scale, bool has_panels);
    void end();

    bool has_panels() const { return has_panels_; }
    bool is_docked() const { return is_docked_; }
    /// True if all panels share the left column.
    bool has_one_column() const;
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
    /// Takes a strip at the top of the left column, for the tabs of panels that share it.
    Area take_tabs(float height);
    /// The left column, below its tabs.
    Area left() const;
    /// Takes a place for a panel: a part of the right column, which is divided among all that took a part of
    /// it in the last frame; or the left column, if the panel's tab is in front. A new panel comes to the
    /// front.
    PanelPlace take_side(const std::string& name);
    /// Takes a strip below the picture: between the columns, or across the window if it has one column. The
    /// picture is shown smaller, and is not rendered again.
    Area take_below_picture(float height);

    /// The tabs of the left column: the controls, and the panels of the last frame.
    std::vector<std::string> tabs() const;
    const std::string& front() const { return front_; }
    /// Brings a tab to the front. @return true if it was behind another one
    bool bring_forward(const std::string& name);

    /// The window without the strips.
    Area rest() const { return rest_; }
    /// The area that the film is rendered for, and the one that shows it.
    Area film() const { return film_; }
    Area picture() const { return picture_; }

private:
    Area middle() const;
    float right_width() const;
    float bottom() const;

    float column_ = default_column;
    float scale_ = 1.0f;
    bool is_docked_ = false;
    bool has_panels_ = false;
    vec2 window_{1.0f};
    Area rest_;           // of the window, columns included
    float below_ = 0.0f;  // height that the picture misses between the columns
    float excess_ = 0.0f; // height of strips that the film makes no room for
    vec2 insets_{0.0f};   // of the film from the top and the bottom of the window, in the last docked frame
    float last_below_ = 0.0f;             // in the last frame
    float tabs_ = 0.0f;                   // height of the strip of tabs
    float last_bottom_ = 0.0f;            // lower edge of rest_ in the last frame
    std::vector<std::string> sides_;      // panels that took a place so far
    std::vector<std::string> last_sides_; // in the last frame
    std::string front_ = side::controls;  // tab that is shown
    Area film_;
    Area picture_;
};

} // namespace sr::viewer
