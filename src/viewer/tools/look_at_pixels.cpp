// Pixel tool: enlarges pixels, shows their numbers, statistics and a loupe, pins pixels.
#include "viewer/app/fonts.hpp"
#include "viewer/panels/pixels.hpp"
#include "viewer/tools/tool.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <utility>

namespace sr::viewer {
namespace {

constexpr int max_factor = 128;

} // namespace

class LookAtPixels : public Tool {
public:
    using Tool::Tool;

    std::optional<Changes> handle(const Event& event) override;
    void notice(Changes changes) override;
    Changes draw(const Overlay& overlay) override;
    bool holds_pointer() const override { return drag_ != Drag::none; }

private:
    enum class Drag { none, move, rectangle };

    std::optional<Changes> execute(Command command);
    std::optional<Changes> press(const ButtonEvent& button);
    std::optional<Changes> move_to(vec2 at);
    Changes zoom(int factor, vec2 around);
    void set_from(vec2 from);
    Changes pin();
    std::optional<glm::ivec2> pixel_at(vec2 at) const;
    void read_film();
    std::string source() const;
    bool is_zoomed() const { return ws_.display.zoom.factor > 1; }

    bool is_open_ = false; // the panel
    Drag drag_ = Drag::none;
    bool is_click_ = false; // the pointer has not moved since the button was pressed
    vec2 at_{0.0f};         // of the last motion: events of a whole drag may come at once
    vec2 pressed_at_{0.0f};
    vec2 from_at_press_{0.0f}; // PixelZoom::from
    glm::ivec2 first_{0};      // corner of the rectangle
    std::optional<PixelRectangle> rectangle_;
    std::vector<glm::ivec2> pinned_;
    image::Image numbers_; // of the picture that is shown, as they were read last
    PixelStatistics statistics_;
    char letter_ = 0;  // of the kept picture that they are of; 0: the render
    int samples_ = -1; // of the render at that time; negative: they are out of date
};

std::optional<Changes> LookAtPixels::handle(const Event& event) {
    if (const auto command = command_in(event)) return execute(*command);
    if (const auto* motion = std::get_if<MotionEvent>(&event)) return move_to(motion->to);
    if (const auto* button = std::get_if<ButtonEvent>(&event)) return press(*button);
    const auto* wheel = std::get_if<ScrollEvent>(&event);
    if (!wheel || wheel->by.y == 0.0f || !(is_zoomed() || (wheel->modifiers & control))) return std::nullopt;
    const int factor = ws_.display.zoom.factor;
    return zoom(wheel->by.y > 0.0f ? 2 * factor : factor / 2, ws_.input.pointer());
}

std::optional<Changes> LookAtPixels::execute(Command command) {
    const int factor = ws_.display.zoom.factor;
    switch (command) {
    case Command::enlarge: return zoom(2 * factor, ws_.input.pointer());
    case Command::reduce: return zoom(factor / 2, ws_.input.pointer());
    case Command::pin_pixel: return pin();
    case Command::pixels:
        if (ws_.show_panel(side::pixels) && is_open_) return Change::redraw;
        is_open_ = !is_open_;
        if (!is_open_) rectangle_.reset();
        samples_ = -1;
        return Change::redraw;
    case Command::cancel:
        if (rectangle_) {
            rectangle_.reset();
            samples_ = -1;
            return Change::redraw;
        }
        return is_zoomed() ? std::optional(zoom(1, ws_.input.pointer())) : std::nullopt;
    default: return std::nullopt;
    }
}

/// Enlarges pixels by a power of two; the one at `around` stays there.
Changes LookAtPixels::zoom(int factor, vec2 around) {
    factor = std::clamp(factor, 1, max_factor);
    const Area shown = ws_.shown_area();
    const vec2 place = glm::clamp((around - shown.from) / shown.size, vec2(0.0f), vec2(1.0f));
    const vec2 size(ws_.width, ws_.height);
    const PixelZoom& now = ws_.display.zoom;
    const vec2 pixel = vec2(now.from) + place * size / static_cast<float>(now.factor);
    ws_.display.zoom.factor = factor;
    set_from(pixel - place * size / static_cast<float>(factor));
    ws_.messages.notify(factor == 1 ? "Pixels have their size again."
                                    : fmt::format("Pixels are {} times as large. Esc ends it.", factor));
    return Change::display;
}

void LookAtPixels::set_from(vec2 from) {
    const vec2 size(ws_.width, ws_.height);
    const vec2 last = size - glm::ceil(size / static_cast<float>(ws_.display.zoom.factor));
    ws_.display.zoom.size = {ws_.width, ws_.height};
    ws_.display.zoom.from = glm::ivec2(glm::clamp(glm::round(from), vec2(0.0f), last));
}

std::optional<glm::ivec2> LookAtPixels::pixel_at(vec2 at) const {
    if (!ws_.shown_area().contains(at)) return std::nullopt;
    return glm::ivec2(glm::floor(ws_.place_in_picture(at) * vec2(ws_.width, ws_.height)));
}

/// A Shift drag chooses a rectangle while the panel is open. Any drag moves enlarged pixels.
std::optional<Changes> LookAtPixels::press(const ButtonEvent& button) {
    const vec2 at = at_;
    if (!button.is_down) {
        if (drag_ == Drag::none) return std::nullopt;
        const bool is_click = std::exchange(drag_, Drag::none) == Drag::move && is_click_;
        if (is_click && button.button == Button::left)
            ws_.input.put(ClickEvent{at, button.modifiers & (shift | control)});
        return Change::redraw;
    }
    if (drag_ != Drag::none) return Changes();
    const auto pixel = pixel_at(at);
    if (!pixel) return std::nullopt;
    const bool is_rectangle = is_open_ && button.button == Button::left && button.modifiers == shift;
    if (!is_rectangle && !is_zoomed()) return std::nullopt;
    drag_ = is_rectangle ? Drag::rectangle : Drag::move;
    is_click_ = true;
    pressed_at_ = at;
    from_at_press_ = vec2(ws_.display.zoom.from);
    first_ = *pixel;
    return Changes();
}

std::optional<Changes> LookAtPixels::move_to(vec2 at) {
    constexpr float click_slack = 4.0f; // [pixels] of motion that still make a click
    at_ = at;
    if (drag_ == Drag::none) return is_open_ ? std::optional(Changes(Change::redraw)) : std::nullopt;
    is_click_ = is_click_ && glm::distance(at, pressed_at_) <= click_slack;
    if (is_click_) return Changes();
    if (drag_ == Drag::move) {
        const vec2 by = (at - pressed_at_) / ws_.picture().size * vec2(ws_.width, ws_.height);
        set_from(from_at_press_ - by);
        return Change::display;
    }
    const Area shown = ws_.shown_area();
    const vec2 inside = glm::clamp(at, shown.from, shown.from + shown.size - 1.0f);
    rectangle_ = between(first_, pixel_at(inside).value_or(first_), {ws_.width, ws_.height});
    samples_ = -1;
    return Change::redraw;
}

Changes LookAtPixels::pin() {
    const auto pixel = pixel_at(ws_.input.pointer());
    if (pixel) {
        pinned_.push_back(*pixel);
        is_open_ = true;
        ws_.show_panel(side::pixels);
        ws_.messages.notify(fmt::format("Pinned pixel {},{}.", pixel->x, pixel->y));
    } else {
        ws_.messages.notify("Point at the picture to pin a pixel.");
    }
    return Change::redraw;
}

void LookAtPixels::notice(Changes changes) {
    if (changes == everything) {
        pinned_.clear();
        rectangle_.reset();
        ws_.display.zoom = {};
    }
    if (changes.any() && !(changes == Change::redraw)) samples_ = -1;
    if (is_zoomed()) set_from(vec2(ws_.display.zoom.from)); // the window may have another size
}

/// Reads the film that is shown if it is another one, or has other samples, than before.
void LookAtPixels::read_film() {
    const ProgressiveRender& render = ws_.scene->render();
    const KeptPicture* const kept = ws_.shown_picture();
    const char letter = kept ? kept->letter : '\0';
    const bool has_size = kept || (numbers_.width == ws_.width && numbers_.height == ws_.height);
    if (render.sample_count() == samples_ && letter == letter_ && has_size) return;
    samples_ = render.sample_count();
    letter_ = letter;
    const output::Variable* const view = ws_.display.view;
    numbers_ = kept ? kept->picture.film() : render.read_film();
    if (view && !(kept && kept->picture.is_display_referred()))
        numbers_ = output::numbers_of(*view, numbers_);
    const glm::ivec2 size(numbers_.width, numbers_.height);
    if (rectangle_ && (rectangle_->end.x > size.x || rectangle_->end.y > size.y)) rectangle_.reset();
    const PixelRectangle all{glm::ivec2(0), size};
    const auto& [from, end] = rectangle_ ? *rectangle_ : all;
    statistics_ = statistics_of(numbers_, {from, end});
    ws_.messages.log(fmt::format("Statistics of {}, {}x{}+{}+{}: mean {:.6g}, at most {:.6g}.", source(),
                                 end.x - from.x, end.y - from.y, from.x, from.y, statistics_.mean.w,
                                 statistics_.max.w));
}

/// The picture whose numbers they are.
std::string LookAtPixels::source() const {
    return letter_ ? fmt::format("picture {}", letter_) : "the render";
}

Changes LookAtPixels::draw(const Overlay& overlay) {
    const ProgressiveRender& render = ws_.scene->render();
    const bool has_numbers = is_zoomed() || is_open_;
    const PanelPlace place = is_open_ ? ws_.layout.take_side(side::pixels) : PanelPlace{false};
    const KeptPicture* const kept = ws_.shown_picture();
    const bool is_coarse = !kept && (render.is_interactive() || render.sample_count() == 0 || ws_.is_mixing);
    if (!has_numbers || (is_coarse && numbers_.width == 0)) return {};
    if (is_coarse)
        samples_ = -1; // another picture follows
    else
        read_film();
    const auto unit =
        kept && kept->picture.is_display_referred()
            ? "linear light of a screen, 0 to 1"
            : with_superscripts(output::unit_of(ws_.display.view, ws_.scene->stage().scene.units));
    const ShownFilm film{numbers_,         source(),      unit,         ws_.display,
                         ws_.shown_area(), ws_.picture(), overlay.scale};
    if (!is_coarse) draw_pixel_numbers(film);
    draw_pixel_marks(film, rectangle_, pinned_);
    if (!place.is_shown) return {};
    const auto pointed = ws_.ui.has_pointer() ? std::nullopt : film.pixel_at(ws_.input.pointer());
    const PixelsOutcome outcome =
        draw_pixels_panel(film, rectangle_, statistics_, pinned_, pointed, place.area, ws_.ui, ws_.keys);
    if (outcome.unpinned) pinned_.erase(pinned_.begin() + static_cast<std::ptrdiff_t>(*outcome.unpinned));
    if (outcome.drops_rectangle) rectangle_.reset();
    if (outcome.drops_rectangle) samples_ = -1;
    if (outcome.closes) return execute(Command::pixels).value_or(Changes());
    return outcome.unpinned || outcome.drops_rectangle ? Changes(Change::redraw) : Changes();
}

std::unique_ptr<Tool> make_look_at_pixels(Workspace& workspace) {
    return std::make_unique<LookAtPixels>(workspace);
}

} // namespace sr::viewer
