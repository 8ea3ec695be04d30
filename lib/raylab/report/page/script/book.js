"use strict";
// What the other scripts share: how elements are made, and the keys with their list. This file is first by its name.

function element(tag, attributes = {}, ...children) {
  const made = document.createElement(tag);
  for (const [name, value] of Object.entries(attributes)) made.setAttribute(name, value);
  made.append(...children);
  return made;
}

function button(words, run, attributes = {}) {
  const made = element("button", { type: "button", ...attributes }, words);
  made.addEventListener("click", run);
  return made;
}

const in_lecture = () => document.body.classList.contains("lecture");

// A key does something on the page, in the lecture, or in both.
const keys = [];

function on_keys(names, words, where, run) {
  keys.push({ names, words, where, run });
}

document.addEventListener("keydown", (event) => {
  if (event.ctrlKey || event.metaKey || event.altKey || event.defaultPrevented) return;
  if (event.target.closest("input:not([type='range']), textarea, select, dialog, [data-own-keys]")) return;
  const where = in_lecture() ? "lecture" : "page";
  const key = keys.find((one) => one.names.includes(event.key) && (one.where === where || one.where === "both"));
  // Space and Enter stay with the button or link that has the focus.
  if (!key || (" Enter".includes(event.key) && event.target.closest("button, a, summary"))) return;
  event.preventDefault();
  key.run();
});

const shown_name = { " ": "space", ArrowRight: "→", ArrowLeft: "←", ArrowDown: "↓", ArrowUp: "↑", Escape: "Esc" };

function show_keys() {
  const rows = keys.map(({ names, words, where }) =>
    element("tr", {},
      element("th", { scope: "row" }, ...names.flatMap((name) => [element("kbd", {}, shown_name[name] ?? name), " "])),
      element("td", {}, words), element("td", {}, where === "both" ? "" : `in the ${where}`)));
  const dialog = element("dialog", { class: "keys", "aria-label": "Keys" },
    element("table", {}, element("tbody", {}, ...rows)), button("close", () => dialog.close()));
  dialog.addEventListener("close", () => dialog.remove());
  document.body.append(dialog);
  dialog.showModal();
}

// The row of buttons at the top of each page, for mice and fingers.
const tools = element("div", { class: "tools", role: "group", "aria-label": "Tools" });
document.querySelector(".skip")?.after(tools);
on_keys(["?"], "this list", "both", show_keys);
tools.append(button("keys", show_keys, { title: "?" }));
