// The page: the list of tests, the chosen one, what a person decides about them, the keyboard.
const data = JSON.parse(document.getElementById("data").textContent);

const outcome_words = { passed: "passed", differs: "differs", missing: "no golden", broken: "broken", flaky: "flaky", unreadable: "unreadable" };

const nearly = 0.8; // of the limit: a test that passed, but not by much

const page = {
  chosen: -1,
  only_failures: false,
  kind: "", // an outcome or "nearly"; empty: all
  words: "",
  viewer: null,
  decisions: new Map(), // of tests: "approved" or "rejected"
  list: element("nav", { ariaLabel: "tests" }),
  article: element("article", { tabIndex: -1 }),
};

const is_nearly_failed = (test) => test.outcome === "passed" && test.largest_error_over_limit > nearly;
const is_decidable = (test) => test.candidate_sha256 !== "" && !test.is_earlier && !["passed", "flaky"].includes(test.outcome);

/** An outcome after a number: "1 differs", "21 differ". */
const counted_word = (outcome, count) => (outcome === "differs" && count !== 1 ? "differ" : outcome_words[outcome]);

function badge(outcome) {
  return element("span", { classes: `badge ${outcome}`, textContent: outcome_words[outcome] });
}

/** A count that shows only its tests when it is pressed. */
function count_button(kind, text, count) {
  const button = element("button", { type: "button", classes: `badge ${kind}`, textContent: `${count} ${text}`, title: "show these alone" });
  button.dataset.kind = kind;
  button.onclick = () => {
    page.kind = page.kind === kind ? "" : kind;
    fill_list();
  };
  return button;
}

function header() {
  const counts = Object.keys(outcome_words)
    .map((outcome) => [outcome, data.tests.filter((test) => test.outcome === outcome).length])
    .map(([outcome, count]) => [outcome, counted_word(outcome, count), count])
    .concat([["nearly", "nearly failed", data.tests.filter(is_nearly_failed).length]])
    .filter(([, , count]) => count > 0)
    .map(([kind, text, count]) => count_button(kind, text, count));
  const failures = element("button", { type: "button" }, ...key_and_text("f", "failures only"));
  failures.onclick = () => toggle_failures();
  page.failures_button = failures;
  const save = element("button", { type: "button", textContent: "save tests.csv", title: "all tests with their outcomes, as a table" });
  save.onclick = () => save_file("tests.csv", "text/csv", tests_csv(data.tests, page.decisions));
  page.count_buttons = counts;
  page.search = element("input", { type: "search", placeholder: "/ name or tag", ariaLabel: "search for a name or a tag" });
  page.search.oninput = () => search_for(page.search.value);
  return element(
    "header",
    {},
    element("h1", { textContent: data.suite }),
    element("div", { classes: "counts" }, ...counts),
    page.search,
    failures,
    save,
    element("details", { classes: "help" }, element("summary", {}, ...key_and_text("?", "keys")), help_table()),
    run_node()
  );
}

/** Where and when the run was, and what it leaves over. */
function run_node() {
  const parts = [];
  const add = (text) => text && parts.push(element("span", { textContent: text }));
  if (data.run) {
    add(data.run.commit && `commit ${data.run.commit.slice(0, 12)}${data.run.branch ? ` (${data.run.branch})` : ""}`);
    add(data.run.began.replace("T", " ").replace("Z", " UTC"));
    add(data.run.host);
    add(`${data.run.seconds.toFixed(1)} s`);
    if (data.run.link) parts.push(element("a", { href: data.run.link, rel: "noreferrer", textContent: "CI job" }));
  }
  if (data.orphans.length)
    parts.push(
      element(
        "details",
        {},
        element("summary", { textContent: `${data.orphans.length} golden${data.orphans.length === 1 ? "" : "s"} of no test` }),
        element("pre", { textContent: data.orphans.join("\n") })
      )
    );
  return element("p", { classes: "run quiet" }, ...parts);
}

