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

  function slides_of_part(part) {
    const heading = part.querySelector(":scope > h2, :scope > h3");
    const slides = [];
    let notes = [], sentence = null, paragraph = null, subheading = null;
    for (const block of blocks_of(part)) {
      if (block.matches("h2, h3, h4")) {
        subheading = block.matches("h2") ? null : block;
      } else if (block.matches("[data-slide]")) {
        sentence = element("span", {}, block.dataset.slide);
      } else if (block.matches(visuals)) {
        // Two things below one paragraph: the second speaks through its caption.
        const words = sentence ?? (paragraph ? first_sentence(paragraph) : caption_of(block)) ?? "";
        slides.push({ heading: subheading ?? heading, sentence: words, notes, visual: block });
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
