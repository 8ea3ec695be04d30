// Fits pictures that stand side by side: in as many columns as make them largest, in the middle of the screen.

const fitted_pictures = (() => {
  const { measures_of } = slide_measures;

  return (show, visual) => {
    const slide = show(visual.cloneNode(true)), group = slide.querySelector(".figures");
    const pictures = [...group.querySelectorAll(":scope > figure > .frame > *")];
    if (group.matches("[data-series]") || pictures.length === 0) return slide;
    const sizes = pictures.map(measures_of);
    // How much larger than they are the pictures are shown in so many columns, the smallest of them.
    function scale_in(columns) {
      group.style.gridTemplateColumns = `repeat(${columns}, minmax(0, 1fr))`;
      return Math.min(...pictures.map(({ parentElement: box }, i) => Math.min(box.clientWidth / sizes[i].width, box.clientHeight / sizes[i].height)));
    }
    const scales = pictures.map((_, i) => scale_in(i + 1)), best = Math.max(...scales);
    const fitting = scale_in(scales.indexOf(best) + 1);
    group.style.gridAutoRows = `${Math.floor(fitting * Math.max(...sizes.map(({ height }) => height)))}px auto`;
    group.classList.add("arranged");
    return slide;
  };
})();
