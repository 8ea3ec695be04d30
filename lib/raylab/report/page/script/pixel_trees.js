// Click a pixel: its ray tree, and its rays in the scene. Beside the page lies trees.js, made with the picture, which calls
// raylab_trees with {command, image, grid, words, views, trees}:
//   trees   [x, y, nodes] for the pixel in the middle of each cell of the grid, row by row
//   nodes   [kind, why it ended, its parent, throughput], and where the ray was cast, further: what it hit (a shadow ray: its
//           light), t there (null: nothing), the three numbers each of origin, direction and, but for shadow rays, local colour;
//           kind, ending and what was hit are places in `words`
//   views   {words, right, up, low, high, outlines}: a point p stands at (p . right, p . up); outlines as [x, y, x, y, ...]
{
  let data = null, when_read = null;
  globalThis.raylab_trees = (read) => {
    data = read;
    when_read();
  };

  const read = (source) => new Promise((resolve) => {
    if (data) return resolve();
    when_read = resolve;
    document.head.append(element("script", { src: source }));
  });

  const node_of = ([kind, ended, parent, throughput, hit, t, ...numbers]) => ({
    kind: data.words[kind], ended: data.words[ended], parent, throughput, cast: hit !== undefined, t,
    object: numbers.length > 6 ? data.words[hit] : "",
    origin: numbers.slice(0, 3), direction: numbers.slice(3, 6), local: numbers.slice(6),
  });

  function show(panel, [x, y, nodes]) {
    const all = nodes.map(node_of);
    const { drawn, left_out } = ray_drawing.tree(all);
    const code = element("code", {}, `${data.command} --pixel ${x},${y} -o tree.svg`);
    const rest = left_out > 0 ? ` ${left_out} more ${left_out === 1 ? "ray, of less throughput, is" : "rays, of less throughput, are"} not drawn.` : "";
    panel.replaceChildren(
      element("p", { role: "status" }, `Pixel (${x}, ${y}): ${all.filter(({ cast, kind }) => cast && kind !== "shadow").length} rays.${rest}`),
      drawn, element("div", { class: "drawings" }, ...data.views.map((view) =>
        element("div", {}, element("p", {}, `The rays ${view.words}; dotted: shadow rays (L), × where blocked`), ray_drawing.scene(view, all)))),
      element("p", {}, code));
  }

  for (const figure of document.querySelectorAll("figure[data-trees]")) {
    const image = figure.querySelector("img");
    const cursor = element("div", { class: "cursor", hidden: "" });
    const picked = element("div", { class: "picked", tabindex: "0", role: "application", "data-own-keys": "", "aria-label": "Click a pixel, or choose one with the arrow keys: its rays are shown below" });
    const panel = element("div", { class: "trees", hidden: "" });
    image.parentElement.replaceWith(picked);
    picked.append(image, cursor);
    figure.append(panel);
    let column = 0, row = 0;

    async function pick(next_column, next_row) {
      await read(figure.dataset.trees);
      const [columns, rows] = data.grid;
      column = Math.max(0, Math.min(columns - 1, next_column(columns)));
      row = Math.max(0, Math.min(rows - 1, next_row(rows)));
      Object.assign(cursor.style, { left: `${(100 * column) / columns}%`, top: `${(100 * row) / rows}%`, width: `${100 / columns}%`, height: `${100 / rows}%` });
      cursor.hidden = panel.hidden = false;
      show(panel, data.trees[row * columns + column]);
    }

    picked.addEventListener("click", (event) => {
      const box = image.getBoundingClientRect();
      pick((columns) => Math.floor((columns * (event.clientX - box.left)) / box.width),
        (rows) => Math.floor((rows * (event.clientY - box.top)) / box.height));
    });
    const step = { ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, -1], ArrowDown: [0, 1] };
    picked.addEventListener("keydown", (event) => {
      const [right, down] = step[event.key] ?? [];
      if (right === undefined) return;
      event.preventDefault();
      if (cursor.hidden) pick((columns) => columns >> 1, (rows) => rows >> 1);
      else pick(() => column + right, () => row + down);
    });
    figure.querySelector("figcaption")?.append(element("span", { class: "hint" }, " Click a pixel to see its rays; the arrow keys move on."));
  }
}
