// The machine as its reader moves it: from coordinates to bodies, actuators, margins, forces and condition, and from actuators and from a
// point of the platform back to coordinates. `liveModel` has the recorded geometry of the mechanism as a function; what follows from it is
// here. SI units and radians throughout: a value times its factor is in its unit. Matrices are flat, row by row.

// LU factors of an n x n matrix, its rows exchanged so that each pivot is the largest of its column, by the size of its row.
function luFactors(matrix, n) {
  const lu = Float64Array.from(matrix), order = Array.from({ length: n }, (_, i) => i);
  const sizes = order.map((i) => Math.max(...lu.subarray(i * n, i * n + n).map(Math.abs)) || 1);
  let sign = 1;
  for (let k = 0; k < n; ++k) {
    let best = k;
    for (let i = k + 1; i < n; ++i)
      if (Math.abs(lu[i * n + k]) / sizes[i] > Math.abs(lu[best * n + k]) / sizes[best]) best = i;
    if (best !== k) {
      for (let j = 0; j < n; ++j) [lu[k * n + j], lu[best * n + j]] = [lu[best * n + j], lu[k * n + j]];
      [order[k], order[best]] = [order[best], order[k]];
      [sizes[k], sizes[best]] = [sizes[best], sizes[k]];
      sign = -sign;
    }
    for (let i = k + 1; i < n; ++i) {
      const factor = lu[k * n + k] === 0 ? 0 : (lu[i * n + k] /= lu[k * n + k]);
      for (let j = k + 1; j < n; ++j) lu[i * n + j] -= factor * lu[k * n + j];
    }
  }
  return { lu, order, sign, n };
}

// The solution of such a system; not finite, or large, where the matrix is singular.
function luSolution({ lu, order, n }, right) {
  const x = order.map((i) => right[i]);
  for (let i = 0; i < n; ++i) for (let j = 0; j < i; ++j) x[i] -= lu[i * n + j] * x[j];
  for (let i = n - 1; i >= 0; --i) {
    for (let j = i + 1; j < n; ++j) x[i] -= lu[i * n + j] * x[j];
    x[i] /= lu[i * n + i];
  }
  return x;
}

function luDeterminant({ lu, sign, n }) {
  let product = sign;
  for (let i = 0; i < n; ++i) product *= lu[i * n + i];
  return product;
}

// Singular values of an n x n matrix, largest first. Rotations of pairs of rows make all rows orthogonal (Hestenes); small values keep
// their relative accuracy.
function singularValues(matrix, n) {
  const a = Float64Array.from(matrix);
  for (let turned = true, sweep = 0; turned && sweep < 40; ++sweep) {
    turned = false;
    for (let p = 0; p < n; ++p)
      for (let q = p + 1; q < n; ++q) {
        let pp = 0, qq = 0, pq = 0;
        for (let j = 0; j < n; ++j) {
          const x = a[p * n + j], y = a[q * n + j];
          pp += x * x;
          qq += y * y;
          pq += x * y;
        }
        if (!(Math.abs(pq) > 1e-15 * Math.sqrt(pp * qq))) continue;
        turned = true;
        const cotangent = (qq - pp) / (2 * pq), tangent = (cotangent < 0 ? -1 : 1) / (Math.abs(cotangent) + Math.sqrt(1 + cotangent * cotangent));
        const c = 1 / Math.sqrt(1 + tangent * tangent), s = c * tangent;
        for (let j = 0; j < n; ++j) {
          const x = a[p * n + j], y = a[q * n + j];
          a[p * n + j] = c * x - s * y;
          a[q * n + j] = s * x + c * y;
        }
      }
  }
  const sizes = Array.from({ length: n }, (_, i) => Math.sqrt(a.subarray(i * n, i * n + n).reduce((sum, x) => sum + x * x, 0)));
  return sizes.sort((x, y) => y - x);
}

