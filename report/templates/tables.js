// Tables that can be sorted by any column, and copied.
(() => {
  "use strict";
  const { make, button, csv } = plumb;

  // ---- copying

  const toClipboard = async (text) => {
    try {
      await navigator.clipboard.writeText(text);
      return true;
    } catch {
      const area = make("textarea", { value: text, className: "off-screen" });
      document.body.append(area);
      area.select();
      const done = document.execCommand("copy");
      area.remove();
      return done;
    }
  };
  const copier = (label, name, text) => {
    const said = make("span", { className: "said" });
    said.setAttribute("role", "status");
    const copy = button(label, async () => {
      said.textContent = (await toClipboard(text())) ? "Copied" : "The browser does not let pages copy";
      setTimeout(() => { said.textContent = ""; }, 3000);
    }, { className: "small", "aria-label": name });
    return [copy, said];
  };

  const rowsOf = (table) =>
    [...table.rows].filter((row) => !row.hidden).map((row) => [...row.cells].map((c) => c.textContent.trim().replace(/\s+/g, " ")));
  const tsv = (table) => rowsOf(table).map((cells) => `${cells.join("\t")}\n`).join("");
  const commas = (table) => rowsOf(table).map((cells) => csv.line(cells)).join("");

  // ---- sorting

  const valueOf = (row, column) => (row.cells[column] ? row.cells[column].textContent.trim() : "");
  const numberIn = (text) => Number.parseFloat(text.replace("−", "-").replace(/^±/, ""));
  const compare = (a, b) => {
    const x = numberIn(a), y = numberIn(b);
    if (Number.isNaN(x) !== Number.isNaN(y)) return Number.isNaN(x) ? 1 : -1;
    return Number.isNaN(x) ? a.localeCompare(b) : x - y;
  };
  const sort = (table, heads, column) => {
    const falling = heads[column].getAttribute("aria-sort") === "ascending";
    heads.forEach((head, k) => head.setAttribute("aria-sort", k === column ? (falling ? "descending" : "ascending") : "none"));
    for (const body of table.tBodies) {
      const rows = [...body.rows];
      const missing = (row) => !/[\p{L}\p{N}]/u.test(valueOf(row, column));
      rows.sort((a, b) => {
        // What is missing stays last either way.
        if (missing(a) !== missing(b)) return missing(a) ? 1 : -1;
        return (falling ? -1 : 1) * compare(valueOf(a, column), valueOf(b, column));
      });
      body.append(...rows);
    }
  };

  // The head of each column: of a head of two rows the lower one, or that of both.
  const columnHeads = (table) => {
    const grid = [];
    [...table.tHead.rows].forEach((row, r) => {
      grid[r] = grid[r] || [];
      for (const cell of row.cells) {
        let c = 0;
        while (grid[r][c]) c += 1;
        for (let down = 0; down < cell.rowSpan; down += 1)
          for (let right = 0; right < cell.colSpan; right += 1) (grid[r + down] = grid[r + down] || [])[c + right] = cell;
      }
    });
    return grid[grid.length - 1];
  };

  for (const table of document.querySelectorAll("table")) {
    const holder = table.closest(".scroll") || table;
    const heading = [...document.querySelectorAll("h2, h3, h4")].filter((h) => h.compareDocumentPosition(table) & Node.DOCUMENT_POSITION_FOLLOWING).pop();
    const name = heading ? heading.firstChild.textContent.trim() : "table";
    if (table.tHead && table.tBodies.length && table.tBodies[0].rows.length > 1) {
      const heads = columnHeads(table);
      heads.forEach((head, column) => {
        // A break between words is a space once they are the label of a button.
        const label = [...head.childNodes].map((node) => (node.nodeName === "BR" ? " " : node.textContent)).join("");
        head.setAttribute("aria-sort", "none");
        head.replaceChildren(button(label, () => sort(table, heads, column), { className: "sort" }));
      });
    }
    // What scrolls has to be reached by the keyboard, and nothing else.
    const reach = () => {
      if (holder.scrollWidth <= holder.clientWidth || holder.querySelector("button, a[href]")) holder.removeAttribute("tabindex");
      else holder.tabIndex = 0;
    };
    new ResizeObserver(reach).observe(holder);
    holder.after(make("p", { className: "table-tools screen" },
      ...copier("Copy as TSV", `Copy as TSV: ${name}`, () => tsv(table)), " ",
      ...copier("Copy as CSV", `Copy as CSV: ${name}`, () => commas(table))));
  }

  for (const command of document.querySelectorAll(".command")) {
    const code = command.querySelector("code");
    command.append(" ", ...copier("Copy", "Copy the command", () => code.textContent));
    command.lastElementChild.classList.add("screen");
    command.querySelector("button").classList.add("screen");
  }
})();
