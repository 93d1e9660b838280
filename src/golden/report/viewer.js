// Two pictures: modes, zoom, exposure, the values under the cursor.

/** An element with properties, classes and children; texts are always text, never markup. */
function element(tag, properties, ...children) {
  const { classes, ...rest } = properties || {};
  const node = Object.assign(document.createElement(tag), rest);
  if (classes) node.className = classes;
  node.append(...children);
  return node;
}

const zooms = [1, 2, 4, 8, 16, 32, 64];

const modes = [
  { key: "1", name: "side by side", panes: ["test", "golden", "difference"] },
  { key: "2", name: "test", panes: ["test"] },
  { key: "3", name: "golden", panes: ["golden"] },
  { key: "4", name: "difference", panes: ["difference"] },
  { key: "5", name: "swipe", panes: ["swipe"] },
  { key: "6", name: "flicker", panes: ["flicker"] },
];

/**
 * Shows `images` {test, golden, is_display_referred}; golden may be absent. `names` are what people read for "test" and
 * "golden".
 */
class Viewer {
  constructor(images, names) {
    this.images = images;
    this.names = names || {};
    this.base = images.is_display_referred ? 1 : automatic_exposure(images.golden || images.test);
    this.stops = 0;
    this.gain = images.golden ? automatic_gain(images.test, images.golden) : 1;
    this.zoom = null; // fits the pane
    this.split = 0.5;
    this.mode = images.golden ? modes[0] : modes[1];
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
    return this.images.golden ? modes : [modes[1]];
  }

  bar() {
    this.mode_buttons = this.modes().map((mode) =>
      element("button", { type: "button", textContent: `${mode.key} ${this.name(mode.name)}`, onclick: () => this.choose(mode) })
    );
    this.zoom_label = element("output", {});
    this.stops_label = element("output", {});
    this.gain_label = element("output", {});
    this.stops_slider = element("input", { type: "range", min: -12, max: 12, step: 0.25, value: 0 });
    this.stops_slider.oninput = () => this.expose(Number(this.stops_slider.value));
    this.gain_slider = element("input", { type: "range", min: 0, max: 4, step: 0.25, value: Math.log10(this.gain) });
    this.gain_slider.oninput = () => this.amplify(10 ** Number(this.gain_slider.value));
    const step = (label, title, by) =>
      element("button", { type: "button", textContent: label, title, onclick: () => this.step_zoom(by) });
    return element(
      "div",
      { classes: "bar" },
      element("div", { classes: "buttons" }, ...this.mode_buttons),
      element("div", { classes: "buttons" }, step("−", "smaller (-)", -1), this.zoom_label, step("+", "larger (+)", 1)),
      element("label", {}, "exposure ", this.stops_slider, this.stops_label),
      ...(this.images.golden ? [element("label", {}, "difference ", this.gain_slider, this.gain_label)] : [])
    );
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
    const pane_count = this.mode.panes.length > 1 && window.innerWidth > 720 ? this.mode.panes.length : 1;
    const room = (this.stages.clientWidth || 320) / pane_count - 14;
    const fit = room / this.images.test.width;
    const tall = Math.max(240, 0.62 * window.innerHeight) / this.images.test.height;
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
    else paint_picture(canvas, this.images[what], this.base * 2 ** this.stops, this.images.is_display_referred);
    canvas.style.width = `${canvas.width * this.scale}px`;
    canvas.style.height = `${canvas.height * this.scale}px`;
    return canvas;
  }

  draw() {
    clearInterval(this.flicker);
    this.scale = this.zoom || this.fitting_zoom();
    const scroll = this.stages.querySelector(".stage");
    const at = scroll ? [scroll.scrollLeft, scroll.scrollTop] : [0, 0];
    this.stages.replaceChildren(...this.mode.panes.map((pane) => this.pane(pane)));
    this.stages.dataset.panes = this.mode.panes.length;
    for (const stage of this.stages.querySelectorAll(".stage")) [stage.scrollLeft, stage.scrollTop] = at;
    this.mode_buttons.forEach((button, i) => button.setAttribute("aria-pressed", this.modes()[i] === this.mode));
    this.zoom_label.textContent = this.zoom ? `×${this.zoom}` : "fit";
    this.stops_label.textContent = `${this.stops >= 0 ? "+" : ""}${this.stops} stops`;
    this.gain_label.textContent = `×${this.gain < 100 ? this.gain.toPrecision(2) : Math.round(this.gain)}`;
    this.mark();
  }

  pane(what) {
    const frame = element("div", { classes: "frame" });
    const stage = element("div", { classes: "stage" }, frame);
    let caption = this.name(what);
    if (what === "swipe") caption = this.fill_swipe(frame);
    else if (what === "flicker") caption = this.fill_flicker(frame);
    else frame.append(this.canvas(what));
    frame.append(element("div", { classes: "marker", hidden: true }));
    frame.onpointermove = (event) => this.point(event, frame);
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
    const values = (image) => [0, 1, 2].map((c) => image.rgb[3 * (y * image.width + x) + c]);
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
    const head = element("tr", {}, ...[`(${x}, ${y})`, "R", "G", "B"].map((text) => element("th", { textContent: text })));
    this.readout.replaceChildren(element("table", {}, head, ...rows));
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
  const is_slider = event.target instanceof HTMLInputElement && event.key.startsWith("Arrow");
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
