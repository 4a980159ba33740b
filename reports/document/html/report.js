// What a reader can do with report.html: move one time cursor through all plots against time, hide curves, sort tables. The page is whole
// without it. Nothing moves by itself, so that there is no motion to reduce.

// Units that a column may change between, each in its base.
const scales = {
  nm: 1e-9, "µm": 1e-6, mm: 1e-3, km: 1e3, mN: 1e-3, kN: 1e3, MN: 1e6, "mN·m": 1e-3, "kN·m": 1e3, mW: 1e-3, kW: 1e3, mJ: 1e-3, kJ: 1e3,
  "µs": 1e-6, ms: 1e-3, min: 60, kHz: 1e3, "mm/s": 1e-3, "µm/s": 1e-6, "mm/s²": 1e-3, "µrad": 1e-6, mrad: 1e-3,
};

// "−812.4 mm", "3.1×10⁵", "2.1 × 10⁻¹⁶ m", "1.2 MB" as a number; NaN for words.
function numberIn(text) {
  const parts = /^\s*[<>≤≥≈]?\s*([-−+]?)(\d+(?:\.\d+)?)(?:e([-−+]?\d+))?(?:\s*×\s*10([⁻⁺]?[⁰¹²³⁴⁵⁶⁷⁸⁹]+))?\s*([kMG]B\b)?/.exec(text);
  if (!parts) return NaN;
  const sign = parts[1] === "−" || parts[1] === "-" ? "-" : "";
  const raised = (parts[4] || "").replace(/[⁻⁺⁰¹²³⁴⁵⁶⁷⁸⁹]/g, (c) => "-+0123456789"["⁻⁺⁰¹²³⁴⁵⁶⁷⁸⁹".indexOf(c)]);
  const exponent = Number((parts[3] || "0").replace("−", "-")) + Number(raised || "0");
  const unit = text.slice(parts[0].length).trim();
  const scale = { kB: 1e3, MB: 1e6, GB: 1e9 }[parts[5]] || scales[unit] || 1;
  return Number(sign + parts[2] + "e" + exponent) * scale;
}

// In which order rows stand when sorted by these cells: 1 ascending, -1 descending, 0 as they came. Equal ones keep their order, and cells
// that say nothing stand last.
function orderOf(cells, direction, numeric) {
  const order = cells.map((_, i) => i);
  if (direction === 0) return order;
  const words = new Intl.Collator("en", { numeric: true });
  const keys = numeric ? cells.map(numberIn) : cells.map((text) => text.trim());
  const says = (i) => (numeric ? !Number.isNaN(keys[i]) : keys[i] !== "");
  return order.sort((a, b) => {
    if (!says(a) || !says(b)) return says(a) ? -1 : says(b) ? 1 : a - b;
    const difference = numeric ? Math.sign(keys[a] - keys[b]) : words.compare(keys[a], keys[b]);
    return direction * difference || a - b;
  });
}

// Times of a curve: a list, or evenly spaced ones by their ends and number.
function timesOf(x) {
  if (Array.isArray(x)) return x;
  return Array.from({ length: x.n }, (_, i) => x.from + ((x.to - x.from) * i) / (x.n - 1));
}

// Values that are kept as steps from the one before.
function valuesOf(y, low, step) {
  let count = 0;
  return y.map((more) => (more === null ? null : low + step * (count += more)));
}

// The value of a curve at `asked`: straight between its samples; null in a gap and outside them, beyond what their six digits leave open.
function valueAt(x, y, asked) {
  const first = x[0], last = x[x.length - 1], slack = 1e-5 * (Math.abs(first) + Math.abs(last));
  if (x.length === 0 || !(asked >= first - slack && asked <= last + slack)) return null;
  const at = Math.min(Math.max(asked, first), last);
  let low = 0, high = x.length - 1;
  while (low < high) {
    const middle = Math.ceil((low + high) / 2);
    if (x[middle] <= at) low = middle;
    else high = middle - 1;
  }
  if (x[low] === at || low + 1 === x.length) return y[low];
  if (y[low] === null || y[low + 1] === null) return null;
  return y[low] + ((y[low + 1] - y[low]) * (at - x[low])) / (x[low + 1] - x[low]);
}

// The value of the dot that is nearest to `at`, null where none is within `reach`.
function dotAt(x, y, at, reach) {
  let best = null, distance = reach;
  x.forEach((value, i) => {
    if (y[i] === null || Math.abs(value - at) > distance) return;
    best = y[i];
    distance = Math.abs(value - at);
  });
  return best;
}

