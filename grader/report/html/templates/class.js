"use strict";
(() => {
  const byId = (id) => document.getElementById(id);
  const table = byId("class"), body = table.tBodies[0], rows = [...body.rows];
  const find = byId("find"), check = byId("check"), shown = byId("shown");
  const columns = [...table.tHead.rows[0].cells];
  const names = columns.map((cell) => cell.textContent);

  const show = () => {
    const wanted = find.value.trim().toLowerCase(), column = names.indexOf(check.value, 3);
    let count = 0;
    for (const row of rows) {
      const named = row.cells[0].textContent.toLowerCase().includes(wanted);
      const failed = check.value === "!" ? row.className === "withheld" : column < 0 || row.cells[column].className === "f";
      row.hidden = !(named && failed);
      count += named && failed;
    }
    shown.textContent = shown.dataset.words.replace("{count}", count);
  };

  const value = (row, column) => {
    const text = row.cells[column].textContent;
    if (column === 0) return text.toLowerCase();
    const number = parseFloat(text);
    return Number.isNaN(number) ? -1 : number;
  };
  const sort = (column) => {
    const cell = columns[column], up = cell.getAttribute("aria-sort") !== "ascending";
    for (const other of columns.slice(0, 3)) other.setAttribute("aria-sort", "none");
    cell.setAttribute("aria-sort", up ? "ascending" : "descending");
    const keyed = rows.map((row, place) => [value(row, column), place, row]);
    keyed.sort(([a, i], [b, j]) => (a < b ? -1 : a > b ? 1 : 0) * (up ? 1 : -1) || i - j);
    body.append(...keyed.map(([, , row]) => row));
  };
  columns.slice(0, 3).forEach((cell, column) => {
    const button = document.createElement("button");
    button.type = "button";
    button.textContent = cell.textContent;
    button.addEventListener("click", () => sort(column));
    cell.replaceChildren(button);
  });

  byId("save").addEventListener("click", () => {
    const { head, first, words } = JSON.parse(byId("csv").textContent);
    const line = (row, place) => [first[place],
      ...[...row.cells].slice(3).map((cell) => words[cell.className])].join(",");
    const text = "\ufeff" + [head, ...rows.map(line), ""].join("\r\n");
    const link = document.createElement("a");
    link.href = URL.createObjectURL(new Blob([text], { type: "text/csv" }));
    link.download = "class.csv";
    link.click();
    setTimeout(() => URL.revokeObjectURL(link.href), 1000);
  });

  byId("filter").addEventListener("submit", (event) => event.preventDefault());
  find.addEventListener("input", show);
  check.addEventListener("change", show);
  byId("filter").hidden = false;
  show();
})();
