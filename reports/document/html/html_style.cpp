#include <reports/document/html/html_page.hpp>

namespace pmreport::document {

// Wide screens: contents beside the text and always in sight. Narrow ones: contents are one line at the top that moves sideways, and so
// does whatever is wider than the screen, each in its own box. Colour says nothing that a word does not say too.
const char* const html_style = R"css(
:root { --ink: #1b1f24; --quiet: #565e68; --rule: #d5dae0; --shade: #f4f6f8; --link: #0b4f8a;
  --good: #17663a; --bad: #a3161c; --alert: #7a4b00; }
* { box-sizing: border-box; }
html { scroll-padding-top: 1rem; -webkit-text-size-adjust: 100%; text-size-adjust: 100%; }
body { margin: 0; color: var(--ink); background: #fff; line-height: 1.55;
  font: 1rem/1.55 system-ui, -apple-system, "Segoe UI", Roboto, "Noto Sans", "Liberation Sans", "DejaVu Sans", sans-serif;
  font-variant-numeric: tabular-nums; display: grid; grid-template-columns: 15rem minmax(0, 56rem); column-gap: 3rem; justify-content: center; }
main { padding: 2.5rem 1.5rem 5rem 0; min-width: 0; }
a { color: var(--link); text-underline-offset: .15em; text-decoration-thickness: .06em; }
a:focus-visible, [tabindex]:focus-visible, summary:focus-visible { outline: 2px solid var(--link); outline-offset: 2px; }
p { max-width: 42rem; margin: .6rem 0; text-wrap: pretty; }
h1, h2 { line-height: 1.2; letter-spacing: -.01em; text-wrap: balance; overflow-wrap: break-word; }
h1 { font-size: 2rem; font-weight: 650; margin: 0 0 .4rem; }
h2 { font-size: 1.4rem; font-weight: 650; margin: 0 0 1rem; }
.section-number { color: var(--quiet); font-weight: 450; font-variant-numeric: tabular-nums; margin-right: .3em; }
header p { margin: .15rem 0; color: var(--quiet); }
header .mechanism { color: var(--ink); font-size: 1.1rem; }
header .description { color: var(--ink); margin: .8rem 0; white-space: pre-line; }
header .source { font-size: .9rem; }
header .files { margin-top: .6rem; font-size: .9rem; }
section { margin-top: 3.2rem; }
section#summary { margin-top: 1.8rem; }

nav { position: sticky; top: 0; align-self: start; max-height: 100vh; overflow-y: auto; padding: 2.9rem 0 2rem 1.5rem; font-size: .925rem; line-height: 1.35; }
nav .label { margin: 0 0 .5rem; color: var(--quiet); font-size: .8rem; letter-spacing: .06em; text-transform: uppercase; }
nav ol { list-style: none; margin: 0; padding: 0; border-left: 1px solid var(--rule); }
nav li { padding: .28rem 0 .28rem .9rem; }
nav a { color: var(--ink); text-decoration: none; }
nav a:hover { color: var(--link); text-decoration: underline; }
nav .failed { color: var(--bad); font-weight: 700; }

h3 { font-size: 1.05rem; font-weight: 650; margin: 1.8rem 0 .5rem; }
.front { display: flex; flex-wrap: wrap; gap: 1.4rem 2rem; align-items: stretch; }
.front figure { margin: 0; flex: 3 1 22rem; max-width: 33rem; } .front img { display: block; width: 100%; height: auto; border: 1px solid var(--rule); background: #fff; }
.front .verdict { flex: 2 1 14rem; }
.verdict { border-left: .4rem solid var(--quiet); background: var(--shade); padding: .8rem 1.2rem .9rem; margin: 0; }
.verdict h2 { margin: 0 0 .6rem; font-size: 1.5rem; }
.verdict dl { display: block; margin: 0; } .verdict dt { margin: .6rem 0 .1rem; font-weight: 600; color: var(--ink); } .verdict dd { margin: 0; }
.verdict.passed { background: #eef7f1; border-color: var(--good); } .verdict.passed h2 { color: var(--good); }
.verdict.failed { background: #fcefee; border-color: var(--bad); } .verdict.failed h2 { color: var(--bad); }
.verdict .disagreement { border-left: .25rem solid #c58a1b; padding-left: .7rem; margin-top: .9rem; }
.states { list-style: none; margin: 0; padding: 0; }
.state::before { content: ""; display: inline-block; width: .6em; height: .6em; margin-right: .5em; background: var(--quiet); }
.state.passed::before { background: var(--good); } .state.failed::before, .state.error::before { background: var(--bad); } .state.not-decided::before { background: #c58a1b; }
.keys { list-style: none; margin: 0; padding: 0; display: grid; gap: 0 1.6rem; grid-template-columns: repeat(auto-fill, minmax(min(100%, 15rem), 1fr)); }
.keys li { border-top: 1px solid var(--rule); padding: .6rem 0 .7rem; overflow-wrap: anywhere; }
.keys .what { font-size: .9rem; } .keys .value { font-size: 1.35rem; font-weight: 650; line-height: 1.25; }
.keys .limit, .keys .where { font-size: .875rem; color: var(--quiet); }
.bar { display: block; width: 100%; height: .7rem; margin: .25rem 0; }
.bar .track { fill: var(--rule); } .bar .fill { fill: var(--good); } .bar.tight .fill { fill: #c58a1b; } .bar.broken .fill { fill: var(--bad); } .bar .tick { fill: var(--ink); }
.findings { margin: 0; padding: 0; list-style: none; max-width: 48rem; }
.findings li { border-left: .25rem solid var(--rule); padding: .1rem 0 .1rem .9rem; margin: .55rem 0; }
.fault-found { border-color: var(--bad) !important; } .disagreement-found { border-color: #c58a1b !important; } .surprise-found { border-color: var(--link) !important; }
.fault-found strong { color: var(--alert); }
.unexamined, .assumptions { margin: 0; padding-left: 2.2rem; max-width: 46rem; color: var(--quiet); font-size: .925rem; }
.unexamined { padding-left: 1.2rem; }
.assumptions { counter-reset: a; list-style: none; } .assumptions li { counter-increment: a; } .assumptions li::before { content: "A" counter(a); display: inline-block; width: 2.2rem; margin-left: -2.2rem; }
.warning { background: #fdf5e3; border-left: .4rem solid #c58a1b; padding: .6rem 1.2rem; max-width: none; }
.warning strong { color: var(--alert); }
.note { color: var(--quiet); font-size: .925rem; }
.result { white-space: nowrap; font-weight: 600; } .result.passed { color: var(--good); } .result.failed { color: var(--bad); } .result.undecided { color: var(--alert); }

.scroll { overflow-x: auto; margin: 1.4rem 0; background: linear-gradient(to right, #fff 40%, transparent) left / 2rem 100% no-repeat local,
  linear-gradient(to left, #fff 40%, transparent) right / 2rem 100% no-repeat local,
  linear-gradient(to right, #0b1c2e33, transparent) left / .7rem 100% no-repeat, linear-gradient(to left, #0b1c2e33, transparent) right / .7rem 100% no-repeat; }
figure .scroll { margin: 0; }
table { border-collapse: collapse; font-size: .925rem; line-height: 1.4; }
caption { text-align: left; font-weight: 600; padding: 0 0 .5rem; }
@media screen { caption { position: sticky; left: 0; max-width: calc(100vw - 2.5rem); } }
th, td { text-align: left; vertical-align: top; padding: .42rem 1.4rem .42rem 0; border-bottom: 1px solid var(--rule); }
th:last-child, td:last-child { padding-right: .2rem; }
.proof td:first-child { padding-right: 1rem; }
thead th { color: var(--quiet); font-weight: 600; vertical-align: bottom; border-bottom: 1px solid var(--ink); }
tbody th { font-weight: 400; }
tbody tr:last-child > * { border-bottom-color: var(--ink); }
.number { text-align: right; white-space: nowrap; } .list { white-space: normal; }
.proof { width: 100%; min-width: 36rem; }
.proof tbody th > div:first-child { font-weight: 500; }
.how { color: var(--quiet); font-size: .875rem; max-width: 34rem; }

figure { margin: 1.8rem 0; }
figcaption { color: var(--quiet); font-size: .9rem; line-height: 1.45; margin-top: .5rem; max-width: 46rem; }
figcaption strong { color: var(--ink); font-weight: 600; }
.files { white-space: nowrap; }
.plot svg, .gallery img, .gallery .lines svg { display: block; width: 100%; height: auto; }
.plot.full svg { min-width: 38rem; }
.plot.column { max-width: 30rem; } .plot.column svg { min-width: 18rem; }
.pictures { display: grid; gap: 1.4rem; grid-template-columns: repeat(auto-fill, minmax(min(100%, 22rem), 1fr)); }
.gallery.single .pictures { display: block; }
.pictures figure { margin: 0; } .pictures img { border: 1px solid var(--rule); background: #fff; }

details summary { cursor: pointer; }
pre { counter-reset: line; background: var(--shade); padding: 1rem; overflow-x: auto; font: .85rem/1.5 ui-monospace, "DejaVu Sans Mono", Menlo, Consolas, monospace; tab-size: 4; }
.line::before { counter-increment: line; content: counter(line); display: inline-block; width: 2.2rem; margin-right: 1.2rem; text-align: right; color: var(--quiet); }
.line:target { background: #fff0b8; }
dl { display: grid; grid-template-columns: max-content minmax(0, 1fr); gap: .3rem 1.6rem; margin: 0; font-size: .925rem; }
#provenance { border-top: 1px solid var(--rule); padding-top: 1rem; font-size: .85rem; } #provenance h2 { font-size: 1rem; margin-bottom: .5rem; }
dt { color: var(--quiet); } dd { margin: 0; overflow-wrap: anywhere; }

@media screen and (max-width: 60rem) {
  html { scroll-padding-top: 3.6rem; }
  body { display: block; }
  nav { z-index: 1; max-height: none; overflow: visible; padding: 0; background: #fff; border-bottom: 1px solid var(--rule); }
  nav .label { position: absolute; width: 1px; height: 1px; overflow: hidden; clip-path: inset(50%); }
  nav ol { display: flex; gap: 1.3rem; overflow-x: auto; white-space: nowrap; padding: .25rem 1.1rem; border: 0; scrollbar-width: none; }
  nav li { padding: .55rem 0; }
  main { padding: 1.5rem 1.1rem 4rem; }
  h1 { font-size: 1.6rem; }
  dl { grid-template-columns: minmax(0, 1fr); gap: 0; } dd { margin-bottom: .6rem; }
}

@media print {
  @page { size: A4; margin: 18mm; }
  html { font-size: 9.5pt; }
  body { display: block; }
  nav, .files { display: none; }
  main { padding: 0; }
  a { color: inherit; text-decoration: none; }
  section { margin-top: 1.6rem; }
  h2, caption, thead { break-after: avoid; }
  figure, tr, .verdict, .warning { break-inside: avoid; }
  .gallery { break-inside: auto; }
  .scroll { overflow: visible; background: none; }
  .proof, .plot.full svg { min-width: 0; }
  pre { white-space: pre-wrap; overflow: visible; }
  .verdict, .warning, pre { print-color-adjust: exact; -webkit-print-color-adjust: exact; }
}
)css";

}  // namespace pmreport::document
