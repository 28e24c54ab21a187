// The charts of a work-precision study: they take the place of the drawn pictures, which stay for paper and for
// pages without scripts. Everything shown is in the JSON element "study-data"; nothing is asked of anywhere.
(() => {
  "use strict";
  const source = document.getElementById("study-data");
  if (!source || typeof Chart === "undefined") return;
  const study = JSON.parse(source.textContent);
  const dark = window.matchMedia("(prefers-color-scheme: dark)");
  const works = [
    { id: "seconds", name: "seconds of the time loop", axis: "time loop [s]" },
    { id: "force_evaluations", name: "force evaluations", axis: "force evaluations" },
  ].filter((work) => study.timed || work.id !== "seconds");

  // ---- numbers

  const superscript = (n) => String(n).replace(/./g, (c) => "⁰¹²³⁴⁵⁶⁷⁸⁹"[c] || "⁻");
  const number = (v) => {
    if (v === null || v === undefined) return "–";
    if (v !== 0 && (Math.abs(v) < 1e-3 || Math.abs(v) >= 1e5)) {
      const [digits, power] = v.toExponential(2).split("e");
      return `${digits}·10${superscript(Number(power))}`;
    }
    return String(Number(v.toPrecision(3)));
  };
  const seconds = (v) => (v < 1 ? `${number(1e3 * v)} ms` : `${number(v)} s`);
  const least = (values) => (values.length ? Math.min(...values) : null);
  const isPower = (value) => Math.abs(value / 10 ** Math.round(Math.log10(value)) - 1) < 1e-9;
  // Powers of ten, plain where all that the axis shows are short; between two of them, also 2 and 5 times.
  const tick = (value, [lo, hi]) => {
    const few = Math.floor(Math.log10(hi)) - Math.ceil(Math.log10(lo)) < 1;
    const digit = value / 10 ** Math.floor(Math.log10(value) + 1e-9);
    if (!isPower(value) && !(few && [2, 5].some((d) => Math.abs(digit / d - 1) < 1e-9))) return "";
    if (lo >= 1e-3 && hi < 1e4) return String(Number(value.toPrecision(1)));
    return isPower(value) ? `10${superscript(Math.round(Math.log10(value)))}` : number(value);
  };

  // ---- what is shown of a run

  // What is not known of a run of another program is undefined.
  const work = (run, measure) => (measure === "seconds" ? least(run.seconds) : run.counters?.[measure]);
  const error = (run, chart) => run[chart.question][chart.norm];
  const fate = (run, question) => {
    const tip = run[question]["tip-max"];
    if (run.outcome !== "completed" || tip === null) return "failed";
    return study.wrong_beyond !== null && tip > study.wrong_beyond ? "wrong" : "good";
  };

  // The methods with their runs: of the fixed mesh, or of every mesh.
  const linesOf = (question) => {
    const lines = new Map();
    for (const curve of study.curves) {
      if (question === "time" && curve.elements !== study.fixed_elements) continue;
      if (!lines.has(curve.label)) lines.set(curve.label, { ...curve, runs: [] });
      lines.get(curve.label).runs.push(...curve.runs.map((k) => ({ ...study.runs[k], label: curve.label })));
    }
    const given = study.given.map((curve) => ({ ...curve, family: "other programs", given: curve, runs: curve.runs.map((run) => ({ ...run, label: curve.label, given: curve })) }));
    return [...lines.values(), ...given];
  };

  // Those that no other beats; the first of equals.
  const paretoFront = (points, floor) => {
    const front = [];
    const clipped = (p) => Math.max(p.y, floor);
    for (const p of [...points].sort((a, b) => a.x - b.x || clipped(a) - clipped(b)))
      if (!front.length || clipped(p) < clipped(front[front.length - 1])) front.push(p);
    return front;
  };

  // ---- looks

  const theme = () => {
    const style = getComputedStyle(document.documentElement);
    const of = (name) => style.getPropertyValue(name).trim();
    return { ink: of("--ink"), soft: of("--soft"), line: of("--line"), paper: of("--paper"), front: of("--front"), band: of("--band") };
  };
  const colorOf = (line) => (dark.matches ? line.style.dark : line.style.color);
  const pointStyles = { circle: "circle", square: "rect", diamond: "rectRot", "triangle-up": "triangle", "triangle-down": "triangle", "triangle-right": "triangle" };
  const pointSizes = { circle: 4.5, square: 5.5, diamond: 6, "triangle-up": 6, "triangle-down": 6, "triangle-right": 7 };
  const rotations = { "triangle-down": 180, "triangle-right": 90 };
  const dashes = { solid: [], dashed: [7, 4], dotted: [2, 3] };
  const looks = (line, scale = 1) => ({
    pointStyle: pointStyles[line.style.marker],
    rotation: rotations[line.style.marker] || 0,
    radius: scale * pointSizes[line.style.marker],
    hoverRadius: scale * pointSizes[line.style.marker] + 2,
    pointBackgroundColor: line.style.open ? theme().paper : colorOf(line),
    pointBorderColor: colorOf(line),
    borderColor: colorOf(line),
    borderWidth: 2,
    pointBorderWidth: 1.5,
    pointHitRadius: 10,
  });

  const make = (name, properties = {}, ...children) => {
    const node = document.createElement(name);
    Object.assign(node, properties);
    node.append(...children);
    return node;
  };
  const sample = (line) => {
    const svg = document.createElementNS("http://www.w3.org/2000/svg", "svg");
    const add = (name, attributes) => {
      const node = document.createElementNS("http://www.w3.org/2000/svg", name);
      for (const [key, value] of Object.entries(attributes)) node.setAttribute(key, value);
      svg.append(node);
    };
    svg.setAttribute("viewBox", "0 0 34 14");
    svg.setAttribute("class", "sample");
    svg.setAttribute("aria-hidden", "true");
    const color = colorOf(line);
    add("line", { x1: 1, y1: 7, x2: 33, y2: 7, stroke: color, "stroke-width": 2, "stroke-dasharray": dashes[line.style.dash].join(" ") });
    const forms = {
      circle: "M12.5 7a4.5 4.5 0 1 0 9 0a4.5 4.5 0 1 0-9 0z",
      square: "M13 3h8v8h-8z",
      diamond: "M17 1.5l5.5 5.5l-5.5 5.5l-5.5-5.5z",
      "triangle-up": "M17 1.5l5.2 9.5h-10.4z",
      "triangle-down": "M17 12.5l5.2-9.5h-10.4z",
      "triangle-right": "M22.5 7l-9.5 5.2v-10.4z",
    };
    add("path", { d: forms[line.style.marker], fill: line.style.open ? theme().paper : color, stroke: color, "stroke-width": 1.5 });
    return svg;
  };

  // ---- one chart

  class WorkChart {
    constructor(figure) {
      this.figure = figure;
      this.question = figure.dataset.question;
      this.norm = study.norms[0].id;
      this.work = works[0].id;
      this.lines = linesOf(this.question);
      this.shown = new Set(study.chosen[this.question]);
      this.meshes = new Set(this.lines.flatMap((line) => (line.given ? [] : line.runs.map((run) => run.elements))));
      this.allMeshes = [...this.meshes].sort((a, b) => a - b);
      this.controls = figure.querySelector(".chart-controls");
      this.box = figure.querySelector(".chart-box");
      this.canvas = this.box.querySelector("canvas");
      this.tip = figure.querySelector(".chart-tip");
      this.addControls();
      this.setRanges();
      this.controls.hidden = this.box.hidden = false;
      for (const picture of figure.querySelectorAll("img")) picture.classList.add("paper");
      this.chart = new Chart(this.canvas, { type: "scatter", data: { datasets: [] }, options: this.options(), plugins: [this.background()] });
      this.update();
      this.canvas.addEventListener("keydown", (event) => this.key(event));
      this.canvas.addEventListener("blur", () => this.point(null));
      dark.addEventListener("change", () => this.restyle());
    }

    // -- controls

    addControls() {
      const choice = (name, items, take) => {
        const select = make("select");
        for (const item of items) select.append(make("option", { value: item.id, textContent: item.name }));
        select.addEventListener("change", () => { take(select.value); this.update(); });
        return make("label", {}, `${name} `, select);
      };
      const bar = make("div", { className: "chart-bar" },
        choice("Error", study.norms, (id) => { this.norm = id; }),
        choice("Work", works, (id) => { this.work = id; }));
      const button = (text, labels) => {
        const node = make("button", { type: "button", textContent: text });
        node.addEventListener("click", () => { this.shown = new Set(labels()); this.tick(); this.update(); });
        bar.append(node);
      };
      if (this.lines.length > study.chosen[this.question].length) button("The best curves", () => study.chosen[this.question]);
      button("All curves", () => this.lines.map((line) => line.label));
      this.controls.append(bar);
      if (this.question === "total" && this.allMeshes.length > 1) {
        const set = make("fieldset", { className: "meshes" }, make("legend", { textContent: "elements" }));
        for (const mesh of this.allMeshes) {
          const box = make("input", { type: "checkbox", checked: true });
          box.addEventListener("change", () => { this.meshes[box.checked ? "add" : "delete"](mesh); this.update(); });
          set.append(make("label", {}, box, ` ${mesh}`));
        }
        this.controls.append(set);
      }
      this.boxes = [];
      const families = make("div", { className: "families" });
      for (const family of new Set(this.lines.map((line) => line.family))) {
        const members = this.lines.filter((line) => line.family === family);
        const all = make("input", { type: "checkbox" });
        all.addEventListener("change", () => {
          for (const line of members) this.shown[all.checked ? "add" : "delete"](line.label);
          this.tick();
          this.update();
        });
        this.boxes.push({ box: all, labels: members.map((line) => line.label) });
        const set = make("fieldset", {}, make("legend", {}, make("label", {}, all, ` ${family}`)));
        for (const line of members) {
          const box = make("input", { type: "checkbox" });
          box.addEventListener("change", () => {
            this.shown[box.checked ? "add" : "delete"](line.label);
            this.tick();
            this.update();
          });
          this.boxes.push({ box, labels: [line.label] });
          const slot = make("span", { className: "slot" }, sample(line));
          line.slot = slot;
          set.append(make("label", { className: "curve" }, box, slot, make("span", { textContent: line.label })));
        }
        families.append(set);
      }
      // On a narrow screen the list would push the chart out of sight.
      const list = make("details", { className: "curves", open: window.innerWidth > 640 }, make("summary", { textContent: "Curves" }), families);
      this.controls.append(list);
      this.tick();
    }

    tick() {
      for (const { box, labels } of this.boxes) {
        const on = labels.filter((label) => this.shown.has(label)).length;
        box.checked = on === labels.length;
        box.indeterminate = on > 0 && on < labels.length;
      }
    }

    // -- data

    // The runs of a line of which what the axes show is known, or which failed; of meshes that are asked for.
    runsOf(line) {
      if (line.given) return line.runs.filter((run) => this.work === "seconds" && (run.outcome !== "completed" || run[this.question][this.norm] !== null));
      return line.runs.filter((run) => this.meshes.has(run.elements));
    }

    floor() {
      const floor = study.floor[this.question];
      return floor && this.norm !== "energy" ? floor : null;
    }

    setRanges() {
      const xs = [], ys = [];
      for (const line of this.lines)
        for (const run of line.given ? this.runsOf(line) : line.runs) {
          if (!this.shown.has(line.label) || fate(run, this.question) === "failed") continue;
          const x = work(run, this.work), y = error(run, this);
          if (x > 0) xs.push(x);
          if (y > 0) ys.push(y);
        }
      if (!xs.length) xs.push(1e-3, 1);
      if (!ys.length) ys.push(1e-6, 0.1);
      const floor = this.floor();
      let lo = Math.min(...ys) / 2;
      if (floor && floor.value > lo / 30) lo = Math.min(lo, floor.value / 3);
      let hi = 3 * Math.max(...ys);
      hi *= (hi / lo) ** 0.06;
      this.x = [Math.min(...xs) / 1.4, Math.max(...xs) * 1.4];
      this.y = [lo, hi];
      this.top = hi / (hi / lo) ** 0.025;
    }

    place(run) {
      const state = fate(run, this.question);
      const value = error(run, this);
      const x = Math.min(Math.max(work(run, this.work) || 0, this.x[0] * 1.1), this.x[1] / 1.1);
      const y = state === "failed" || value === null ? this.top : Math.min(Math.max(value, this.y[0] * 1.1), this.top);
      return { x, y, run, state };
    }

    datasets() {
      const sets = [];
      const good = [];
      const colors = theme();
      for (const line of this.lines) {
        if (!this.shown.has(line.label)) continue;
        const points = this.runsOf(line).map((run) => this.place(run));
        const fine = points.filter((p) => p.state === "good" && work(p.run, this.work) > 0);
        if (!line.given) good.push(...fine);
        // Over several meshes a method is as good as its own front; what lies behind stays as small points.
        const best = this.question === "time" || line.given ? fine : paretoFront(fine, 0);
        sets.push({ data: best, showLine: true, borderDash: dashes[line.style.dash], order: 3, ...looks(line) });
        const rest = fine.filter((p) => !best.includes(p));
        if (rest.length) sets.push({ data: rest, order: 4, ...looks(line, 0.55), pointBorderColor: colorOf(line) + "88", pointBackgroundColor: "transparent" });
        const cross = { ...looks(line), pointStyle: "crossRot", rotation: 0, radius: 6, hoverRadius: 8, pointBorderWidth: 2, order: 1 };
        const wrong = points.filter((p) => p.state === "wrong");
        if (wrong.length) {
          sets.push({ data: wrong, ...cross, radius: 4 });
          sets.push({ data: wrong, ...cross, pointStyle: "circle", radius: 7, pointBackgroundColor: "transparent", pointHitRadius: 0, order: 2 });
        }
        const failed = points.filter((p) => p.state === "failed");
        if (failed.length) sets.push({ data: failed, ...cross });
      }
      const floor = this.floor();
      const front = paretoFront(good, floor ? floor.value : 0);
      sets.push({ data: front.map(({ x, y }) => ({ x, y })), showLine: true, radius: 0, hoverRadius: 0, pointHitRadius: 0, borderWidth: 9, borderColor: colors.front, borderJoinStyle: "round", borderCapStyle: "round", order: 9 });
      return sets;
    }

    update() {
      this.setRanges();
      const measure = works.find((w) => w.id === this.work);
      const norm = study.norms.find((n) => n.id === this.norm);
      const { x, y } = this.chart.options.scales;
      [x.min, x.max] = this.x;
      [y.min, y.max] = this.y;
      x.title.text = measure.axis;
      y.title.text = `${this.question === "time" ? "time integration" : "total"}: ${norm.name} [${norm.unit}]`;
      this.chart.data.datasets = this.datasets();
      this.at = null;
      this.point(null);
      this.chart.update("none");
    }

    restyle() {
      const options = this.options();
      for (const axis of ["x", "y"]) Object.assign(this.chart.options.scales[axis], options.scales[axis]);
      for (const line of this.lines) line.slot.replaceChildren(sample(line));
      this.update();
    }

    // -- drawing

    options() {
      const colors = theme();
      const font = { family: getComputedStyle(document.body).fontFamily, size: 13 };
      const axis = (range) => ({
        type: "logarithmic",
        grid: {
          color: (context) => (context.tick && isPower(context.tick.value) ? colors.line : "transparent"),
          borderColor: colors.soft,
          tickColor: colors.soft,
        },
        ticks: { color: colors.ink, font, autoSkip: true, maxRotation: 0, callback: (value) => tick(value, range()) || null },
        title: { display: true, text: "", color: colors.ink, font },
      });
      return {
        animation: false,
        responsive: true,
        maintainAspectRatio: false,
        interaction: { mode: "nearest", intersect: true },
        scales: { x: axis(() => this.x), y: axis(() => this.y) },
        plugins: {
          legend: { display: false },
          tooltip: { enabled: false, external: ({ tooltip }) => this.hover(tooltip) },
        },
      };
    }

    // The floor of the reference, what each mesh errs by itself, and the line of those that failed.
    background() {
      return {
        id: "background",
        beforeDatasetsDraw: (chart) => {
          const { ctx, chartArea: area, scales } = chart;
          const colors = theme();
          ctx.save();
          ctx.font = `12px ${getComputedStyle(document.body).fontFamily}`;
          ctx.textBaseline = "bottom";
          ctx.fillStyle = colors.soft;
          const floor = this.floor();
          if (floor && floor.value > this.y[0]) {
            const top = scales.y.getPixelForValue(Math.min(floor.value, this.y[1]));
            ctx.fillStyle = colors.band;
            ctx.fillRect(area.left, top, area.width, area.bottom - top);
            ctx.fillStyle = colors.soft;
            ctx.textAlign = "left";
            ctx.fillText(floor.certified ? "floor of the reference" : "floor: not certified below", area.left + 6, top - 3, area.width - 12);
          }
          if (this.question === "total" && (this.norm === "tip-max"))
            for (const mesh of study.mesh_alone) {
              if (!(mesh.distance > this.y[0] && mesh.distance < this.y[1])) continue;
              const y = scales.y.getPixelForValue(mesh.distance);
              ctx.strokeStyle = colors.soft;
              ctx.setLineDash([2, 4]);
              ctx.beginPath();
              ctx.moveTo(area.left, y);
              ctx.lineTo(area.right, y);
              ctx.stroke();
              ctx.textAlign = "left";
              ctx.fillText(`${mesh.elements} elements, exact in time`, area.left + 6, y - 2);
            }
          ctx.restore();
        },
      };
    }

    // -- everything about a run

    describe(run) {
      const state = fate(run, this.question);
      const rows = [];
      const row = (name, value) => rows.push(make("dt", { textContent: name }), make("dd", { textContent: value }));
      const known = (values) => study.norms.filter((n) => values[n.id] !== null).map((n) => `${n.name} ${number(values[n.id])}${n.unit === "m" ? " m" : ""}`).join("; ") || "not known";
      if (run.given) {
        const { program, threads, machine, scaled } = run.given;
        row("run", `${run.setting}, of ${run.file}`);
        row("program", program);
        if (run.message) row("no error", run.message);
        row("to the case's mesh", known(run.time));
        row("to the converged motion", known(run.total));
        row("time", `${seconds(run.stated_seconds)} on ${machine}, ${threads} ${threads === 1 ? "thread" : "threads"}${scaled ? `; ${seconds(run.seconds[0])} here, by the yardstick` : ""}`);
        return [make("strong", { textContent: run.label }), make("dl", {}, ...rows)];
      }
      const parameters = Object.entries(run.parameters).map(([name, value]) => `${name} ${number(value)}`);
      row("run", [`${run.elements} ${run.elements === 1 ? "element" : "elements"}`, run.setting, ...parameters].filter(Boolean).join(", "));
      if (state === "failed") row("outcome", run.outcome === "completed" ? "completed; not compared with any reference" : run.message || run.outcome);
      else row("outcome", state === "wrong" ? "completed, stable but wrong" : "completed");
      const errors = (values) => study.norms.map((n) => `${n.name} ${number(values[n.id])}${n.unit === "m" ? " m" : ""}`).join("; ");
      row("error of time", errors(run.time));
      row("total error", errors(run.total));
      const c = run.counters;
      row("counts", `${number(c.steps)} steps (${number(c.rejected_steps)} rejected), ${number(c.force_evaluations)} forces, ${number(c.tangent_evaluations)} tangents, ${number(c.factorizations)} factorizations, ${number(c.newton_iterations)} Newton iterations`);
      if (run.seconds.length) {
        const low = Math.min(...run.seconds), high = Math.max(...run.seconds);
        row("time", run.seconds.length === 1 ? `${seconds(low)}, once` : `${seconds(low)}, least of ${run.seconds.length}; greatest ${seconds(high)} (+${number(100 * (high / low - 1))} %)`);
      } else row("time", "not timed");
      const floor = this.floor();
      if (floor && state === "good" && run[this.question]["tip-max"] < floor.value) row("note", "below the floor of the reference");
      return [make("strong", { textContent: run.label }), make("dl", {}, ...rows)];
    }

    showTip(point, x, y) {
      this.tip.hidden = !point;
      if (!point) return;
      this.tip.replaceChildren(...this.describe(point.run));
      const wide = this.box.clientWidth, high = this.box.clientHeight;
      const left = x + 16 + this.tip.offsetWidth <= wide ? x + 16 : Math.max(0, x - 16 - this.tip.offsetWidth);
      this.tip.style.left = `${left}px`;
      this.tip.style.top = `${this.box.offsetTop + Math.max(0, Math.min(y + 12, high - this.tip.offsetHeight))}px`;
    }

    hover(tooltip) {
      const item = tooltip.opacity > 0 && tooltip.dataPoints && tooltip.dataPoints.find((p) => p.raw.run);
      this.showTip(item ? item.raw : null, tooltip.caretX, tooltip.caretY);
    }

    // Arrows walk through the runs: left and right along a curve, up and down from curve to curve.
    key(event) {
      const ways = { ArrowRight: [0, 1], ArrowLeft: [0, -1], ArrowDown: [1, 0], ArrowUp: [-1, 0] };
      if (event.key === "Escape") { this.point(null); return; }
      const way = ways[event.key];
      const sets = this.chart.data.datasets.map((set, index) => ({ set, index })).filter(({ set }) => set.pointHitRadius > 0 && set.data.length);
      if (!way || !sets.length) return;
      event.preventDefault();
      const wrap = (value, count) => (value + count) % count;
      if (!this.at) this.at = [0, 0];
      else if (way[0]) this.at = [wrap(this.at[0] + way[0], sets.length), 0];
      else this.at = [this.at[0], wrap(this.at[1] + way[1], sets[wrap(this.at[0], sets.length)].set.data.length)];
      const { set, index } = sets[wrap(this.at[0], sets.length)];
      this.point({ datasetIndex: index, index: Math.min(this.at[1], set.data.length - 1) });
    }

    point(active) {
      this.chart.setActiveElements(active ? [active] : []);
      if (active) {
        const { x, y } = this.chart.getDatasetMeta(active.datasetIndex).data[active.index];
        this.showTip(this.chart.data.datasets[active.datasetIndex].data[active.index], x, y);
      } else {
        this.showTip(null);
      }
      this.chart.update("none");
    }
  }

  for (const figure of document.querySelectorAll(".study-chart")) new WorkChart(figure);
})();
