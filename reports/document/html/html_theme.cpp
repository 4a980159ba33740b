#include <reports/document/html/html_page.hpp>

namespace pmreport::document {

// What the style is on a dark screen, what figures carry beside their drawing, and what the script adds. Stands after html_style.
//
// A figure keeps its white paper in the dark: its colours are chosen for white, those of maps mean something, and it is the same figure as
// in the PDF. The paper is dimmed a little, so that it does not glare.
const char* const html_theme = R"css(
:root { --paper: #fff; --shadow: #0b1c2e33; --fine: #eef7f1; --fault: #fcefee; --caution: #fdf5e3; --target: #fff0b8; --cursor: #b3261e; }
body { background: var(--paper); }
main { overflow-wrap: break-word; }
h1, h2, h3, p, li, dt, figcaption, .panel-name { overflow-wrap: anywhere; }
.scroll { background: linear-gradient(to right, var(--paper) 40%, transparent) left / 2rem 100% no-repeat local,
  linear-gradient(to left, var(--paper) 40%, transparent) right / 2rem 100% no-repeat local,
  linear-gradient(to right, var(--shadow), transparent) left / .7rem 100% no-repeat, linear-gradient(to left, var(--shadow), transparent) right / .7rem 100% no-repeat; }
.verdict.passed { background: var(--fine); } .verdict.failed { background: var(--fault); }
.warning { background: var(--caution); }
.line:target { background: var(--target); }
pre { white-space: pre-wrap; overflow-wrap: anywhere; }
.line { display: inline-block; width: 100%; padding-left: 3.4rem; text-indent: -3.4rem; } .line::before { text-indent: 0; }
button:focus-visible, input:focus-visible { outline: 2px solid var(--link); outline-offset: 2px; }
.words-of-figure { margin-top: .4rem; }
.words-of-figure p { margin: .4rem 0 0; color: var(--ink); }
.words-of-figure ul { margin: .1rem 0 0; padding-left: 1.1rem; }
.words-of-figure li { margin: 0; }

.sort { all: unset; position: relative; cursor: pointer; }
.sort:hover { color: var(--link); }
.sort:focus-visible { outline: 2px solid var(--link); outline-offset: 2px; }
.sort::after { content: "↕" / ""; position: absolute; bottom: 0; left: 100%; padding-left: .2em; opacity: 0; } .number .sort::after { left: auto; right: 100%; padding: 0 .2em 0 0; } .sort:hover::after, .sort:focus-visible::after { opacity: .6; }
[aria-sort="ascending"] .sort::after { content: "↑" / ""; opacity: 1; } [aria-sort="descending"] .sort::after { content: "↓" / ""; opacity: 1; }

.controls { font-size: .85rem; line-height: 1.3; padding: .5rem 0 .3rem; background: var(--paper); }
.time { display: flex; align-items: center; gap: .6rem; max-width: 34rem; margin-bottom: .3rem; }
.time input { flex: 1; min-width: 4rem; accent-color: var(--link); } .time output { min-width: 8.5em; }
.curves { display: flex; flex-wrap: wrap; align-items: center; gap: .25rem .35rem; margin: .2rem 0; }
.panel-name { color: var(--quiet); margin-right: .3rem; }
.curve-button { font: inherit; color: var(--ink); background: none; border: 1px solid var(--rule); border-radius: .3rem; padding: .12rem .45rem; cursor: pointer;
  display: inline-flex; align-items: center; gap: .4em; min-height: 24px; max-width: 100%; overflow-wrap: anywhere; text-align: left; }
.curve-button:hover { border-color: var(--ink); }
.curve-button[aria-pressed="false"] { color: var(--quiet); border-style: dashed; text-decoration: line-through; }
.curve-button[aria-pressed="false"] .swatch { opacity: .35; }
.curve-button .value { min-width: 4.4em; text-align: right; }
.readings { font-size: .95em; border-collapse: collapse; font-variant-numeric: tabular-nums; } .readings th, .readings td { padding: .1rem .7rem .1rem 0; }
.readings thead th { color: var(--quiet); font-weight: 400; }
.plot svg.swatch { display: inline; flex: none; width: 22px; min-width: 0; height: 8px; background: #fff; border-radius: 2px; }
.drawing .curve.hidden, .cursor-dot.hidden { display: none; } .drawing .key.hidden { opacity: .3; }
.cursor { pointer-events: none; display: none; } .has-cursor .cursor { display: inline; }
.cursor-line { stroke: var(--cursor); stroke-width: .7; } .cursor-dot { stroke: #fff; stroke-width: .6; }
.drawing .on-key, .drawing .on-key .text { cursor: pointer; }
.drawing .text { user-select: text; cursor: text; } .drawing ::selection { background: #1a73e859; }
@media (min-width: 60rem) and (min-height: 40rem) { .controls { position: sticky; bottom: 0; max-height: 34vh; overflow-y: auto; } }

@media screen and (prefers-color-scheme: dark) {
  :root { color-scheme: dark; --ink: #e6e9ed; --quiet: #a9b2bd; --rule: #38414b; --shade: #1d232a; --link: #86bff5; --good: #74d198; --bad: #ff928c;
    --alert: #f2bd68; --paper: #13171c; --shadow: #0009; --fine: #14291d; --fault: #331a1a; --caution: #2e2513; --target: #4a3d10; --cursor: #b3261e; }
  .plot svg, .pictures img, .front img { background: #fff; border-radius: .25rem; filter: brightness(.88); }
}
@media screen and (max-width: 60rem) { nav { background: var(--paper); } .panel-name { flex-basis: 100%; } }

@media print {
  details::details-content { content-visibility: visible; display: block; block-size: auto; }
  .words-of-figure { font-size: .92em; }
  .drawing .text, .controls, .cursor, .has-cursor .cursor { display: none; }
  .sort::after { content: none; }
}
)css";

}  // namespace pmreport::document
