// Two pictures: modes, zoom, exposure, boxes around what fails, the values under the cursor.

/** An element with properties, classes and children; texts are always text, never markup. */
function element(tag, properties, ...children) {
  const { classes, ...rest } = properties || {};
  const node = Object.assign(document.createElement(tag), rest);
  if (classes) node.className = classes;
  node.append(...children);
  return node;
}

/** The key of a button and its text; pages without a keyboard hide the key. */
function key_and_text(key, text) {
  return [element("span", { classes: "key", textContent: `${key} ` }), text];
}

const zooms = [1, 2, 4, 8, 16, 32, 64];

const modes = [
  { key: "1", name: "side by side", panes: ["test", "golden", "difference"] },
  { key: "2", name: "test", panes: ["test"] },
  { key: "3", name: "golden", panes: ["golden"] },
  { key: "4", name: "difference", panes: ["difference"] },
  { key: "5", name: "swipe", panes: ["swipe"] },
  { key: "6", name: "flicker", panes: ["flicker"] },
  { key: "7", name: "limits", panes: ["limits"] },
];

const alpha_modes = ["off", "over", "alone"];
const alpha_words = { off: "off", over: "over squares", alone: "alone" };

/**
 * Shows `images` {test, golden, errors, is_display_referred}; golden and errors (unpacked_errors()) may be absent, and
 * golden may be of another size. `names` are what people read for "test" and "golden".
 */
class Viewer {
  constructor(images, names) {
    this.images = images;
    this.names = names || {};
    this.base = images.is_display_referred ? 1 : automatic_exposure(images.golden || images.test);
    this.stops = 0;
    const { test, golden } = images;
    this.is_comparable = Boolean(golden) && golden.width === test.width && golden.height === test.height;
    this.gain = this.is_comparable ? automatic_gain(test, golden) : 1;
    this.alpha_mode = alpha_modes[0];
    this.boxes = images.errors ? failing_boxes(images.errors) : [];
    this.box = -1; // none is chosen
    this.touches = new Map(); // fingers on the picture, by pointer
    this.zoom = null; // fits the pane
    this.split = 0.5;
    this.mode = this.modes()[0];
    this.cursor = null;
    this.node = element("section", { classes: "viewer" });
    this.stages = element("div", { classes: "stages" });
    this.readout = element("div", { classes: "readout" });
    this.node.append(this.bar(), this.stages, this.readout);
    this.show_readout();
  }

  name(what) {
    return this.names[what] || what;
  }

  /** The modes that there is something to show in. */
  modes() {
    if (!this.images.golden) return [modes[1]];
    if (!this.is_comparable) return modes.slice(0, 3);
    return this.images.errors ? modes : modes.slice(0, 6);
  }

  /** What a mode shows; where sizes differ there is no difference. The first shows what broke the limit, if anything. */
  panes(mode) {
    if (mode.panes.length === 1) return mode.panes;
    if (!this.is_comparable) return ["test", "golden"];
    return this.boxes.length ? ["test", "golden", "limits"] : mode.panes;
  }

  has_alpha() {
    return Boolean(this.images.test.alpha || (this.images.golden && this.images.golden.alpha));
  }

