// Fits a slide's visual to the screen: text is never smaller than 1/30 of its height, labels in drawings never than 1/50.
// What does not fit at that size is cut: a table or listing into further slides, a drawing into enlarged parts.

// A slide for each piece of the visual; `show(visual, kind)` puts it on the screen, to be measured, and returns the slide.
const fitted_slides = (() => {
  const { overflows } = slide_measures;

  // How many of the rows, from `first` on, fit on a screen.
  function rows_that_fit(rows, first, box, most) {
    const shown = (end) => rows.forEach((row, i) => (row.hidden = i < first || i >= end));
    let fit = first + 1, too_many = Math.min(rows.length, first + most) + 1;
    while (too_many - fit > 1) {
      const middle = Math.floor((fit + too_many) / 2);
      shown(middle);
      if (overflows(box)) too_many = middle;
      else fit = middle;
    }
    shown(fit);
    return fit;
  }

  function cut_at(show, visual, rows_of, most) {
    const slides = [];
    let first = 0, count = 1;
    while (first < count) {
      const copy = visual.cloneNode(true);
      const slide = show(copy);
      const rows = rows_of(copy);
      count = rows.length;
      first = rows_that_fit(rows, first, slide.querySelector(".stage"), most);
      for (const row of rows) if (row.hidden) row.remove();
      slides.push(slide);
    }
    return { slides, count };
  }

  // As few slides as do, about equally long: no last row stands alone.
  function cut_rows(show, visual, rows_of) {
    const { slides, count } = cut_at(show, visual, rows_of, Infinity);
    if (slides.length < 2) return slides;
    const even = cut_at(show, visual, rows_of, Math.ceil(count / slides.length)).slides;
    const [kept, other] = even.length > slides.length ? [slides, even] : [even, slides];
    for (const slide of other) slide.remove();
    return kept;
  }

  // The lines of a listing, each an element that can be hidden.
  function lines_of(listing) {
    const code = listing.querySelector("code") ?? listing;
    if (!code.querySelector(".line")) code.replaceChildren(...code.textContent.trimEnd().split("\n").map((words) => line_of({ words })));
    return [...code.querySelectorAll(".line")];
  }

  const line_of = ({ words, remark }) => element("span", { class: remark ? "line remark" : "line" }, words + "\n");

  // The listing with lines of at most so many letters as the stage is wide (listing_lines.js).
  function with_broken_lines(show, visual) {
    const slide = show(visual.cloneNode(true)), code = slide.querySelector(".stage pre > code"), listing = code.parentElement;
    const ruler = element("span", {}, "0".repeat(10));
    code.replaceChildren(ruler);
    const { paddingLeft, paddingRight } = getComputedStyle(listing);
    const room = slide.querySelector(".stage").clientWidth - parseFloat(paddingLeft) - parseFloat(paddingRight);
    const columns = Math.floor((10 * room) / ruler.getBoundingClientRect().width);
    slide.remove();
    const broken = visual.cloneNode(true), text = broken.querySelector("code"), lines = text.textContent.trimEnd().split("\n");
    const whole = broken.matches(".excerpt") ? statements_of(lines) : lines;  // pseudo-code has no continued lines
    text.replaceChildren(...whole.flatMap((line) => lines_within(line, columns)).map(line_of));
    return broken;
  }

  // Text and formulas are as large as fits; absent where they do not even fit at the smallest size.
  function enlarged(show, visual, largest) {
    const slide = show(visual.cloneNode(true));
    const stage = slide.querySelector(".stage"), unwrapped = stage.querySelector(".unwrapped");
    for (let size = largest; size > 0.99; size -= 0.1) {
      stage.style.setProperty("--enlarged", size);
      if (!overflows(stage) && !(unwrapped && overflows(unwrapped))) return slide;
    }
    slide.remove();
    return null;
  }

  function enlarged_or_cut(show, visual, rows_of, largest = 1.4) {
    const slide = enlarged(show, visual, largest);
    return slide ? [slide] : cut_rows(show, visual, rows_of);
  }

  const body_rows = (table) => [...table.querySelectorAll("tbody > tr")];

  function table_slides(show, visual) {
    const table = fitted_table.with_whole_quantities(visual), slide = fitted_table.in_best_way(show, table);
    return slide ? [slide] : cut_rows(show, fitted_table.narrow_enough(show, table), body_rows);
  }

  function listing_slides(show, visual) {
    // Better somewhat smaller than with broken lines.
    const unwrapped = (listing) => {
      (listing.matches("pre") ? listing : listing.querySelector("pre")).classList.add("unwrapped");
      return listing;
    };
    const slide = enlarged(show, unwrapped(visual.cloneNode(true)), 1.4);
    return slide ? [slide] : enlarged_or_cut(show, unwrapped(with_broken_lines(show, visual)), lines_of);
  }

  function illustrated_slides(show, visual) {
    const [content] = visual.children;
    if (content.matches("ul, ol")) {
      const slide = fitted_beside.fitted_list(show, visual);
      return slide ? [slide] : cut_rows(show, content, (copy) => [...copy.children]);
    }
    const slides = table_slides(show, content);
    return slides.length > 1 ? slides : [fitted_beside.fitted_narrow_table(show, visual, slides[0])];
  }

  function case_slides(show, visual) {
    const drawings = visual.firstElementChild, table = fitted_table.with_whole_quantities(visual.lastElementChild);
    const slide = fitted_beside.fitted_case(show, drawings, table);
    if (slide) return [slide];
    if (drawings.children.length === 1) {
      // It stays in sight beside each part of the table.
      const beside = fitted_beside.with_case_drawings(show, drawings, "beside");
      const slides = cut_rows(beside, fitted_table.narrow_enough(beside, table), body_rows);
      if (slides.every((one) => fitted_beside.are_legible(one) && !overflows(one.querySelector(".stage")))) return slides;
      for (const one of slides) one.remove();
    }
    const drawn = drawings.children.length > 1 ? [fitted_pictures(show, drawings)] : fitted_drawing(show, drawings.firstElementChild);
    return [...drawn, ...table_slides(show, table)];
  }

  return (visual, show) => {
    if (visual.matches(".scroll, .choices")) return table_slides(show, visual);
    if (visual.matches("ul, ol")) return enlarged_or_cut(show, visual, (copy) => [...copy.children]);
    if (visual.matches("pre, .excerpt")) return listing_slides(show, visual);
    if (visual.matches(".derivation")) return [fitted_derivation(show, visual)];
    if (visual.matches(".illustrated")) return illustrated_slides(show, visual);
    if (visual.matches(".whole-case")) return case_slides(show, visual);
    if (visual.matches("figure")) return fitted_drawing(show, visual);
    if (visual.matches(".figures")) return [fitted_pictures(show, visual)];
    return [show(visual.cloneNode(true))];
  };
})();
