// Fits a table: better smaller letters than cells of several lines, and better both than a table in pieces.

const fitted_table = (() => {
  const { overflows } = slide_measures;

  // A number stays in one line with its unit and its exponent. What was expected stands in the next column.
  function with_whole_quantities(table) {
    const copy = table.cloneNode(true), texts = document.createTreeWalker(copy, NodeFilter.SHOW_TEXT);
    while (texts.nextNode())
      texts.currentNode.data = texts.currentNode.data.replace(/(\d) (?=(%|ppm|ulp|rad|m|s|ms|us|ns|MB)(?![\w.]))/g, "$1\u00a0")
        .replace(/(\de)-(?=\d)/g, "$1\u2011");
    for (const verdict of copy.querySelectorAll(".verdict")) verdict.textContent = verdict.textContent.replace(", as expected", "");
    return copy;
  }

  const lines_in = (row) => {
    const { paddingTop, paddingBottom, lineHeight } = getComputedStyle(row.cells[0]);
    return Math.round((row.clientHeight - parseFloat(paddingTop) - parseFloat(paddingBottom)) / parseFloat(lineHeight));
  };
  const most_lines = (table) => Math.max(...[...table.querySelectorAll("tbody > tr")].map(lines_in));

  // The best first: what is kept in one line, how many lines a row may have, and between which sizes.
  const ways = [
    { kept: "whole-cells", lines: 2, largest: 1.7 }, { kept: "whole-heads", lines: 2, largest: 1.7 },
    { kept: "whole-cells dense", lines: 2, largest: 1.2 }, { kept: "whole-heads dense", lines: 2, largest: 1.2 },
    { kept: "whole-heads", lines: Infinity, largest: 1.7 }, { kept: "", lines: Infinity, largest: 1.7 },
    { kept: "dense", lines: Infinity, largest: 1.2 },
  ];

  // The first of the ways that fits: `show(table)` puts it on a screen, `also` is what else must hold there.
  function in_best_way(show, table, choices = ways, also = () => true) {
    for (const { kept, lines, largest } of choices) {
      const copy = table.cloneNode(true);
      copy.classList.add(...kept.split(" ").filter(Boolean));
      const slide = show(copy), stage = slide.querySelector(".stage");
      for (let size = largest; size > 0.99; size -= 0.1) {
        stage.style.setProperty("--enlarged", size);
        if (!overflows(stage) && !overflows(copy) && most_lines(copy) <= lines && also(slide, copy)) return slide;
      }
      slide.remove();
    }
    return null;
  }

  // For a table in pieces: what may be kept in one line at the smallest size.
  function narrow_enough(show, table) {
    for (const kept of ["whole-cells", "whole-heads"]) {
      const copy = table.cloneNode(true);
      copy.classList.add(kept);
      const slide = show(copy), stage = slide.querySelector(".stage"), fits = [stage, copy].every((box) => box.scrollWidth <= box.clientWidth + 1);
      slide.remove();
      if (fits) return copy;
    }
    return table;
  }

  return { with_whole_quantities, in_best_way, narrow_enough };
})();