  bar() {
    this.mode_buttons = this.modes().map((mode) =>
      element("button", { type: "button", onclick: () => this.choose(mode) }, ...key_and_text(mode.key, this.name(mode.name)))
    );
    this.zoom_label = element("output", {});
    this.fit_button = element("button", { type: "button", textContent: "fit", title: "as large as fits (0)", onclick: () => this.fit() });
    this.stops_label = element("output", {});
    this.gain_label = element("output", {});
    this.stops_slider = element("input", { type: "range", min: -12, max: 12, step: 0.25, value: 0 });
    this.stops_slider.oninput = () => this.expose(Number(this.stops_slider.value));
    this.gain_slider = element("input", { type: "range", min: 0, max: 4, step: 0.25, value: Math.log10(this.gain) });
    this.gain_slider.oninput = () => this.amplify(10 ** Number(this.gain_slider.value));
    const button = (label, title, onclick) => element("button", { type: "button", textContent: label, title, onclick });
    this.box_label = element("output", {});
    this.alpha_button = button("", "transparency (a)", () => this.step_alpha());
    const boxes = element(
      "div",
      { classes: "buttons places" },
      button("‹", "previous failing place (p)", () => this.step_box(-1)),
      this.box_label,
      button("›", "next failing place (n)", () => this.step_box(1))
    );
    return element(
      "div",
      { classes: "bar" },
      element("div", { classes: "buttons" }, ...this.mode_buttons),
      ...(this.boxes.length ? [boxes] : []),
      element(
        "div",
        { classes: "buttons" },
        button("−", "smaller (-)", () => this.step_zoom(-1)),
        this.zoom_label,
        button("+", "larger (+)", () => this.step_zoom(1)),
        this.fit_button
      ),
      element("label", {}, "exposure ", this.stops_slider, this.stops_label),
      ...(this.is_comparable ? [element("label", {}, "difference ", this.gain_slider, this.gain_label)] : []),
      ...(this.has_alpha() ? [this.alpha_button] : [])
    );
  }

  step_alpha() {
    if (!this.has_alpha()) return;
    this.alpha_mode = alpha_modes[(alpha_modes.indexOf(this.alpha_mode) + 1) % alpha_modes.length];
    this.draw();
  }

  /** Goes to the next or previous failing place and enlarges it. */
  step_box(by) {
    if (!this.boxes.length) return;
    this.box = this.box < 0 && by < 0 ? this.boxes.length - 1 : (this.box + by + this.boxes.length) % this.boxes.length;
    const box = this.boxes[this.box];
    const stage = this.stages.querySelector(".stage");
    const context = 5; // how many times the box the view is
    const fitting = Math.min(stage.parentElement.clientWidth / (context * box.width), (0.6 * window.innerHeight) / (context * box.height));
    this.zoom = Math.max(this.fitting_zoom(), Math.min(32, fitting));
    this.look_at(box.worst.x, box.worst.y);
    this.draw();
    this.center(box.x + box.width / 2, box.y + box.height / 2);
  }

  /** Scrolls so that a place of the picture is in the middle. */
  center(x, y) {
    for (const stage of this.stages.querySelectorAll(".stage")) {
      stage.scrollLeft = x * this.scale - stage.clientWidth / 2;
      stage.scrollTop = y * this.scale - stage.clientHeight / 2;
    }
  }

  choose(mode) {
    if (!this.modes().includes(mode)) return;
    this.mode = mode;
    this.draw();
  }

  expose(stops) {
    this.stops = Math.max(-12, Math.min(12, stops));
    this.stops_slider.value = this.stops;
    this.draw();
  }

  amplify(gain) {
    this.gain = gain;
    this.draw();
  }

  /** The largest zoom at which the picture is as wide as its pane. */
  fitting_zoom() {
    const pane_count = window.innerWidth > 720 ? this.panes(this.mode).length : 1;
    const room = (this.stages.clientWidth || 320) / pane_count - 14;
    const { test, golden } = this.images;
    const fit = room / Math.max(test.width, golden ? golden.width : 0);
    const tall = Math.max(240, 0.62 * window.innerHeight) / Math.max(test.height, golden ? golden.height : 0);
    return Math.max(0.05, Math.min(fit, tall, 64));
  }

  step_zoom(by) {
    const now = this.zoom || this.fitting_zoom();
    const larger = zooms.filter((z) => z > now * 1.01);
    const smaller = zooms.filter((z) => z < now * 0.99);
    if (by > 0) this.zoom = larger.length ? larger[0] : 64;
    else this.zoom = smaller.length ? smaller[smaller.length - 1] : null;
    this.draw();
  }

  fit() {
    this.zoom = null;
    this.draw();
  }

  canvas(what) {
    const canvas = element("canvas", {});
    const { test, golden } = this.images;
    if (what === "difference") paint_difference(canvas, test, golden, this.gain);
    else if (what === "limits") paint_limits(canvas, this.images.errors);
    else paint_picture(canvas, this.images[what], this.base * 2 ** this.stops, this.images.is_display_referred, this.alpha_mode);
    return canvas;
  }

