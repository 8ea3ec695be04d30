// A series of figures (depth_1, depth_2, ...) is shown one at a time.
for (const group of document.querySelectorAll(".figures[data-series]")) {
  const figures = [...group.querySelectorAll("figure")];
  if (figures.length < 3) continue;
  const show = (step) => {
    group.classList.add("one-at-a-time");
    figures.forEach((figure, i) => figure.classList.toggle("behind", i + 1 !== step));
  };
  const show_all = () => {
    group.classList.remove("one-at-a-time");
    figures.forEach((figure) => figure.classList.remove("behind"));
  };
  const { controls, go } = player(figures.length, show, show_all);
  group.prepend(controls);
  go(1);
}
