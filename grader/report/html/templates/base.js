"use strict";
// The switch between light and dark; without it the page follows the system.
(() => {
  const button = document.getElementById("theme"), root = document.documentElement;
  button.addEventListener("click", () => {
    const system = matchMedia("(prefers-color-scheme: dark)").matches ? "dark" : "light";
    root.dataset.theme = (root.dataset.theme || system) === "dark" ? "light" : "dark";
  });
  button.hidden = false;
})();
