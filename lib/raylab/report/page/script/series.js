// A series of figures (depth_1, depth_2, ...), or a drawing of numbered parts, with a slider, and a button that plays it.
{
  const pause = 900;  // milliseconds from step to step

  function add_player(box, count, words_of, show) {
    let timer = null;
    const slider = element("input", { type: "range", min: "1", max: String(count), value: "1", "aria-label": "step" });
    const words = element("output", {});
    const stop = () => {
      clearInterval(timer);
      timer = null;
      play.textContent = "play";
    };
    const go = (step) => {
      slider.value = String(step);
      words.textContent = words_of(step - 1);
      show(step - 1);
    };
    const play = button("play", () => {
      if (timer) return stop();
      if (Number(slider.value) === count) go(1);
      play.textContent = "stop";
      timer = setInterval(() => {
        go(Number(slider.value) + 1);
        if (Number(slider.value) === count) stop();
      }, pause);
    });
    slider.addEventListener("input", () => {
      stop();
      go(Number(slider.value));
    });
    const controls = element("div", { class: "controls player", role: "group", "aria-label": "Steps" }, play, element("label", {}, slider), words);
    box.prepend(controls);
    return { controls, go, stop };
  }

  for (const group of document.querySelectorAll(".figures[data-series]")) {
    const figures = [...group.querySelectorAll("figure")];
    if (figures.length < 3) continue;
    const number = (i) => `${i + 1} of ${figures.length}`;
    const player = add_player(group, figures.length, number, (shown) => {
      group.classList.add("one-at-a-time");
      figures.forEach((figure, i) => figure.classList.toggle("behind", i !== shown));
    });
    player.controls.append(button("all", () => {
      player.stop();
      group.classList.remove("one-at-a-time");
      figures.forEach((figure) => figure.classList.remove("behind"));
    }));
    player.go(1);
  }

  for (const drawing of document.querySelectorAll("figure svg")) {
    const steps = [...drawing.querySelectorAll("[id^='step-']")];
    if (steps.length < 2) continue;
    const show = (shown) => steps.forEach((step, i) => step.classList.toggle("later", i > shown));
    const player = add_player(drawing.closest("figure"), steps.length, (i) => `${i + 1} of ${steps.length}`, show);
    player.go(steps.length);
  }
}
