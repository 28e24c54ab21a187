// The animation as a player. Its frames are those of the animated PNG that the page shows without scripts: each is a
// whole picture, so it becomes a PNG of its own by taking its data under the header of all.
(() => {
  "use strict";
  const { data, make, button, clock } = plumb;
  const figure = document.querySelector(".motion-figure");
  const moving = figure && figure.querySelector("img.moving");
  if (!moving || !moving.src.startsWith("data:image/png;base64,")) return;

  // ---- frames (W3C, Portable Network Graphics, third edition, sections 5 and 11.3.6)

  const table = Uint32Array.from({ length: 256 }, (_, n) => {
    for (let k = 0; k < 8; ++k) n = n & 1 ? 0xedb88320 ^ (n >>> 1) : n >>> 1;
    return n;
  });
  const checkSum = (bytes) => {
    let sum = 0xffffffff;
    for (const byte of bytes) sum = table[(sum ^ byte) & 255] ^ (sum >>> 8);
    return ~sum >>> 0;
  };

  const chunk = (type, body) => {
    const bytes = new Uint8Array(body.length + 12);
    const view = new DataView(bytes.buffer);
    view.setUint32(0, body.length);
    for (let k = 0; k < 4; ++k) bytes[4 + k] = type.charCodeAt(k);
    bytes.set(body, 8);
    view.setUint32(body.length + 8, checkSum(bytes.subarray(4, body.length + 8)));
    return bytes;
  };

  // Each frame as the bodies of its data chunks.
  const split = (bytes) => {
    const view = new DataView(bytes.buffer);
    const frames = [];
    let header = null;
    for (let at = 8; at + 12 <= bytes.length; at += 12 + view.getUint32(at)) {
      const type = String.fromCharCode(...bytes.subarray(at + 4, at + 8));
      const body = bytes.subarray(at + 8, at + 8 + view.getUint32(at));
      if (type === "IHDR") header = body;
      else if (type === "fcTL") frames.push([]);
      else if (type === "IDAT" && frames.length) frames[frames.length - 1].push(body);
      else if (type === "fdAT") frames[frames.length - 1].push(body.subarray(4));
    }
    return { header, frames };
  };

  const text = atob(moving.src.slice(moving.src.indexOf(",") + 1));
  const { header, frames } = split(Uint8Array.from(text, (c) => c.charCodeAt(0)));
  if (frames.length < 2) return;
  const signature = Uint8Array.of(137, 80, 78, 71, 13, 10, 26, 10);
  const png = (k) =>
    new Blob([signature, chunk("IHDR", header), ...frames[k].map((body) => chunk("IDAT", body)), chunk("IEND", new Uint8Array(0))],
      { type: "image/png" });

  // Decoded when first seen; the last ones are kept.
  const kept = new Map();
  const most = 64;
  const picture = (k) => {
    if (!kept.has(k)) {
      if (kept.size >= most) kept.delete(kept.keys().next().value);
      kept.set(k, createImageBitmap(png(k)));
    }
    return kept.get(k);
  };

  // ---- elements

  const last = frames.length - 1;
  const timeOf = (k) => Math.min(k / data.frame_rate, clock.end);
  const frameAt = (time) => Math.min(Math.round(time * data.frame_rate), last);

  // Of the frames' own size; the page scales it.
  const size = new DataView(header.buffer, header.byteOffset);
  const canvas = make("canvas", { width: size.getUint32(0), height: size.getUint32(4), role: "img" });
  const slider = make("input", { type: "range", min: 0, max: last, step: 1, value: 0, id: "player-time" });
  slider.setAttribute("aria-label", "Time of the animation");
  const play = button("Play", () => (playing ? stop() : start()), { className: "play" });
  const back = button("◂", () => step(-1), { "aria-label": "One frame back" });
  const on = button("▸", () => step(1), { "aria-label": "One frame on" });
  const speed = make("select");
  for (const s of [0.1, 0.25, 0.5, 1, 2]) speed.append(make("option", { value: s, textContent: `${s}×`, selected: s === 1 }));
  const shown = make("output", { className: "player-shown" });
  const player = make("div", { className: "player screen" },
    canvas,
    make("div", { className: "player-bar" }, play, back, slider, on),
    make("div", { className: "player-bar" }, make("label", {}, "Speed ", speed), shown));
  player.setAttribute("role", "group");
  player.setAttribute("aria-label", "Player of the animation");
  shown.setAttribute("aria-live", "polite");

  // ---- showing

  // What is decoded late is drawn all the same, but never over what was asked for after it.
  let frame = -1, asked = 0, drawn = 0;
  const show = async (k) => {
    if (k === frame) return;
    frame = k;
    const turn = ++asked;
    const bitmap = await picture(k);
    if (turn < drawn) return;
    drawn = turn;
    canvas.getContext("2d").drawImage(bitmap, 0, 0);
    canvas.setAttribute("aria-label", `The cable at ${timeOf(k).toFixed(2)} s`);
    canvas.dataset.frame = k;
  };
  clock.follow((time) => {
    const k = frameAt(time);
    slider.value = k;
    const words = `${Number(time.toPrecision(4))} s of ${Number(clock.end.toPrecision(4))} s, frame ${k} of ${last}`;
    slider.setAttribute("aria-valuetext", words);
    shown.textContent = words;
    show(k);
  });
  slider.addEventListener("input", () => {
    stop();
    clock.set(timeOf(Number(slider.value)));
  });
  const step = (by) => {
    stop();
    clock.set(timeOf(Math.min(Math.max(frameAt(clock.time) + by, 0), last)));
  };

  // ---- playing

  let playing = 0;
  const stop = () => {
    if (!playing) return;
    cancelAnimationFrame(playing);
    playing = 0;
    play.textContent = "Play";
    shown.setAttribute("aria-live", "polite");
  };
  const start = () => {
    if (clock.time >= clock.end) clock.set(0);
    play.textContent = "Pause";
    // What changes many times a second is not to be read out.
    shown.setAttribute("aria-live", "off");
    let before = performance.now();
    const tick = (now) => {
      const time = clock.time + ((now - before) / 1000) * Number(speed.value);
      before = now;
      playing = requestAnimationFrame(tick);
      clock.set(time);
      if (time >= clock.end) stop();
    };
    playing = requestAnimationFrame(tick);
  };
  plumb.player = { stop, get playing() { return playing !== 0; } };

  moving.hidden = true;
  figure.prepend(player);

  // It plays once, when it is first seen, unless its reader wants stillness.
  if (window.matchMedia("(prefers-reduced-motion: reduce)").matches) return;
  const seen = new IntersectionObserver((entries) => {
    if (!entries.some((entry) => entry.isIntersecting)) return;
    seen.disconnect();
    // From its first frame on, which is there before the others move it on.
    picture(0).then(() => { if (clock.time === 0) start(); });
  }, { threshold: 0.6 });
  seen.observe(canvas);
})();
