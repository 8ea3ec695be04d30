// Tables are sorted by a click on a column's head, and long ones filtered by words.
{
  const enough_to_sort = 4, enough_to_filter = 9;  // rows

  // "12 %" and "~3.5 ns" sort as numbers; what has no number comes last.
  const value_of = (cell) => {
    const text = cell.dataset.sort ?? cell.textContent.trim();
    const number = parseFloat(text.replace(/^[<>~±≈ ]+/, "").replace(/(\d)[\s\u202f](?=\d{3})/g, "$1"));
    return { text, number: Number.isNaN(number) ? Infinity : number };
  };
  const compare = (a, b) => (a.number === b.number ? a.text.localeCompare(b.text) : a.number - b.number);

  function sort_by(table, column, head) {
    const rows = [...table.tBodies[0].rows];
    const direction = head.getAttribute("aria-sort") === "ascending" ? "descending" : "ascending";
    for (const other of table.tHead.rows[0].cells) other.removeAttribute("aria-sort");
    head.setAttribute("aria-sort", direction);
    const sign = direction === "ascending" ? 1 : -1;
    rows.sort((a, b) => sign * compare(value_of(a.cells[column]), value_of(b.cells[column])));
    table.tBodies[0].append(...rows);
  }

  for (const table of document.querySelectorAll(".scroll > table")) {
    const heads = table.tHead?.rows.length === 1 ? [...table.tHead.rows[0].cells] : [];
    const rows = [...(table.tBodies[0]?.rows ?? [])];
    const regular = table.tBodies.length === 1 && rows.every((row) => row.cells.length === heads.length);
    if (!regular || rows.length < enough_to_sort) continue;
    heads.forEach((head, column) => {
      if (!head.textContent.trim()) return;
      // A formula is no name for those who hear the page.
      const pressed = button("", () => sort_by(table, column, head), { class: "sort", "aria-label": head.textContent.trim() });
      pressed.append(...head.childNodes);
      head.append(pressed);
    });
    if (rows.length < enough_to_filter) continue;
    const words = element("input", { type: "search", placeholder: "only rows with ...", "aria-label": "only rows with these words" });
    words.addEventListener("input", () => {
      const wanted = words.value.toLowerCase().split(/\s+/);
      for (const row of rows) row.hidden = !wanted.every((word) => row.textContent.toLowerCase().includes(word));
    });
    table.parentElement.before(element("div", { class: "controls" }, words));
  }
}