  draw() {
    clearInterval(this.flicker);
    this.scale = this.zoom || this.fitting_zoom();
    const scroll = this.stages.querySelector(".stage");
    const at = scroll ? [scroll.scrollLeft, scroll.scrollTop] : [0, 0];
    const panes = this.panes(this.mode);
    this.stages.replaceChildren(...panes.map((pane) => this.pane(pane)));
    this.stages.dataset.panes = panes.length;
    this.place_all();
    for (const stage of this.stages.querySelectorAll(".stage")) [stage.scrollLeft, stage.scrollTop] = at;
    this.mode_buttons.forEach((button, i) => button.setAttribute("aria-pressed", this.modes()[i] === this.mode));
    this.box_label.textContent = this.box_text();
    this.alpha_button.replaceChildren(...key_and_text("a", `alpha ${alpha_words[this.alpha_mode]}`));
    this.stops_label.textContent = `${this.stops >= 0 ? "+" : ""}${this.stops} stops`;
    this.gain_label.textContent = `×${this.gain < 100 ? this.gain.toPrecision(2) : Math.round(this.gain)}`;
    this.mark();
  }

  box_text() {
    const places = `${this.boxes.length} failing place${this.boxes.length === 1 ? "" : "s"}`;
    if (this.box < 0) return places;
    const box = this.boxes[this.box];
    const worst = box.nonfinite ? `${box.nonfinite} not finite` : `up to ${box.worst.error >= 1000 ? "1000 and more" : Number(box.worst.error.toPrecision(3))} times the limit`;
    return `${this.box + 1} of ${places}: ${box.count} pixel${box.count === 1 ? "" : "s"} at (${box.x}, ${box.y}), ${worst}`;
  }

  /** Gives canvases and boxes their sizes at this scale. */
  place_all() {
    const place = (node, box) => {
      if (box.x !== undefined) [node.style.left, node.style.top] = [`${box.x * this.scale}px`, `${box.y * this.scale}px`];
      [node.style.width, node.style.height] = [`${box.width * this.scale}px`, `${box.height * this.scale}px`];
    };
    for (const canvas of this.stages.querySelectorAll("canvas")) place(canvas, { width: canvas.width, height: canvas.height });
    for (const node of this.stages.querySelectorAll(".box")) place(node, this.boxes[Number(node.dataset.box)]);
    this.zoom_label.textContent = `×${Number((this.zoom || this.fitting_zoom()).toPrecision(2))}`;
    this.fit_button.setAttribute("aria-pressed", !this.zoom);
    this.mark();
  }

  /** Zooms by a factor so that the place under (x, y) of the window stays there. */
  zoom_at(factor, x, y, stage) {
    const box = stage.firstChild.getBoundingClientRect();
    const [px, py] = [(x - box.left) / this.scale, (y - box.top) / this.scale];
    const smallest = Math.min(this.fitting_zoom(), 1);
    this.zoom = Math.max(smallest, Math.min(64, this.scale * factor));
    this.scale = this.zoom;
    this.place_all();
    const frame = stage.getBoundingClientRect();
    stage.scrollLeft = px * this.scale - (x - frame.left);
    stage.scrollTop = py * this.scale - (y - frame.top);
    this.scroll_together(stage);
  }

  on_wheel(event, stage) {
    if (event.shiftKey) return; // scrolls aside
    event.preventDefault();
    this.zoom_at(2 ** (-event.deltaY / (event.deltaMode === 0 ? 300 : 10)), event.clientX, event.clientY, stage);
  }

