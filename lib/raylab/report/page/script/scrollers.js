// What is too wide for the screen scrolls by itself, and can be reached and moved by keys.
{
  const mark = () => {
    for (const part of document.querySelectorAll(".equation, pre, .scroll")) {
      if (part.scrollWidth > part.clientWidth) part.tabIndex = 0;
      else part.removeAttribute("tabindex");
    }
  };
  mark();
  addEventListener("resize", mark);
}
