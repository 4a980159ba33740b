// Live machines against the report's numbers: node live_machine.js FOLDER, which has a model a mechanism and expected.json.
const assert = require("node:assert/strict"), fs = require("node:fs"), path = require("node:path"), vm = require("node:vm");

const source = path.join(__dirname, "../../../reports/document/html/live.js"), folder = process.argv[2];
vm.runInThisContext(fs.readFileSync(source, "utf8"), source);

// Relative to the largest number among them, or to one.
function near(seen, expected, tolerance, what) {
  const scale = Math.max(1e-6, ...expected.map(Math.abs));
  assert.equal(seen.length, expected.length, what);
  expected.forEach((x, i) => assert.ok(Math.abs(seen[i] - x) <= tolerance * scale, `${what} ${i}: ${seen[i]}, expected ${x}`));
}
const promised = 1e-9, rounding = 1e-13;

for (const machine of JSON.parse(fs.readFileSync(path.join(folder, "expected.json"), "utf8"))) {
  const model = vm.runInThisContext("(" + fs.readFileSync(path.join(folder, machine.name + ".js"), "utf8") + ")");
  const live = makeLive(model), say = (what) => machine.name + ": " + what;

  live.at(live.home).bodies.forEach((body, i) => {
    near(body.origin, machine.nodes[i].origin, rounding, say("node " + i));
    near(body.rotation, machine.nodes[i].rotation, 1e-12, say("turn of node " + i));
  });

  machine.samples.forEach((expected, k) => {
    const state = live.at(expected.x);
    assert.ok(state.reachable && state.reach >= 0, say("reach"));
    near(state.actuators, expected.actuators, rounding, say("actuators"));
    near(state.derived, expected.derived, 1e-12, say("derived"));
    near(state.forces, expected.forces, promised, say("static forces"));
    near([state.condition], [expected.condition], promised, say("condition"));
    near([state.det], [expected.determinant], promised, say("determinant"));
    expected.bodies.forEach((body, i) => {
      near(state.bodies[i].origin, body.origin, rounding, say("origin of body " + i));
      if (!body.slender) near(state.bodies[i].rotation, body.rotation, rounding, say("rotation of body " + i));
      else near([2, 5, 8].map((e) => state.bodies[i].rotation[e]), [2, 5, 8].map((e) => body.rotation[e]), rounding, say("axis of body " + i));
      for (const [a, b] of [[0, 1], [1, 2], [2, 0], [0, 0], [1, 1], [2, 2]]) {
        const r = state.bodies[i].rotation, product = [0, 3, 6].reduce((sum, row) => sum + r[row + a] * r[row + b], 0);
        assert.ok(Math.abs(product - (a === b ? 1 : 0)) < 1e-12, say("axes of body " + i));
      }
    });

    // Strokes and every limit that binds, each with the report's value and ends; what has no margin has no end to meet.
    const told = new Map(state.margins.map((margin) => [margin.name, margin]));
    model.actuators.forEach((a, i) => near([told.get(a.name).value], [expected.actuators[i]], rounding, say(a.name)));
    for (const [name, joint] of Object.entries(expected.motions)) {
      const margin = told.get(name);
      if (!margin) continue;
      near([margin.value], [joint.value], 1e-12, say(name));
      for (const end of ["low", "high"]) assert.ok(margin[end] === joint[end] || !Number.isFinite(margin[end]), say(name));
      assert.equal(margin.margin, Math.min(margin.value - margin.low, margin.high - margin.value), say(name));
    }
    assert.equal(told.size, model.actuators.length + model.motions.length, say("margins"));

    const way = {};
    near(live.solve(state.actuators, live.home, way) || [], expected.x, promised, say("solved from home, " + JSON.stringify(way)));
    near(live.solve(state.actuators, expected.x) || [], expected.x, promised, say("solved from there"));
    assert.equal(way.share, 1);

    // The reference point of another pose that is turned alike.
    const other = machine.samples[(k + 1) % machine.samples.length].x.map((v, i) => (live.coordinates[i].rotary ? expected.x[i] : v));
    const target = live.at(other).bodies[machine.platform].origin, left = {}, there = live.dragged(expected.x, target, left);
    near(live.at(there).bodies[machine.platform].origin, target, promised, say("dragged"));
    assert.ok(left.left < 1e-9, say("dragged"));
    live.coordinates.forEach((c, i) => c.rotary && assert.equal(there[i], expected.x[i], say("dragged turns")));
  });

  // A way of a thousand machines ends, but for slides that have no other end than their strokes.
  const far = {}, away = live.at(live.home).actuators.map((v, i) => v + (live.actuators[i].rotary ? 0 : 1000 * model.length));
  const found = live.solve(away, live.home, far);
  if (found === null) {
    assert.ok(far.share < 1 && ["reach", "singular", "side"].includes(far.why), say("the way ends"));
    assert.ok(live.at(far.x).reachable, say("where the way ends"));
  } else near(live.at(found).actuators, away, promised, say("the way does not end"));
  for (const c of live.coordinates) assert.ok(c.min <= c.home && c.home <= c.max && c.max - c.min > 0, say("range of " + c.name));
}
