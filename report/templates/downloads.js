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
    let text = "panel,series,x,y\n";
    figure.panels.forEach((panel, p) => panel.series.forEach((series, s) => series.x.forEach((x, i) => {
      text += line([p + 1, series.label || `#${s + 1}`, x, series.y[i]]);
    })));
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
    if (!figure || !figure.panels.some((panel) => panel.series.length)) continue;
    const name = figure.file.replace(/^.*\//, "").replace(/\.png$/, ".csv");
    caption.append(" ", button("Download data", () => save(name, numbersOf(figure)),
      { className: "small screen", "aria-label": `Download data of ${figure.title} (CSV)` }));
  }
  return { line };
})();
