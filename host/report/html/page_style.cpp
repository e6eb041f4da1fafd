// SPDX-License-Identifier: Apache-2.0
#include "report/html/parts.h"

namespace lobe {

// Charts are drawn on white: on dark pages they are inverted with their hues kept.
const char* const page_style = R"css(
:root { --paper: #fff; --ink: #1f2328; --soft: #656d76; --rule: #d8dde3; --tint: #f4f6f8;
  --accent: #6a00a8; color-scheme: light dark; }
@media (prefers-color-scheme: dark) {
  :root { --paper: #141414; --ink: #dfe1e4; --soft: #999fa6; --rule: #33363a; --tint: #1e2022;
    --accent: #d5a6f2; }
  .chart svg { filter: invert(.92) hue-rotate(180deg); }
}
* { box-sizing: border-box; }
body { margin: 0; background: var(--paper); color: var(--ink);
  font: 16px/1.6 system-ui, "Segoe UI", Roboto, "Helvetica Neue", sans-serif; }
main { max-width: 62rem; margin: 0 auto; padding: 4rem 1.5rem 6rem; }
h1 { font-size: 2rem; line-height: 1.25; font-weight: 650; letter-spacing: -.01em; margin: 0; }
h2 { font-size: 1.3rem; line-height: 1.3; font-weight: 650; margin: 0 0 1rem; }
section { margin-top: 3rem; padding-top: 2rem; border-top: 1px solid var(--rule); }
p, dl, pre, figcaption { max-width: 72ch; }
p { margin: 0 0 1rem; }
.headline { font-size: 1.2rem; margin: 1rem 0 2rem; }
.note, figcaption { color: var(--soft); font-size: .875rem; }
.label { margin: 1.5rem 0 .25rem; color: var(--soft); }
nav { display: flex; flex-wrap: wrap; gap: .25rem 1.25rem; margin-top: 2rem; }
a { color: var(--accent); text-decoration: none; }
a:hover { text-decoration: underline; }
dl { display: grid; grid-template-columns: minmax(8rem, max-content) 1fr; gap: .25rem 1.5rem;
  margin: 0 0 1.5rem; }
dt { color: var(--soft); }
dd { margin: 0; overflow-wrap: anywhere; }
pre { margin: 0 0 1.5rem; padding: .75rem 1rem; background: var(--tint); border-radius: 6px;
  white-space: pre-wrap; overflow-wrap: anywhere; font: .875rem/1.5 ui-monospace, monospace; }
.table { overflow-x: auto; margin: 0 0 1.5rem; }
table { border-collapse: collapse; font-size: .9rem; font-variant-numeric: tabular-nums; }
caption { text-align: left; font-weight: 600; padding-bottom: .5rem; white-space: nowrap; }
.csv { font-weight: 400; font-size: .8rem; margin-left: .5rem; }
th, td { padding: .35rem 1.5rem .35rem 0; text-align: left; vertical-align: top; }
th:last-child, td:last-child { padding-right: 0; }
th { color: var(--soft); font-weight: 500; border-bottom: 1px solid var(--ink); }
td { border-bottom: 1px solid var(--rule); }
.number { text-align: right; white-space: nowrap; }
figure { margin: 0 0 2rem; }
figcaption { margin: .5rem 0; }
.chart svg { display: block; max-width: 100%; height: auto; }
.pictures .picture > figcaption { color: var(--ink); font-weight: 600; }
img, canvas { display: block; max-width: 100%; height: auto; image-rendering: pixelated;
  border-radius: 2px; background: var(--tint); }
canvas { cursor: pointer; }
[hidden] { display: none !important; }
.choices { display: flex; flex-wrap: wrap; gap: .5rem; margin: .75rem 0; }
button { font: inherit; font-size: .875rem; padding: .2rem .8rem; color: var(--ink);
  background: none; border: 1px solid var(--rule); border-radius: 99px; cursor: pointer; }
button[aria-pressed=true] { color: var(--paper); background: var(--ink);
  border-color: var(--ink); }
.exposure { display: flex; align-items: center; gap: .75rem; margin: .75rem 0; font-size: .875rem;
  font-variant-numeric: tabular-nums; }
.exposure input { width: 18rem; max-width: 45vw; accent-color: var(--accent); }
.viewer:focus { outline: none; }
.viewer:focus-visible canvas { outline: 1px solid var(--rule); outline-offset: 4px; }
:focus-visible { outline: 2px solid var(--accent); outline-offset: 3px; }
@media print {
  :root { --paper: #fff; --ink: #000; --soft: #444; --rule: #bbb; --tint: #f4f4f4; }
  main { max-width: none; padding: 0; }
  nav, .csv, .exposure { display: none; }
  .chart svg { filter: none; }
  figure, tr, dl { break-inside: avoid; }
}
)css";

}  // namespace lobe
