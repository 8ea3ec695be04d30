// Search over the whole book. Its index, search.js, is read when it is first wanted; a page that stands alone has none.
{
  const home = document.body.classList.contains("front") ? "" : document.querySelector("nav.book a[href$='index.html']:not([rel])")?.getAttribute("href").replace("index.html", "");
  const most = 12;  // results
  let entries = null;

  // search.js calls this with [[kind, words, address, chapter], ...].
  globalThis.raylab_search = (all) => (entries = all.map(([kind, words, address, chapter]) => ({ kind, words, address, chapter })));

  // How well an entry fits: all words must occur; those at the beginning of a word count most, and short entries before long ones.
  function rank(entry, wanted) {
    const text = entry.words.toLowerCase();
    let sum = 0;
    for (const word of wanted) {
      const found = text.indexOf(word);
      if (found < 0) return 0;
      sum += found === 0 ? 4 : /\W/.test(text[found - 1]) ? 3 : 1;
    }
    return sum + 1 / (1 + text.length);
  }

  function found_for(text) {
    const wanted = text.toLowerCase().split(/\s+/).filter(Boolean);
    if (wanted.length === 0 || !entries) return [];
    const ranked = entries.map((entry) => ({ entry, rank: rank(entry, wanted) })).filter((one) => one.rank > 0);
    return ranked.sort((a, b) => b.rank - a.rank).slice(0, most).map(({ entry }) => entry);
  }

  function read_index() {
    if (document.querySelector("script[data-index]")) return;
    document.head.append(element("script", { src: `${home}search.js`, "data-index": "" }));
  }

  if (home !== undefined) {
    const words = element("input", { type: "search", placeholder: "search ( / )", "aria-label": "Search the book", "aria-controls": "found" });
    const results = element("ul", { class: "found", id: "found", hidden: "" });
    const box = element("div", { class: "search", role: "search" }, words, results);
    tools.prepend(box);
    const list = () => {
      const found = found_for(words.value);
      results.replaceChildren(...found.map(({ kind, words: text, address, chapter }) =>
        element("li", {}, element("a", { href: home + address }, element("span", { class: "kind" }, kind), " ", text, " ", element("small", {}, chapter)))));
      if (found.length === 0) results.append(element("li", {}, entries ? "nothing found" : "the index is being read"));
      results.hidden = words.value.trim() === "";
    };
    words.addEventListener("focus", read_index);
    words.addEventListener("input", list);
    document.head.addEventListener("load", list, true);  // of the index
    box.addEventListener("keydown", (event) => {
      const stops = [words, ...results.querySelectorAll("a")];
      const at = stops.indexOf(document.activeElement);
      if (event.key === "ArrowDown" || event.key === "ArrowUp") {
        event.preventDefault();
        stops[(at + (event.key === "ArrowDown" ? 1 : stops.length - 1)) % stops.length].focus();
      } else if (event.key === "Escape") {
        results.hidden = true;
        words.blur();
      } else if (event.key === "Enter" && at === 0) {
        stops[1]?.click();
      }
    });
    box.addEventListener("focusout", (event) => {
      if (!box.contains(event.relatedTarget)) results.hidden = true;
    });
    on_keys(["/"], "search the book", "page", () => words.focus());
  }
}
