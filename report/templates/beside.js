// Two pictures over one another with a slider between them; without scripts they stand side by side.
(() => {
  "use strict";
  const { make } = plumb;
  for (const pair of document.querySelectorAll("figure.pair")) {
    const slider = make("input", { type: "range", min: 0, max: 100, value: 50, className: "screen" });
    slider.setAttribute("aria-label", pair.querySelector("figcaption").textContent);
    const cut = () => pair.style.setProperty("--cut", `${slider.value}%`);
    slider.addEventListener("input", cut);
    cut();
    pair.classList.add("sliding");
    pair.querySelector(".pair-pictures").after(slider);
  }
})();
