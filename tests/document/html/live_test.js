// The functions of live.js, run by Node on a machine whose every number is known: node --test live_test.js
const assert = require("node:assert/strict"), fs = require("node:fs"), path = require("node:path"), test = require("node:test"), vm = require("node:vm");

const source = path.join(__dirname, "../../../reports/document/html/live.js");
vm.runInThisContext(fs.readFileSync(source, "utf8"), source);

const close = (seen, expected, tolerance = 1e-12) => assert.ok(Math.abs(seen - expected) <= tolerance, `${seen}, expected ${expected}`);
const allClose = (seen, expected, tolerance = 1e-12) => {
  assert.equal(seen.length, expected.length);
  expected.forEach((x, i) => close(seen[i], x, tolerance));
};

// Between 0 and 1, the same in every run.
function randomNumbers(seed) {
  let state = seed;
  return () => (state = (state * 48271) % 2147483647) / 2147483647;
}
const product = (a, b, n) => Array.from({ length: n * n }, (_, e) => {
  let sum = 0;
  for (let k = 0; k < n; ++k) sum += a[Math.floor(e / n) * n + k] * b[k * n + (e % n)];
  return sum;
});

test("a linear system is solved to rounding, whatever the sizes of its rows", () => {
  const random = randomNumbers(1);
  for (let round = 0; round < 200; ++round) {
    const n = 1 + (round % 6), x = Array.from({ length: n }, () => 2 * random() - 1);
    const a = Array.from({ length: n * n }, (_, e) => (2 * random() - 1) * 10 ** ((Math.floor(e / n) % 3) * 6));
    const right = x.map((_, i) => x.reduce((sum, v, j) => sum + a[i * n + j] * v, 0));
    const factors = luFactors(a, n), smallest = Math.min(...Array.from({ length: n }, (_, i) => Math.abs(factors.lu[i * n + i])));
    if (smallest > 1e-2) allClose(luSolution(factors, right), x, 1e-9);
  }
});

test("rows are exchanged where a pivot is zero, and a singular system has no finite solution", () => {
  const swapped = luFactors([0, 1, 0, 0, 0, 2, 3, 0, 0], 3);
  allClose(luSolution(swapped, [1, 2, 3]), [1, 1, 1]);
  close(luDeterminant(swapped), 6);
  close(luDeterminant(luFactors([2, 1, 1, 3], 2)), 5);
  close(luDeterminant(luFactors([1, 3, 2, 1], 2)), -5);
  assert.equal(luDeterminant(luFactors([1, 2, 2, 4], 2)), 0);
  assert.ok(!luSolution(luFactors([1, 2, 2, 4], 2), [1, 1]).every(Number.isFinite));
  assert.ok(!luSolution(luFactors([0, 0, 0, 0], 2), [1, 1]).every(Number.isFinite));
});

test("singular values are those that the matrix was made of, the small ones to as many digits as the large", () => {
  const turn = (n, i, j, angle) => {
    const r = Array.from({ length: n * n }, (_, e) => (e % (n + 1) === 0 ? 1 : 0));
    r[i * n + i] = r[j * n + j] = Math.cos(angle);
    r[j * n + i] = -(r[i * n + j] = -Math.sin(angle));
    return r;
  };
  const random = randomNumbers(2), n = 6, values = [900, 30, 5, 1, 1, 0.02];
  for (let round = 0; round < 50; ++round) {
    let a = Array.from({ length: n * n }, (_, e) => (e % (n + 1) === 0 ? values[(e / (n + 1) + round) % n] : 0));
    for (let i = 0; i < n; ++i)
      for (let j = i + 1; j < n; ++j) a = product(turn(n, i, j, 6 * random()), product(a, turn(n, i, j, 6 * random()), n), n);
    const seen = singularValues(a, n);
    allClose(seen, values, 1e-11);
  }
  allClose(singularValues([3, 0, 0, 0], 2), [3, 0]);
  allClose(singularValues([0, 0, 0, 0], 2), [0, 0]);
  // Rows of unlike size: a value of 1e-12 beside one of 1 is kept.
  close(singularValues([1, 0, 0, 1e-12], 2)[1], 1e-12, 1e-26);
});

