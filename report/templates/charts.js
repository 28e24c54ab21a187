// The figures as charts, in the place of the drawn pictures, which stay for paper. A time that is pointed at in one is
// shown in all of them and by the player. Numbers are read out to the digits that their uncertainty bears, and to all
// those of results.json once one is pressed.
(() => {
  "use strict";
  const { data, make, clock } = plumb;
  if (typeof Chart === "undefined") return;
  const dark = window.matchMedia("(prefers-color-scheme: dark)");

  // ---- looks

  const color = (name) => getComputedStyle(document.documentElement).getPropertyValue(name).trim();
  const colorOf = (series, k) => (series.color ? (series.color === "#000000" ? color("--ink") : series.color) : color(`--series-${k % 6}`));
  const dashes = { solid: [], dashed: [7, 4], dotted: [2, 3] };
  const leastAxisWidth = 72;

  // ---- numbers

  const known = (value) => value !== null && value !== undefined;
  const exact = (value) => (known(value) ? String(value).replace("-", "−") : "not finite");
  const signs = { "-": "⁻", 0: "⁰", 1: "¹", 2: "²", 3: "³", 4: "⁴", 5: "⁵", 6: "⁶", 7: "⁷", 8: "⁸", 9: "⁹" };
  // "1.2·10⁻¹⁴", where JavaScript writes "1.2e-14".
  const typeset = (text) =>
    text.replace(/e\+?(-?\d+)$/, (_, power) => `·10${[...power].map((sign) => signs[sign]).join("")}`).replace(/^1·/, "").replace(/^-1·/, "-").replace("-", "−");
  // Small numbers have few digits, so that they keep to the width of an axis.
  const short = (value) => {
    const small = value !== 0 && Math.abs(value) < 1e-3;
    return typeset(String(Number(value.toPrecision(small ? 2 : 4))));
  };
  // To what it may be off by, of which one digit is shown, or two where that begins with 1 or 2.
  const readable = (value, uncertainty) => {
    if (!known(value) || !(uncertainty > 0)) return exact(value);
    const first = Math.floor(Math.log10(uncertainty));
    const place = uncertainty < 3 * 10 ** first ? first - 1 : first;
    const digits = value === 0 ? 1 : Math.floor(Math.log10(Math.abs(value))) - place + 1;
    if (digits < 1) return place > -6 ? (0).toFixed(Math.max(-place, 0)) : "0";
    if (place >= -6 && place <= 0) return typeset(value.toFixed(-place));
    return typeset(Number(value).toPrecision(Math.min(digits, 17)));
  };
  const moments = (value) => String(Number(value.toPrecision(6)));
  const nearest = (values, value) => {
    let best = -1;
    values.forEach((v, k) => {
      if (known(v) && (best < 0 || Math.abs(v - value) < Math.abs(values[best] - value))) best = k;
    });
    return best;
  };

  // The times of the points of a series, if they have any.
  const timesOf = (panel, series) => (panel.over_time ? series.x : series.time);

  class PanelChart {
    constructor(panel, name, group) {
      this.panel = panel;
      this.group = group;
      this.name = name;
      this.timed = panel.series.some((series) => timesOf(panel, series));
      this.at = panel.series.map(() => -1);  // the point of each series that is shown
      this.canvas = make("canvas", { tabIndex: 0 });
      const box = make("div", { className: "panel-box" }, this.canvas);
      box.style.height = `calc(var(--panel-scale, 1) * ${Math.max(11, (panel.equal_axes ? 26 : 19) * panel.height_share)}rem)`;
      this.moment = make("span", { className: "moment" });
      this.full = false;
      this.values = panel.series.map((series, k) => {
        const value = make("button", { type: "button", className: "value", textContent: "–", title: "All digits, or those that it is known to" });
        value.hidden = true;  // until there is a number
        value.addEventListener("click", () => this.showAll(!this.full));
        return { sample: this.sampleOf(series), value, item: null, k };
      });
      const list = make("ul");
      for (const entry of this.values) {
        const label = panel.series[entry.k].label || panel.y.label.replace(/ \[.*\]$/, "");
        entry.item = make("li", {}, entry.sample, make("span", { textContent: `${label} ` }), entry.value);
        list.append(entry.item);
      }
      const readout = make("div", { className: "readout" }, this.moment, list);
      this.node = make("div", { className: "panel" }, ...(panel.title ? [make("p", { textContent: panel.title, className: "panel-title" })] : []), box, readout);
      this.canvas.setAttribute("role", this.timed ? "slider" : "img");
      this.canvas.setAttribute("aria-label", this.timed ? `${name} ${panel.y.label}. The arrow keys move the time.` : name);
      if (this.timed) {
        this.canvas.setAttribute("aria-valuemin", 0);
        this.canvas.setAttribute("aria-valuemax", clock.end);
      }
    }

    // What stands for a series in the read-out: its line with its dashes, its points, or both.
    sampleOf(series) {
      const svg = document.createElementNS("http://www.w3.org/2000/svg", "svg");
      const part = (name, attributes) => {
        const node = document.createElementNS(svg.namespaceURI, name);
        for (const [key, value] of Object.entries(attributes)) node.setAttribute(key, value);
        svg.append(node);
      };
      const dash = dashes[series.dash];
      const width = series.line ? Math.max(24, 2 * (dash[0] || 0) + (dash[1] || 0) + 2) : 10;
      svg.setAttribute("width", width);
      svg.setAttribute("height", 10);
      svg.setAttribute("class", "sample");
      svg.setAttribute("aria-hidden", "true");
      if (series.line) part("path", { d: `M0 5H${width}`, "stroke-width": 2, ...(dash.length ? { "stroke-dasharray": dash.join(" ") } : {}) });
      if (series.marker) part("circle", { cx: width / 2, cy: 5, r: 3.5, "stroke-width": 1.4 });
      return svg;
    }

    // Half the width of what a value may be: as is stated, or of its panel's range what can be seen.
    uncertaintyOf(series, along, i) {
      const bars = along === "x" ? series.x_error : series.y_error;
      if (bars && known(bars.lower[i]) && known(bars.upper[i])) return (bars.upper[i] - bars.lower[i]) / 2;
      const axis = this.panel[along];
      if (axis.uncertainty) return axis.uncertainty;
      if (axis.scale === "logarithmic") return Math.abs(series[along][i]) / 100;
      const { min, max } = this.chart.scales[along];
      return (max - min) / 200;
    }

    numberOf(series, along, i) {
      return this.full ? exact(series[along][i]) : readable(series[along][i], this.uncertaintyOf(series, along, i));
    }

    showAll(full) {
      this.full = full;
      for (const { value } of this.values) value.setAttribute("aria-pressed", full);
      if (this.last) this.read(...this.last);
    }

    // Once its place in the page is known.
    begin() {
      this.chart = new Chart(this.canvas, { type: "scatter", data: { datasets: this.datasets() }, options: this.options(), plugins: [this.overlay()] });
      this.equalize();
      this.paintSamples();
      this.canvas.addEventListener("pointermove", (event) => this.pointAt(event));
      this.canvas.addEventListener("pointerdown", (event) => this.pointAt(event));
      this.canvas.addEventListener("keydown", (event) => this.key(event));
      dark.addEventListener("change", () => this.restyle());
      if (this.timed) clock.follow((time) => this.moveTo(time));
    }

    datasets() {
      return this.panel.series.map((series, k) => ({
        data: series.x.map((x, i) => ({ x, y: series.y[i] })),
        showLine: series.line,
        borderDash: dashes[series.dash],
        borderColor: colorOf(series, k),
        borderWidth: 2,
        pointRadius: series.marker ? 3.5 : 0,
        pointBorderColor: colorOf(series, k),
        pointBackgroundColor: "transparent",
        pointBorderWidth: 1.4,
        order: -k,  // the last on top, as it is drawn
      }));
    }

    // A label in lines that are no longer than its axis.
    linesOf(label, length, font) {
      const ctx = this.canvas.getContext("2d");
      ctx.save();
      ctx.font = `${font.size}px ${font.family}`;
      const lines = [];
      for (const word of label.split(" ")) {
        const longer = lines.length ? `${lines[lines.length - 1]} ${word}` : word;
        if (lines.length && ctx.measureText(longer).width <= length) lines[lines.length - 1] = longer;
        else lines.push(word);
      }
      ctx.restore();
      return lines;
    }

    options() {
      const font = { family: getComputedStyle(document.body).fontFamily, size: 13 };
      const axis = ({ label, scale, range }, zeroLine) => ({
        type: scale,
        min: range ? range[0] : undefined,
        max: range ? range[1] : undefined,
        grid: {
          color: (context) => (zeroLine && context.tick && context.tick.value === 0 ? color("--soft") : color("--line")),
          borderColor: color("--soft"),
        },
        ticks: { color: color("--ink"), font, maxRotation: 0, autoSkipPadding: 16, includeBounds: false, callback: short },
        title: { display: true, text: label, color: color("--ink"), font },
      });
      const foot = this.panel.shares_x_below ? 12 : 56;  // of what is below the axis
      const x = axis(this.panel.x, this.panel.x.zero_line);
      const y = axis(this.panel.y, this.panel.y.zero_line);
      y.title.text = this.linesOf(this.panel.y.label, this.canvas.parentNode.clientHeight - foot, font);
      // Those of one figure are as wide as the widest needs, so that labels have room and frames are aligned.
      y.afterFit = (scale) => {
        this.group.axisWidth = Math.max(this.group.axisWidth, Math.ceil(scale.width));
        scale.width = this.group.axisWidth;
      };
      // Panels above each other begin and end alike, however long their labels are.
      x.afterFit = (scale) => { scale.paddingLeft = scale.paddingRight = 0; };
      // What bands reach has to be in sight.
      const reached = this.panel.series.flatMap((series) => (series.band ? [...series.band.lower, ...series.band.upper] : [])).filter(known);
      if (reached.length) [y.suggestedMin, y.suggestedMax] = [Math.min(...reached), Math.max(...reached)];
      if (this.panel.over_time && !this.panel.x.range) [x.min, x.max] = [0, clock.end];
      if (this.panel.shares_x_below) {
        x.title.display = false;
        x.ticks.display = false;
      }
      return {
        animation: false,
        parsing: false,
        responsive: true,
        maintainAspectRatio: false,
        events: [],
        layout: { padding: { right: 20, top: 6 } },
        onResize: () => requestAnimationFrame(() => this.equalize()),
        scales: { x, y },
        plugins: { legend: { display: false }, tooltip: { enabled: false } },
      };
    }

    // One unit as long along x as along y.
    equalize() {
      if (!this.panel.equal_axes || !this.chart) return;
      const span = (values) => {
        const finite = this.panel.series.flatMap(values).filter(known);
        return finite.length ? [Math.min(...finite), Math.max(...finite)] : [0, 1];
      };
      const x = span((series) => series.x), y = span((series) => series.y);
      const { width, height } = this.chart.chartArea;
      const unit = 1.06 * Math.max((x[1] - x[0]) / width, (y[1] - y[0]) / height) || 2 / Math.min(width, height);
      const around = ([lo, hi], length) => [(lo + hi - unit * length) / 2, (lo + hi + unit * length) / 2];
      const { scales } = this.chart.options;
      [scales.x.min, scales.x.max] = around(x, width);
      [scales.y.min, scales.y.max] = around(y, height);
      this.chart.update("none");
    }

    // What is written over the chart: where the run ended, the time, and the points that are read out.
    overlay() {
      return {
        id: "overlay",
        beforeDatasetsDraw: ({ ctx, chartArea: area, scales }) => {
          ctx.save();
          ctx.beginPath();
          ctx.rect(area.left, area.top, area.right - area.left, area.bottom - area.top);
          ctx.clip();
          for (const rule of this.panel.rules) this.drawRule(ctx, area, scales, rule);
          this.panel.series.forEach((series, k) => this.drawExtents(ctx, scales, series, colorOf(series, k)));
          ctx.restore();
        },
        afterDatasetsDraw: ({ ctx, chartArea: area, scales }) => {
          ctx.save();
          if (this.panel.over_time) {
            const x = scales.x.getPixelForValue(clock.time);
            ctx.strokeStyle = color("--ink");
            ctx.lineWidth = 1.2;
            ctx.beginPath();
            ctx.moveTo(x, area.top);
            ctx.lineTo(x, area.bottom);
            ctx.stroke();
          }
          this.panel.series.forEach((series, k) => {
            const i = this.at[k];
            if (i < 0 || !known(series.x[i]) || !known(series.y[i])) return;
            ctx.beginPath();
            ctx.arc(scales.x.getPixelForValue(series.x[i]), scales.y.getPixelForValue(series.y[i]), 4.5, 0, 7);
            ctx.fillStyle = colorOf(series, k);
            ctx.strokeStyle = color("--paper");
            ctx.lineWidth = 1.5;
            ctx.fill();
            ctx.stroke();
          });
          ctx.restore();
        },
      };
    }

    // Between where and where a value may be: as a band, or as bars at its points.
    drawExtents(ctx, { x: sx, y: sy }, series, ink) {
      ctx.save();
      ctx.strokeStyle = ctx.fillStyle = ink;
      if (series.band) {
        ctx.globalAlpha = 0.2;
        ctx.beginPath();
        series.x.forEach((x, i) => ctx.lineTo(sx.getPixelForValue(x), sy.getPixelForValue(series.band.upper[i])));
        for (let i = series.x.length - 1; i >= 0; --i) ctx.lineTo(sx.getPixelForValue(series.x[i]), sy.getPixelForValue(series.band.lower[i]));
        ctx.fill();
        ctx.globalAlpha = 1;
      }
      const bar = (x0, y0, x1, y1) => {
        ctx.beginPath();
        ctx.moveTo(sx.getPixelForValue(x0), sy.getPixelForValue(y0));
        ctx.lineTo(sx.getPixelForValue(x1), sy.getPixelForValue(y1));
        ctx.stroke();
      };
      const { x_error: across, y_error: up } = series;
      series.x.forEach((x, i) => {
        const y = series.y[i];
        if (up && known(up.lower[i]) && known(up.upper[i])) bar(x, up.lower[i], x, up.upper[i]);
        if (across && known(across.lower[i]) && known(across.upper[i])) bar(across.lower[i], y, across.upper[i], y);
      });
      ctx.restore();
    }

    drawRule(ctx, area, scales, rule) {
      const scale = rule.upright ? scales.x : scales.y;
      const limits = rule.upright ? [area.left, area.right] : [area.bottom, area.top];
      const inside = (value, missing) => {
        const pixel = known(value) ? scale.getPixelForValue(value) : missing;
        return Math.min(Math.max(pixel, Math.min(...limits)), Math.max(...limits));
      };
      const from = inside(rule.from, limits[0]), to = inside(rule.to, limits[1]);
      const [lo, hi] = [Math.min(from, to), Math.max(from, to)];
      ctx.save();
      ctx.globalAlpha = 0.22;
      ctx.fillStyle = ctx.strokeStyle = color("--bad");
      const thick = Math.max(hi - lo, 1.5);
      if (rule.upright) ctx.fillRect(lo, area.top, thick, area.bottom - area.top);
      else ctx.fillRect(area.left, lo, area.right - area.left, thick);
      ctx.globalAlpha = 1;
      ctx.fillStyle = color("--bad");
      ctx.font = `13px ${getComputedStyle(document.body).fontFamily}`;
      if (rule.upright) ctx.fillText(rule.label, lo + 6, area.top + 16, Math.max(area.right - lo - 8, 40));
      else ctx.fillText(rule.label, area.left + 6, lo - 4, area.right - area.left - 12);
      ctx.restore();
    }

    // ---- the time

    moveTo(time) {
      const { panel } = this;
      const first = panel.series.findIndex((series) => timesOf(panel, series));
      const own = timesOf(panel, panel.series[first]);
      const k = nearest(own, time);
      const moment = k < 0 ? time : own[k];
      panel.series.forEach((series, s) => {
        const times = timesOf(panel, series);
        this.at[s] = times ? nearest(times, moment) : -1;
      });
      this.read(`${moments(moment)} s`, moment);
      this.canvas.setAttribute("aria-valuenow", moment);
    }

    read(moment, time) {
      const { panel } = this;
      this.last = [moment, time];
      this.moment.textContent = moment;
      for (const { k, value } of this.values) {
        const series = panel.series[k], i = this.at[k];
        const times = timesOf(panel, series);
        value.hidden = false;
        value.disabled = i < 0;
        if (i < 0) { value.textContent = "–"; continue; }
        const y = this.numberOf(series, "y", i);
        const numbers = panel.over_time ? y : `${this.numberOf(series, "x", i)}, ${y}`;
        value.textContent = times && times[i] !== time && time !== undefined ? `${numbers} (at ${moments(times[i])} s)` : numbers;
      }
      this.canvas.setAttribute("aria-valuetext", `${moment}: ${this.values.map(({ item }) => item.textContent).join("; ")}`);
      this.chart.draw();
    }

    // The point that is nearest on the screen; along the time, the nearest output.
    pointAt(event) {
      const { panel, chart } = this;
      const box = this.canvas.getBoundingClientRect();
      const x = event.clientX - box.left, y = event.clientY - box.top;
      const { x: sx, y: sy } = chart.scales;
      if (panel.over_time) {
        this.setTime(sx.getValueForPixel(x));
        return;
      }
      let best = null;
      panel.series.forEach((series, s) => series.x.forEach((value, i) => {
        if (!known(value) || !known(series.y[i])) return;
        const distance = Math.hypot(sx.getPixelForValue(value) - x, sy.getPixelForValue(series.y[i]) - y);
        if (!best || distance < best.distance) best = { distance, s, i };
      }));
      if (best) this.pick(best.s, best.i);
    }

    pick(s, i) {
      const times = timesOf(this.panel, this.panel.series[s]);
      if (times) {
        this.setTime(times[i]);
        return;
      }
      this.at.fill(-1);
      this.at[s] = i;
      this.read(this.panel.series[s].label);
    }

    setTime(time) {
      if (plumb.player) plumb.player.stop();
      const times = timesOf(this.panel, this.panel.series.find((series) => timesOf(this.panel, series)));
      const k = nearest(times, time);
      if (k >= 0) clock.set(times[k]);
    }

    key(event) {
      const steps = { ArrowRight: 1, ArrowUp: 1, ArrowLeft: -1, ArrowDown: -1, PageUp: 10, PageDown: -10, Home: -Infinity, End: Infinity };
      const by = steps[event.key];
      if (by === undefined) return;
      event.preventDefault();
      const s = this.timed ? this.panel.series.findIndex((series) => timesOf(this.panel, series)) : Math.max(this.at.findIndex((i) => i >= 0), 0);
      const last = this.panel.series[s].x.length - 1;
      this.pick(s, Math.min(Math.max(this.at[s] + by, 0), last));
    }

    // ---- light and dark

    paintSamples() {
      for (const { sample, k } of this.values) sample.style.setProperty("--sample", colorOf(this.panel.series[k], k));
    }

    restyle() {
      const { x, y } = this.chart.options.scales;
      const ranges = [x.min, x.max, y.min, y.max];
      Object.assign(this.chart.options, this.options());
      const scales = this.chart.options.scales;
      [scales.x.min, scales.x.max, scales.y.min, scales.y.max] = ranges;
      this.chart.data.datasets = this.datasets();
      this.paintSamples();
      this.chart.update("none");
    }
  }

  plumb.charts = [];
  for (const figure of document.querySelectorAll("figure.plot")) {
    const shown = data.figures.find(({ file }) => file === figure.dataset.file);
    const drawable = shown && shown.chart && shown.panels.length && shown.panels.every((panel) => panel.only_series && panel.series.length);
    if (!drawable) continue;
    const picture = figure.querySelector("img");
    const group = { axisWidth: leastAxisWidth };
    const charts = shown.panels.map((panel) => new PanelChart(panel, picture.alt, group));
    figure.prepend(make("div", { className: "chart screen" }, ...charts.map((chart) => chart.node)));
    picture.classList.add("paper");
    for (const chart of charts) chart.begin();
    for (const chart of charts) chart.chart.update("none");
    plumb.charts.push(...charts);
  }
})();
