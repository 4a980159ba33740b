// What the view in 3D tells of poses, limits and numbers, and what it understands of what is typed: no part of the page is needed for it.

// In the units that a reader expects, the nearest to its limit first.
function byRoom(margins) {
  const alike = (m) => margins.filter(({ title }) => title === m.title).length > 1;
  return margins.map((m) => shownLimit(m, alike(m))).sort((a, b) => a.share - b.share);
}

function shownLimit({ name, title, unit, factor, value, low, high, margin, share, broken }, alike) {
  return { name: !title ? name : alike ? title + " (" + name + ")" : title, unit, value: value * factor, low: low * factor, high: high * factor, margin: margin * factor, share, broken };
}

// With the digits that a span bears out; without one, as many as the number itself.
function told(value, low, high) {
  if (!Number.isFinite(value)) return "–";
  return Number.isFinite(low) && Number.isFinite(high) && high > low ? shown(value, low, high) : shown(value, 0, Math.abs(value) || 1);
}

// As a limit is declared: six digits, and no zeros that say nothing.
function declared(value) {
  const size = Math.abs(value);
  return size >= 1e6 || (size > 0 && size < 1e-4) ? told(value) : String(Number(value.toPrecision(6))).replace("-", "−");
}

const withUnit = (text, unit) => (unit ? text + (unit === "°" || unit === "%" ? "\u202f" : "\u00a0") + unit : text);

// A value against its limits, of which one may be none.
function toldLimited(value, { low, high, unit }) {
  const from = Number.isFinite(low) ? low : Math.min(0, high), to = Number.isFinite(high) ? high : Math.max(0, low);
  return withUnit(told(value, from, to), unit);
}

// "850 to 1490 mm", "at most 45°", "at least 10 mm"
function limitsOf({ low, high, unit }) {
  const [from, to] = [low, high].map((end) => (Number.isFinite(end) ? declared(end) : ""));
  if (from && to) return withUnit(from + " to " + to, unit);
  return to ? withUnit("at most " + to, unit) : from ? withUnit("at least " + from, unit) : "";
}

// What a reader must know of a pose, a sentence.
function verdictOf(state) {
  const beyond = byRoom(state.margins).filter((m) => m.broken), [worst] = beyond;
  if (!worst) return state.margins.some(({ margin }) => Number.isFinite(margin)) ? "Within all limits." : "No limits are declared.";
  return (beyond.length === 1 ? "Beyond a limit: " : "Beyond " + beyond.length + " limits, farthest: ") + worst.name + ", " + toldLimited(worst.value, worst) + ", allowed " + limitsOf(worst) + ".";
}

// Why the machine did not go where it was asked to.
const refusals = { reach: "Out of reach", singular: "A singular pose is in the way", side: "That pose lies beyond a singular one" };
const refusalOf = (why) => refusals[why] + ". The machine stays where it was.";

// What stands beside a field whose word was not taken.
const remarkOf = (text, why) => "“" + text.trim() + "”: " + why;

// An angle that was typed and the one that the machine tells, in degrees, where whole turns lie between them; else nothing.
function turnsTold(typed, kept) {
  const turns = Math.round((typed - kept) / 360), count = Math.abs(turns);
  if (turns === 0) return "";
  return withUnit(declared(typed), "°") + " is " + withUnit(declared(kept), "°") + (turns > 0 ? " and " : " less ") + (count === 1 ? "a turn" : count + " turns");
}

// A number as a reader types it; null where it is none.
function numberTyped(text) {
  const plain = text.trim().replace("−", "-").replace(",", ".");
  return plain !== "" && Number.isFinite(Number(plain)) ? Number(plain) : null;
}

// The next time of a motion that is played again and again.
function nextTime(time, step, low, high) {
  if (!(high > low)) return low;
  const next = time + step;
  return next <= high ? next : low + ((next - low) % (high - low));
}
