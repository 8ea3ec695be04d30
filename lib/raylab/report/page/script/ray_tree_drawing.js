// Draws one pixel's ray tree, and its rays in the scene, with the same numbers and colours in both: see pixel_trees.js.

const ray_drawing = (() => {
  const look = {  // as in the lab's own diagrams; colour is never the only sign
    eye: { color: "#000000", dash: "" },
    reflected: { color: "#0072b2", dash: "" },
    transmitted: { color: "#007a58", dash: "7 4" },
    shadow: { color: "#767676", dash: "2 4" },
  };
  const most_nodes = 15, size = [600, 420];  // of a view of the scene

  function svg(tag, attributes = {}, ...children) {
    const made = document.createElementNS("http://www.w3.org/2000/svg", tag);
    for (const [name, value] of Object.entries(attributes)) made.setAttribute(name, value);
    made.append(...children);
    return made;
  }

  const srgb_byte = (value) => {
    const share = Math.max(0, Math.min(1, value));
    return Math.round(255 * (share <= 0.0031308 ? 12.92 * share : 1.055 * share ** (1 / 2.4) - 0.055));
  };
  const css_color = (color) => `rgb(${color.map(srgb_byte).join(" ")})`;
  // At a luminance of 0.18 black and white letters have the same contrast (WCAG 2, 1.4.3).
  const readable_on = ([r, g, b]) => (0.2126 * r + 0.7152 * g + 0.0722 * b > 0.18 ? "#000" : "#fff");
  const share_words = (value) => (value < 0.001 ? value.toExponential(1) : String(Number(value.toPrecision(3))));
  // What is too little to be seen is "~0", as in the lab's own diagrams.
  const in_words = (color) => color.map((value) => (value > 0 && value < 0.0005 ? "~0" : Number(value.toPrecision(2)))).join(" ");

  // The colour that each ray returns: what it and those below it add to the pixel, divided by its throughput.
  function brought(nodes) {
    const sums = nodes.map(({ kind, local, throughput }) => (kind === "shadow" || local.length === 0 ? [0, 0, 0] : local.map((value) => value * throughput)));
    for (let i = nodes.length - 1; i > 0; --i) sums[nodes[i].parent] = sums[nodes[i].parent].map((value, k) => value + sums[i][k]);
    return sums.map((sum, i) => sum.map((value) => (nodes[i].throughput > 0 ? value / nodes[i].throughput : 0)));
  }

  // The rays that count most, with their numbers: a ray's throughput is never above its parent's, so that they are a tree.
  function numbered_rays(nodes) {
    const rays = nodes.map((node, index) => ({ ...node, index })).filter(({ cast, kind }) => cast && kind !== "shadow");
    const heaviest = [...rays].sort((a, b) => b.throughput - a.throughput || a.index - b.index).slice(0, most_nodes);
    const shown = heaviest.sort((a, b) => a.index - b.index);
    shown.forEach((ray, i) => (ray.number = i + 1));
    return { shown, left_out: rays.length - shown.length };
  }

  function tree(nodes) {
    const { shown, left_out } = numbered_rays(nodes);
    const colors = brought(nodes);
    const width = 176, height = 58, gap = 14, level = 96;
    const below = (ray) => shown.filter(({ parent }) => parent === ray.index);
    let leaves = 0;
    const place = (ray, depth) => {
      ray.y = depth * level;
      const children = below(ray).map((child) => place(child, depth + 1));
      ray.x = children.length > 0 ? (children[0].x + children.at(-1).x) / 2 : leaves++ * (width + gap);
      return ray;
    };
    place(shown[0], 0);
    const drawn = svg("svg", { role: "img", "aria-label": "ray tree", "font-size": 12.5 });
    const at = new Map(shown.map((ray) => [ray.index, ray]));
    for (const ray of shown.slice(1)) {
      const parent = at.get(ray.parent);
      const x1 = parent.x + width / 2, y1 = parent.y + height, x2 = ray.x + width / 2, y2 = ray.y;
      drawn.append(svg("line", { x1, y1, x2, y2, stroke: look[ray.kind].color, "stroke-dasharray": look[ray.kind].dash, "stroke-width": 1 + 4 * ray.throughput }),
        svg("text", { x: (x1 + x2) / 2 + 6, y: (y1 + y2) / 2 + 4, fill: look[ray.kind].color }, `${ray.kind === "reflected" ? "R" : "T"} × ${Number((ray.throughput / parent.throughput).toPrecision(3))}`));
    }
    for (const ray of shown) {
      const color = colors[ray.index];
      const line = (y, words, weight) => svg("text", { x: ray.x + width / 2, y: ray.y + y, "text-anchor": "middle", fill: readable_on(color), "font-weight": weight }, words);
      drawn.append(svg("g", { class: "ray", "data-node": ray.index, "data-throughput": ray.throughput, "data-object": ray.object },
        svg("rect", { x: ray.x, y: ray.y, width, height, rx: 6, fill: css_color(color), stroke: look[ray.kind].color, "stroke-width": 3, "stroke-dasharray": look[ray.kind].dash }),
        line(17, `${ray.number}: ${ray.object || "background"}`, 700), line(34, `throughput ${share_words(ray.throughput)}`, 400),
        line(50, `adds ${in_words(ray.local.map((value) => value * ray.throughput))}`, 400)));
    }
    const depth = Math.max(...shown.map(({ y }) => y)) + height;
    drawn.setAttribute("viewBox", `-4 -4 ${Math.max(leaves, 1) * (width + gap) + 8} ${depth + 8}`);
    drawn.style.maxWidth = `${Math.max(leaves, 1) * (width + gap) + 8}px`;
    return { drawn, left_out };
  }

  // The part of a view in which the rays that count most have their hits; the others leave it, as the eye ray enters.
  function part_shown(view, rays) {
    const hits = rays.filter(({ t }) => t !== null).sort((a, b) => b.throughput - a.throughput).slice(0, 6)
      .map((ray) => along(ray, ray.t)).map((point) => [dot(point, view.right), dot(point, view.up)]);
    const range = (axis) => {
      const values = hits.map((point) => point[axis]);
      const all = values.length > 0 ? values : [view.low[axis], view.high[axis]];
      return { middle: (Math.min(...all) + Math.max(...all)) / 2, length: Math.max(...all) - Math.min(...all) };
    };
    const x = range(0), y = range(1), whole = Math.max(view.high[0] - view.low[0], view.high[1] - view.low[1]);
    const scale = Math.min(size[0] / (1.3 * x.length + 0.1 * whole), size[1] / (1.3 * y.length + 0.1 * whole));
    return ([right, up]) => [size[0] / 2 + scale * (right - x.middle), size[1] / 2 - scale * (up - y.middle)];
  }

  // Beside the middle of the part that is seen; neighbours in number a little apart.
  function number_place(from, to, number) {
    const direction = [to[0] - from[0], to[1] - from[1]];
    let [begin, end] = [0, 1];
    for (const axis of [0, 1]) {
      const crossings = [(12 - from[axis]) / direction[axis], (size[axis] - 12 - from[axis]) / direction[axis]].sort((a, b) => a - b);
      if (Number.isFinite(crossings[0])) [begin, end] = [Math.max(begin, crossings[0]), Math.min(end, crossings[1])];
    }
    const share = begin + (end - begin) * (0.5 + 0.08 * ((number % 3) - 1)), length = Math.hypot(...direction) || 1;
    return [from[0] + share * direction[0] - (10 * direction[1]) / length, from[1] + share * direction[1] + (10 * direction[0]) / length + 5];
  }

  const along = ({ origin, direction }, t) => origin.map((value, i) => value + t * direction[i]);
  const dot = (a, b) => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];

  function scene(view, nodes) {
    const { shown } = numbered_rays(nodes);
    const on_page = part_shown(view, shown);
    const seen = (point) => on_page([dot(point, view.right), dot(point, view.up)]);
    const drawn = svg("svg", { viewBox: `0 0 ${size.join(" ")}`, role: "img", "aria-label": `the rays ${view.words}`, "font-size": 15 });
    for (const corners of view.outlines) {
      const points = [];
      for (let i = 0; i < corners.length; i += 2) points.push(on_page([corners[i], corners[i + 1]]).map((value) => value.toFixed(1)).join(","));
      drawn.append(svg("polygon", { points: points.join(" "), fill: "none", stroke: "#9a9aa2" }));
    }
    const line = (ray, t, width) => {
      const [x1, y1] = seen(ray.origin), [x2, y2] = seen(along(ray, t));
      drawn.append(svg("line", { x1, y1, x2, y2, stroke: look[ray.kind].color, "stroke-width": width, "stroke-dasharray": look[ray.kind].dash }));
      return [[x1, y1], [x2, y2]];
    };
    const far = 4 * Math.hypot(view.high[0] - view.low[0], view.high[1] - view.low[1]);  // beyond the drawing
    const numbers = new Map(shown.map((ray) => [ray.index, ray.number]));
    for (const node of nodes) {
      if (!node.cast || node.kind !== "shadow" || !numbers.has(node.parent)) continue;
      const [from, to] = line(node, node.t ?? far, 1.2);
      const along_it = (axis) => from[axis] + 0.2 * (to[axis] - from[axis]);
      if (node.ended === "blocked") drawn.append(svg("text", { x: along_it(0), y: along_it(1) + 5, fill: "#595959", "text-anchor": "middle" }, "×"));
    }
    for (const ray of shown) {
      const [from, to] = line(ray, ray.t ?? far, 1.5 + 2 * ray.throughput);
      if (ray.t !== null) drawn.append(svg("circle", { cx: to[0], cy: to[1], r: 3.5, fill: look[ray.kind].color }));
      const [x, y] = number_place(from, to, ray.number);
      drawn.append(svg("text", { x, y, fill: look[ray.kind].color, stroke: "#fff", "stroke-width": 4, "paint-order": "stroke", "font-weight": 700, "text-anchor": "middle" }, String(ray.number)));
    }
    return drawn;
  }

  return { tree, scene };
})();
