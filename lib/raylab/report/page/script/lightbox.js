// A picture as large as the screen, to be enlarged down to its pixels, whose places and values are shown. A page that was
// opened as a file may not read its pictures; the values come by a script beside the picture, which calls raylab_values with a
// picture of mantissas above and exponents below.
{
  const largest_zoom = 64;

  let take_values = null;
  globalThis.raylab_values = (png) => take_values(png);

  // Resolves to a function of column and row that returns the three linear values.
  async function reader_of(source) {
    const png = await new Promise((resolve, reject) => {
      take_values = resolve;
      const script = element("script", { src: source });
      script.addEventListener("load", () => script.remove());
      script.addEventListener("error", reject);
      document.head.append(script);
    });
    const stored = element("img", { src: png });
    await stored.decode();
    const canvas = element("canvas", { width: stored.naturalWidth, height: stored.naturalHeight });
    const context = canvas.getContext("2d", { willReadFrequently: true });
    context.drawImage(stored, 0, 0);
    const bytes = (x, y) => [...context.getImageData(x, y, 1, 1).data].slice(0, 3);
    return (x, y) => {
      const [exponent] = bytes(x, y + stored.naturalHeight / 2);
      return bytes(x, y).map((mantissa) => mantissa * 2 ** (exponent - 136));
    };
  }

  function open(link) {
    const small = link.querySelector("img");
    const image = element("img", { src: link.href, alt: small.alt });
    const words = element("p", { role: "status" }, small.alt);
    const view = element("div", { class: "view", tabindex: "0", "data-own-keys": "", "aria-label": "+ and - enlarge, arrow keys move" }, image);
    const dialog = element("dialog", { class: "lightbox", "aria-label": small.alt },
      view, element("div", { class: "bar" }, words,
        button("+", () => zoom_by(2), { "aria-label": "larger" }), button("−", () => zoom_by(0.5), { "aria-label": "smaller" }),
        button("close", () => dialog.close())));
    let zoom = 1, x = 0, y = 0, read = null;

    const place = () => {
      image.style.transform = `translate(${x}px, ${y}px) scale(${zoom})`;
      image.classList.toggle("pixels", zoom * (image.width / image.naturalWidth) >= 2);
    };
    const move = (by_x, by_y) => {
      x += by_x;
      y += by_y;
      place();
    };
    // About a point of the view, its middle by default.
    function zoom_by(factor, at_x = view.clientWidth / 2, at_y = view.clientHeight / 2) {
      const next = Math.max(1, Math.min(largest_zoom, zoom * factor));
      const left = image.offsetLeft, top = image.offsetTop;
      x = at_x - left - ((at_x - left - x) * next) / zoom;
      y = at_y - top - ((at_y - top - y) * next) / zoom;
      zoom = next;
      if (zoom === 1) x = y = 0;
      place();
    }
    function tell(event) {
      const box = image.getBoundingClientRect();
      const column = Math.floor(((event.clientX - box.left) / box.width) * image.naturalWidth);
      const row = Math.floor(((event.clientY - box.top) / box.height) * image.naturalHeight);
      if (column < 0 || row < 0 || column >= image.naturalWidth || row >= image.naturalHeight) return;
      const values = read?.(column, row);
      words.textContent = `pixel (${column}, ${row})` +
        (values ? `: red, green, blue ${values.map((value) => Number(value.toPrecision(3))).join(", ")}` : "");
    }

    if (link.dataset.values) reader_of(link.dataset.values).then((reader) => (read = reader), () => {});
    view.addEventListener("wheel", (event) => {
      event.preventDefault();
      const box = view.getBoundingClientRect();
      zoom_by(event.deltaY < 0 ? 1.25 : 0.8, event.clientX - box.left, event.clientY - box.top);
    }, { passive: false });
    view.addEventListener("pointermove", (event) => {
      if (event.buttons) move(event.movementX, event.movementY);
      else tell(event);
    });
    view.addEventListener("dragstart", (event) => event.preventDefault());
    const step = 80;
    const does = {
      "+": () => zoom_by(2), "=": () => zoom_by(2), "-": () => zoom_by(0.5), ArrowLeft: () => move(step, 0),
      ArrowRight: () => move(-step, 0), ArrowUp: () => move(0, step), ArrowDown: () => move(0, -step),
    };
    view.addEventListener("keydown", (event) => {
      if (!does[event.key]) return;
      event.preventDefault();
      does[event.key]();
    });
    dialog.addEventListener("close", () => dialog.remove());
    document.body.append(dialog);
    dialog.showModal();
    view.focus();
  }

  document.addEventListener("click", (event) => {
    const link = event.target.closest?.("figure > a");
    if (!link?.querySelector("img") || event.ctrlKey || event.metaKey || event.shiftKey || event.defaultPrevented) return;
    event.preventDefault();
    open(link);
  });
}
