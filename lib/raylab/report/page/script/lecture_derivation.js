// Fits a formula's slide: the formula as large as fits, with the paragraph that derives it and a drawing of what it is about.

// `show` is that of fitted_slides() (lecture_fit.js), whose measuring functions it takes.
const fitting_of_derivations = ({ overflows, measures_of }) => {
  const scale_of_legible = (drawing) => (innerHeight * smallest_label) / measures_of(drawing).label;
  const width_of_legible = (drawing) => Math.ceil(scale_of_legible(drawing) * measures_of(drawing).width);

  function labels_are_legible(drawing) {
    if (!drawing.matches("img[data-label], svg")) return true;
    const { width, height } = measures_of(drawing), box = drawing.parentElement;
    return Math.min(box.clientWidth / width, box.clientHeight / height) >= scale_of_legible(drawing) - 1e-3;
  }

  // The formula as large as fits beside or above the drawing; null where it cannot be `least`, or the labels become too small.
  function derivation_in(show, visual, place, { largest, least }) {
    const slide = show(visual), stage = slide.querySelector(".stage"), reasoning = stage.querySelector(".reasoning");
    const drawing = stage.querySelector(".frame > *");
    visual.classList.add(place);
    if (drawing?.matches("img[data-label], svg")) visual.style.setProperty("--legible", `${width_of_legible(drawing)}px`);
    for (let size = largest; size > least - 0.01; size -= 0.1) {
      stage.style.setProperty("--formula", size);
      if (!overflows(stage) && !overflows(reasoning) && (!drawing || labels_are_legible(drawing))) return slide;
    }
    slide.remove();
    return null;
  }

  // Of the drawings the first that leaves room for the formula and its paragraph: beside them, or below if it is wide. Without one
  // there is room for the paragraph that follows.
  return (show, visual) => {
    const drawings = [...visual.querySelectorAll("figure")];
    const with_only = (kept, words) => {
      const copy = visual.cloneNode(true);
      [...copy.querySelectorAll("figure")].forEach((figure, i) => i !== kept && figure.remove());
      for (const left_out of copy.querySelectorAll(`.reasoning > p:not(${words})`)) left_out.remove();
      return copy;
    };
    const places = (drawing) => {
      const { width, height } = measures_of(drawing.querySelector("img, svg"));
      return width > 1.9 * height ? ["below", "beside"] : ["beside", "below"];
    };
    const ways = drawings.flatMap((drawing, i) => [1.3, 1].flatMap((least) =>
      places(drawing).map((place) => [with_only(i, ".before"), place, { largest: 1.7, least }])));
    for (const words of [".before, .after", ".before", ".none"]) ways.push([with_only(null, words), "alone", { largest: 2.2, least: 1 }]);
    for (const way of ways) {
      const slide = derivation_in(show, ...way);
      if (slide) return slide;
    }
    return show(with_only(null, ".none"));
  };
};
