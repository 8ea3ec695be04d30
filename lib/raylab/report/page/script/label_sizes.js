// What fits on a slide, and whether the letters of its drawings are large enough.

const smallest_label = 1 / 50;  // of the screen's height

const slide_measures = (() => {
  const overflows = (box) => box.scrollHeight > box.clientHeight + 1 || box.scrollWidth > box.clientWidth + 1;

  // A drawing's size and its smallest label, in the drawing's own units: of an image its HTML says them.
  function measures_of(drawing) {
    if (drawing.matches("img")) {
      const { label, width = drawing.getAttribute("width"), height = drawing.getAttribute("height") } = drawing.dataset;
      return { label: Number(label), width: Number(width), height: Number(height) };
    }
    const { width, height } = drawing.viewBox.baseVal;
    const sizes = [...drawing.querySelectorAll("text")].map((text) => parseFloat(getComputedStyle(text).fontSize));
    return { label: Math.min(...sizes), width, height };
  }

  const has_labels = (drawing) => drawing.matches("img[data-label], svg");
  const legible_scale = (drawing) => (innerHeight * smallest_label) / measures_of(drawing).label;
  const legible_width = (drawing) => Math.ceil(legible_scale(drawing) * measures_of(drawing).width);

  // How much larger a drawing is shown in its frame than it is.
  function scale_of(drawing) {
    const { width, height } = measures_of(drawing), box = drawing.parentElement;
    return Math.min(box.clientWidth / width, box.clientHeight / height);
  }

  const labels_are_legible = (drawing) => !has_labels(drawing) || scale_of(drawing) >= legible_scale(drawing) - 1e-3;

  return { overflows, measures_of, has_labels, legible_scale, legible_width, scale_of, labels_are_legible };
})();
