// The lecture: one step a screen. The deck is made of the lesson's own elements when it is first asked for.
{
  const has_lesson = document.body.classList.contains("lesson");
  let deck = null, slides = [], at = 0, shown_items = 0, page_position = 0;
  const paper = element("style", { media: "print" });  // printed, each slide is a page that has the shape of this screen

  // What appears step by step, each step a list of elements: the points of a list, the pictures of a group, and in a drawing of
  // a ray's way what it visits, in that order. The enlarged parts of a drawing that was built up before are complete.
  function items_of(slide) {
    const is_complete = slide.querySelector(".enlarged");
    return [...slide.querySelectorAll(".stage :is(li, figure, .whole-case > .scroll)")].flatMap((item) => [[item], ...(is_complete ? [] : visits_in(item))]);
  }

  // Of a long way several visits are one step.
  function visits_in(item) {
    const most_steps = item.matches(".title *, .figures > *") ? 12 : 24;
    const marks = [...item.querySelectorAll("svg [data-visit]")], number = (mark) => Number(mark.dataset.visit);
    const at_once = Math.ceil(new Set(marks.map(number)).size / most_steps), steps = [];
    for (const mark of marks.sort((one, other) => number(one) - number(other))) (steps[Math.floor((number(mark) - 1) / at_once)] ??= []).push(mark);
    return steps.filter(Boolean);
  }

  // The last visit is marked, and what its mark says when it is pointed at stands below the drawing.
  function tell_visit(slide, items) {
    const marks = (items[shown_items - 1] ?? []).filter((part) => part.matches("[data-visit]")), last = marks.at(-1);
    for (const mark of slide.querySelectorAll("[data-visit]")) mark.classList.toggle("visited-now", marks.includes(mark));
    for (const said of slide.querySelectorAll(".said")) said.textContent = "";
    if (!last) return;
    const drawing = last.closest("svg"), all = [...drawing.querySelectorAll("[data-visit]")].map((mark) => Number(mark.dataset.visit));
    const words = marks.map((mark) => mark.dataset.visit === last.dataset.visit && mark.querySelector("title")?.textContent).find(Boolean);
    const figure = last.closest("figure"), place = `${last.dataset.visit} of ${Math.max(...all)}`;
    figure.querySelector(".said").textContent = words && !figure.matches(".figures > *") ? `${place}: ${words}` : place;  // a column is too narrow for words
  }

  function new_slide({ heading, sentence, notes }) {
    const words = sentence instanceof Node ? sentence.cloneNode(true) : sentence;
    const slide = element("section", { class: "slide", tabindex: "-1", "aria-label": heading?.textContent ?? "" },
      element("h2", {}, ...[...(heading?.childNodes ?? [])].map((node) => node.cloneNode(true))),
      element("p", { class: "sentence" }, words), element("div", { class: "stage" }),
      element("div", { class: "notes" }, ...notes.map((note) => note.cloneNode(true))));
    return slide;
  }

  // A copied drawing must be clipped by its own frame: the page's, which is hidden now, would clip all of it.
  let copies = 0;
  function name_frames(drawing) {
    ++copies;
    for (const frame of drawing.querySelectorAll("clipPath[id]")) {
      const clipped = drawing.querySelectorAll(`[clip-path="url(#${frame.id})"]`);
      frame.id += `-copy-${copies}`;
      for (const part of clipped) part.setAttribute("clip-path", `url(#${frame.id})`);
    }
  }

  // Controls stay on the page, and among the copies no name may stand twice.
  function without_controls(visual) {
    visual.classList.remove("in-one-place", "wiped", "one-at-a-time");
    for (const hidden of visual.querySelectorAll(".behind")) hidden.classList.remove("behind");
    for (const control of visual.querySelectorAll(".controls, .command, .floats, .trees, .cursor, .hint, .mark, button.copy, .step, details")) control.remove();
    for (const named of [visual, ...visual.querySelectorAll("[id]")]) if (!named.closest("svg")) named.removeAttribute("id");
    for (const image of visual.querySelectorAll("img")) image.loading = "eager";
    for (const mark of visual.querySelectorAll(".ahead, .visited-now")) mark.classList.remove("ahead", "visited-now");
    visual.querySelectorAll("svg").forEach(name_frames);
    for (const link of visual.querySelectorAll("a:has(> img), .picked, .scroll:has(> svg)")) link.replaceWith(...link.childNodes);
    for (const drawing of visual.querySelectorAll("figure > img, figure > svg")) {
      const frame = element("div", { class: "frame" });
      drawing.replaceWith(frame);
      frame.append(drawing);
      if (!drawing.querySelector("[data-visit]")) continue;
      const said = element("span", { class: "said", "aria-live": "polite" });
      if (visual.matches(".figures")) frame.parentElement.querySelector("figcaption").append(said);
      else frame.after(said);
    }
    return visual;
  }

  function make_deck() {
    deck?.remove();
    deck = element("div", { class: "deck" });
    document.body.append(deck);
    slides_of_lesson().forEach((step, index) => {
      const show = (visual) => {
        const slide = new_slide(step);
        deck.append(slide);
        slide.classList.add("current");
        slide.querySelector(".stage").append(without_controls(visual));
        return slide;
      };
      fitted_slides(step.visual, show).forEach((slide, part) => {
        slide.id = `slide-${index + 1}` + (part > 0 ? `-${part + 1}` : "");
        slide.classList.remove("current");
        if (index === 0) slide.classList.add("title");
      });
    });
    slides = [...deck.children];
    slides.forEach((slide, i) => slide.append(element("p", { class: "count" }, `${i + 1} / ${slides.length}`)));
    paper.textContent = `@page { size: ${innerWidth}px ${innerHeight}px; margin: 0; }`;
    document.head.append(paper);
  }

  function show(index, items) {
    slides[at]?.classList.remove("current");
    at = Math.max(0, Math.min(index, slides.length - 1));
    const slide = slides[at];
    const all = items_of(slide);
    shown_items = Math.max(0, Math.min(items, all.length));
    all.forEach((step, i) => step.forEach((part) => part.classList.toggle("later", i >= shown_items)));
    tell_visit(slide, all);
    slide.classList.add("current");
    slide.focus({ preventScroll: true });
    history.replaceState(null, "", address_of(slide));
  }

  // #slide-5 is a slide as it begins, #slide-5.3 the same with three of its items shown.
  const address_of = (slide) => `#${slide.id}` + (shown_items > 1 ? `.${shown_items}` : "");
  const address_pattern = /^#(slide-\d+(?:-\d+)?)(?:\.(\d+))?$/;

  const begin_of = (index) => show(index, 1);
  const end_of = (index) => show(index, Infinity);

  function forward() {
    if (shown_items < items_of(slides[at]).length) show(at, shown_items + 1);
    else if (at + 1 < slides.length) begin_of(at + 1);
  }
  function back() {
    if (shown_items > 1) show(at, shown_items - 1);
    else if (at > 0) end_of(at - 1);
  }

  // What is left of this slide at once, then the next one.
  function whole() {
    if (shown_items < items_of(slides[at]).length) end_of(at);
    else forward();
  }

  function open(address = "") {
    if (!in_lecture()) page_position = scrollY;
    document.body.classList.add("lecture");
    make_deck();
    const [, name, items] = address_pattern.exec(address) ?? [];
    const wanted = slides.findIndex(({ id }) => id === name);
    if (wanted >= 0) show(wanted, Number(items ?? 1));
    else begin_of(first_slide_in_view());
  }

  // On the page you see a part; the lecture begins there.
  function first_slide_in_view() {
    const passed = [...document.querySelectorAll("main > section.part")].filter((part) => part.offsetTop <= page_position + innerHeight / 3);
    const words = passed.at(-1)?.querySelector("h2")?.textContent;
    return Math.max(0, slides.findIndex((slide) => slide.querySelector("h2").textContent === words));
  }

  function close() {
    if (document.fullscreenElement) document.exitFullscreen();
    document.body.classList.remove("lecture", "with-notes", "with-pointer");
    deck.remove();
    paper.remove();
    history.replaceState(null, "", location.pathname + location.search);
    scrollTo(0, page_position);
  }

  // A deck of its own (../deck.h) begins as a lecture.
  const is_deck = document.body.dataset.deck !== undefined;
  const open_from_address = (event) => {
    if (address_pattern.test(location.hash) || (is_deck && event.type === "DOMContentLoaded")) open(location.hash);
  };

  if (has_lesson) {
    tools.append(button("lecture", () => open(), { title: "l" }));
    on_keys(["l"], "lecture: one step a screen", "page", () => open());
    on_keys(["ArrowRight", "ArrowDown", " ", "PageDown"], "next step", "lecture", forward);
    on_keys(["Enter"], "all of this slide, then the next", "lecture", whole);
    on_keys(["ArrowLeft", "ArrowUp", "PageUp", "Backspace"], "step before", "lecture", back);
    on_keys(["Home"], "first slide", "lecture", () => begin_of(0));
    on_keys(["End"], "last slide", "lecture", () => end_of(slides.length - 1));
    on_keys(["Escape", "l"], "back to the page", "lecture", close);
    on_keys(["n"], "the presenter's notes", "lecture", () => document.body.classList.toggle("with-notes"));
    on_keys(["p"], "a pointer that follows the mouse", "lecture", () => document.body.classList.toggle("with-pointer"));
    on_keys(["f"], "full screen", "lecture", () =>
      document.fullscreenElement ? document.exitFullscreen() : document.documentElement.requestFullscreen().catch(() => {}));

    const pointer = element("div", { class: "pointer", "aria-hidden": "true" });
    document.body.append(pointer);
    addEventListener("pointermove", ({ clientX, clientY }) => (pointer.style.transform = `translate(${clientX}px, ${clientY}px)`));

    // A finger or a mouse on the left third goes back, elsewhere on.
    addEventListener("click", (event) => {
      if (!in_lecture() || event.target.closest("a, button, dialog, .notes")) return;
      if (event.clientX < innerWidth / 3) back();
      else forward();
    });
    addEventListener("hashchange", open_from_address);
    // Another screen has room for other pieces.
    addEventListener("resize", () => {
      if (in_lecture() && !matchMedia("print").matches) open(address_of(slides[at]));
    });
    addEventListener("DOMContentLoaded", open_from_address);  // when all scripts have run
  }
}