// With as many digits as the steps of an axis from `low` to `high` bear out, so that they stay while the cursor moves.
function shown(value, low, high) {
  if (value === null) return "–";
  const decade = Math.floor(Math.log10(high - low));
  const raise = (exponent) => String(exponent).replace(/[-0-9]/g, (c) => "⁻⁰¹²³⁴⁵⁶⁷⁸⁹"["-0123456789".indexOf(c)]);
  if (decade > 5 || decade < -4) {
    const [digits, exponent] = value.toExponential(3).split("e");
    return (digits + "×10" + raise(Number(exponent))).replace("-", "−");
  }
  const text = value.toFixed(Math.max(0, Math.floor(Math.log10(20000 / (high - low)))));
  return (/^-0\.?0*$/.test(text) ? text.slice(1) : text).replace("-", "−");
}

// "x y width height" of a frame and the ranges of its axes, as the drawing carries them.
function readFrame(frame, x, y) {
  const [left, top, width, height] = frame.split(" ").map(Number);
  const [xLow, xHigh] = x.split(" ").map(Number), [yLow, yHigh] = y.split(" ").map(Number);
  return { left, top, width, height, xLow, xHigh, yLow, yHigh };
}

const across = (frame, x) => frame.left + (frame.width * (x - frame.xLow)) / (frame.xHigh - frame.xLow);
const down = (frame, y) => frame.top + frame.height * (1 - (y - frame.yLow) / (frame.yHigh - frame.yLow));
const timeAt = (frame, x) => frame.xLow + ((frame.xHigh - frame.xLow) * (x - frame.left)) / frame.width;
const within = (frame, x, y) => x >= frame.left && x <= frame.left + frame.width && y >= frame.top && y <= frame.top + frame.height;

// Curves that a reader may ask for: those with a name, and in a plot against time the nameless one too.
function listed(panel) {
  const named = panel.series.map((series, i) => ({ ...series, i })).filter((series) => series.label !== "" || panel.time);
  if (!panel.time && named.length < 2) return [];
  return named.map((series) => ({ ...series, label: series.label || (named.length > 1 ? "curve " + (series.i + 1) : "curve") }));
}

function element(name, attributes, ...children) {
  const svg = ["svg", "g", "line", "circle"].includes(name);
  const node = svg ? document.createElementNS("http://www.w3.org/2000/svg", name) : document.createElement(name);
  for (const [key, value] of Object.entries(attributes)) node.setAttribute(key, value);
  node.append(...children);
  return node;
}

const heading = (text, kind) => element("th", kind ? { scope: "col", class: kind } : { scope: "col" }, text);

function makeTable(kind, label, headings, rows) {
  return element("table", { class: kind }, element("caption", {}, label), element("thead", {}, element("tr", {}, ...headings)), element("tbody", {}, ...rows));
}

function sortable(table) {
  const headings = [...table.querySelectorAll("thead th")], body = table.tBodies[0];
  if (!body || body.rows.length < 2) return;
  const rows = [...body.rows];
  let sorted = null, direction = 0;
  for (const heading of headings) {
    const button = element("button", { type: "button", class: "sort" });
    button.append(...heading.childNodes);
    heading.append(button);
    button.addEventListener("click", () => {
      direction = sorted !== heading ? 1 : direction === 1 ? -1 : 0;
      sorted = direction === 0 ? null : heading;
      for (const other of headings) other.removeAttribute("aria-sort");
      if (sorted) heading.setAttribute("aria-sort", direction > 0 ? "ascending" : "descending");
      const cells = rows.map((row) => row.cells[heading.cellIndex]?.textContent ?? "");
      body.append(...orderOf(cells, direction, heading.classList.contains("number")).map((i) => rows[i]));
    });
  }
}

// The last path of a curve has its colour: over a map a light rim comes before it.
function inkOf(curve) {
  const path = [...(curve?.querySelectorAll("path") ?? [])].pop();
  const stroke = path?.getAttribute("stroke") ?? "none", line = stroke !== "none";
  return { line, colour: line ? stroke : path?.getAttribute("fill") ?? "none", dash: path?.getAttribute("stroke-dasharray") ?? "none" };
}

function swatch({ line, colour, dash }) {
  const mark = element("svg", { class: "swatch", viewBox: "0 0 22 8", width: 22, height: 8, "aria-hidden": "true" });
  if (line) mark.append(element("line", { x1: 1, y1: 4, x2: 21, y2: 4, stroke: colour, "stroke-width": 1.6, "stroke-dasharray": dash }));
  else mark.append(element("circle", { cx: 11, cy: 4, r: 2.6, fill: colour }));
  return mark;
}