// A slide along x at height one that turns about z: its platform is at (x, 0, 1). One actuator is the distance from the origin, whose rate
// vanishes at x = 0; the other is the turn. The slide ends at 2 m.
const slide = {
  name: "slide", length: 1,
  coordinates: [
    { name: "x", title: "", unit: "mm", factor: 1000, rotary: false, home: 1, min: -2, max: 2 },
    { name: "phi", title: "", unit: "°", factor: 180 / Math.PI, rotary: true, home: 0, min: -3, max: 3 },
  ],
  actuators: [
    { name: "l", title: "", unit: "mm", factor: 1000, rotary: false, min: 1.1, max: 2 },
    { name: "a", title: "", unit: "°", factor: 180 / Math.PI, rotary: true, min: -Infinity, max: 1 },
  ],
  derived: [], bodies: [{ name: "base", at: 0 }, { name: "platform", at: 1 }, { name: "rod", at: 13, slender: true }], platform: 1,
  motions: [{ name: "rod_angle", title: "", unit: "°", factor: 180 / Math.PI, at: 57, low: -Infinity, high: 1.5 }],
  rotaryRows: [false, true, false, false, false, false], gravity: [0, 0, -10], load: { force: [3, 0, 0], moment: [0, 0, 7], varies: false },
  at: { actuators: 19, derived: 21, jacobian: 21, rates: 58, twist: 62, masses: 74, all: 80 },
  geometry: (x, y) => {
    const l = Math.sqrt(x[0] * x[0] + 1), c = Math.cos(x[1]), s = Math.sin(x[1]);
    y.fill(0);
    y[0] = 2 - x[0];
    y.set([x[0], 0, 1, c, -s, 0, s, c, 0, 0, 0, 1], 1);
    y.set([0, 0, 0, x[0] / l, 0, 1 / l, l, x[1]], 13);
    for (let i = 0; i < 6; ++i) y[21 + 7 * i] = 1;
    y[21] = x[0] / l;
    y[57] = Math.atan2(x[0], 1);
    y.set([x[0] / l, 0, 0, 1], 58);
    y[62] = 1;
    y[62 + 5 * 2 + 1] = 1;
    y[74] = 5;
    y[74 + 2 * 2] = 0.5;  // as if 5 kg rose by a tenth of what they move aside
  },
};

test("a machine at home is where its geometry says", () => {
  const live = makeLive(slide), state = live.at(live.home);
  assert.deepEqual(live.home, [1, 0]);
  assert.ok(state.reachable);
  assert.equal(state.reach, 1);
  allClose(state.actuators, [Math.sqrt(2), 0]);
  assert.deepEqual(state.bodies[0], { origin: [0, 0, 0], rotation: [1, 0, 0, 0, 1, 0, 0, 0, 1] });
  allClose(state.bodies[1].origin, [1, 0, 1]);
  allClose(state.bodies[1].rotation, [1, 0, 0, 0, 1, 0, 0, 0, 1]);
  close(state.det, Math.SQRT1_2);
  close(state.condition, Math.SQRT2);
});

test("a slender body shows its axis as the third of a frame that turns no more than it must", () => {
  const live = makeLive(slide);
  let before = live.at(live.home).bodies[2].rotation;
  for (let x = 0.99; x > -1; x -= 0.01) {
    const r = live.at([x, 0]).bodies[2].rotation, l = Math.sqrt(x * x + 1);
    allClose([r[2], r[5], r[8]], [x / l, 0, 1 / l]);
    allClose(product(r, [r[0], r[3], r[6], r[1], r[4], r[7], r[2], r[5], r[8]], 3), [1, 0, 0, 0, 1, 0, 0, 0, 1]);
    r.forEach((v, e) => close(v, before[e], 0.02));
    before = r;
  }
});

test("forces at rest balance load and weights, and there are none where the actuators do not hold", () => {
  const live = makeLive(slide);
  // tau_l dl/dx + 3 + gravity: 5 kg g_x + 0.5 g_z = 0; tau_a + 7 = 0.
  allClose(live.at([1, 0.3]).forces, [(5 - 3) * Math.SQRT2, -7]);
  allClose(live.at([1, 0.3], { force: [0, 0, 0], moment: [0, 0, 0] }).forces, [5 * Math.SQRT2, 0]);
  allClose(live.at([1, 0.3], { force: [3, 0, 0], moment: [0, 0, 0], gravity: [0, 0, 0] }).forces, [-3 * Math.SQRT2, 0]);
  const singular = live.at([0, 0]);
  assert.ok(!Number.isFinite(singular.forces[0]));
  assert.equal(singular.condition, Infinity);
  assert.equal(singular.det, 0);
});

