// Light or dark, whatever the system prefers: the style sheet's rules for dark screens are switched on or off for all.
{
  const dark_rules = [...document.styleSheets].flatMap((sheet) => [...sheet.cssRules])
    .filter((rule) => rule instanceof CSSMediaRule && rule.conditionText.includes("prefers-color-scheme: dark"));
  const is_dark = () => matchMedia(dark_rules[0].media.mediaText).matches;

  const switch_scheme = () => {
    const scheme = is_dark() ? "light" : "dark";
    for (const rule of dark_rules) rule.media.mediaText = scheme === "dark" ? "screen" : "not all";
    document.documentElement.style.colorScheme = scheme;
  };
  if (dark_rules.length > 0) on_keys(["d"], "dark or light", "both", switch_scheme);
}
