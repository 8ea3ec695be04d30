// Fits a formula's slide: the formula as large as fits, with the paragraph that derives it and a drawing of what it is about.

const fitted_derivation = (() => {
  const { overflows, measures_of, has_labels, legible_width, labels_are_legible } = slide_measures;

  // The formula as large as fits beside or above the drawing; null where it cannot be `least`, or the labels become too small.
  function derivation_in(show, visual, place, { largest, least, words = 1 }) {
    const slide = show(visual), stage = slide.querySelector(".stage"), reasoning = stage.querySelector(".reasoning");
    const drawing = stage.querySelector(".frame > *");
    visual.classList.add(place);
    visual.style.setProperty("--words", words);
    if (drawing && has_labels(drawing)) visual.style.setProperty("--legible", `${legible_width(drawing)}px`);
    for (let size = largest; size > least - 0.01; size -= 0.1) {
      stage.style.setProperty("--formula", size);
      if (!overflows(stage) && !overflows(reasoning) && (!drawing || labels_are_legible(drawing))) return slide;
    }
    slide.remove();
    return null;
  }

  // Of the drawings the first that leaves room for the formula and its paragraph: beside them, or below if it is wide. What the
  // slide's own sentence tells needs no paragraph beside a drawing. Without one there is room for the paragraph that follows, and
  // for larger letters.
  return (show, visual) => {
    const drawings = [...visual.querySelectorAll("figure")], is_told = visual.classList.contains("told");
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
    const with_drawing = (words) => drawings.flatMap((drawing, i) => [1.3, 1].flatMap((least) =>
      places(drawing).map((place) => [with_only(i, words), place, { largest: 1.7, least }])));
    const alone = (said, words, least) => [with_only(null, said), "alone", { largest: 2.2, least, words }];
    const ways = [...with_drawing(".before"), ...(is_told ? with_drawing(".none") : []),
      ...[1.4, 1.2].map((words) => alone(".before, .after", words, 1.5 * words)), alone(".before, .after", 1, 1),
      ...[1.4, 1.2].map((words) => alone(".before", words, 1.5 * words)), alone(".before", 1, 1), alone(".none", 1, 1)];
    for (const way of ways) {
      const slide = derivation_in(show, ...way);
      if (slide) return slide;
    }
    return show(with_only(null, ".none"));
  };
})();