test("margins are distances to the nearer end, broken beyond rounding, and ends may be open", () => {
  const live = makeLive(slide), [l, a, angle] = live.at([1, 0.4]).margins;
  close(l.margin, Math.SQRT2 - 1.1);
  close(l.share, (Math.SQRT2 - 1.1) / 0.9);
  assert.ok(!l.broken);
  close(a.margin, 0.6);
  close(a.share, 0.6);
  assert.equal(a.low, -Infinity);
  close(angle.value, Math.PI / 4);
  assert.equal(angle.high, 1.5);
  assert.ok(live.at([0.1, 0]).margins[0].broken);
  assert.ok(live.at([1, 1.1]).margins[1].broken);
  assert.ok(!live.at([1, 1 + 1e-13]).margins[1].broken);
  assert.ok(live.at([1, NaN]).margins[1].broken);
});

test("beyond reach nothing is reachable", () => {
  const live = makeLive(slide);
  assert.ok(!live.at([2.1, 0]).reachable);
  assert.ok(!live.at([NaN, 0]).reachable);
});

test("actuators lead to coordinates, near and far", () => {
  const live = makeLive(slide);
  for (const x of [[1.0001, 0], [0.3, 0.7], [1.9, -3], [0.01, 2]]) {
    const told = {}, found = live.solve(live.at(x).actuators, live.home, told);
    allClose(found, x, 1e-10);
    assert.equal(told.share, 1);
    assert.equal(told.why, "");
  }
  allClose(live.solve(live.at(live.home).actuators, live.home), live.home, 0);
});

test("an actuator's angle is the same after a turn", () => {
  const live = makeLive(slide);
  allClose(live.solve([Math.SQRT2, 0.2 + 2 * Math.PI], live.home), [1, 0.2]);
  allClose(live.solve([Math.SQRT2, 0.2 - 4 * Math.PI], live.home), [1, 0.2]);
});

test("a way that ends at a singular pose, or at the end of reach, is told with how far it goes", () => {
  const live = makeLive(slide), told = {};
  // From a length of 1.414 m to 0.9 m: at 1 m the slide is at x = 0 and no shorter.
  assert.equal(live.solve([0.9, 0], live.home, told), null);
  assert.equal(told.why, "singular");
  close(told.share, (Math.SQRT2 - 1) / (Math.SQRT2 - 0.9), 1e-4);
  assert.ok(told.x[0] > 0 && told.x[0] < 0.05);
  assert.equal(live.solve([Math.sqrt(10), 0], live.home, told), null);
  assert.equal(told.why, "reach");
  close(told.share, (Math.sqrt(5) - Math.SQRT2) / (Math.sqrt(10) - Math.SQRT2), 1e-4);
  assert.ok(live.at(told.x).reachable);
  assert.equal(live.solve([1.5, 0], [2.5, 0], told), null);
  assert.equal(told.why, "reach");
  assert.equal(told.share, 0);
});

// Two actuators x and x y: driven along y = 0 through x = 0, where the second holds nothing, they lead on to the other side.
const crossing = {
  ...slide, name: "crossing",
  geometry: (x, y) => {
    slide.geometry(x, y);
    y[0] = 9;
    y.set([x[0], x[0] * x[1]], 19);
    y.set([1, 0, x[1], x[0]], 58);
  },
  actuators: slide.actuators.map((a) => ({ ...a, rotary: false })),
};

test("a pose to which a way leads beyond a singular one alone is told to lie on the other side", () => {
  const live = makeLive(crossing), told = {};
  allClose(live.solve([0.2, 0], [1, 0], told), [0.2, 0]);
  assert.equal(live.solve([-0.7, 0], [1, 0], told), null);
  assert.equal(told.why, "side");
  close(told.share, 1 / 1.7, 1e-4);
  assert.ok(told.x[0] > 0);
});

test("a machine stays on its side of a singular pose", () => {
  const live = makeLive(slide);
  allClose(live.solve(live.at([1, 0]).actuators, [-1, 0]), [-1, 0], 1e-10);
  allClose(live.solve(live.at([0.2, 0]).actuators, [-1, 0]), [-0.2, 0], 1e-10);
});

test("the platform is dragged by its translations alone, as near to the point as they come", () => {
  const live = makeLive(slide), told = {};
  allClose(live.dragged([1, 0.5], [0.2, 0, 1], told), [0.2, 0.5]);
  close(told.left, 0);
  allClose(live.dragged([1, 0.5], [0.2, 0.3, 1.4], told), [0.2, 0.5]);
  close(told.left, 0.5);
  const [x] = live.dragged([1, 0.5], [2.5, 0, 1], told);
  close(x, 2, 1e-2);
  assert.ok(x <= 2);
  close(told.left, 2.5 - x);
});

test("nothing is dragged where nothing translates", () => {
  const ball = { ...slide, coordinates: slide.coordinates.map((c) => ({ ...c, rotary: true })) };
  assert.deepEqual(makeLive(ball).dragged([1, 0.5], [0, 0, 0]), [1, 0.5]);
});
