// What a slide says of a longer text: its first sentence.

const { first_sentence, with_short_items } = (() => {
  const abbreviation = /(?:\b(?:e\.g|i\.e|cf|vs|Fig|No)|\b[A-Z])\.$/;

  // With its formulas, code and emphasis, and longer than so many words.
  function first_sentence(text, { ends = /[.?!:](?=\s|$)/g, words = 0 } = {}) {
    const range = document.createRange();
    range.selectNodeContents(text);
    const texts = document.createTreeWalker(text, NodeFilter.SHOW_TEXT);
    while (texts.nextNode()) {
      if (texts.currentNode.parentElement.closest("code, math")) continue;
      for (const { index } of texts.currentNode.data.matchAll(ends)) {
        if (abbreviation.test(texts.currentNode.data.slice(0, index + 1))) continue;
        range.setEnd(texts.currentNode, index + 1);
        if (range.toString().trim().split(/\s+/).length > words) return range.cloneContents();
        range.setEndAfter(text.lastChild);
      }
    }
    return range.cloneContents();
  }

  // Of each item its first sentence, and the next where that is only a catchword.
  function with_short_items(list) {
    const copy = list.cloneNode(true);
    for (const item of copy.children) item.replaceChildren(first_sentence(item, { ends: /[.?!](?=\s|$)/g, words: 3 }));
    return copy;
  }

  return { first_sentence, with_short_items };
})();
