// Shows the reports, verdicts and marks in which a text stands, of one kind, or of one status.
(() => {
  "use strict";
  const { make } = plumb;
  const all = (selector) => [...document.querySelectorAll(selector)];
  const low = (node) => node.textContent.toLowerCase();
  const tally = (found, shown) => `${found} of ${reports.length} reports, ${shown} of ${rows.length} verdicts`;
  const rows = all(".verdict-group tr[data-status]").map((row) => (
    { row, name: row.dataset.case, kind: row.closest(".verdict-group").dataset.kind, status: row.dataset.status, text: low(row) }));
  const reports = all("#reports tr[data-case]").map((row) => ({ name: row.dataset.case, state: row.dataset.state, text: low(row) }));
  const followers = all(".card, #reports tr[data-case], .unheld [data-case], #history [data-case]");
  const marks = all(".chart circle[data-case]");
  const groups = all(".verdict-group");
  if (reports.length < 2) return;

  const choice = (label, values) => {
    const select = make("select");
    select.append(make("option", { value: "", textContent: "all" }));
    for (const value of [...new Set(values)]) select.append(make("option", { value, textContent: value }));
    return { select, node: make("label", {}, `${label} `, select) };
  };
  const input = make("input", { type: "search", placeholder: "report, reference, column …" });
  input.setAttribute("aria-label", "Text to find");
  const kind = choice("Kind", rows.map((entry) => entry.kind));
  const status = choice("Status", [...reports.map((entry) => entry.state), ...rows.map((entry) => entry.status)]);
  const said = make("output");

  const show = () => {
    const words = input.value.toLowerCase().split(/\s+/).filter(Boolean);
    const has = (text) => words.every((word) => text.includes(word));
    const fits = (entry) => (kind.select.value === "" || entry.kind === kind.select.value) && (status.select.value === "" || entry.status === status.select.value);
    const found = new Set();
    let shown = 0;
    for (const entry of rows) {
      const visible = fits(entry) && has(entry.text);
      entry.row.hidden = !visible;
      if (visible) {
        found.add(entry.name);
        shown += 1;
      }
    }
    // A report without verdicts is found by what its row says.
    for (const entry of reports)
      if (has(entry.text) && kind.select.value === "" && (status.select.value === "" || status.select.value === entry.state)) found.add(entry.name);
    for (const node of followers) node.hidden = !found.has(node.dataset.case);
    for (const mark of marks) {
      const visible = found.has(mark.dataset.case) && (kind.select.value === "" || mark.dataset.kind === kind.select.value);
      if (visible) mark.removeAttribute("visibility");
      else mark.setAttribute("visibility", "hidden");
    }
    for (const group of groups) group.hidden = ![...group.querySelectorAll("tr[data-status]")].some((row) => !row.hidden);
    for (const group of all(".report-group")) group.hidden = ![...group.querySelectorAll(".card")].some((card) => !card.hidden);
    said.textContent = tally(found.size, shown);
  };
  for (const node of [kind.select, status.select]) node.addEventListener("change", show);
  input.addEventListener("input", show);
  const bar = make("div", { className: "filter-bar screen" }, input, kind.node, status.node, said);
  bar.setAttribute("role", "search");
  document.querySelector("#strip").before(bar);
  said.textContent = tally(reports.length, rows.length);
})();
