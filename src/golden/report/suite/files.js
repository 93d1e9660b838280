// The files that the page saves: what a person decided, and the table of the tests.

/** Saves a text as a file of the browser's downloads. */
function save_file(name, type, text) {
  const link = element("a", { href: URL.createObjectURL(new Blob([text], { type })), download: name });
  link.click();
  setTimeout(() => URL.revokeObjectURL(link.href), 60000);
}

/** The decisions as `golden approve --failed-as-reviewed` reads them. */
function review_text(suite, approved, rejected) {
  const entry = ({ name, candidate_sha256 }) => ({ name, candidate_sha256 });
  return JSON.stringify({ steradian_golden_review: 1, suite, approved: approved.map(entry), rejected: rejected.map(entry) }, null, 1);
}

/** A cell of a CSV file (RFC 4180). A spreadsheet would compute a text that begins with one of = + - @. */
function csv_cell(value) {
  if (typeof value === "number") return String(value);
  const text = /^[=+\-@\t\r]/.test(value) ? `'${value}` : value;
  return /[",\r\n]/.test(text) ? `"${text.replaceAll('"', '""')}"` : text;
}

/** The tests with their outcomes and decisions, one a row. */
function tests_csv(tests, decisions) {
  const rows = tests.map((test) => [
    test.name,
    test.outcome,
    decisions.get(test) || "",
    test.message,
    test.largest_error_over_limit,
    test.seconds === undefined ? "" : test.seconds,
    test.comparison && test.comparison.diagnosis ? test.comparison.diagnosis.name : "",
    test.tags.join(" "),
    test.renderer.test,
    test.is_earlier ? "yes" : "no",
  ]);
  const head = ["test", "outcome", "decision", "message", "largest_error_over_limit", "seconds", "diagnosis", "tags", "renderer", "of_an_earlier_run"];
  return [head, ...rows].map((row) => `${row.map(csv_cell).join(",")}\r\n`).join("");
}
