// Grid tool: a grid on the ground of the file's world, its axes, and how the view is turned.
#include "viewer/palette.hpp"
#include "viewer/tools/tool.hpp"

#include <array>
#include <cmath>
#include <fmt/format.h>

namespace sr::viewer {
namespace {

constexpr int grid_reach = 10; // steps of the grid on each side of its middle
constexpr int parts = 60;      // of a line, each of which is seen, hidden or behind the camera
constexpr ImU32 weak = IM_COL32(200, 200, 200, 95);
constexpr ImU32 strong = IM_COL32(220, 220, 220, 160); // each tenth line

/// A round length, 1, 2 or 5 times a power of ten, of which some five make the radius of the scene [m].
double step_for(float radius) {
    const double wanted = std::max(1e-6, 0.2 * static_cast<double>(radius));
    const double decade = std::pow(10.0, std::floor(std::log10(wanted)));
    const double share = wanted / decade;
    return decade * (share < 1.5 ? 1.0 : share < 3.5 ? 2.0 : share < 7.5 ? 5.0 : 10.0);
}

} // namespace

class ShowGrid : public Tool {
public:
    using Tool::Tool;

    std::optional<Changes> handle(const Event& event) override;
    Changes draw(const Overlay& overlay) override;

private:
    void draw_ground(const Overlay& overlay, double step) const;
    void draw_axes(const Overlay& overlay, float length) const;
    void draw_compass(const Overlay& overlay) const;
    static void draw_line(const Overlay& overlay, vec3 from, vec3 to, ImU32 ink, float width);

    bool is_shown_ = false;
};

std::optional<Changes> ShowGrid::handle(const Event& event) {
    if (command_in(event) != Command::grid) return std::nullopt;
    is_shown_ = ws_.show_panels() || !is_shown_; // without panels, nothing is drawn over the picture
    const float radius = ws_.camera->bounds().is_empty() ? 1.0f : ws_.camera->bounds().radius();
    ws_.messages.notify(is_shown_
                            ? fmt::format("Grid: lines each {:g} m on the plane y = 0.", step_for(radius))
                            : "No grid.");
    return Change::redraw;
}

Changes ShowGrid::draw(const Overlay& overlay) {
    if (!is_shown_) return {};
    const float radius = ws_.camera->bounds().is_empty() ? 1.0f : ws_.camera->bounds().radius();
    const double step = step_for(radius);
    draw_ground(overlay, step);
    draw_axes(overlay, static_cast<float>(step * grid_reach));
    draw_compass(overlay);
    const Area picture = ws_.shown_area();
    const float line = ImGui::GetTextLineHeight();
    draw_caption({picture.from.x + picture.size.x - 9.0f * line, picture.from.y + 0.7f * line},
                 fmt::format("grid {:g} m", step));
    return {};
}

void ShowGrid::draw_line(const Overlay& overlay, vec3 from, vec3 to, ImU32 ink, float width) {
    ImDrawList& list = *ImGui::GetBackgroundDrawList();
    for (int i = 0; i < parts; ++i) {
        const auto a = overlay.projection(glm::mix(from, to, static_cast<float>(i) / parts));
        const auto b = overlay.projection(glm::mix(from, to, static_cast<float>(i + 1) / parts));
        if (!a || !b) continue;
        const bool is_hidden = overlay.hides(glm::mix(from, to, (static_cast<float>(i) + 0.5f) / parts));
        list.AddLine({a->x, a->y}, {b->x, b->y}, is_hidden ? palette::behind(ink) : ink,
                     width * overlay.scale);
    }
}

/// The grid lies around the scene, its lines at whole steps of the file's world.
void ShowGrid::draw_ground(const Overlay& overlay, double step) const {
    const glm::dvec3 origin = ws_.camera->origin();
    const scene::Bounds& bounds = ws_.camera->bounds();
    const glm::dvec3 middle = origin + glm::dvec3(bounds.is_empty() ? vec3(0.0f) : bounds.center());
    const double x0 = std::round(middle.x / step), z0 = std::round(middle.z / step);
    const auto point = [&](double i, double k) {
        return vec3(glm::dvec3((x0 + i) * step, 0.0, (z0 + k) * step) - origin);
    };
    for (int i = -grid_reach; i <= grid_reach; ++i) {
        const bool is_tenth_x = std::fmod(x0 + i, 10.0) == 0.0, is_tenth_z = std::fmod(z0 + i, 10.0) == 0.0;
        draw_line(overlay, point(i, -grid_reach), point(i, grid_reach), is_tenth_x ? strong : weak, 1.0f);
        draw_line(overlay, point(-grid_reach, i), point(grid_reach, i), is_tenth_z ? strong : weak, 1.0f);
    }
}

/// The axes of the file's world, from its origin on.
void ShowGrid::draw_axes(const Overlay& overlay, float length) const {
    const vec3 origin = vec3(-ws_.camera->origin());
    for (int axis = 0; axis < 3; ++axis) {
        const auto number = static_cast<std::size_t>(axis);
        const vec3 end = origin + length * axis_direction(axis);
        draw_line(overlay, origin, end, palette::axes[number], 2.0f);
        const auto at = overlay.projection(end);
        if (at)
            ImGui::GetBackgroundDrawList()->AddText({at->x + 3.0f, at->y}, palette::axes[number],
                                                    axis_names[number]);
    }
}

/// Three arrows at the upper right that show how the view is turned; what points away is thin.
void ShowGrid::draw_compass(const Overlay& overlay) const {
    const Area picture = ws_.shown_area();
    const float length = 28.0f * overlay.scale;
    const vec2 middle = picture.from + vec2(picture.size.x - 1.7f * length, 3.0f * length);
    const mat4 camera_from_world = glm::inverse(overlay.projection.camera.world_from_camera);
    ImDrawList& list = *ImGui::GetBackgroundDrawList();
    list.AddCircleFilled({middle.x, middle.y}, 1.5f * length, IM_COL32(0, 0, 0, 180));
    for (int axis = 0; axis < 3; ++axis) {
        const vec3 seen = glm::normalize(mat3(camera_from_world) * axis_direction(axis));
        const vec2 end = middle + length * vec2(seen.x, -seen.y);
        const ImU32 ink = palette::axes[static_cast<std::size_t>(axis)];
        list.AddLine({middle.x, middle.y}, {end.x, end.y}, ink,
                     (seen.z >= -0.1f ? 2.5f : 1.0f) * overlay.scale);
        const ImVec2 size = ImGui::CalcTextSize(axis_names[static_cast<std::size_t>(axis)]);
        const vec2 label = middle + 1.25f * length * vec2(seen.x, -seen.y) - 0.5f * vec2(size.x, size.y);
        list.AddText({label.x, label.y}, ink, axis_names[static_cast<std::size_t>(axis)]);
    }
}

std::unique_ptr<Tool> make_show_grid(Workspace& workspace) { return std::make_unique<ShowGrid>(workspace); }

} // namespace sr::viewer
