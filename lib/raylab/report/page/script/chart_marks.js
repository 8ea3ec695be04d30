// A mark of a chart under the mouse, or chosen with the arrow keys, says what it measured; the other methods step back.
for (const chart of document.querySelectorAll("figure.chart:has(svg [data-method])")) {
  const drawing = chart.querySelector("svg"), marks = [...drawing.querySelectorAll("[data-method]")];
  const words = element("output", { class: "mark" }, "Point at a mark, or choose one with the arrow keys.");
  let chosen = -1;

  const show = (mark) => {
    for (const other of marks) other.classList.toggle("faint", Boolean(mark) && other.dataset.method !== mark.dataset.method);
    if (mark) words.textContent = mark.querySelector("title")?.textContent ?? mark.dataset.method;
  };
  drawing.tabIndex = 0;
  drawing.dataset.ownKeys = "";
  drawing.addEventListener("pointerover", (event) => show(event.target.closest("[data-method]")));
  drawing.addEventListener("pointerleave", () => show(null));
  drawing.addEventListener("blur", () => show(null));
  drawing.addEventListener("keydown", (event) => {
    const step = { ArrowRight: 1, ArrowDown: 1, ArrowLeft: -1, ArrowUp: -1 }[event.key];
    if (!step) return;
    event.preventDefault();
    chosen = (chosen + step + marks.length) % marks.length;
    show(marks[chosen]);
  });
  chart.querySelector("figcaption")?.prepend(words);
}
