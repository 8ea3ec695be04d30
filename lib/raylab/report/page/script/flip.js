// A group of two pictures of one size: flip between them in one place, or wipe from one to the other.
{
  const pairs = [...document.querySelectorAll(".figures")].filter((group) => {
    const images = [...group.querySelectorAll("figure img")];
    return images.length === 2 && images[0].width > 0 &&
      images[0].getAttribute("width") === images[1].getAttribute("width") &&
      images[0].getAttribute("height") === images[1].getAttribute("height");
  });

  for (const group of pairs) {
    const [one, other] = group.querySelectorAll("figure");
    const look = (kind) => {
      group.classList.toggle("in-one-place", kind !== "beside");
      group.classList.toggle("wiped", kind === "wipe");
      beside.hidden = kind === "beside";
      share.parentElement.hidden = kind !== "wipe";
    };
    const show = (shown) => {
      one.classList.toggle("behind", shown !== one);
      other.classList.toggle("behind", shown !== other);
    };
    const flip = button("flip", () => {
      const again = group.classList.contains("in-one-place") && !group.classList.contains("wiped");
      look("flip");
      show(again && other.classList.contains("behind") ? other : one);
    });
    const wipe = button("wipe", () => {
      look("wipe");
      share.focus();
    });
    const beside = button("side by side", () => {
      look("beside");
      flip.focus();
    });
    const share = element("input", { type: "range", min: "0", max: "100", value: "50", "aria-label": "how much of the second picture" });
    const place = () => group.style.setProperty("--wiped", `${share.value}%`);
    share.addEventListener("input", place);
    group.prepend(element("div", { class: "controls", role: "group", "aria-label": "Compare the two pictures" },
      flip, wipe, element("label", {}, share), beside));
    place();
    look("beside");
  }
}
