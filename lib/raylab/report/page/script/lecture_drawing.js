// Fits a drawing: one whose labels would be too small is shown as a whole, then enlarged part by part.

const fitted_drawing = (() => {
  const { measures_of, legible_scale, scale_of } = slide_measures;

  // Where a drawing may be cut across so that both parts are at most `most` high, in its own units: next to the middle, between
  // what is drawn above and below. Null where there is no such place.
  function quiet_cut(drawing, most) {
    const { height } = measures_of(drawing), to_screen = drawing.getScreenCTM?.();
    if (!to_screen) return null;
    const marks = [...drawing.querySelectorAll("text, path, line, rect, circle, polyline, polygon, use")].map((mark) => mark.getBoundingClientRect())
      .map(({ top, bottom }) => [(top - to_screen.f) / to_screen.d, (bottom - to_screen.f) / to_screen.d])
      .filter(([top, bottom]) => bottom - top < 0.6 * height);  // no frame about all of it
    const is_quiet = (place) => marks.every(([top, bottom]) => place <= top || place >= bottom);
    const places = marks.map(([, bottom]) => bottom + 1).filter((place) => place >= height - most && place <= most && is_quiet(place));
    const from_middle = (place) => Math.abs(place - height / 2);
    return places.length > 0 ? places.reduce((best, place) => (from_middle(place) < from_middle(best) ? place : best)) : null;
  }

  // The parts of a length, each as long as fits, evenly spaced.
  function even_parts(length, most) {
    const count = Math.ceil(length / most - 0.005);
    return Array.from({ length: count }, (_, i) => {
      const from = count > 1 ? (i / (count - 1)) * (length - most) : (length - most) / 2;
      return [from, from + most];
    });
  }

  // First it gets the heading's room, too.
  return (show, visual) => {
    const whole = show(visual.cloneNode(true));
    const drawing = whole.querySelector(".stage .frame > :is(img[data-label], svg)");
    if (!drawing) return [whole];
    const box = drawing.parentElement, { width, height } = measures_of(drawing), wanted = legible_scale(drawing);
    if (scale_of(drawing) < wanted) whole.classList.add("tight");
    const least = Math.max(scale_of(drawing), wanted), most = box.clientHeight / least;
    const rows = even_parts(height, most), cut = rows.length === 2 ? quiet_cut(drawing, most) : null;
    const bands = cut ? [[0, cut], [cut, height]] : rows, longest = Math.max(...bands.map(([top, bottom]) => bottom - top));
    const scale = Math.max(least, Math.min(box.clientWidth / width, box.clientHeight / longest));
    const columns = even_parts(width, box.clientWidth / scale), slides = [whole];
    if (columns.length * bands.length <= 1) return slides;
    whole.classList.add("overview");
    for (const [top, bottom] of bands)
      for (const [left] of columns) {
        const slide = show(visual.cloneNode(true)), frame = slide.querySelector(".stage .frame"), image = frame.firstElementChild;
        slide.classList.add("tight");
        image.classList.add("enlarged");
        frame.style.flex = `0 1 ${(bottom - top) * scale}px`;
        Object.assign(image.style, { width: `${width * scale}px`, height: `${height * scale}px`, left: `${-left * scale}px`, top: `${-top * scale}px` });
        slides.push(slide);
      }
    return slides;
  };
})();
