// Questions that the browser test asks a page.

globalThis.browser_test = {
  // Unfolds what is folded, so that it is looked at, too.
  unfold() {
    for (const part of document.querySelectorAll("details")) part.open = true;
  },

  // What is wider than the screen, or sticks out of it, though it does not scroll by itself.
  overflow() {
    const wide = document.documentElement.scrollWidth - innerWidth;
    if (wide <= 0) return [];
    const clipped = (part) => part && part !== document.body && (getComputedStyle(part).overflowX !== "visible" || clipped(part.parentElement));
    const out = [...document.querySelectorAll("body *")].filter((part) =>
      part.checkVisibility() && part.getBoundingClientRect().right > innerWidth + 1 && !clipped(part.parentElement));
    return [`${wide} pixels too wide`, ...out.slice(0, 3).map((part) => part.outerHTML.slice(0, 120))];
  },

  // Text smaller than `least` pixels, but for exponents and indices.
  small_text(least, root = document.body) {
    const texts = document.createTreeWalker(root, NodeFilter.SHOW_TEXT), small = new Set();
    while (texts.nextNode()) {
      const part = texts.currentNode.parentElement;
      if (!texts.currentNode.data.trim() || !part.checkVisibility({ visibilityProperty: true })) continue;
      if (part.ownerSVGElement && root !== document.body) continue;  // a slide's labels: small_labels
      if (part.closest("sub, sup, script, style, msub, msup, msubsup, mfrac, munder, mover, munderover, mroot > :nth-child(2), tspan[font-size], .skip, option")) continue;
      const scale = part.ownerSVGElement ? part.getScreenCTM().a : 1;
      const size = scale * parseFloat(getComputedStyle(part).fontSize);
      if (size < least - 0.05) small.add(`${size.toFixed(1)} px: ${texts.currentNode.data.trim().slice(0, 60)} <${part.tagName} class="${part.getAttribute("class") ?? ""}">`);
    }
    return [...small];
  },

  // Drawings with letters smaller than `least` pixels as they are shown.
  small_labels(least, root = document.body) {
    const visible = (part) => part.checkVisibility({ visibilityProperty: true });
    const images = [...root.querySelectorAll("img[data-label]")].filter(visible).map((image) => {
      const scale = Math.min(image.clientWidth / image.dataset.width, image.clientHeight / image.dataset.height);
      return [scale * image.dataset.label, image.getAttribute("src")];
    });
    const texts = [...root.querySelectorAll("svg text")].filter(visible).map((text) =>
      [text.getScreenCTM().a * parseFloat(getComputedStyle(text).fontSize), `"${text.textContent}"`]);
    return [...images, ...texts].filter(([size]) => size < least - 0.05).map(([size, where]) => `${size.toFixed(1)} px in ${where}`);
  },

  links() {
    const all = [...document.querySelectorAll("[href], [src]")].map((part) => part.href?.baseVal ?? part.href ?? part.src);
    return [...new Set(all)];
  },

  anchors: () => [...document.querySelectorAll("[id]")].map(({ id }) => id),

  async pictures_loaded(root = document) {
    const images = [...root.querySelectorAll("img")];
    for (const image of images) image.loading = "eager";
    await Promise.all(images.map((image) => image.decode().catch(() => {})));
    return images.filter((image) => image.naturalWidth === 0).map((image) => image.src);
  },

  // The state of the lecture, which each step changes.
  step() {
    const slide = document.querySelector(".slide.current");
    return `${slide.id} with ${slide.querySelectorAll(".later").length} to come`;
  },

  // How many marks of visits the slide shows, for each drawing; a mark may not show before one with a lower number.
  visits_shown() {
    const drawings = [...document.querySelectorAll(".slide.current svg:has([data-visit])")];
    return Object.fromEntries(drawings.map((drawing, i) => {
      const numbers = (marks) => [...drawing.querySelectorAll(marks)].map(({ dataset }) => Number(dataset.visit));
      const shown = numbers("[data-visit]:not(.later)"), later = numbers("[data-visit].later");
      return [i, Math.max(0, ...shown) < Math.min(Infinity, ...later) ? shown.length : -1];
    }));
  },

  slide_faults() {
    const slide = document.querySelector(".slide.current"), stage = slide.querySelector(".stage"), faults = [];
    faults.push(...this.small_text(innerHeight / 30, slide).slice(0, 3).map((text) => `below 1/30 of the height: ${text}`));
    if (!slide.classList.contains("overview"))
      faults.push(...this.small_labels(innerHeight / 50, stage).map((text) => `below 1/50 of the height: ${text}`));
    if (stage.scrollHeight > stage.clientHeight + 1) faults.push(`${stage.scrollHeight - stage.clientHeight} pixels too high`);
    if (stage.scrollWidth > stage.clientWidth + 1) faults.push(`${stage.scrollWidth - stage.clientWidth} pixels too wide`);
    for (const part of stage.querySelectorAll(".scroll, ul, ol, .reasoning"))
      if (part.scrollWidth > part.clientWidth + 1 || part.scrollHeight > part.clientHeight + 1) faults.push("a table, list or formula sticks out of its place");
    for (const listing of stage.querySelectorAll("pre"))
      if (listing.scrollWidth > listing.clientWidth + 1 || getComputedStyle(listing.querySelector("code")).whiteSpace !== "pre") faults.push("a line of code is cut off, or broken anywhere");
    for (const part of stage.querySelectorAll("svg [clip-path]"))
      if (!part.ownerSVGElement.querySelector(part.getAttribute("clip-path").slice(4, -1))) faults.push("a drawing is clipped by another's frame");
    if (stage.clientHeight < innerHeight / 2) faults.push(`the heading leaves less than half of the screen`);
    return faults;
  },

  // Texts of the deck with less than WCAG's contrast of 4.5 to the ground they stand on, and drawings, whose ink is dark in both
  // schemes, on a dark ground. One look at all slides at once, thirty times as fast as axe.
  slide_contrast() {
    const linear = (part) => (part <= 0.04045 ? part / 12.92 : ((part + 0.055) / 1.055) ** 2.4);
    const luminance = (colour) => [0.2126, 0.7152, 0.0722].reduce((sum, weight, i) => sum + weight * linear(colour[i] / 255), 0);
    const numbers = (colour) => colour.match(/[\d.]+/g).map(Number);
    const is_painted = ([, , , alpha = 1]) => alpha === 1;
    function ground_of(part) {
      const colour = numbers(getComputedStyle(part).backgroundColor);
      return is_painted(colour) || !part.parentElement ? luminance(colour) : ground_of(part.parentElement);
    }
    const faint = new Set(), deck = document.querySelector(".deck"), texts = document.createTreeWalker(deck, NodeFilter.SHOW_TEXT);
    while (texts.nextNode()) {
      const part = texts.currentNode.parentElement, words = texts.currentNode.data.trim();
      if (!words || part.ownerSVGElement) continue;
      const [dark, light] = [luminance(numbers(getComputedStyle(part).color)), ground_of(part)].sort((one, other) => one - other);
      const contrast = (light + 0.05) / (dark + 0.05);
      if (contrast < 4.5) faint.add(`${part.closest(".slide").id}: contrast ${contrast.toFixed(1)}: ${words.slice(0, 60)}`);
    }
    for (const drawing of deck.querySelectorAll("svg, img[data-label]"))
      if (ground_of(drawing) < 0.9) faint.add(`${drawing.closest(".slide").id}: a drawing on a dark ground`);
    return [...faint].slice(0, 8);
  },

  // Of tables that are shown.
  hidden_heads: () => [...document.querySelectorAll("thead th")].map((head) => head.querySelector(".sort") ?? head)
    .filter((part) => part.closest("table").checkVisibility() && !part.checkVisibility()).map((part) => part.textContent.trim()),

  middle_of(selector) {
    const part = document.querySelector(selector);
    part.scrollIntoView({ block: "center", behavior: "instant" });
    const box = part.getBoundingClientRect();
    return [box.left + box.width / 2, box.top + box.height / 2];
  },

  // What the page drew for the pixel that was picked.
  picked() {
    const code = document.querySelector(".trees code");
    return code && {
      command: code.textContent,
      rays: [...document.querySelectorAll(".trees .ray")].map(({ dataset }) => ({ node: Number(dataset.node), throughput: Number(dataset.throughput), object: dataset.object })),
    };
  },

  async contrast() {
    const { violations } = await axe.run(document, { runOnly: ["wcag2a", "wcag2aa"], resultTypes: ["violations"] });
    return violations.flatMap(({ id, nodes }) => nodes.slice(0, 4).map((node) => `${id}: ${node.html.slice(0, 120)} ${node.any[0]?.message ?? ""}`));
  },
};
