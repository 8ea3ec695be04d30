#include "raylab/report/page/style.h"

namespace raylab {

const char* lab_book_style() {
    return R"(
:root {
  color-scheme: light dark;
  --paper: #fdfcf9; --ink: #1d1d1f; --quiet: #5c5c66; --rule: #dcd9d0; --card: #ffffff; --link: #0059a3;
  --good: #00684a; --bad: #a83500; --good-back: #e7f4ee; --bad-back: #fdece3; --code-back: #f1efe8;
}
@media (prefers-color-scheme: dark) {
  :root {
    --paper: #16171a; --ink: #e9e7e1; --quiet: #a2a1a8; --rule: #36373d; --card: #1f2025; --link: #7cc0ff;
    --good: #5fd3a8; --bad: #ff9c6b; --good-back: #16302a; --bad-back: #3a2118; --code-back: #26272d;
  }
}
* { box-sizing: border-box; }
html { font-size: 112.5%; scroll-padding-top: 1rem; }
body {
  margin: 0; background: var(--paper); color: var(--ink);
  font-family: Charter, "Bitstream Charter", "Iowan Old Style", Georgia, "DejaVu Serif", serif; line-height: 1.6;
}
h1, h2, h3, nav, th, .number, .facts, .verdict, .card p, figcaption, .chip, .data {
  font-family: system-ui, -apple-system, "Segoe UI", Roboto, "Noto Sans", "DejaVu Sans", sans-serif;
}
header, main, footer, nav.book { max-width: 74rem; margin: 0 auto; padding: 0 1.5rem; }
main > * { max-width: 42rem; }
main > pre { max-width: max-content; }
main > .wide { max-width: none; }
a { color: var(--link); text-underline-offset: 0.15em; }
a:focus-visible, summary:focus-visible, .scroll:focus-visible { outline: 3px solid var(--link); outline-offset: 3px; border-radius: 2px; }
.skip { position: absolute; left: -99rem; }
.skip:focus { left: 1rem; top: 1rem; background: var(--card); padding: 0.5rem 1rem; z-index: 1; }
nav.book { display: flex; gap: 1.5rem; justify-content: space-between; padding-top: 1.1rem; padding-bottom: 1.1rem; font-size: 0.83rem; }
nav.book a { text-decoration: none; }
nav.book a:hover { text-decoration: underline; }
nav.book > :nth-child(2) { text-align: center; }
nav.book > :last-child { text-align: right; }
nav.book > * { flex: 1; }
header { padding-top: 2.2rem; padding-bottom: 1.2rem; }
.number { margin: 0; color: var(--quiet); font-size: 0.83rem; font-weight: 600; letter-spacing: 0.09em; text-transform: uppercase; }
h1 { font-size: 2.6rem; line-height: 1.12; letter-spacing: -0.022em; margin: 0.25rem 0 0.6rem; }
.question { font-size: 1.35rem; line-height: 1.4; font-style: italic; color: var(--quiet); margin: 0; max-width: 46rem; }
h2 { font-size: 1.5rem; line-height: 1.25; letter-spacing: -0.012em; margin: 3.2rem 0 0.8rem; }
h3 { font-size: 1.08rem; margin: 2rem 0 0.5rem; }
code, pre { font-family: ui-monospace, "SF Mono", Menlo, "DejaVu Sans Mono", monospace; font-size: 0.86em; }
code { background: var(--code-back); padding: 0.08em 0.3em; border-radius: 3px; }
pre { background: var(--code-back); padding: 0.9rem 1.1rem; border-radius: 6px; overflow-x: auto; line-height: 1.45; }
pre code { background: none; padding: 0; }
.contents { margin: 1rem 0 0; padding: 0; list-style: none; display: flex; flex-wrap: wrap; gap: 0.4rem 1.4rem; font-size: 0.88rem; }
figure { margin: 0; }
figure img { display: block; max-width: 100%; height: auto; border-radius: 4px; }
figure.chart, figure.drawing { background: #fff; border: 1px solid var(--rule); border-radius: 8px; padding: 0.6rem; }
figure.chart figcaption, figure.drawing figcaption { color: #44444c; padding: 0 0.6rem 0.3rem; }
figure.chart img { width: 100%; }
figure.chart a { color: #0059a3; }
figcaption { color: var(--quiet); font-size: 0.86rem; line-height: 1.45; margin-top: 0.55rem; }
.steps { display: grid; grid-template-columns: repeat(auto-fit, minmax(min(100%, 17rem), 1fr)); gap: 1.6rem; margin: 1.8rem 0; }
.steps img { width: 100%; }
.steps img.small { image-rendering: pixelated; }
.step { font-weight: 700; color: var(--ink); margin-right: 0.35em; }
.scroll { overflow-x: auto; margin: 1.4rem 0; }
table { border-collapse: collapse; font-size: 0.86rem; line-height: 1.4; min-width: min(100%, 30rem); }
caption { text-align: left; color: var(--quiet); padding-bottom: 0.5rem; caption-side: top; font-size: 0.86rem; }
th { text-align: left; font-weight: 600; font-size: 0.8rem; color: var(--quiet); border-bottom: 2px solid var(--rule); vertical-align: bottom; }
tbody th { vertical-align: top; color: var(--ink); border-bottom: 1px solid var(--rule); font-size: 0.83rem; }
th, td { padding: 0.42rem 1.1rem 0.42rem 0; }
td { border-bottom: 1px solid var(--rule); vertical-align: top; }
td.data, th.data { text-align: right; font-variant-numeric: tabular-nums; white-space: nowrap; }
td.front { font-weight: 700; }
.verdict { white-space: nowrap; font-weight: 600; }
.good { color: var(--good); } .bad { color: var(--bad); }
tr.unexpected td, tr.unexpected th { background: var(--bad-back); }
.chip { display: inline-block; font-size: 0.78rem; font-weight: 600; padding: 0.12rem 0.6rem; border-radius: 99rem; }
.chip.good { background: var(--good-back); } .chip.bad { background: var(--bad-back); }
details { margin: 1rem 0; } summary { cursor: pointer; font-size: 0.9rem; color: var(--link); }
.cards { display: grid; grid-template-columns: repeat(auto-fill, minmax(min(100%, 24rem), 1fr)); gap: 1.6rem; padding: 0; margin: 2rem 0; list-style: none; }
.card { background: var(--card); border: 1px solid var(--rule); border-radius: 10px; overflow: hidden; position: relative; }
.card:hover, .card:focus-within { border-color: var(--link); }
.card .picture { aspect-ratio: 16 / 10; background: #1b1c20; }
.card .picture img { width: 100%; height: 100%; object-fit: cover; display: block; }
.card .picture.drawn { background: #fff; } .card .picture.drawn img { object-fit: contain; padding: 0.8rem; }
.card .words { padding: 1rem 1.2rem 1.2rem; }
.card h2 { margin: 0.1rem 0 0.3rem; font-size: 1.2rem; }
.card h2 a { color: inherit; text-decoration: none; }
.card h2 a::after { content: ""; position: absolute; inset: 0; }
.card p { margin: 0.3rem 0; font-size: 0.9rem; color: var(--quiet); line-height: 1.45; }
.card p.question { font-size: 1rem; font-family: inherit; }
footer { margin-top: 4rem; padding-top: 1.4rem; padding-bottom: 3rem; border-top: 1px solid var(--rule); color: var(--quiet); }
.facts { display: grid; grid-template-columns: max-content 1fr; gap: 0.15rem 1.2rem; font-size: 0.83rem; margin: 0.6rem 0 0; }
.facts dt { font-weight: 600; } .facts dd { margin: 0; }
@media print { nav.book, .skip { display: none; } body { background: #fff; } h2 { break-after: avoid; } figure, tr { break-inside: avoid; } }
)";
}

}  // namespace raylab