// One curve of a plot: its button, its key in the legend, its value and its dot on the cursor.
function makeCurve(series, panel, drawn, frame, lists) {
  const find = (kind) => [...drawn.querySelectorAll("." + kind)].find((g) => g.dataset.series === String(series.i));
  const curve = find("curve"), key = find("key"), ink = inkOf(curve);
  const value = element("span", { class: "value" });
  const button = element("button", { type: "button", class: "curve-button", "aria-pressed": "true", title: "Show or hide this curve" }, swatch(ink), series.label);
  if (panel.time) button.append(" ", value);
  const dot = element("circle", { r: 2.4, class: "cursor-dot", fill: ink.colour, visibility: "hidden" });
  const toggle = () => {
    const visible = button.getAttribute("aria-pressed") !== "true";
    button.setAttribute("aria-pressed", String(visible));
    for (const part of [curve, key, dot]) part?.classList.toggle("hidden", !visible);
  };
  button.addEventListener("click", toggle);
  const x = panel.time ? lists[series.x] : [], values = panel.time ? valuesOf(series.y, panel.low, panel.step) : [];
  const move = (time) => {
    const y = series.points ? dotAt(x, values, time, (frame.xHigh - frame.xLow) / 100) : valueAt(x, values, time);
    value.textContent = panel.rows ? panel.rows[Math.round(y ?? -1)] ?? "–" : shown(y, frame.yLow, frame.yHigh);
    const seen = y !== null && within(frame, across(frame, time), down(frame, y));
    dot.setAttribute("visibility", seen ? "visible" : "hidden");
    if (!seen) return;
    dot.setAttribute("cx", across(frame, time).toFixed(2));
    dot.setAttribute("cy", down(frame, y).toFixed(2));
  };
  return { button, key, dot, value, toggle, move };
}

// The panel of a plot with its row of curves, and its cursor where it is against time. Null where there is nothing to do.
function makePanel(panel, drawn, lists) {
  const { frame: place, x, y } = drawn.dataset;
  const frame = readFrame(place, x, y);
  const curves = listed(panel).map((series) => makeCurve(series, panel, drawn, frame, lists));
  if (curves.length === 0) return null;
  const name = panel.name + (panel.time && panel.unit ? " [" + panel.unit + "]" : "");
  const row = element("div", { class: "curves", role: "group", "aria-label": "Curves of " + (panel.name || "the plot") });
  if (name) row.append(element("span", { class: "panel-name" }, name));
  row.append(...curves.map((curve) => curve.button));
  const line = element("line", { class: "cursor-line", y1: frame.top, y2: frame.top + frame.height });
  const cursor = element("g", { class: "cursor" }, line, ...curves.map((curve) => curve.dot));
  const move = (time) => {
    const inside = time >= frame.xLow && time <= frame.xHigh;
    cursor.setAttribute("visibility", inside ? "visible" : "hidden");
    for (const end of ["x1", "x2"]) line.setAttribute(end, across(frame, inside ? time : frame.xLow).toFixed(2));
    for (const curve of curves) curve.move(time);
  };
  return { frame, curves, row, cursor, move, time: panel.time, unit: panel.unit };
}

// Of small multiples: what their curves come to at the time, in rows and columns as they are drawn. They have one curve each, none to hide.
function makeReadings({ rows, columns }, panels) {
  const titled = columns.map((name, c) => heading(name + (panels[c].unit ? " [" + panels[c].unit + "]" : ""), "number"));
  const rowOf = (name, r) => element("tr", {}, element("th", { scope: "row" }, name),
    ...columns.map((_, c) => element("td", { class: "number" }, panels[r * columns.length + c].curves[0].value)));
  return element("div", { class: "scroll", role: "group", "aria-label": "Values at the time" },
    makeTable("readings", "Values at the time", [heading("Actuator"), ...titled], rows.map(rowOf)));
}

// The time of all plots, and what follows it: one move a frame of the screen, however fast the pointer.
const clock = {
  followers: [],
  asked: null,
  move(time) {
    if (this.asked === null) requestAnimationFrame(() => {
      document.body.classList.add("has-cursor");
      for (const follow of this.followers) follow(this.asked);
      this.asked = null;
    });
    this.asked = time;
  },
};

