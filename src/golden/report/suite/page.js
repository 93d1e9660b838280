// The page: the list of tests, the chosen one, the keyboard.
const data = JSON.parse(document.getElementById("data").textContent);

const outcome_words = { passed: "passed", differs: "differs", missing: "no golden", broken: "broken", flaky: "flaky" };

const page = {
  chosen: -1,
  only_failures: false,
  viewer: null,
  list: element("nav", { ariaLabel: "tests" }),
  article: element("article", { tabIndex: -1 }),
};

function badge(outcome) {
  return element("span", { classes: `badge ${outcome}`, textContent: outcome_words[outcome] });
}

function header() {
  const counts = Object.keys(outcome_words)
    .map((outcome) => [outcome, data.tests.filter((test) => test.outcome === outcome).length])
    .filter(([, count]) => count > 0)
    .map(([outcome, count]) => element("span", { classes: `badge ${outcome}`, textContent: `${count} ${outcome_words[outcome]}` }));
  const failures = element("button", { type: "button", textContent: "f failures only" });
  failures.onclick = () => toggle_failures();
  page.failures_button = failures;
  return element(
    "header",
    {},
    element("h1", { textContent: data.suite }),
    element("div", { classes: "counts" }, ...counts),
    failures,
    element("details", { classes: "help" }, element("summary", { textContent: "? keys" }), help_table())
  );
}

function help_table() {
  const keys = [
    ["j k", "next, previous test"],
    ["1 … 6", "side by side, test, golden, difference, swipe, flicker"],
    ["+ − 0", "larger, smaller, fit"],
    ["[ ]", "darker, brighter"],
    ["← ↑ → ↓", "the pixel beside (with Shift: ten further)"],
    ["space", "in flicker: change by hand"],
    ["f", "failures only"],
  ];
  const row = ([key, what]) => element("tr", {}, element("th", { textContent: key }), element("td", { textContent: what }));
  return element("table", {}, ...keys.map(row));
}

function toggle_failures() {
  page.only_failures = !page.only_failures;
  page.failures_button.setAttribute("aria-pressed", page.only_failures);
  fill_list();
}

function fill_list() {
  const entries = data.tests.map((test, index) => {
    const button = element(
      "button",
      { type: "button", onclick: () => choose(index) },
      badge(test.outcome),
      element("span", { classes: "name", textContent: test.name })
    );
    button.dataset.index = index;
    button.hidden = page.only_failures && test.outcome === "passed";
    if (index === page.chosen) button.setAttribute("aria-current", "true");
    return button;
  });
  page.list.replaceChildren(...entries);
}

function metric_text(value) {
  if (typeof value === "number") return Number(value.toPrecision(5)).toString();
  if (Array.isArray(value)) return value.map(metric_text).join("  ");
  return String(value);
}

function metrics_table(metrics) {
  const row = ([name, value]) =>
    element("tr", {}, element("th", { textContent: name.replaceAll("_", " ") }), element("td", { textContent: metric_text(value) }));
  return element("table", { classes: "metrics" }, ...Object.entries(metrics).map(row));
}

function comparison_nodes(comparison) {
  if (!comparison) return [];
  const nodes = [];
  if (comparison.diagnosis)
    nodes.push(
      element(
        "p",
        { classes: "diagnosis" },
        element("strong", { textContent: `${comparison.diagnosis.name}: ` }),
        `${comparison.diagnosis.statement} (${metric_text(100 * comparison.diagnosis.residual)} % of the difference is left)`
      )
    );
  const verdict = (v) => element("li", { classes: v.passed ? "ok" : "failed", textContent: v.line });
  nodes.push(element("ul", { classes: "verdicts" }, ...(comparison.verdicts || []).map(verdict)));
  nodes.push(element("details", {}, element("summary", { textContent: "all metrics" }), metrics_table(comparison.metrics || {})));
  return nodes;
}

