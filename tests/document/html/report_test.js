// The functions of report.js that need no page, run by Node: node --test report_test.js
const assert = require("node:assert/strict"), fs = require("node:fs"), path = require("node:path"), test = require("node:test"), vm = require("node:vm");

const source = path.join(__dirname, "../../../reports/document/html/report.js");
vm.runInThisContext(fs.readFileSync(source, "utf8"), source);

test("numbers are read as the report writes them", () => {
  const cases = {
    "−812.4": -812.4, "-7": -7, "312.4 N": 312.4, "3.1×10⁵": 3.1e5, "2.1 × 10⁻¹⁶ m": 2.1e-16, "−1 × 10³": -1000, "1e-9": 1e-9, "98 %": 98, "< 400 N": 400,
    "1.2 MB": 1.2e6, "300 kB": 3e5, "12 B": 12, "1, 2, 3": 1, " 4": 4,
  };
  for (const [text, value] of Object.entries(cases)) assert.equal(numberIn(text), value, text);
  for (const [less, more] of [["400 N", "12 kN"], ["500 nm", "3 mm"], ["900 mm", "1.2 m"], ["20 ms", "1 s"]])
    assert.ok(numberIn(less) < numberIn(more), less + " < " + more);
  for (const text of ["", "–", "passed", "l₁", "✓ passed"]) assert.ok(Number.isNaN(numberIn(text)), text);
});

test("numbers sort as numbers, both ways, and equal ones keep their order", () => {
  const cells = ["10", "9", "−2", "9", "3 × 10²"];
  assert.deepEqual(orderOf(cells, 1, true), [2, 1, 3, 0, 4]);
  assert.deepEqual(orderOf(cells, -1, true), [4, 0, 1, 3, 2]);
  assert.deepEqual(orderOf(cells, 0, true), [0, 1, 2, 3, 4]);
});

test("cells that say nothing stand last both ways", () => {
  assert.deepEqual(orderOf(["–", "2", "", "1"], 1, true), [3, 1, 0, 2]);
  assert.deepEqual(orderOf(["–", "2", "", "1"], -1, true), [1, 3, 0, 2]);
  assert.deepEqual(orderOf(["b", "", "a"], 1, false), [2, 0, 1]);
  assert.deepEqual(orderOf(["b", "", "a"], -1, false), [0, 2, 1]);
});

test("words sort with the numbers in them by size", () => assert.deepEqual(orderOf(["l10", "l9", "a"], 1, false), [2, 1, 0]));

test("a curve is straight between its samples, and nothing outside them and in a gap", () => {
  const x = [0, 1, 2, 3, 4], y = [0, 10, null, 30, 40];
  assert.equal(valueAt(x, y, 0), 0);
  assert.equal(valueAt(x, y, 0.25), 2.5);
  assert.equal(valueAt(x, y, 1), 10);
  assert.equal(valueAt(x, y, 1.5), null);
  assert.equal(valueAt(x, y, 2), null);
  assert.equal(valueAt(x, y, 2.5), null);
  assert.equal(valueAt(x, y, 3.5), 35);
  assert.equal(valueAt(x, y, 4), 40);
  for (const outside of [-0.1, 4.1, NaN]) assert.equal(valueAt(x, y, outside), null);
  assert.equal(valueAt([], [], 0), null);
  assert.equal(valueAt([0, 1.23456], [1, 2], 1.234564), 2);
});

test("of two samples at one time the later counts", () => assert.equal(valueAt([0, 1, 1, 2], [0, 1, 5, 6], 1), 5));

test("a dot counts near it alone", () => {
  assert.equal(dotAt([0, 1, 2], [5, 6, 7], 1.04, 0.1), 6);
  assert.equal(dotAt([0, 1, 2], [5, 6, 7], 1.5, 0.1), null);
  assert.equal(dotAt([0, 1], [null, 6], 0, 0.1), null);
});

test("times and values are unpacked", () => {
  assert.deepEqual(timesOf([0, 3]), [0, 3]);
  assert.deepEqual(timesOf({ from: 0, to: 2, n: 5 }), [0, 0.5, 1, 1.5, 2]);
  assert.deepEqual(valuesOf([4, 2, null, -6], 10, 0.5), [12, 13, null, 10]);
});

test("values have the digits that their axis bears out", () => {
  assert.equal(shown(-812.4251, 0, 1000), "−812.4");
  assert.equal(shown(0.123456, 0, 1), "0.1235");
  assert.equal(shown(-0.00001, -1, 1), "0.0000");
  assert.equal(shown(123456.7, 0, 200000), "123457");
  assert.equal(shown(-2.5e-7, -1e-6, 1e-6), "−2.500×10⁻⁷");
  assert.equal(shown(3.1e8, 0, 1e9), "3.100×10⁸");
  assert.equal(shown(null, 0, 1), "–");
});

test("a frame maps times to the drawing and back", () => {
  const frame = readFrame("50 10 200 100", "0 2", "-1 1");
  assert.equal(across(frame, 1), 150);
  assert.equal(down(frame, 1), 10);
  assert.equal(down(frame, -1), 110);
  assert.equal(timeAt(frame, across(frame, 0.7)).toFixed(9), "0.700000000");
  assert.ok(within(frame, 150, 60));
  assert.ok(!within(frame, 49, 60) && !within(frame, 150, 111));
});

test("curves with a name are listed, and nameless ones where they have values", () => {
  const a = { label: "l₁" }, nameless = { label: "" };
  assert.deepEqual(listed({ time: true, series: [a, nameless] }).map((s) => s.label), ["l₁", "curve 2"]);
  assert.deepEqual(listed({ time: true, series: [nameless] }).map((s) => s.label), ["curve"]);
  assert.deepEqual(listed({ time: false, series: [a, nameless, { label: "l₃" }] }).map((s) => s.i), [0, 2]);
  assert.deepEqual(listed({ time: false, series: [a] }), []);
});