function timeSlider(low, high) {
  const slider = element("input", { type: "range", min: low, max: high, step: "any" });
  const reading = element("output", { "aria-live": "off" });  // the slider says it
  const follow = (time) => {
    const text = "t = " + shown(time, low, high) + " s";
    slider.value = time;
    slider.setAttribute("aria-valuetext", text);
    reading.textContent = text;
  };
  slider.addEventListener("input", () => clock.move(Number(slider.value)));
  slider.addEventListener("keydown", (event) => {
    const steps = { ArrowRight: 1, ArrowUp: 1, ArrowLeft: -1, ArrowDown: -1, PageUp: 10, PageDown: -10, Home: -Infinity, End: Infinity }[event.key];
    if (steps === undefined || event.ctrlKey || event.altKey || event.metaKey) return;
    event.preventDefault();
    clock.move(Math.min(high, Math.max(low, Number(slider.value) + (steps * (high - low)) / 200)));
  });
  return { row: element("label", { class: "time" }, "Time ", slider, " ", reading), follow, low };
}

function playable(figure) {
  const drawing = figure.querySelector(".drawing svg"), source = figure.querySelector('script[type="application/json"]');
  if (!drawing || !source) return;
  const data = JSON.parse(source.textContent);
  const drawn = drawing.querySelectorAll(".panel");
  const lists = data.x.map(timesOf);
  const panels = data.panels.map((panel, i) => makePanel(panel, drawn[i], lists)).filter((panel) => panel !== null);
  if (panels.length === 0) return;
  const box = element("div", { class: "controls" });
  const timed = panels.filter((panel) => panel.time);
  if (timed.length > 0) {
    const slider = timeSlider(Math.min(...timed.map(({ frame }) => frame.xLow)), Math.max(...timed.map(({ frame }) => frame.xHigh)));
    box.append(slider.row);
    // A figure out of sight waits until it comes into sight: a motion that plays moves what is seen of it.
    let inSight = true, due = slider.low;
    const follow = (time) => {
      due = time;
      if (!inSight) return;
      slider.follow(time);
      for (const panel of timed) panel.move(time);
    };
    follow(slider.low);
    new IntersectionObserver((entries) => {
      inSight = entries[entries.length - 1].isIntersecting;
      follow(due);
    }, { rootMargin: "25%" }).observe(figure);
    clock.followers.push(follow);
    drawing.append(...timed.map((panel) => panel.cursor));
  }
  if (data.rows && timed.length === data.rows.length * data.columns.length) box.append(makeReadings(data, timed));
  else box.append(...panels.map((panel) => panel.row));
  figure.querySelector("figcaption").before(box);

  const placeOf = (event) => new DOMPoint(event.clientX, event.clientY).matrixTransform(drawing.getScreenCTM().inverse());
  const curveAt = ({ x, y }) =>
    panels.flatMap((panel) => panel.curves).find(({ key }) => {
      const area = key?.getBBox();
      return area && x >= area.x && x <= area.x + area.width && y >= area.y && y <= area.y + area.height;
    });
  const point = (event) => {
    const at = placeOf(event);
    drawing.classList.toggle("on-key", curveAt(at) !== undefined);
    const panel = timed.find(({ frame }) => within(frame, at.x, at.y));
    if (panel && event.buttons === 0 || panel && event.pointerType !== "mouse") clock.move(timeAt(panel.frame, at.x));
  };
  drawing.addEventListener("pointermove", point);
  drawing.addEventListener("pointerdown", (event) => event.pointerType !== "mouse" && point(event));
  drawing.addEventListener("click", (event) => {
    if (getSelection().isCollapsed) curveAt(placeOf(event))?.toggle();
  });
}

// A box that shows all that it holds is no stop for the keyboard.
function stopWhereItScrolls() {
  for (const box of document.querySelectorAll(".scroll")) {
    if (box.scrollWidth > box.clientWidth) box.tabIndex = 0;
    else box.removeAttribute("tabindex");
  }
}

// What is folded away is printed.
function unfoldForPrint() {
  let folded = [];
  addEventListener("beforeprint", () => {
    folded = [...document.querySelectorAll("details:not([open])")];
    for (const details of folded) details.open = true;
  });
  addEventListener("afterprint", () => {
    for (const details of folded) details.open = false;
  });
}

function start() {
  document.querySelectorAll("table").forEach(sortable);
  document.querySelectorAll("figure.plot").forEach(playable);
  stopWhereItScrolls();
  addEventListener("resize", stopWhereItScrolls);
  unfoldForPrint();
  startView();
}

if (typeof document !== "undefined") start();
