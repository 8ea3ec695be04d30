// Fits what may stand beside a drawing: a list, a narrow table, what came of a case.

const fitted_beside = (() => {
  const { overflows, measures_of, has_labels, legible_width, labels_are_legible, scale_of } = slide_measures;
  const least_height = 0.3;  // of the stage, for what is drawn

  function are_legible(slide) {
    const least = least_height * slide.querySelector(".stage").clientHeight;
    return [...slide.querySelectorAll(".frame > *")].every((drawing) =>
      labels_are_legible(drawing) && scale_of(drawing) * measures_of(drawing).height >= least);
  }

  // The slides on which `content`, as it is on the screen by `fit(show)`, has a drawing of `visual` beside or below; null: none.
  function with_drawing(show, visual, fit) {
    for (const figure of visual.querySelectorAll(":scope > figure")) {
      const { width, height } = measures_of(figure.querySelector("img, svg"));
      for (const place of width > 1.9 * height ? ["below", "beside"] : ["beside", "below"]) {
        const slide = fit((content) => {
          const both = element("div", { class: `illustrated ${place}` }, content, figure.cloneNode(true)), slide = show(both);
          const drawing = both.querySelector(".frame > *");
          if (has_labels(drawing)) both.style.setProperty("--legible", `${legible_width(drawing)}px`);
          return slide;
        });
        if (slide) return slide;
      }
    }
    return null;
  }

  // A list as large as fits, at least so large.
  function list_of_size(show, list, least) {
    const copy = list.cloneNode(true), slide = show(copy), stage = slide.querySelector(".stage");
    for (let size = 1.4; size > least - 0.01; size -= 0.1) {
      stage.style.setProperty("--enlarged", size);
      if (!overflows(stage) && !overflows(copy) && are_legible(slide)) return slide;
    }
    slide.remove();
    return null;
  }

  // Better few words in each item than small ones.
  function fitted_list(show, visual) {
    const list = visual.querySelector(":scope > :is(ul, ol)");
    for (const items of [list, with_short_items(list)]) {
      const slide = with_drawing(show, visual, (show_beside) => list_of_size(show_beside, items, 1.1)) ?? list_of_size(show, items, 1.2);
      if (slide) return slide;
    }
    return list_of_size(show, with_short_items(list), 1);
  }

  // A drawing beside a table that would leave nearly half of the screen empty.
  function fitted_narrow_table(show, visual, alone) {
    const table = visual.querySelector(":scope > .scroll"), shown = alone.querySelector(".stage table");
    if (shown.clientWidth > 0.6 * alone.querySelector(".stage").clientWidth) return alone;
    const slide = with_drawing(show, visual, (show_beside) => fitted_table.in_best_way(show_beside, table, [{ kept: "whole-cells", lines: 2, largest: 1.7 }], are_legible));
    if (slide) alone.remove();
    return slide ?? alone;
  }

  // Puts a table below a case's drawings, or beside them.
  const with_case_drawings = (show, drawings, place) => (table) => {
    const both = element("div", { class: `whole-case ${place}` }, drawings.cloneNode(true), table), slide = show(both);
    const widths = [...both.querySelectorAll(".frame > *")].filter(has_labels).map(legible_width);
    both.style.setProperty("--legible", `${Math.max(0, ...widths)}px`);
    return slide;
  };

  // A case's drawings above its table, or beside it; null where that is too much for a slide.
  function fitted_case(show, drawings, table) {
    const in_place = (place, ways) => fitted_table.in_best_way(with_case_drawings(show, drawings, place), table, ways, are_legible);
    return in_place("below", [{ kept: "whole-cells", lines: 2, largest: 1.3 }]) ??
      in_place("beside", [{ kept: "whole-cells", lines: 2, largest: 1.3 }, { kept: "whole-heads", lines: 2, largest: 1.3 }]) ??
      in_place("below", [{ kept: "whole-heads", lines: 2, largest: 1.3 }]) ??
      in_place("beside", [{ kept: "whole-heads", lines: 3, largest: 1.1 }, { kept: "whole-heads dense", lines: 3, largest: 1.1 }]);
  }

  return { fitted_list, fitted_narrow_table, fitted_case, with_case_drawings, are_legible };
})();
