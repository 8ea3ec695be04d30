// A button beside each command that copies it. Where the browser forbids that, the command is selected instead.
{
  const copy = async (code, pressed) => {
    try {
      await navigator.clipboard.writeText(code.textContent.trim());
      pressed.textContent = "copied";
      setTimeout(() => (pressed.textContent = "copy"), 1500);
    } catch {
      getSelection().selectAllChildren(code);
    }
  };
  for (const code of document.querySelectorAll("pre.sh > code, .command > code")) {
    const pressed = button("copy", () => copy(code, pressed), { class: "copy" });
    code.after(pressed);
  }
}
