// The maps of a stability study, one at a time, with what each run did under the pointer or the arrow keys. The drawn
// pictures stay: they show all methods at once. Everything shown is in the JSON element "stability-data"; nothing is
// asked of anywhere.
(() => {
  "use strict";
  const source = document.getElementById("stability-data");
  const figure = document.querySelector(".map-viewer");
  if (!source || !figure) return;
  const study = JSON.parse(source.textContent);
  if (!study.maps.length) return;

  const superscript = (n) => String(n).replace(/./g, (c) => "⁰¹²³⁴⁵⁶⁷⁸⁹"[c] || "⁻");
  const number = (v) => {
    if (v === null || v === undefined) return "–";
    if (v !== 0 && (Math.abs(v) < 1e-2 || Math.abs(v) >= 1e5)) {
      const [digits, power] = v.toExponential(2).split("e");
      return `${digits}·10${superscript(Number(power))}`;
    }
    return String(Number(v.toPrecision(3)));
  };

  const svgNode = (name, attributes, text) => {
    const node = document.createElementNS("http://www.w3.org/2000/svg", name);
    for (const [key, value] of Object.entries(attributes)) node.setAttribute(key, value);
    if (text !== undefined) node.textContent = text;
    return node;
  };
  const make = (name, properties = {}, ...children) => {
    const node = document.createElement(name);
    Object.assign(node, properties);
    node.append(...children);
    return node;
  };

  const left = 90, top = 12, right = 16, bottom = 58, width = 880, rowHeight = 30;

  class MapViewer {
    constructor() {
      this.box = figure.querySelector(".map-box");
      this.words = figure.querySelector(".map-words");
      this.tip = figure.querySelector(".map-tip");
      this.labels = [...new Set(study.maps.map((map) => map.label))];
      this.axes = [...new Set(study.maps.map((map) => map.axis))];
      this.label = this.labels[0];
      this.axis = this.axes[0];
      const choice = (name, items, take) => {
        const select = make("select");
        for (const [value, text] of items) select.append(make("option", { value, textContent: text }));
        select.addEventListener("change", () => { take(select.value); this.draw(); });
        return make("label", {}, `${name} `, select);
      };
      figure.querySelector(".chart-controls").append(make("div", { className: "chart-bar" },
        choice("Method", this.labels.map((label) => [label, label]), (label) => { this.label = label; }),
        choice("Over", this.axes.map((axis) => [axis, study.axis_names[axis]]), (axis) => { this.axis = axis; })));
      figure.hidden = false;
      this.draw();
    }

    draw() {
      const map = study.maps.find((any) => any.label === this.label && any.axis === this.axis);
      this.map = map;
      const columns = map.settings.length, rows = map.values.length;
      const cell = (width - left - right) / columns, height = top + rows * rowHeight + bottom;
      this.place = (row, column) => ({ x: left + column * cell, y: top + (rows - 1 - row) * rowHeight, w: cell, h: rowHeight });
      const svg = svgNode("svg", { viewBox: `0 0 ${width} ${height}`, tabindex: 0, role: "img",
        "aria-label": `Map of outcomes of ${map.label}: ${map.words}. The arrow keys walk through the runs.` });
      for (let row = 0; row < rows; ++row) {
        const { y } = this.place(row, 0);
        svg.append(svgNode("text", { x: left - 8, y: y + rowHeight / 2, "text-anchor": "end", "dominant-baseline": "central" }, map.value_labels[row]));
        for (let column = 0; column < columns; ++column) {
          const place = this.place(row, column), outcome = study.outcomes[map.points[row * columns + column].o];
          const rect = svgNode("rect", { x: place.x + 0.5, y: place.y + 0.5, width: place.w - 1, height: place.h - 1, fill: outcome.color });
          rect.addEventListener("pointerenter", () => this.choose(row, column));
          rect.addEventListener("click", () => this.choose(row, column));
          svg.append(rect, svgNode("text", { class: "letter", x: place.x + place.w / 2, y: place.y + place.h / 2, style: `fill:${outcome.ink}` }, outcome.letter));
        }
      }
      for (let column = 0; column < columns; ++column)
        svg.append(svgNode("text", { x: left + (column + 0.5) * cell, y: top + rows * rowHeight + 20, "text-anchor": "middle" }, map.setting_labels[column]));
      svg.append(svgNode("text", { x: (left + width - right) / 2, y: height - 10, "text-anchor": "middle" }, map.by_step ? "step [s]" : "rtol"));
      this.addLimits(svg, map, cell, rows);
      this.mark = svgNode("rect", { class: "chosen", width: cell - 2, height: rowHeight - 2, visibility: "hidden" });
      svg.append(this.mark);
      svg.addEventListener("keydown", (event) => this.key(event));
      this.box.replaceChildren(svg);
      this.words.textContent = `${map.label}, ${map.where}: ${map.words}.`;
      this.at = null;
      this.tip.replaceChildren("Point at a cell, or walk through the runs with the arrow keys.");
    }

    // Columns are of equal ratio, so that a step has its place between their middles by its logarithm.
    addLimits(svg, map, cell, rows) {
      const ratio = Math.log(map.settings[map.settings.length - 1] / map.settings[0]) / (map.settings.length - 1);
      for (const [index, name] of [[0, "start"], [1, "worst"]]) {
        const points = [];
        for (let row = 0; row < map.limits.length; ++row) {
          const step = map.limits[row][index];
          if (!(step > 0)) continue;
          const x = left + (Math.log(step / map.settings[0]) / ratio + 0.5) * cell;
          const { y, h } = this.place(row, 0);
          points.push(`${Math.min(Math.max(x, left), width - right)},${y + h}`, `${Math.min(Math.max(x, left), width - right)},${y}`);
        }
        if (!points.length) continue;
        svg.append(svgNode("polyline", { class: "halo", points: points.join(" ") }), svgNode("polyline", { class: `limit ${name}`, points: points.join(" ") }));
      }
    }

    choose(row, column) {
      const map = this.map, place = this.place(row, column);
      this.at = [row, column];
      this.mark.setAttribute("x", place.x + 1);
      this.mark.setAttribute("y", place.y + 1);
      this.mark.setAttribute("visibility", "visible");
      const point = map.points[row * map.settings.length + column], outcome = study.outcomes[point.o];
      const rows = [];
      const say = (name, text) => rows.push(make("dt", { textContent: name }), make("dd", { textContent: text }));
      say("outcome", `${outcome.name}: ${outcome.meaning}`);
      if (point.m) say("message", point.m);
      if (point.e !== null) say("error", `${number(point.e)} m until ${number(point.j)} s`);
      say("energy", `${number(point.d)} of the first kinetic energy gained by ${number(point.t)} s`);
      this.tip.replaceChildren(make("strong", { textContent: `${map.label}, ${map.value_names[row]}, ${map.by_step ? "step" : "rtol"} ${number(map.settings[column])}${map.by_step ? " s" : ""}` }), make("dl", {}, ...rows));
    }

    key(event) {
      const ways = { ArrowRight: [0, 1], ArrowLeft: [0, -1], ArrowDown: [-1, 0], ArrowUp: [1, 0] };
      const way = ways[event.key];
      if (!way) return;
      event.preventDefault();
      const wrap = (value, count) => (value + count) % count;
      const [row, column] = this.at ? [this.at[0] + way[0], this.at[1] + way[1]] : [0, 0];
      this.choose(wrap(row, this.map.values.length), wrap(column, this.map.settings.length));
    }
  }

  new MapViewer();
})();