// What the page can ask of a model:
//   name, coordinates [{name, title, unit, factor, rotary, home, min, max}], home (their values),
//   actuators [{name, title, unit, factor, rotary, min, max, effort: {name, unit, factor}}], derived [{name, title, unit, factor}],
//   load {force, moment, gravity, varies}: what at() takes to act; `varies`: it is that of the motion's first instant
//   at(x, load), solve(lengths, from, told), dragged(x, target, told): below
function makeLive(model) {
  const m = model.coordinates.length, at = model.at, platform = model.bodies[model.platform].at;
  const home = model.coordinates.map((c) => c.home), load = { ...model.load, gravity: model.gravity };
  const size = (x) => (x.rotary ? 1 : model.length);

  const numbersAt = (x) => {
    const y = new Float64Array(at.all);
    model.geometry(x, y);
    return y;
  };
  const product = (a, b) => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
  const across = (a, b) => [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]];
  const byColumns = (x, y, z) => [x[0], y[0], z[0], x[1], y[1], z[1], x[2], y[2], z[2]];

  // The frame about axis z whose x lies as nearly as can be along `guide`.
  const frameAlong = (z, guide) => {
    const y = across(z, guide), length = Math.sqrt(product(y, y)), unit = y.map((v) => v / length);
    return byColumns(across(unit, z), unit, z);
  };
  // About axis z, with x across it and one of the base's axes.
  const anyFrame = (z) => {
    const flat = Math.abs(z[0]) <= 1e-12 * Math.abs(z[2]) && Math.abs(z[1]) <= 1e-12 * Math.abs(z[2]);
    return frameAlong(z, flat ? [0, -z[2], z[1]] : [-z[1], z[0], 0]);
  };
  // A slender body shows its axis alone. How it turns about it a joint's axis tells; else it turns from home no more than it must.
  const framesAtHome = new Map();
  const rotationOf = (body, y) => {
    if (!body.slender) return Array.from(y.subarray(body.at + 3, body.at + 12));
    const z = Array.from(y.subarray(body.at + 3, body.at + 6));
    if (body.guide !== undefined) return frameAlong(z, y.subarray(body.guide, body.guide + 3));
    const r = anyFrame(z), before = framesAtHome.get(body);
    if (before === undefined) return r;
    const entry = (i, j) => before[i] * r[j] + before[3 + i] * r[3 + j] + before[6 + i] * r[6 + j];  // of before' r
    const turn = Math.atan2(entry(0, 1) - entry(1, 0), entry(0, 0) + entry(1, 1)), c = Math.cos(turn), s = Math.sin(turn);
    return frameAlong(z, [0, 3, 6].map((i) => c * r[i] + s * r[i + 1]));
  };
  const fixed = { origin: [0, 0, 0], rotation: [1, 0, 0, 0, 1, 0, 0, 0, 1] };
  const bodiesOf = (y) =>
    model.bodies.map((body, i) => (i === 0 ? fixed : { origin: Array.from(y.subarray(body.at, body.at + 3)), rotation: rotationOf(body, y) }));
  const atHome = bodiesOf(numbersAt(home));
  model.bodies.forEach((body, i) => framesAtHome.set(body, atHome[i].rotation));

  const reached = (y) => y[0] >= 0 && y.subarray(0, at.jacobian).every(Number.isFinite);

  // A value between two ends, either of which may be infinite; negative margins are broken ones, those of mere rounding are not. `share`:
  // the margin as a part of what there is between the ends.
  const marginOf = (from, value, low, high) => {
    const ends = [low, high].filter(Number.isFinite), slack = 1e-12 * Math.max(1, ...ends.map(Math.abs));
    const margin = Math.min(value - low, high - value), span = ends.length === 2 ? high - low : Math.abs(ends[0]) || 1;
    const { name, title, unit, factor } = from;
    return { name, title, unit, factor, value, low, high, margin, share: margin / span, broken: !(margin >= -slack) };
  };
  const marginsOf = (y) => [
    ...model.actuators.map((a, i) => marginOf(a, y[at.actuators + i], a.min, a.max)),
    ...model.motions.map((j) => marginOf(j, y[j.at], j.low, j.high)),
  ];

  // Of the overall Jacobian G, moments counted per characteristic length and rotary rows in lengths.
  const conditionOf = (y) => {
    const g = y.slice(at.jacobian, at.jacobian + 36);
    for (let e = 0; e < 36; ++e) {
      if (e % 6 > 2) g[e] /= model.length;
      if (model.rotaryRows[Math.floor(e / 6)]) g[e] *= model.length;
    }
    if (!g.every(Number.isFinite)) return Infinity;
    const sigma = singularValues(g, 6);
    return sigma[5] > 0 ? sigma[0] / sigma[5] : Infinity;
  };

  const rates = (y) => y.subarray(at.rates, at.rates + m * m);
  // Forces of the actuators, push positive, that hold load and weights at rest. For every displacement dq of the coordinates
  //   tau . J dq + load . T dq + gravity . S dq = 0,
  // J the rates of the actuators, T the twist of the platform, S the displacement of all mass: J' tau = -(T' load + S' gravity).
  const forcesOf = (y, { force, moment, gravity }) => {
    const wrench = [...force, ...moment], transposed = new Float64Array(m * m), right = new Array(m).fill(0);
    for (let i = 0; i < m; ++i) {
      for (let j = 0; j < m; ++j) transposed[i * m + j] = y[at.rates + j * m + i];
      for (let k = 0; k < 6; ++k) right[i] -= wrench[k] * y[at.twist + k * m + i];
      for (let k = 0; k < 3; ++k) right[i] -= gravity[k] * y[at.masses + k * m + i];
    }
    return luSolution(luFactors(transposed, m), right);
  };

  const sideOf = (y) => Math.sign(luDeterminant(luFactors(rates(y), m)));
  const rotaryTurns = (d) => d.map((v, i) => (model.actuators[i].rotary ? v - 2 * Math.PI * Math.round(v / (2 * Math.PI)) : v));
  const largestOf = (d, of) => Math.max(...d.map((v, i) => Math.abs(v) / size(of[i])));  // of the machine's length, or of a radian

  // Newton's method from nearby: x where the actuators have these values to `enough`, then as near as rounding lets it come. A step that
  // leaves the neighbourhood or brings them no nearer ends it, since stages can be shorter.
  const approached = (from, lengths, enough) => {
    const deviations = (y) => rotaryTurns(lengths.map((l, i) => y[at.actuators + i] - l));
    const nearby = 0.3;
    let x = from, y = numbersAt(x), d = deviations(y), left = largestOf(d, model.actuators);
    for (let steps = 0; left > 0 && steps < 20; ++steps) {
      const step = luSolution(luFactors(rates(y), m), d), wide = largestOf(step, model.coordinates);
      const next = x.map((v, i) => v - step[i]), there = numbersAt(next), off = deviations(there), now = largestOf(off, model.actuators);
      const worse = wide < nearby && reached(there) ? !(now < left / 2) && !(now < left && left < 1e-9) : true;
      if (worse && left <= enough) break;
      if (worse) return { why: wide < nearby && !reached(there) ? "reach" : "singular" };
      [x, y, d, left] = [next, there, off, now];
    }
    return left <= enough ? { x, y } : { why: "singular" };
  };

  return {
    name: model.name, coordinates: model.coordinates, home, actuators: model.actuators, derived: model.derived, load,

    // Everything at coordinates x. Where the machine cannot be assembled (`reachable`), or is singular, numbers are not finite, or mean
    // nothing. `forces`: that the actuators exert at rest under `given` and gravity, push positive [N], [N m].
    at(x, given = load) {
      const y = numbersAt(x);
      return {
        x: Array.from(x), reach: y[0], reachable: reached(y), bodies: bodiesOf(y),
        actuators: Array.from(y.subarray(at.actuators, at.actuators + m)),
        derived: Array.from(y.subarray(at.derived, at.derived + model.derived.length)),
        margins: marginsOf(y), condition: conditionOf(y), det: luDeterminant(luFactors(y.subarray(at.jacobian, at.jacobian + 36), 6)),
        forces: forcesOf(y, { ...load, ...given }),
      };
    },

    // The coordinates to which actuators come that are driven evenly from those of `from` to these values; null where the way there ends.
    // Newton's method with exact partials follows the way in stages, so that the machine stays on its side of every singular surface. An
    // angle is driven by half a turn at most. `told` gets how far it came: x, `share` of the way, stages, and where it ended why:
    // "singular", "side" where the way goes on beyond a singular pose alone, or "reach".
    solve(lengths, from, told = {}) {
      let x = Array.from(from), y = numbersAt(x), share = 0;
      const start = Array.from(y.subarray(at.actuators, at.actuators + m)), full = rotaryTurns(lengths.map((l, i) => l - start[i]));
      const most = largestOf(full, model.actuators), side = sideOf(y);
      Object.assign(told, { x, share, stages: 0, why: reached(y) ? "" : "reach" });
      let stage = most > 0.05 ? 0.05 / most : 1;
      while (!told.why && share < 1) {
        const next = share + stage > 1 - 1e-9 ? 1 : share + stage;
        const found = approached(x, start.map((l, i) => l + next * full[i]), next === 1 ? 1e-12 : 1e-6);
        ++told.stages;
        if (found.x && (side === 0 || sideOf(found.y) === side)) {
          x = told.x = found.x;
          share = told.share = next;
          stage *= 1.5;
        } else {
          stage /= 2;
          if (stage < 1e-6 || told.stages > 400) told.why = found.why || "side";
        }
      }
      return told.why ? null : x;
    },

    // From coordinates x those that bring the platform's reference point to `target` [m], or as near as it comes: translations move, turns
    // stay. Least squares, since a dependent coordinate may follow the others. `told` gets what is left [m].
    dragged(x, target, told = {}) {
      const moving = model.coordinates.flatMap((c, i) => (c.rotary ? [] : [i])), n = moving.length;
      const missing = (y) => [0, 1, 2].map((k) => target[k] - y[platform + k]);
      let now = Array.from(x), y = numbersAt(now), r = missing(y), left = product(r, r);
      const tied = reached(y);
      for (let steps = 0; n > 0 && left > (1e-14 * model.length) ** 2 && steps < 30; ++steps) {
        const slope = (k, i) => y[at.twist + k * m + moving[i]];
        const square = new Float64Array(n * n), right = new Array(n).fill(0);
        for (let i = 0; i < n; ++i)
          for (let k = 0; k < 3; ++k) {
            right[i] += slope(k, i) * r[k];
            for (let j = 0; j < n; ++j) square[i * n + j] += slope(k, i) * slope(k, j);
          }
        for (let i = 0; i < n; ++i) square[i * n + i] += 1e-12;  // where coordinates move the point one way
        const step = luSolution(luFactors(square, n), right);
        let better = false;
        for (let share = 1; !better && share > 1e-6 && step.every(Number.isFinite); share /= 2) {
          const next = now.slice();
          moving.forEach((c, i) => (next[c] += share * step[i]));
          const there = numbersAt(next), off = missing(there);
          if ((!tied || reached(there)) && product(off, off) < left) [now, y, r, left, better] = [next, there, off, product(off, off), true];
        }
        if (!better) break;
      }
      told.left = Math.sqrt(left);
      return now;
    },
  };
}
