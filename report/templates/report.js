// What the other scripts of the page share: its data, and how they make elements. The page asks nothing of anywhere;
// without scripts it shows the same as drawn pictures and plain tables.
const plumb = (() => {
  "use strict";
  const make = (name, properties = {}, ...children) => {
    const node = document.createElement(name);
    for (const [key, value] of Object.entries(properties)) {
      if (key in node) node[key] = value;
      else node.setAttribute(key, value);
    }
    node.append(...children);
    return node;
  };
  const button = (text, act, properties = {}) => {
    const node = make("button", { type: "button", textContent: text, ...properties });
    node.addEventListener("click", act);
    return node;
  };
  // Which section is being read, in the column of contents.
  const links = new Map([...document.querySelectorAll(".contents a")].map((link) => [document.querySelector(link.hash), link]));
  links.delete(null);
  const watch = new IntersectionObserver(() => {
    const passed = [...links.keys()].filter((section) => section.getBoundingClientRect().top < innerHeight / 3);
    for (const [section, link] of links) {
      if (section === passed[passed.length - 1]) link.setAttribute("aria-current", "true");
      else link.removeAttribute("aria-current");
    }
  }, { rootMargin: "0px 0px -66% 0px" });
  for (const section of links.keys()) watch.observe(section);
  return { data: JSON.parse(document.getElementById("page-data").textContent), make, button };
})();
