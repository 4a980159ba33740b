#include <reports/document/html/html_view.hpp>

namespace pmreport::document {

// The 3D view, which the script makes. Stands after html_theme. On narrow screens the picture stays in sight while the reader moves the
// machine by hand; on paper the still pictures do.
const char* const html_view_style = R"css(
.view-stage { position: relative; overflow: hidden; border: 1px solid var(--rule); background: radial-gradient(ellipse at 50% 40%, #fff, #f3f5f7); }
.view-stage canvas { display: block; width: 100%; height: clamp(18rem, 62vh, 34rem); touch-action: pan-y; cursor: grab; }
.view-stage canvas:active { cursor: grabbing; } .view-stage canvas.on-platform { cursor: move; }
.view-stage canvas:focus-visible { outline: 3px solid var(--link); outline-offset: -3px; }
.view-row { display: flex; flex-wrap: wrap; align-items: center; gap: .5rem .8rem; margin: .6rem 0; font-size: .875rem; }
.view-row .time { flex: 1 1 16rem; max-width: none; margin: 0; }
.view-row select { font: inherit; color: var(--ink); background: var(--paper); border: 1px solid var(--rule); border-radius: .3rem; padding: .2rem .3rem; min-height: 2rem; }
.view-row select:focus-visible { outline: 2px solid var(--link); outline-offset: 2px; }
.view-button { font: inherit; font-size: .875rem; color: var(--ink); background: var(--paper); border: 1px solid var(--rule); border-radius: .3rem; padding: .2rem .7rem; min-height: 2rem; cursor: pointer; }
.view-button:hover { border-color: var(--ink); } .view-button.play { min-width: 6.2em; }
.view-choice { display: inline-flex; } .view-choice .view-button { border-radius: 0; margin-left: -1px; }
.view-choice .view-button:first-child { border-radius: .3rem 0 0 .3rem; margin-left: 0; } .view-choice .view-button:last-child { border-radius: 0 .3rem .3rem 0; }
.view-choice .view-button[aria-pressed="true"] { background: var(--link); border-color: var(--link); color: var(--paper); position: relative; }
.view-help { margin: .3rem 0 0; max-width: none; font-size: .85rem; } .for-fingers, .for-hands { display: none; } .by-hand .for-hands { display: inline; }
.axis { position: absolute; top: 0; left: 0; pointer-events: none; font-size: .85rem; font-weight: 650; line-height: 1; }
.axis { text-shadow: 0 0 3px var(--paper), 0 0 3px var(--paper), 0 0 3px var(--paper); }
.axis-x { color: #b3261e; } .axis-y { color: #1f6f2c; } .axis-z { color: #2a5fc4; }
.grip, .grip:hover { position: absolute; top: 0; left: 0; width: 2.75rem; height: 2.75rem; padding: 0; border: 0; background: none; border-radius: 50%; cursor: move; touch-action: none; }
.grip::before { content: ""; position: absolute; inset: .6rem; border-radius: 50%; border: 2px solid #fff; background: radial-gradient(circle, #d2560a 0 24%, #d2560a33 27%); box-shadow: 0 0 0 1.5px #d2560a; }
.grip:focus-visible { outline: 3px solid var(--link); outline-offset: -3px; }

.hand { font-size: .875rem; margin-top: .6rem; }
.hand-verdict { position: absolute; left: .5rem; right: .5rem; bottom: .5rem; pointer-events: none; }
.hand-status { display: inline-block; margin: 0; padding: .1rem .5rem; max-width: none; font-size: .875rem; font-weight: 600; line-height: 1.4; color: var(--good); background: var(--paper); border-left: .25rem solid; }
.hand-status.broken { color: var(--bad); }
.unseen, .readings caption { position: absolute; width: 1px; height: 1px; margin: 0; overflow: hidden; clip-path: inset(50%); }
.hand-columns { display: grid; grid-template-columns: repeat(2, minmax(0, 1fr)); gap: 0 2rem; align-items: start; }
.hand table { width: 100%; font-size: inherit; margin-top: .8rem; table-layout: auto; }
.hand th, .hand td { padding: .22rem .5rem .22rem 0; vertical-align: middle; } .hand caption { padding: 0 0 .2rem; position: static; }
.hand thead th { vertical-align: bottom; } .hand-table tbody th { white-space: nowrap; min-width: 5.6em; }
.hand-table td:nth-child(2) { width: 60%; min-width: 5rem; } .hand-table .value { text-align: left; } .hand-table .force { min-width: 6.2em; }
.by-hand .view-stage canvas { height: clamp(16rem, 46vh, 30rem); }
.hand-table input[type="range"] { display: block; width: 100%; min-height: 1.6rem; margin: 0; accent-color: var(--link); background: none; }
.stroke { background: linear-gradient(var(--rule), var(--rule)) center / calc((100% - 1rem) / 1.2) 1.1rem no-repeat; }
.entry { font: inherit; color: var(--ink); background: var(--paper); border: 1px solid var(--rule); border-radius: .3rem; width: 5.6rem; text-align: right; padding: .15rem .35rem; min-height: 1.75rem; }
.hand .unit { display: inline-block; min-width: 1.9em; color: var(--quiet); } .hand .word { color: var(--bad); font-weight: 600; }
.remark { display: block; color: var(--quiet); white-space: normal; font-size: .8rem; line-height: 1.3; max-width: 11rem; } .remark:empty { display: none; }
.entry[aria-invalid="true"] { border-color: var(--bad); } .entry[aria-invalid="true"] ~ .remark { color: var(--bad); font-weight: 600; }
.view-lost { position: absolute; inset: 0; display: flex; flex-direction: column; align-items: center; padding: .8rem; background: var(--paper); }
.view-lost p { margin: 0 0 .5rem; } .view-lost img { min-height: 0; max-width: 100%; object-fit: contain; }
.hand tr.broken > *, .hand tr.broken .entry { color: var(--bad); font-weight: 600; }
.hand-condition { margin: .8rem 0 0; }

@media screen and (prefers-color-scheme: dark) {
  .view-stage { background: radial-gradient(ellipse at 50% 40%, #262d35, #191e24); }
  .axis-x { color: #ff8d85; } .axis-y { color: #74d198; } .axis-z { color: #8fb6ff; }
}
@media (pointer: coarse) { .for-mouse { display: none; } .for-fingers { display: inline; } }
@media screen and (max-width: 60rem) {
  .view-stage canvas { height: min(92vw, 62vh); }
  .view-row .time { order: 1; flex-basis: 100%; } .view-row .time output { min-width: 0; }
  .by-hand .view-stage { position: sticky; top: 2.9rem; z-index: 1; } .by-hand .view-stage canvas { height: min(70vw, 42vh); }
  .hand-columns { grid-template-columns: minmax(0, 1fr); }
  .hand-table td:nth-child(2) { min-width: 3.5rem; } .hand-table .force { min-width: 0; } .entry { width: 4.9rem; } .hand th, .hand td { padding-right: .35rem; } .hand-limits .number { white-space: normal; }
}
@media print { #machine-view, .to-view { display: none; } }
)css";

}  // namespace pmreport::document
