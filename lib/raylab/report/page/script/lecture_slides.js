// Which slides a lesson has: each thing to be seen in its core is one, under the heading of its part and one sentence.
// A slide is {heading, sentence, notes, visual}; the visual is the lesson's own element.

const slides_of_lesson = (() => {
  const visuals = "figure, .figures, .equation, pre.pseudo, .scroll, .choices, ul, ol";
  const not_shown = new Set(["deeper", "try-this", "questions", "words-and-symbols", "sources-and-further-reading"]);

  // The part's own blocks, with what stands in a case or a box of its own but not what is folded.
  const blocks_of = (part) => [...part.children].flatMap((block) =>
    block.matches("section") ? blocks_of(block) : block.matches("details, aside, script") ? [] : [block]);

  const ends_sentence = /[.?!:](?=\s|$)/g;
  const abbreviation = /(?:\b(?:e\.g|i\.e|cf|vs|Fig|No)|\b[A-Z])\.$/;

  // The first sentence of a paragraph with its formulas, code and emphasis.
  function first_sentence(paragraph) {
    const range = document.createRange();
    range.selectNodeContents(paragraph);
    const texts = document.createTreeWalker(paragraph, NodeFilter.SHOW_TEXT);
    while (texts.nextNode()) {
      if (texts.currentNode.parentElement.closest("code, math")) continue;
      for (const { index } of texts.currentNode.data.matchAll(ends_sentence)) {
        if (abbreviation.test(texts.currentNode.data.slice(0, index + 1))) continue;
        range.setEnd(texts.currentNode, index + 1);
        return range.cloneContents();
      }
    }
    return range.cloneContents();
  }

  function caption_of(visual) {
    const caption = visual.querySelector("figcaption");
    if (!caption || visual.matches(".figures, .chart, .excerpt")) return null;  // these say it themselves
    const words = caption.cloneNode(true);
    for (const part of words.querySelectorAll(".step, .command, .floats, button")) part.remove();
    return words.textContent.trim() ? element("span", {}, ...words.childNodes) : null;
  }

  // The figures that may stand beside a formula, the best first: those between it and the next formula, then the drawings of its
  // part, the nearest first; the last drawing before the part if the text says that it is above.
  function drawings_for(formula, part, paragraph) {
    const precedes = (one, other) => one.compareDocumentPosition(other) & Node.DOCUMENT_POSITION_FOLLOWING;
    const drawings_in = (root) => [...root.querySelectorAll("figure.drawing:not(details *, aside *)")];
    const next = [...part.querySelectorAll(".equation")].find((other) => precedes(formula, other));
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

  // A formula is shown below the paragraph that derives it and beside a drawing of what it is about, or with what is said of it.
  function derivation_of(formula, part, paragraph) {
    const formulas = formulas_from(formula), last = formulas.at(-1), next = next_block(last);
    const is_after = next?.matches("p") && !next_block(next)?.matches(visuals);
    const drawings = drawings_for(last, part, paragraph).slice(0, 3).map((figure) => figure.cloneNode(true));
    for (const visited of drawings.flatMap((figure) => [...figure.querySelectorAll("[data-visit]")])) visited.removeAttribute("data-visit");
    const words = (block, place) => {
      const copy = block.cloneNode(true);
      copy.className = place;
      return copy;
    };
    return element("div", { class: "derivation" },
      element("div", { class: "reasoning" }, ...(paragraph ? [words(paragraph, "before")] : []),
        ...formulas.map((one) => one.cloneNode(true)), ...(is_after ? [words(next, paragraph ? "after" : "before")] : [])),
      ...drawings);
  }

  function slides_of_part(part) {
    const heading = part.querySelector(":scope > h2, :scope > h3");
    const slides = [];
    let notes = [], sentence = null, paragraph = null, subheading = null;
    for (const block of blocks_of(part)) {
      if (block.matches("h2, h3, h4")) {
        subheading = block.matches("h2") ? null : block;
      } else if (block.matches("[data-slide]")) {
        sentence = element("span", {}, block.dataset.slide);
      } else if (block.matches(visuals) && !(block.matches(".equation") && follows_formula(block))) {
        // Two things below one paragraph: the second speaks through its caption.
        const is_formula = block.matches(".equation");
        const words = sentence ?? (is_formula ? null : paragraph ? first_sentence(paragraph) : caption_of(block)) ?? "";
        const visual = is_formula ? derivation_of(block, part, paragraph) : block;
        slides.push({ heading: subheading ?? heading, sentence: words, notes, visual });
        notes = [];
        sentence = paragraph = null;
      } else if (block.matches("p:not([hidden], .not-run)")) {
        notes.push(block);
        paragraph = block;
      }
    }
    if (slides.length > 0) slides.at(-1).notes.push(...notes);
    if (slides.length === 0 && notes.length > 0) {
      const said = notes.map((note) => element("li", {}, first_sentence(note)));
      slides.push({ heading, sentence: "", notes, visual: element("ul", {}, ...said) });
    }
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
