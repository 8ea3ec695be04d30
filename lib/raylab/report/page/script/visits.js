// A drawing of a ray's way through a structure: its cells and numbers appear in the order in which the ray visits them. What
// a mark says when it is pointed at (its title) stands beside the slider.
for (const drawing of document.querySelectorAll("figure svg:has([data-visit])")) {
  const marks = [...drawing.querySelectorAll("[data-visit]")].map((mark) => ({ mark, visit: Number(mark.dataset.visit) }));
  const show = (step) => {
    for (const { mark, visit } of marks) {
      mark.classList.toggle("ahead", visit > step);
      mark.classList.toggle("visited-now", visit === step);
    }
    return marks.find(({ visit }) => visit === step)?.mark.querySelector("title")?.textContent;
  };
  const show_all = () => {
    for (const { mark } of marks) mark.classList.remove("ahead", "visited-now");
  };
  drawing.parentElement.after(player(Math.max(...marks.map(({ visit }) => visit)), show, show_all).controls);
}
