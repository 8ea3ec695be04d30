// Which slides a lesson has: each thing to be seen in its core is one, under the heading of its part and one sentence.
// A slide is {heading, sentence, notes, visual}; the visual is the lesson's own element.

const slides_of_lesson = (() => {
  const visuals = "figure, .figures, .equation, pre.pseudo, .scroll, .choices, ul, ol";
  const not_shown = new Set(["deeper", "try-this", "questions", "words-and-symbols", "sources-and-further-reading"]);

  // The part's own blocks, with what stands in a case or a box of its own but not what is folded.
  const blocks_of = (part) => [...part.children].flatMap((block) =>
    block.matches("section") ? blocks_of(block) : block.matches("details, aside, script") ? [] : [block]);

  function caption_of(visual) {
    const caption = visual.querySelector("figcaption");
    if (!caption || visual.matches(".figures, .chart, .excerpt")) return null;  // these say it themselves
    const words = caption.cloneNode(true);
    for (const part of words.querySelectorAll(".step, .command, .floats, button")) part.remove();
    return words.textContent.trim() ? element("span", {}, ...words.childNodes) : null;
  }

  const precedes = (one, other) => Boolean(one.compareDocumentPosition(other) & Node.DOCUMENT_POSITION_FOLLOWING);

  // The figures that may stand beside a formula, the best first: those between it and the next formula, table or listing, then the
  // drawings of its part, the nearest first; the last drawing before the part if the text says that it is above.
  function drawings_for(formula, part, paragraph) {
    const drawings_in = (root) => [...root.querySelectorAll("figure.drawing:not(details *, aside *)")];
    const next = [...part.querySelectorAll(".equation, .scroll, pre")].find((other) => precedes(formula, other) && !other.closest("figure:not(.excerpt)"));
    const about = [...part.querySelectorAll("figure:not(.chart, .excerpt, .figures *, details *, aside *)")]
      .filter((figure) => precedes(formula, figure) && !(next && precedes(next, figure)));
    const drawings = drawings_in(part), before = drawings.filter((figure) => precedes(figure, formula)).reverse();
    const own = [...new Set([...about, ...before, ...drawings])], is_above = /\b(drawing|figure|picture) above\b/.test(paragraph?.textContent ?? "");
    return own.length > 0 || !is_above ? own : drawings_in(document).filter((figure) => precedes(figure, formula)).slice(-1);
  }

  const next_block = (block) => (block.nextElementSibling?.matches("[data-slide]") ? next_block(block.nextElementSibling) : block.nextElementSibling);
  const follows_formula = (block) => block.previousElementSibling?.matches(".equation") ?? false;

  // Formulas with nothing between them are one step.
  function formulas_from(formula) {
    const next = formula.nextElementSibling;
    return [formula, ...(next?.matches(".equation") ? formulas_from(next) : [])];
  }

  function as_illustration(figure) {
    const copy = figure.cloneNode(true);
    for (const visited of copy.querySelectorAll("[data-visit]")) visited.removeAttribute("data-visit");
    return copy;
  }

  // What stands before a block, or behind it, but for paragraphs.
  const next_to = (block, side) => (block[side]?.matches("p, [data-slide]") ? next_to(block[side], side) : block[side]);

  // A list or a table, with the drawings that may stand beside it: beside a list those next to it, beside a table, which has their
  // numbers, those before it.
  function illustrated(block, part, paragraph) {
    const sides = ["previousElementSibling", "nextElementSibling"].map((side) => next_to(block, side));
    const drawings = (block.matches(".scroll") ? drawings_for(block, part, paragraph).filter((figure) => precedes(figure, block)) : sides)
      .filter((figure) => figure?.matches("figure.drawing"));
    return element("div", { class: "illustrated" }, block.cloneNode(true), ...drawings.slice(0, 2).map(as_illustration));
  }

  // A stability case: what it draws, and what came of it.
  function whole_case(section) {
    const drawings = [...section.querySelectorAll(":scope > figure")], table = section.querySelector(":scope > .scroll");
    return element("div", { class: "whole-case" },
      element("div", { class: "figures" }, ...drawings.map((figure) => figure.cloneNode(true))), table.cloneNode(true));
  }

  // A formula is shown below the paragraph that derives it and beside a drawing of what it is about, or with what is said of it.
  function derivation_of(formula, part, paragraph, is_told) {
    const formulas = formulas_from(formula), last = formulas.at(-1), next = next_block(last);
    const is_after = next?.matches("p") && !next_block(next)?.matches(visuals);
    const drawings = drawings_for(last, part, paragraph).slice(0, 3).map(as_illustration);
    const words = (block, place) => {
      const copy = block.cloneNode(true);
      copy.className = place;
      return copy;
    };
    return element("div", { class: is_told ? "derivation told" : "derivation" },
      element("div", { class: "reasoning" }, ...(paragraph ? [words(paragraph, "before")] : []),
        ...formulas.map((one) => one.cloneNode(true)), ...(is_after ? [words(next, paragraph ? "after" : "before")] : [])),
      ...drawings);
  }

  const is_in_case = (block) => block.matches("section.case > :is(figure, .scroll)") && block.parentElement.querySelector(":scope > figure");
  const whole_sentences = /[.?!](?=\s|$)/g;

  function slides_of_part(part) {
    const heading = part.querySelector(":scope > h2, :scope > h3"), slides = [];
    let notes = [], sentence = null, paragraph = null, subheading = null;
    function add(words, visual) {
      slides.push({ heading: subheading ?? heading, sentence: words ?? "", notes, visual });
      notes = [];
      sentence = paragraph = null;
    }
    for (const block of blocks_of(part)) {
      if (subheading?.matches("section.case > *") && !block.matches("section.case > *")) subheading = null;
      if (block.matches("h2, h3, h4")) {
        subheading = block.matches("h2") ? null : block;
      } else if (block.matches("[data-slide]")) {
        sentence = element("span", {}, block.dataset.slide);
      } else if (is_in_case(block)) {
        if (block.matches(".scroll")) add(paragraph && first_sentence(paragraph, { ends: whole_sentences }), whole_case(block.parentElement));
      } else if (block.matches(".equation")) {
        if (!follows_formula(block)) add(sentence, derivation_of(block, part, paragraph, sentence !== null));
      } else if (block.matches(visuals)) {
        if (block.matches("ul, ol")) notes.push(block);  // it may be shown shortened
        // Two things below one paragraph: the second speaks through its caption.
        const words = sentence ?? (paragraph ? first_sentence(paragraph) : caption_of(block));
        add(words, block.matches(".scroll, ul, ol") ? illustrated(block, part, paragraph) : block);
      } else if (block.matches("p:not([hidden], .not-run)")) {
        notes.push(block);
        paragraph = block;
      }
    }
    if (slides.length > 0) slides.at(-1).notes.push(...notes);
    else if (notes.length > 0) add("", element("ul", {}, ...notes.map((note) => element("li", {}, first_sentence(note)))));
    return slides;
  }

  function title_slide() {
    const introduction = document.querySelector("main .introduction");
    const slides = introduction ? slides_of_part(introduction) : [];
    const picture = slides.find(({ visual }) => visual.matches("figure, .figures"));
    return {
      heading: document.querySelector("header h1"), sentence: document.querySelector("header .question")?.textContent ?? "",
      notes: slides.flatMap(({ notes }) => notes), visual: picture?.visual ?? element("p"),
    };
  }

  return () => {
    const parts = [...document.querySelectorAll("main > section.part:not(.introduction)")].filter(({ id }) => !not_shown.has(id));
    return [title_slide(), ...parts.flatMap(slides_of_part)];
  };
})();
