// The page of a check: tasks with their marks, and for each its checks, what is wrong, and its pictures.
const data = JSON.parse(document.getElementById("data").textContent);

const names = { test: "yours", golden: "reference" };
const page = { viewers: [], active: null };

const points_text = (part) => `${part.points} / ${part.of}`;

function badge(status) {
  const kind = { "not implemented": "missing" }[status] || status;
  return element("span", { classes: `badge ${kind}`, textContent: status });
}

function header() {
  const share = element("span", {
    classes: `badge ${data.points >= data.of ? "passed" : "failed"}`,
    textContent: `${data.points} of ${data.of} points, ${Math.round(data.percent)} %`,
  });
  return element(
    "header",
    {},
    element("h1", { textContent: `${data.assignment}: ${data.title}` }),
    ...(data.student ? [element("span", { textContent: `student ${data.student}` })] : []),
    share,
    element("details", { classes: "help" }, element("summary", { textContent: "? keys" }), help_table())
  );
}

function help_table() {
  const keys = [
    ["j k", "next, previous task"],
    ["1 … 6", "a picture: side by side, yours, reference, difference, swipe, flicker"],
    ["+ − 0", "larger, smaller, fit"],
    ["[ ]", "darker, brighter"],
    ["← ↑ → ↓", "the pixel beside (with Shift: ten further)"],
    ["space", "in flicker: change by hand"],
  ];
  const row = ([key, what]) => element("tr", {}, element("th", { textContent: key }), element("td", { textContent: what }));
  return element("table", {}, ...keys.map(row));
}

function task_list() {
  const link = (task) =>
    element(
      "a",
      { href: `#${task.id}` },
      badge(task.status),
      element("span", { classes: "name", textContent: `${task.id} ${task.title}${task.extra ? " (extra)" : ""}` }),
      element("span", { classes: "points", textContent: points_text(task) })
    );
  return element("nav", { ariaLabel: "tasks" }, ...data.tasks.map(link));
}

function hint_node(text) {
  return text ? [element("p", { classes: "hint", textContent: text })] : [];
}

function problem_node(problem) {
  const place = problem.line > 0 ? `${problem.file}:${problem.line}:${problem.column > 0 ? `${problem.column}:` : ""} ` : "";
  return element(
    "div",
    { classes: "problem" },
    element("p", { classes: "message", textContent: place + problem.text }),
    ...(problem.source ? [element("pre", { textContent: problem.source })] : []),
    ...hint_node(problem.hint)
  );
}

/** A row of its own for what is wrong and what helps; none if all is right. */
function what_row(check) {
  if (check.passed) return [];
  const cell = element("td", { classes: "what", colSpan: 6 });
  cell.append(element("p", { textContent: check.message + (check.at ? `; worst at ${check.at}` : "") }));
  if (check.diagnosis)
    cell.append(element("p", {}, element("span", { classes: "diagnosis-name", textContent: `${check.diagnosis.name}: ` }), check.diagnosis.text));
  if (!check.diagnosis || check.diagnosis.text !== check.hint) cell.append(...hint_node(check.hint));
  return [element("tr", {}, cell)];
}

function checks_table(task) {
  const head = ["check", "verdict", "points", "got", "expected", "unit"];
  const rows = (check) => [
    element(
      "tr",
      {},
      element("th", { textContent: check.name }),
      element("td", {}, badge(check.passed ? "passed" : "failed")),
      element("td", { classes: "value", textContent: points_text(check) }),
      element("td", { classes: "value", textContent: check.got }),
      element("td", { classes: "value", textContent: check.expected }),
      element("td", { classes: "value", textContent: check.unit })
    ),
    ...what_row(check),
  ];
  const head_row = element("tr", {}, ...head.map((text) => element("th", { textContent: text })));
  return element("div", { classes: "scroll" }, element("table", { classes: "checks" }, head_row, ...task.checks.flatMap(rows)));
}

/** The viewer of a check's pictures, or why there is none. */
async function pictures_node(check) {
  try {
    const images = { test: await unpacked(check.pictures.yours), is_display_referred: false };
    images.golden = check.pictures.reference === "equal" ? images.test : await unpacked(check.pictures.reference);
    const viewer = new Viewer(images, names);
    const activate = () => (page.active = viewer);
    viewer.node.addEventListener("pointerenter", activate);
    viewer.node.addEventListener("pointerdown", activate);
    page.viewers.push(viewer);
    page.active = page.active || viewer;
    return viewer.node;
  } catch (error) {
    return element("p", { classes: "failed", textContent: `This browser cannot unpack the pixels: ${error.message}` });
  }
}

async function task_section(task) {
  const section = element(
    "section",
    { classes: "task", id: task.id },
    element("h2", {}, badge(task.status), `${task.id} ${task.title}`, element("span", { classes: "quiet points", textContent: `${points_text(task)}${task.extra ? " extra" : ""} points` })),
    ...task.problems.map(problem_node)
  );
  if (task.checks.length) section.append(checks_table(task));
  for (const check of task.checks)
    if (check.pictures) section.append(element("p", { classes: "quiet", textContent: `${check.name} [${check.unit || "cd/m²"}]` }), await pictures_node(check));
  return section;
}

/** The next task below the top of the window, or the one above. */
function step_task(by) {
  const sections = [...document.querySelectorAll("section.task")];
  const tops = sections.map((section) => section.getBoundingClientRect().top);
  const wanted = by > 0 ? tops.findIndex((top) => top > 2) : tops.findLastIndex((top) => top < -2);
  if (sections[wanted]) sections[wanted].scrollIntoView();
}

function on_key(event) {
  if (!is_for_page(event)) return;
  const page_actions = { j: () => step_task(1), k: () => step_task(-1) };
  const action = page_actions[event.key] || (page.active && viewer_key(page.active, event));
  if (!action) return;
  event.preventDefault();
  action();
}

function draw_all() {
  for (const viewer of page.viewers) viewer.draw();
}

async function start() {
  const article = element("article", { tabIndex: -1 });
  for (const task of data.tasks) article.append(await task_section(task));
  document.getElementById("page").replaceChildren(header(), element("div", { classes: "columns" }, task_list(), article));
  draw_all();
  document.addEventListener("keydown", on_key);
  free_keyboard_after_clicks();
  window.addEventListener("resize", draw_all);
  const wanted = document.getElementById(decodeURIComponent(location.hash.slice(1)));
  if (wanted) wanted.scrollIntoView();
}

start();
