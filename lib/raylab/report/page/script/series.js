// A series of figures (depth_1, depth_2, ...) with a slider, and a button that plays it.
{
  const pause = 900;  // milliseconds from step to step

  for (const group of document.querySelectorAll(".figures[data-series]")) {
    const figures = [...group.querySelectorAll("figure")];
    if (figures.length < 3) continue;
    let timer = null;
    const slider = element("input", { type: "range", min: "1", max: String(figures.length), "aria-label": "step" });
    const words = element("output", {});
    const stop = () => {
      clearInterval(timer);
      timer = null;
      play.textContent = "play";
    };
    const show = (step) => {
      slider.value = String(step);
      words.textContent = `${step} of ${figures.length}`;
      group.classList.add("one-at-a-time");
      figures.forEach((figure, i) => figure.classList.toggle("behind", i + 1 !== step));
    };
    const play = button("play", () => {
      if (timer) return stop();
      if (Number(slider.value) === figures.length) show(1);
      play.textContent = "stop";
      timer = setInterval(() => {
        show(Number(slider.value) + 1);
        if (Number(slider.value) === figures.length) stop();
      }, pause);
    });
    const all = button("all", () => {
      stop();
      group.classList.remove("one-at-a-time");
      figures.forEach((figure) => figure.classList.remove("behind"));
    });
    slider.addEventListener("input", () => {
      stop();
      show(Number(slider.value));
    });
    group.prepend(element("div", { class: "controls player", role: "group", "aria-label": "Steps" }, play, element("label", {}, slider), words, all));
    show(1);
  }
}
