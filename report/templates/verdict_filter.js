// Shows the verdicts of one kind, or of one status, alone.
(() => {
  "use strict";
  const { make } = plumb;
  const groups = [...document.querySelectorAll(".verdict-group")];
  const rows = groups.flatMap((group) => [...group.querySelectorAll("tr[data-status]")].map((row) => ({ row, kind: group.dataset.kind, status: row.dataset.status })));
  if (rows.length < 2) return;

  const choice = (label, key) => {
    const select = make("select", { id: `filter-${key}` });
    select.append(make("option", { value: "", textContent: `all (${rows.length})` }));
    for (const value of new Set(rows.map((entry) => entry[key])))
      select.append(make("option", { value, textContent: `${value} (${rows.filter((entry) => entry[key] === value).length})` }));
    select.addEventListener("change", show);
    return { node: make("label", {}, `${label} `, select), select };
  };
  const said = make("output");
  const show = () => {
    for (const { row, kind: k, status: s } of rows)
      row.hidden = (kind.select.value !== "" && kind.select.value !== k) || (status.select.value !== "" && status.select.value !== s);
    for (const group of groups) group.hidden = ![...group.querySelectorAll("tr[data-status]")].some((row) => !row.hidden);
    said.textContent = `${rows.filter(({ row }) => !row.hidden).length} of ${rows.length} shown`;
  };
  const kind = choice("Kind", "kind"), status = choice("Status", "status");
  const bar = make("div", { className: "filter screen" }, kind.node, status.node, said);
  bar.setAttribute("role", "group");
  bar.setAttribute("aria-label", "Filter of the verdicts");
  groups[0].before(bar);
  show();
})();