/** The bar with the decisions: how many, the file, and the command that reads it. */
function review_bar() {
  const of = (decision) => [...page.decisions].filter(([, d]) => d === decision).map(([test]) => test);
  const [approved, rejected] = [of("approved"), of("rejected")];
  page.review.hidden = !approved.length && !rejected.length;
  const save = element("button", { type: "button", textContent: "save review.json" });
  save.onclick = () => save_file("review.json", "application/json", review_text(data.suite, approved, rejected));
  page.review.replaceChildren(
    element("span", { textContent: `${approved.length} approved, ${rejected.length} rejected` }),
    save,
    element("code", { textContent: `${data.approve} review.json` })
  );
}

function decide(test, decision) {
  if (!is_decidable(test)) return;
  if (page.decisions.get(test) === decision) page.decisions.delete(test);
  else page.decisions.set(test, decision);
  show_decisions();
}

/** Approves or rejects all tests that the list shows. */
function decide_all(decision) {
  for (const test of data.tests) if (is_listed(test) && is_decidable(test)) page.decisions.set(test, decision);
  show_decisions();
}

function show_decisions() {
  for (const button of page.list.querySelectorAll("button[data-index]")) button.dataset.decision = page.decisions.get(data.tests[button.dataset.index]) || "";
  for (const button of page.article.querySelectorAll("button[data-decides]"))
    button.setAttribute("aria-pressed", page.decisions.get(data.tests[page.chosen]) === button.dataset.decides);
  review_bar();
}

function decision_buttons(test) {
  if (!is_decidable(test)) return "";
  const button = (decision, key, text) => {
    const node = element("button", { type: "button", onclick: () => decide(test, decision) }, ...key_and_text(key, text));
    node.dataset.decides = decision;
    node.setAttribute("aria-pressed", page.decisions.get(test) === decision);
    return node;
  };
  return element("div", { classes: "buttons decisions" }, button("approved", "y", "approve"), button("rejected", "x", "reject"));
}

function help_table() {
  const keys = [
    ["j k", "next, previous test"],
    ["1 … 7", "side by side, test, golden, difference, swipe, flicker, limits"],
    ["n p", "next, previous failing place"],
    ["+ − 0", "larger, smaller, fit (also: wheel, pinch, drag)"],
    ["a", "alpha: off, over squares, alone"],
    ["[ ]", "darker, brighter"],
    ["← ↑ → ↓", "the pixel beside (with Shift: ten further)"],
    ["space", "in flicker: change by hand"],
    ["f", "failures only"],
    ["/", "search"],
    ["y x", "approve, reject (again: undecided)"],
  ];
  const row = ([key, what]) => element("tr", {}, element("th", { textContent: key }), element("td", { textContent: what }));
  return element("table", {}, ...keys.map(row));
}

function toggle_failures() {
  page.only_failures = !page.only_failures;
  page.failures_button.setAttribute("aria-pressed", page.only_failures);
  fill_list();
}

function search_for(words) {
  page.search.value = words;
  page.words = words.toLowerCase();
  fill_list();
}

/** Whether the list shows a test: by its outcome, and each word in its name, tags or message. */
function is_listed(test) {
  if (page.only_failures && test.outcome === "passed") return false;
  if (page.kind && !(page.kind === "nearly" ? is_nearly_failed(test) : test.outcome === page.kind)) return false;
  const text = [test.name, ...test.tags, test.message].join("\n").toLowerCase();
  return page.words.split(/\s+/).every((word) => text.includes(word));
}

/** Paints a small picture of a test once it is seen. */
const thumbnails = new IntersectionObserver((entries) => {
  for (const entry of entries) {
    if (!entry.isIntersecting) continue;
    thumbnails.unobserve(entry.target);
    paint_thumbnail(entry.target, data.tests[entry.target.dataset.index]).catch(() => (entry.target.hidden = true));
  }
});