  /** A mouse drags the picture; two fingers zoom it. One finger scrolls, as everywhere. */
  listen(stage, can_drag) {
    const spread = () => {
      const [a, b] = [...this.touches.values()];
      return { x: (a.x + b.x) / 2, y: (a.y + b.y) / 2, distance: Math.hypot(a.x - b.x, a.y - b.y) };
    };
    stage.addEventListener("wheel", (event) => this.on_wheel(event, stage), { passive: false });
    stage.addEventListener("pointerdown", (event) => {
      if (event.pointerType === "touch") this.touches.set(event.pointerId, { x: event.clientX, y: event.clientY });
    });
    for (const end of ["pointerup", "pointercancel", "pointerleave"])
      stage.addEventListener(end, (event) => this.touches.delete(event.pointerId));
    stage.addEventListener("pointermove", (event) => {
      if (event.pointerType !== "touch") {
        if (event.buttons !== 1 || !can_drag) return;
        stage.scrollLeft -= event.movementX;
        stage.scrollTop -= event.movementY;
      } else if (this.touches.has(event.pointerId)) {
        const before = this.touches.size === 2 ? spread() : null;
        this.touches.set(event.pointerId, { x: event.clientX, y: event.clientY });
        if (!before) return;
        const after = spread();
        if (before.distance > 0) this.zoom_at(after.distance / before.distance, after.x, after.y, stage);
      }
    });
  }

  pane(what) {
    const frame = element("div", { classes: "frame" });
    const stage = element("div", { classes: "stage" }, frame);
    let caption = this.name(what);
    if (what === "swipe") caption = this.fill_swipe(frame);
    else if (what === "flicker") caption = this.fill_flicker(frame);
    else frame.append(this.canvas(what));
    const shown_boxes = this.boxes.slice(0, 200);
    for (const [i] of shown_boxes.entries()) {
      const box = element("div", { classes: i === this.box ? "box chosen" : "box" });
      box.dataset.box = i;
      frame.append(box);
    }
    frame.append(element("div", { classes: "marker", hidden: true }));
    frame.onpointermove = (event) => this.point(event, frame);
    this.listen(stage, what !== "swipe");
    stage.onscroll = () => this.scroll_together(stage);
    return element("figure", {}, element("figcaption", {}, caption), stage);
  }

  fill_swipe(frame) {
    const above = this.canvas("test");
    above.classList.add("above");
    const handle = element("div", { classes: "handle" });
    const place = () => {
      above.style.clipPath = `inset(0 ${100 * (1 - this.split)}% 0 0)`;
      handle.style.left = `${100 * this.split}%`;
    };
    frame.addEventListener("pointermove", (event) => {
      if (event.buttons !== 1 && event.pointerType !== "touch") return;
      const box = frame.getBoundingClientRect();
      this.split = Math.max(0, Math.min(1, (event.clientX - box.left) / box.width));
      place();
    });
    place();
    frame.classList.add("swipe");
    frame.append(this.canvas("golden"), above, handle);
    return `left ${this.name("test")} | right ${this.name("golden")}: drag`;
  }

  fill_flicker(frame) {
    const above = this.canvas("test");
    above.classList.add("above");
    frame.append(this.canvas("golden"), above);
    const caption = element("span", { textContent: this.name("test") });
    this.blink = () => {
      above.hidden = !above.hidden;
      caption.textContent = this.name(above.hidden ? "golden" : "test");
    };
    const still = window.matchMedia("(prefers-reduced-motion: reduce)").matches;
    if (!still) this.flicker = setInterval(this.blink, 500);
    return element("span", {}, caption, still ? " (space changes)" : " (space stops and changes)");
  }

  /** Space in flicker mode: by hand from now on. */
  blink_once() {
    clearInterval(this.flicker);
    if (this.mode.name === "flicker") this.blink();
  }

  scroll_together(from) {
    for (const stage of this.stages.querySelectorAll(".stage"))
      if (stage !== from) [stage.scrollLeft, stage.scrollTop] = [from.scrollLeft, from.scrollTop];
  }

  point(event, frame) {
    const box = frame.getBoundingClientRect();
    const x = Math.floor((event.clientX - box.left) / this.scale);
    const y = Math.floor((event.clientY - box.top) / this.scale);
    this.look_at(x, y);
  }

  look_at(x, y) {
    const { width, height } = this.images.test;
    this.cursor = { x: Math.max(0, Math.min(width - 1, x)), y: Math.max(0, Math.min(height - 1, y)) };
    this.mark();
    this.show_readout();
  }

  step_cursor(dx, dy) {
    const { width, height } = this.images.test;
    const from = this.cursor || { x: width >> 1, y: height >> 1 };
    this.look_at(from.x + dx, from.y + dy);
  }

