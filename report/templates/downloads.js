// The numbers of every figure, to be kept: the same columns as figures/*.csv.
plumb.csv = (() => {
  "use strict";
  const { data, button } = plumb;
  const cell = (value) => {
    const text = value === null || value === undefined ? "" : String(value);
    return /[",\r\n]/.test(text) ? `"${text.replaceAll('"', '""')}"` : text;
  };
  const line = (cells) => `${cells.map(cell).join(",")}\n`;

  const numbersOf = (figure) => {
    let text = "panel,kind,series,x,y,x_to,y_to,value\n";
    figure.panels.forEach((panel, p) => {
      const row = (kind, name, x, y, xTo, yTo, value) => { text += line([p + 1, kind, name, x, y, xTo, yTo, value]); };
      const map = panel.heat_map;
      if (map) {
        const middle = (edges, k) => edges[k] / 2 + edges[k + 1] / 2;
        const columns = map.x_edges.length - 1;
        map.values.forEach((value, k) => row("cell", "", middle(map.x_edges, k % columns), middle(map.y_edges, Math.floor(k / columns)), null, null, value));
      }
      for (const { upright, label, from, to } of panel.rules) {
        if (upright) row("rule", label, from, null, to, null);
        else row("rule", label, null, from, null, to);
      }
      panel.series.forEach((series, s) => {
        const name = series.label || `#${s + 1}`;
        const { x, y, band, x_error: across, y_error: up } = series;
        x.forEach((value, i) => row("point", name, value, y[i]));
        if (band) x.forEach((value, i) => row("band", name, value, band.lower[i], value, band.upper[i]));
        if (across) x.forEach((value, i) => row("x_error", name, across.lower[i], y[i], across.upper[i], y[i]));
        if (up) x.forEach((value, i) => row("y_error", name, value, up.lower[i], value, up.upper[i]));
      });
    });
    return text;
  };

  const save = (name, text) => {
    const link = document.createElement("a");
    link.href = URL.createObjectURL(new Blob([text], { type: "text/csv" }));
    link.download = name;
    link.click();
    setTimeout(() => URL.revokeObjectURL(link.href), 10000);
  };

  for (const caption of document.querySelectorAll("figcaption")) {
    const file = caption.querySelector(".file");
    const figure = file && data.figures.find((candidate) => candidate.file === file.textContent);
    if (!figure || !figure.panels.some((panel) => panel.series.length || panel.heat_map)) continue;
    const name = figure.file.replace(/^.*\//, "").replace(/\.png$/, ".csv");
    caption.append(" ", button("Download data", () => save(name, numbersOf(figure)),
      { className: "small screen", "aria-label": `Download data of ${figure.title} (CSV)` }));
  }
  return { line };
})();