function command_nodes(test) {
  return Object.entries(test.commands).map(([name, command]) => {
    const copy = element("button", { type: "button", textContent: "copy" });
    copy.onclick = async () => {
      try {
        await navigator.clipboard.writeText(command);
        copy.textContent = "copied";
      } catch {
        getSelection().selectAllChildren(copy.previousSibling); // a page from a file may not write the clipboard
        copy.textContent = "selected";
      }
    };
    return element("div", { classes: "command" }, element("span", { textContent: name }), element("code", { textContent: command }), copy);
  });
}

function renderer_node(renderer) {
  if (!renderer.test && !renderer.golden) return "";
  const same = renderer.test === renderer.golden || !renderer.golden;
  const text = same ? `rendered by ${renderer.test}` : `test by ${renderer.test || "unknown"}; golden by ${renderer.golden}`;
  return element("p", { classes: same ? "quiet" : "quiet other", textContent: text });
}

async function pictures(test) {
  if (!test.test) {
    const why = test.images_left_out ? "The report is full: look at the files in candidates/." : "There is no image to show.";
    return element("p", { classes: "quiet", textContent: why });
  }
  try {
    const images = { test: await unpacked(test.test), is_display_referred: test.is_display_referred };
    if (test.golden === "equal") images.golden = images.test;
    else if (test.golden) images.golden = await unpacked(test.golden);
    const is_comparable = images.golden && images.golden.width === images.test.width && images.golden.height === images.test.height;
    if (images.golden && !is_comparable) delete images.golden;
    page.viewer = new Viewer(images);
    return page.viewer.node;
  } catch (error) {
    return element("p", { classes: "failed", textContent: `This browser cannot unpack the pixels: ${error.message}` });
  }
}

async function choose(index) {
  if (index < 0 || index >= data.tests.length || index === page.chosen) return;
  page.chosen = index;
  if (page.viewer) page.viewer.end();
  page.viewer = null;
  for (const button of page.list.children) {
    if (Number(button.dataset.index) === index) button.setAttribute("aria-current", "true");
    else button.removeAttribute("aria-current");
  }
  const test = data.tests[index];
  history.replaceState(null, "", `#${encodeURIComponent(test.name)}`);
  const view = await pictures(test);
  if (page.chosen !== index) return; // another was chosen meanwhile
  page.article.replaceChildren(
    element("h2", {}, badge(test.outcome), test.name),
    ...(test.description ? [element("p", { textContent: test.description })] : []),
    ...(test.message ? [element("p", { classes: "message", textContent: test.message })] : []),
    view,
    ...comparison_nodes(test.comparison),
    ...command_nodes(test),
    renderer_node(test.renderer),
    ...(test.log ? [element("details", {}, element("summary", { textContent: "log" }), element("pre", { textContent: test.log }))] : [])
  );
  if (page.viewer) page.viewer.draw();
  const current = page.list.querySelector("[aria-current]");
  if (current) page.list.scrollTop += current.getBoundingClientRect().top - page.list.getBoundingClientRect().top - page.list.clientHeight / 2;
}

function step_test(by) {
  let index = page.chosen + by;
  while (data.tests[index] && page.only_failures && data.tests[index].outcome === "passed") index += by;
  choose(index);
}

function on_key(event) {
  if (!is_for_page(event)) return;
  const page_actions = { j: () => step_test(1), k: () => step_test(-1), f: toggle_failures };
  const action = page_actions[event.key] || (page.viewer && viewer_key(page.viewer, event));
  if (!action) return;
  event.preventDefault();
  action();
}

function start() {
  const main = document.getElementById("page");
  main.replaceChildren(header(), element("div", { classes: "columns" }, page.list, page.article));
  fill_list();
  document.addEventListener("keydown", on_key);
  free_keyboard_after_clicks();
  window.addEventListener("resize", () => page.viewer && page.viewer.draw());
  const wanted = decodeURIComponent(location.hash.slice(1));
  choose(Math.max(0, data.tests.findIndex((test) => test.name === wanted)));
}

start();