  mark() {
    if (!this.cursor) return;
    for (const marker of this.stages.querySelectorAll(".marker")) {
      marker.hidden = false;
      marker.style.left = `${this.cursor.x * this.scale}px`;
      marker.style.top = `${this.cursor.y * this.scale}px`;
      marker.style.width = marker.style.height = `${this.scale}px`;
    }
  }

  show_readout() {
    if (!this.cursor) {
      this.readout.replaceChildren("Point at a pixel, or move with the arrow keys, for its linear values.");
      return;
    }
    const { test, golden } = this.images;
    const { x, y } = this.cursor;
    const values = (image) => {
      if (x >= image.width || y >= image.height) return [NaN, NaN, NaN];
      const at = y * image.width + x;
      const colour = [0, 1, 2].map((c) => image.rgb[3 * at + c]);
      return this.has_alpha() ? [...colour, image.alpha ? image.alpha[at] : 1] : colour;
    };
    const row = (name, numbers, text) =>
      element("tr", {}, element("th", { textContent: name }), ...numbers.map((v) => element("td", { textContent: text(v) })));
    const linear = (v) => (Number.isFinite(v) ? Number(v.toPrecision(4)).toString() : String(v));
    const [ours, theirs] = [this.name("test"), this.name("golden")];
    const rows = [row(ours, values(test), linear)];
    if (golden) {
      const [t, g] = [values(test), values(golden)];
      rows.push(row(theirs, g, linear));
      rows.push(row(`${ours} − ${theirs}`, t.map((v, c) => v - g[c]), linear));
      rows.push(row(`${ours} / ${theirs}`, t.map((v, c) => v / g[c]), linear));
    }
    const channels = this.has_alpha() ? ["R", "G", "B", "A"] : ["R", "G", "B"];
    const head = element("tr", {}, ...[`(${x}, ${y})`, ...channels].map((text) => element("th", { textContent: text })));
    const { errors } = this.images;
    const error = errors && errors.values[y * errors.width + x];
    const are_finite = [test, golden].filter((image) => image && values(image).every(Number.isFinite)).length;
    const nonfinite = are_finite ? "Not finite in one of them." : "Not finite in both.";
    const verdict = !errors || error < 0 ? "" : Number.isNaN(error) ? nonfinite : `${Number(error.toPrecision(3))} times the limit.`;
    this.readout.replaceChildren(element("table", {}, head, ...rows), element("p", { classes: "quiet", textContent: verdict }));
  }

  end() {
    clearInterval(this.flicker);
  }
}

/** What a key does in a viewer; undefined: nothing. */
function viewer_key(viewer, event) {
  const step = event.shiftKey ? 10 : 1;
  const actions = {
    "+": () => viewer.step_zoom(1),
    "=": () => viewer.step_zoom(1),
    "-": () => viewer.step_zoom(-1),
    0: () => viewer.fit(),
    "[": () => viewer.expose(viewer.stops - 1),
    "]": () => viewer.expose(viewer.stops + 1),
    n: () => viewer.step_box(1),
    p: () => viewer.step_box(-1),
    a: () => viewer.step_alpha(),
    " ": () => viewer.blink_once(),
    ArrowLeft: () => viewer.step_cursor(-step, 0),
    ArrowRight: () => viewer.step_cursor(step, 0),
    ArrowUp: () => viewer.step_cursor(0, -step),
    ArrowDown: () => viewer.step_cursor(0, step),
  };
  const mode = modes.find((m) => m.key === event.key);
  return mode ? () => viewer.choose(mode) : actions[event.key];
}

/** Whether a key is neither the browser's nor that of the button or slider which has the focus. */
function is_for_page(event) {
  if (event.ctrlKey || event.altKey || event.metaKey) return false;
  const is_slider = event.target instanceof HTMLInputElement && (event.target.type === "search" || event.key.startsWith("Arrow"));
  const is_button = event.target instanceof HTMLButtonElement && event.key === " ";
  return !is_slider && !is_button;
}

/** A button that the mouse pressed lets go of the keyboard, so that space is the page's again. */
function free_keyboard_after_clicks() {
  document.addEventListener("click", (event) => {
    const button = event.target.closest("button");
    if (button && event.detail > 0) button.blur();
  });
}