async function paint_thumbnail(canvas, test) {
  const image = await unpacked(test.test);
  const whole = element("canvas", {});
  paint_picture(whole, image, test.is_display_referred ? 1 : automatic_exposure(image), test.is_display_referred, "off");
  const factor = Math.min(canvas.width / whole.width, canvas.height / whole.height);
  const [width, height] = [whole.width * factor, whole.height * factor];
  canvas.getContext("2d").drawImage(whole, (canvas.width - width) / 2, (canvas.height - height) / 2, width, height);
}

/** A test of the list. It is made once: thumbnails stay. */
function entry_of(test, index) {
  const thumbnail = element("canvas", { width: 96, height: 72, classes: "thumbnail" });
  thumbnail.dataset.index = index;
  if (test.test) thumbnails.observe(thumbnail);
  const button = element(
    "button",
    { type: "button", onclick: () => choose(index) },
    thumbnail,
    element("span", { classes: "name" }, badge(test.outcome), test.name)
  );
  button.dataset.index = index;
  return button;
}

function fill_list() {
  page.entries = page.entries || data.tests.map(entry_of);
  let count = 0;
  for (const [index, button] of page.entries.entries()) {
    button.hidden = !is_listed(data.tests[index]);
    if (!button.hidden) ++count;
    if (index === page.chosen) button.setAttribute("aria-current", "true");
  }
  for (const button of page.count_buttons) button.setAttribute("aria-pressed", button.dataset.kind === page.kind);
  const decidable = data.tests.filter((test) => is_listed(test) && is_decidable(test)).length;
  const all = (decision, text) => element("button", { type: "button", textContent: `${text} ${decidable}`, onclick: () => decide_all(decision) });
  page.list_head.replaceChildren(
    element("span", { classes: "quiet", textContent: `${count} of ${data.tests.length}` }),
    ...(decidable > 1 ? [all("approved", "approve all"), all("rejected", "reject all")] : [])
  );
  if (!page.list.childElementCount) page.list.append(...page.entries);
  show_decisions();
}

function metric_text(value) {
  if (typeof value === "number") return Number(value.toPrecision(5)).toString();
  if (Array.isArray(value)) return value.map(metric_text).join("  ");
  return String(value);
}

