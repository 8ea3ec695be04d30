// A slider over the steps of something, a button that plays them, one that shows all, and words for the step that is shown.
// `show(step)` shows a step, from 1 on, and returns words for it; `show_all()` takes that back.
function player(steps, show, show_all) {
  const pause = 900;  // milliseconds from step to step
  let timer = null;
  const slider = element("input", { type: "range", min: "1", max: String(steps), "aria-label": "step" });
  const words = element("output", {});
  const stop = () => {
    clearInterval(timer);
    timer = null;
    play.textContent = "play";
  };
  const go = (step) => {
    slider.value = String(step);
    const said = show(step);
    words.textContent = `${step} of ${steps}` + (said ? `: ${said}` : "");
  };
  const play = button("play", () => {
    if (timer) return stop();
    if (Number(slider.value) === steps || words.textContent === "") go(1);
    play.textContent = "stop";
    timer = setInterval(() => {
      go(Number(slider.value) + 1);
      if (Number(slider.value) === steps) stop();
    }, pause);
  });
  const all = button("all", () => {
    stop();
    words.textContent = "";
    show_all();
  });
  slider.addEventListener("input", () => {
    stop();
    go(Number(slider.value));
  });
  const controls = element("div", { class: "controls player", role: "group", "aria-label": "Steps" }, play, element("label", {}, slider), all, words);
  return { controls, go };
}
