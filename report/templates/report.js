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
  return { data: JSON.parse(document.getElementById("page-data").textContent), make, button };
})();