function percent_text(share) {
  if (typeof share === "number" && share < 1e-4) return share > 0 ? "less than 0.01 %" : "nothing";
  return `${typeof share === "number" ? Number((100 * share).toPrecision(3)) : share} %`;
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
        `${comparison.diagnosis.statement} (${percent_text(comparison.diagnosis.residual)} of the difference is left)`
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

/** Tags as buttons that search for them, the duration, and whether the result is an earlier run's. */
function tags_node(test) {
  const tag = (text) => element("button", { type: "button", classes: "tag", textContent: text, onclick: () => search_for(text) });
  const texts = [];
  if (test.seconds !== undefined) texts.push(`${test.seconds.toFixed(2)} s`);
  if (is_nearly_failed(test)) texts.push(`nearly failed: ${metric_text(test.largest_error_over_limit)} of the limit`);
  if (test.is_earlier) texts.push("of an earlier run: this one left it out");
  if (!test.tags.length && !texts.length) return "";
  return element("p", { classes: "tags quiet" }, ...test.tags.map(tag), ...texts.map((textContent) => element("span", { textContent })));
}

/** The viewer of a test's pictures, and what is to be said beside it. */
async function pictures(test) {
  const said = (classes, textContent) => [element("p", { classes, textContent })];
  const problem = test.images_problem ? said("failed", test.images_problem) : [];
  if (test.images_left_out) return { nodes: said("quiet", "The report is full: look at the files in candidates/.") };
  if (!test.test) return { nodes: problem.length ? problem : said("quiet", "There is no image to show.") };
  try {
    const images = { test: await unpacked(test.test), is_display_referred: test.is_display_referred };
    if (test.golden === "equal") images.golden = images.test;
    else if (test.golden) images.golden = await unpacked(test.golden);
    if (test.errors) images.errors = await unpacked_errors(test.errors);
    const viewer = new Viewer(images);
    return { viewer, nodes: [...problem, viewer.node] };
  } catch (error) {
    return { nodes: said("failed", `This browser cannot unpack the pixels: ${error.message}`) };
  }
}

async function choose(index) {
  if (index < 0 || index >= data.tests.length || index === page.chosen) return;
  page.chosen = index;
  if (page.viewer) page.viewer.end();
  page.viewer = null;
  for (const button of page.entries) {
    if (Number(button.dataset.index) === index) button.setAttribute("aria-current", "true");
    else button.removeAttribute("aria-current");
  }
  const test = data.tests[index];
  history.replaceState(null, "", `#${encodeURIComponent(test.name)}`);
  const { viewer, nodes } = await pictures(test);
  if (page.chosen !== index) { // another was chosen meanwhile
    if (viewer) viewer.end();
    return;
  }
  page.viewer = viewer || null;
  page.article.replaceChildren(
    element("h2", {}, badge(test.outcome), test.name),
    tags_node(test),
    ...(test.description ? [element("p", { textContent: test.description })] : []),
    ...(test.message ? [element("p", { classes: "message", textContent: test.message })] : []),
    decision_buttons(test),
    ...nodes,
    ...comparison_nodes(test.comparison),
    ...command_nodes(test),
    renderer_node(test.renderer),
    ...(test.attempts.length ? [element("details", { open: true }, element("summary", { textContent: `${test.attempts.length} attempts failed before` }), element("pre", { textContent: test.attempts.join("\n") }))] : []),
    ...(test.log ? [element("details", {}, element("summary", { textContent: "log" }), element("pre", { textContent: test.log }))] : [])
  );
  if (page.viewer) page.viewer.draw();
  const current = page.list.querySelector("[aria-current]");
  if (!current) return;
  const [at, list] = [current.getBoundingClientRect(), page.list.getBoundingClientRect()];
  page.list.scrollTop += at.top - list.top - page.list.clientHeight / 2;
  page.list.scrollLeft += at.left - list.left - (page.list.clientWidth - at.width) / 2; // on a phone the list is a row
}

function step_test(by) {
  let index = page.chosen + by;
  while (data.tests[index] && !is_listed(data.tests[index])) index += by;
  choose(index);
}

function on_key(event) {
  if (!is_for_page(event)) return;
  const chosen = data.tests[page.chosen];
  const page_actions = {
    j: () => step_test(1),
    k: () => step_test(-1),
    f: toggle_failures,
    "/": () => page.search.focus(),
    y: () => chosen && decide(chosen, "approved"),
    x: () => chosen && decide(chosen, "rejected"),
  };
  const action = page_actions[event.key] || (page.viewer && viewer_key(page.viewer, event));
  if (!action) return;
  event.preventDefault();
  action();
}

function start() {
  const main = document.getElementById("page");
  page.review = element("div", { classes: "review", hidden: true });
  page.list_head = element("div", { classes: "list_head" });
  const aside = element("aside", {}, page.list_head, page.list);
  main.replaceChildren(header(), element("div", { classes: "columns" }, aside, page.article), page.review);
  fill_list();
  document.addEventListener("keydown", on_key);
  free_keyboard_after_clicks();
  page.search.addEventListener("keydown", (event) => {
    if (event.key === "Escape") search_for("");
    if (event.key === "Escape" || event.key === "Enter") page.search.blur();
  });
  window.addEventListener("resize", () => page.viewer && page.viewer.draw());
  const wanted = decodeURIComponent(location.hash.slice(1));
  choose(Math.max(0, data.tests.findIndex((test) => test.name === wanted)));
}

start();
