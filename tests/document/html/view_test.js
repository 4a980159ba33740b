// The functions of view.js, view_words.js and view_controls.js that need no page, run by Node: node --test view_test.js
const assert = require("node:assert/strict"), fs = require("node:fs"), path = require("node:path"), test = require("node:test"), vm = require("node:vm"), zlib = require("node:zlib");

// As in the page: one script, whose parts see each other's names.
const folder = path.join(__dirname, "../../../reports/document/html");
vm.runInThisContext(["live.js", "view.js", "view_words.js", "view_controls.js", "report.js"].map((name) => fs.readFileSync(path.join(folder, name), "utf8")).join("\n"));

const near = (a, b, margin = 1e-9) => {
  assert.equal(a.length, b.length);
  a.forEach((value, k) => assert.ok(Math.abs(value - b[k]) <= margin, `${a} is not ${b}`));
};

// A unit cube from (0, 0, 0) to (1, 1, 1), its triangles counter-clockwise from outside.
const cube = {
  positions: [0, 1, 2, 3, 4, 5, 6, 7].flatMap((i) => [i & 1, (i >> 1) & 1, i >> 2]),
  indices: [0, 2, 1, 1, 2, 3, 4, 5, 6, 5, 7, 6, 0, 1, 4, 1, 5, 4, 2, 6, 3, 3, 6, 7, 0, 4, 2, 2, 4, 6, 1, 3, 5, 3, 7, 5],
};

// Two cubes: one stands, the other moves along x while it turns by 90° about z, at the keys 0, 1 and 3 s.
function sampleFile() {
  const accessors = [], bufferViews = [], pieces = [];
  let size = 0;
  const add = (numbers, type, kind, width) => {
    const bytes = Buffer.from(new kind(numbers).buffer), padded = Buffer.concat([bytes, Buffer.alloc((4 - (bytes.length % 4)) % 4)]);
    bufferViews.push({ buffer: 0, byteOffset: size, byteLength: bytes.length });
    accessors.push({ bufferView: accessors.length, componentType: kind === Uint16Array ? 5123 : 5126, count: numbers.length / width, type });
    pieces.push(padded);
    size += padded.length;
    return accessors.length - 1;
  };
  const half = Math.SQRT1_2;
  const POSITION = add(cube.positions, "VEC3", Float32Array, 3), NORMAL = add(cube.positions, "VEC3", Float32Array, 3), indices = add(cube.indices, "SCALAR", Uint16Array, 1);
  const input = add([0, 1, 3], "SCALAR", Float32Array, 1), moved = add([0, 0, 0, 2, 0, 0, 4, 0, 0], "VEC3", Float32Array, 3);
  const rotated = add([0, 0, 0, 1, 0, 0, half, half, 0, 0, half, half], "VEC4", Float32Array, 4);
  const sampler = (output) => ({ input, output, interpolation: "LINEAR" }), channel = (k, path) => ({ sampler: k, target: { node: 2, path } });
  const json = {
    asset: { version: "2.0" }, scene: 0, scenes: [{ nodes: [0] }],
    nodes: [{ name: "machine", rotation: [-half, 0, 0, half], children: [1, 2] }, { name: "base", mesh: 0, translation: [0, 0, -1], rotation: [0, 0, 0, 1] },
      { name: "Plattform ä", mesh: 0, translation: [0, 0, 0], rotation: [0, 0, 0, 1], extras: { platform: true } }],
    meshes: [{ primitives: [{ attributes: { POSITION, NORMAL }, indices, material: 0 }] }],
    materials: [{ pbrMetallicRoughness: { baseColorFactor: [0.1, 0.2, 0.3, 1] } }],
    animations: [{ extras: { begin: -1 }, samplers: [sampler(moved), sampler(rotated)], channels: [channel(0, "translation"), channel(1, "rotation")] }],
    accessors, bufferViews, buffers: [{ byteLength: size }],
  };
  let text = Buffer.from(JSON.stringify(json));
  text = Buffer.concat([text, Buffer.alloc((4 - (text.length % 4)) % 4, " ")]);
  const word = (...values) => Buffer.from(new Uint32Array(values).buffer);
  return Buffer.concat([word(0x46546c67, 2, 12 + 8 + text.length + 8 + size, text.length, 0x4e4f534a), text, word(size, 0x004e4942), ...pieces]);
}

const bytesOf = (buffer) => buffer.buffer.slice(buffer.byteOffset, buffer.byteOffset + buffer.length);
const sample = () => readModel(bytesOf(sampleFile()));

test("a model comes out of the page as it was packed", async () => {
  const file = sampleFile();
  assert.deepEqual(Buffer.from(await unpacked(zlib.gzipSync(file).toString("base64"))), file);
});

test("a model is read: bodies in order, their meshes, colours, keys and what is marked", () => {
  const model = sample();
  assert.deepEqual(model.bodies.map(({ name }) => name), ["base", "Plattform ä"]);
  assert.equal(model.platform, 1);
  assert.equal(model.begin, -1);
  assert.deepEqual([...model.times], [0, 1, 3]);
  assert.equal(model.meshes.length, 1);
  assert.deepEqual([...model.meshes[0][0].positions], cube.positions);
  assert.deepEqual([...model.meshes[0][0].indices], cube.indices);
  assert.deepEqual(model.meshes[0][0].colour, [0.1, 0.2, 0.3, 1]);
});

test("what is no model is refused", () => {
  for (const bytes of [Buffer.alloc(0), Buffer.from("no model, but long enough to be read")]) assert.throws(() => readModel(bytesOf(bytes)), /glTF/);
});

test("bodies stand at their keys, half-way between them, and outside the motion as at its ends", () => {
  const model = sample(), moving = (time) => posesAt(model, time)[1];
  near(moving(-1).origin, [0, 0, 0]);
  near(moving(0).origin, [2, 0, 0]);
  near(moving(-0.5).origin, [1, 0, 0]);
  near(moving(1).origin, [3, 0, 0]);
  near(moving(2).origin, [4, 0, 0]);
  near(moving(9).origin, [4, 0, 0]);
  near(moving(-9).origin, [0, 0, 0]);
  const c = Math.cos(Math.PI / 4);
  near(moving(-0.5).rotation, [c, -c, 0, c, c, 0, 0, 0, 1], 1e-6);
  near(moving(1).rotation, [0, -1, 0, 1, 0, 0, 0, 0, 1], 1e-6);
  near(posesAt(model, 0.3)[0].origin, [0, 0, -1]);
});

test("keys are found by their times", () => {
  assert.deepEqual(keyAt([0, 1, 3], 0), [0, 0]);
  assert.deepEqual(keyAt([0, 1, 3], 1), [1, 0]);
  assert.deepEqual(keyAt([0, 1, 3], 2.5), [1, 0.75]);
  assert.deepEqual(keyAt([0, 1, 3], 3), [2, 0]);
  assert.deepEqual(keyAt([0, 1, 3], NaN), [0, 0]);
  assert.deepEqual(keyAt([5], 7), [0, 0]);
});

test("a turn goes evenly and the short way, whichever sign its quaternions have", () => {
  const about = (angle) => [0, Math.sin(angle / 2), 0, Math.cos(angle / 2)];
  near(turned(about(0.2), about(1.4), 0.25), about(0.5));
  near(turned(about(0.2), about(1.4).map((v) => -v), 0.25).map((v) => Math.abs(v)), about(0.5).map((v) => Math.abs(v)));
  near(turned(about(1), about(1 + 1e-7), 0.5), about(1 + 5e-8), 1e-12);
  near(rotationOf(about(0.3)), [Math.cos(0.3), 0, Math.sin(0.3), 0, 1, 0, -Math.sin(0.3), 0, Math.cos(0.3)]);
});

test("a ray meets the body that is nearest to the viewer, where its surface is", () => {
  const model = sample(), poses = posesAt(model, -1);
  const down = pick(model, poses, [0.4, 0.3, 10], [0, 0, -1]);
  assert.equal(down.body, 1);
  near(down.point, [0.4, 0.3, 1]);
  assert.equal(pick(model, poses, [0.4, 0.3, -10], [0, 0, 1]).body, 0);
  assert.equal(pick(model, poses, [5, 0.3, 10], [0, 0, -1]), null);
  near(pick(model, posesAt(model, 2), [3.5, 0.5, 10], [0, 0, -1]).point, [3.5, 0.5, 1], 1e-6);  // turned by 90° about (4, 0)
  assert.equal(pick(model, posesAt(model, 2), [4.5, 0.5, 10], [0, 0, -1]), null);
});

test("a line meets a triangle from outside alone", () => {
  const corners = [9, 9, 9, 0, 0, 0, 1, 0, 0, 0, 1, 0];  // of it the last three
  assert.equal(meets([0.2, 0.2, 5], [0, 0, -1], corners, 3, 6, 9), 5);
  assert.equal(meets([0.2, 0.2, -5], [0, 0, 1], corners, 3, 6, 9), Infinity);
  assert.equal(meets([0.8, 0.8, 5], [0, 0, -1], corners, 3, 6, 9), Infinity);
  assert.equal(meets([0.2, 0.2, 5], [1, 0, 0], corners, 3, 6, 9), Infinity);
});

test("a ray asks the triangles of those bodies alone that it comes near to", () => {
  const model = sample(), poses = posesAt(model, 2), asked = meets, cut = Float32Array.prototype.subarray;  // the bodies are far apart
  let triangles = 0, lists = 0;
  globalThis.meets = (...all) => (++triangles, asked(...all));
  Float32Array.prototype.subarray = function (...all) {
    ++lists;
    return cut.apply(this, all);
  };
  try {
    assert.equal(pick(model, poses, [0.4, 0.3, 10], [0, 0, -1]).body, 0);
    assert.equal(triangles, 12);
    assert.equal(pick(model, poses, [0.4, 5, 10], [0, 0, -1]), null);
    assert.equal(triangles, 12);
    assert.equal(lists, 0);
  } finally {
    globalThis.meets = asked;
    Float32Array.prototype.subarray = cut;
  }
});

test("a ball around a mesh holds it, and no ray that meets the mesh passes it by", () => {
  const ball = ballOf([{ positions: cube.positions }]);
  near(ball.middle, [0.5, 0.5, 0.5]);
  near([ball.radius], [Math.sqrt(3) / 2]);
  for (const corner of [[0, 0, 0], [1, 0, 1], [1, 1, 1]])
    for (const d of [[0, 0, -3], [1, 2, 0.5], [-0.1, 0.2, 0.1]]) assert.ok(!passes(along(corner, [-7, d]), d, ball));
  assert.ok(passes([0.5, 1.4, 9], [0, 0, -2], ball));
});

test("the camera's axes are right, up and towards the viewer, as in the pictures", () => {
  for (const [azimuth, elevation] of [[0, 0], [0.7, 0.4], [-2, 1.5], [3, -0.6]]) {
    const { right, up, towards } = axesOf({ azimuth, elevation });
    for (const [a, b] of [[right, up], [up, towards], [towards, right]]) assert.ok(Math.abs(dot(a, b)) < 1e-12);
    near(cross(right, up), towards);
    assert.equal(right[2], 0);
  }
  near(axesOf({ azimuth: 0, elevation: 0 }).towards, [0, -1, 0]);
  near(axesOf({ azimuth: Math.PI / 2, elevation: 0 }).towards, [1, 0, 0]);
  near(axesOf({ azimuth: 0, elevation: Math.PI / 2 }).towards, [0, 0, 1]);
  const isometric = axesOf({ azimuth: standpoints.Isometric[0], elevation: standpoints.Isometric[1] });
  near(isometric.towards, [Math.sqrt(1 / 3), -Math.sqrt(1 / 3), Math.sqrt(1 / 3)]);
});

const cross = (a, b) => [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]];
const corners = [0, 1, 2, 3, 4, 5, 6, 7].map((i) => [2 * (i & 1), (i >> 1) & 1, 3 * (i >> 2)]);

test("the first view holds all points within its margin, in wide pictures and in narrow ones", () => {
  for (const [width, height] of [[900, 500], [390, 390], [300, 800]])
    for (const place of Object.values(standpoints)) {
      const camera = framing(corners, place, width / height), all = corners.map((p) => seen(camera, p, width, height));
      const [x, y] = [0, 1].map((k) => all.map((p) => p[k]));
      assert.ok(Math.min(...x) >= 0.05 * width && Math.max(...x) <= 0.95 * width && Math.min(...y) >= 0.05 * height && Math.max(...y) <= 0.95 * height);
      assert.ok(Math.max(...x) - Math.min(...x) > 0.87 * width || Math.max(...y) - Math.min(...y) > 0.87 * height);
    }
});

test("a place of the picture is found again in space, and what is moved by pixels moves by pixels", () => {
  const camera = framing(corners, standpoints.Isometric, 1.5), [width, height] = [600, 400];
  near(seen(camera, pointed(camera, 123, 77, width, height), width, height), [123, 77]);
  const from = [0.3, -0.2, 1.1], to = shifted(camera, from, 31, -12, height), [a, b] = [from, to].map((p) => seen(camera, p, width, height));
  near([b[0] - a[0], b[1] - a[1]], [31, -12]);
  assert.ok(Math.abs(dot(axesOf(camera).towards, less(to, from))) < 1e-12);
});

test("zooming keeps what stands under the pointer, and ends in time", () => {
  const home = framing(corners, standpoints.Isometric, 1.5), point = pointed(home, 100, 50, 600, 400);
  const closer = zoomed(home, 2, 100, 50, 600, 400, home);
  assert.equal(closer.height, home.height / 2);
  near(seen(closer, point, 600, 400), [100, 50]);
  assert.equal(zoomed(home, 1e9, 0, 0, 600, 400, home).height, home.height / 40);
  assert.equal(zoomed(home, 1e-9, 0, 0, 600, 400, home).height, home.height * 4);
});

test("turning stops straight above and straight below", () => {
  assert.equal(orbited({ azimuth: 1, elevation: 1.5 }, 0.2, 1).elevation, Math.PI / 2);
  assert.equal(orbited({ azimuth: 1, elevation: 0 }, 0.2, -9).elevation, -Math.PI / 2);
  assert.equal(orbited({ azimuth: 1, elevation: 0 }, 0.25, 0).azimuth, 1.25);
});

test("clip space is what is seen, and nearer is less deep", () => {
  const camera = framing(corners, [0.6, 0.5], 1.5), [width, height] = [600, 400], m = clipMatrix(camera, 1.5, [1, 0.5, 1.5], 9);
  const clip = (p) => [0, 1, 2, 3].map((row) => m[row] * p[0] + m[4 + row] * p[1] + m[8 + row] * p[2] + m[12 + row]);
  for (const p of corners) {
    const [x, y, z, w] = clip(p), [across, down] = seen(camera, p, width, height);
    near([(x + 1) * width / 2, (1 - y) * height / 2, w], [across, down, 1], 1e-4);
    assert.ok(Math.abs(z) < 1);
  }
  assert.ok(clip(along([0, 0, 0], [1, axesOf(camera).towards]))[2] < clip([0, 0, 0])[2]);
});

test("the points of reach hold the machine at all its times", () => {
  const points = reachOf(sample()), x = points.map((p) => p[0]), z = points.map((p) => p[2]);
  near([Math.min(...x), Math.max(...x), Math.min(...z), Math.max(...z)], [0, 4, -1, 1], 1e-6);
});

test("steps of a grid are 1, 2 or 5 times a power of ten", () => {
  for (const [length, step] of [[0.013, 0.02], [0.02, 0.02], [0.03, 0.05], [0.6, 1], [7, 10], [1, 1]]) near([roundStep(length)], [step], 1e-12);
});

test("the lines of a grid pass through round places, every fifth of them strong", () => {
  const { fine, strong } = gridLines(-1, [0.03, 0], 1, 0.1, 5), ends = (list) => Array.from({ length: list.length / 3 }, (_, i) => list.slice(3 * i, 3 * i + 3));
  assert.equal(fine.length % 6 + strong.length % 6, 0);
  for (const [x, y, z] of ends(strong)) {
    assert.equal(z, -1);
    assert.ok([x, y].some((v) => Math.abs(v / 0.5 - Math.round(v / 0.5)) < 1e-9));
    assert.ok(Math.hypot(x - 0.03, y) < 1 + 1e-9);
  }
  assert.ok(ends(fine).some(([x]) => Math.abs(x - 0.7) < 1e-9));
});

test("a motion that is played begins again where it ends", () => {
  assert.equal(nextTime(1, 0.25, 0, 2), 1.25);
  assert.equal(nextTime(1.75, 0.25, 0, 2), 2);
  assert.equal(nextTime(2, 0.5, 0, 2), 0.5);
  assert.equal(nextTime(-0.5, 7, -1, 1), 0.5);
  assert.equal(nextTime(3, 1, 3, 3), 3);
});

const margin = (more) => ({ name: "rho1", title: "", unit: "mm", factor: 1000, value: 1.2, low: 1, high: 2, margin: 0.2, share: 0.2, broken: false, ...more });

test("limits are told in the reader's units, the nearest first", () => {
  const angle = margin({ name: "A1", title: "swivel of A1", unit: "°", factor: 180 / Math.PI, value: 0.5, low: -Infinity, high: Math.PI / 4, margin: Math.PI / 4 - 0.5, share: 0.1 });
  const [first, second] = byRoom([margin(), angle]);
  assert.equal(first.name, "swivel of A1");
  assert.equal(limitsOf(first), "at most 45\u202f°");
  assert.equal(second.name, "rho1");
  assert.equal(limitsOf(second), "1000 to 2000\u00a0mm");
  assert.equal(limitsOf({ ...second, high: Infinity }), "at least 1000\u00a0mm");
  assert.equal(limitsOf({ ...second, low: -Infinity, high: Infinity }), "");
});

test("a pose is told in a sentence", () => {
  assert.equal(verdictOf({ margins: [margin()] }), "Within all limits.");
  assert.equal(verdictOf({ margins: [] }), "No limits are declared.");
  assert.equal(verdictOf({ margins: [margin({ low: -Infinity, high: Infinity, margin: Infinity })] }), "No limits are declared.");
  const bad = margin({ value: 2.1, margin: -0.1, share: -0.1, broken: true });
  assert.equal(verdictOf({ margins: [margin(), bad] }), "Beyond a limit: rho1, 2100.0\u00a0mm, allowed 1000 to 2000\u00a0mm.");
  const worse = margin({ name: "rho2", value: 2.5, margin: -0.5, share: -0.5, broken: true });
  assert.match(verdictOf({ margins: [bad, margin(), worse] }), /^Beyond 2 limits, farthest: rho2, /);
  for (const why of ["reach", "singular", "side"]) assert.match(refusalOf(why), /^[A-Z].*\. The machine stays where it was\.$/);
});

test("numbers are read as readers type them", () => {
  assert.equal(numberTyped(" 12.5 "), 12.5);
  assert.equal(numberTyped("−3,5"), -3.5);
  for (const text of ["", "abc", "1 2", "1e999"]) assert.equal(numberTyped(text), null, text);
});

test("numbers have the digits of their span, or their own, and limits no zeros that say nothing", () => {
  assert.equal(told(312.437), "312.4");
  assert.equal(told(-0.0312), "−0.03120");
  assert.equal(told(1e-17, 0, 300), "0.0");
  assert.equal(told(Infinity), "–");
  assert.equal(declared(1490.0000000001), "1490");
  assert.equal(declared(-0.25), "−0.25");
  assert.equal(declared(0), "0");
});

// ---- The reader's hands, with as much of a page as they touch ----

class Part {
  constructor(name) {
    Object.assign(this, { name, style: {}, children: [], attributes: {}, heard: {}, clientWidth: 600, clientHeight: 400, textContent: "", value: "" });
    const classes = new Set();
    this.classList = { toggle: (one, on) => (on ? classes.add(one) : classes.delete(one)), contains: (one) => classes.has(one) };
  }
  setAttribute(key, value) { this.attributes[key] = value; }
  append(...parts) {
    this.children.push(...parts);
    for (const part of parts) if (part instanceof Part) part.parent = this;
    if (parts.every((part) => typeof part === "string")) this.textContent += parts.join("");
  }
  replaceChildren(...parts) { this.children = parts; }
  before() {}
  remove() { if (this.parent) this.parent.children = this.parent.children.filter((part) => part !== this); }
  focus() { document.activeElement = this; }
  blur() { document.activeElement = null; }
  setPointerCapture() {}
  getBoundingClientRect() { return { left: 0, top: 0 }; }
  addEventListener(what, act) { (this.heard[what] ??= []).push(act); }
  tell(what, event = {}) { for (const act of this.heard[what] ?? []) act({ preventDefault() {}, ...event }); }
  // The first part below that is so.
  find(is) {
    for (const child of this.children.filter((one) => one instanceof Part)) {
      const found = is(child) ? child : child.find(is);
      if (found) return found;
    }
    return null;
  }
}

// Runs `act(find, asked)` on the view of the sample, whose platform a live machine moves by hand; `find` looks for a part of it, `asked` has
// the values that its actuator was asked for. `actuator`: what else is true of that. Nothing is in reach beyond 7.
function withView(act, actuator = {}) {
  const before = {};
  const put = (name, value) => {
    before[name] = Object.getOwnPropertyDescriptor(globalThis, name);
    Object.defineProperty(globalThis, name, before[name]?.configurable === false ? { value } : { value, configurable: true, writable: true });
  };
  const frames = [];
  put("document", { createElement: (name) => new Part(name), activeElement: null, body: new Part("body"), querySelector: () => cover });
  put("matchMedia", () => ({ matches: false, addEventListener() {} }));
  put("addEventListener", () => {});
  put("devicePixelRatio", 1);
  put("requestAnimationFrame", (next) => frames.push(next));
  for (const name of ["ResizeObserver", "IntersectionObserver"]) put(name, class { observe() {} });
  put("makePainter", () => () => {});
  const margins = [{ name: "l", unit: "m", factor: 1, value: 1, low: 0, high: 2, margin: 1, share: 0.5, broken: false }];
  const one = { symbol: "l", title: "", unit: "m", factor: 1, min: 0, max: 2, effort: { name: "force", unit: "N", factor: 1 } };
  const asked = [];
  const live = {
    home: [1], coordinates: [{ ...one, symbol: "x" }], actuators: [{ ...one, ...actuator }], load: {},
    at: (x) => ({ x, reachable: Math.abs(x[0]) < 7, actuators: actuator.rotary ? [Math.atan2(Math.sin(x[0]), Math.cos(x[0]))] : x, forces: [0], margins, condition: 1, bodies: posesAt(sample(), -1) }),
    solve: (lengths, from, how) => (asked.push(lengths), lengths[0] > 2.5 && !actuator.rotary ? ((how.why = "singular"), null) : lengths),
  };
  const section = new Part("section");
  try {
    assert.ok(showMachine(section, sample(), live));
    act((is) => section.find(is), asked);
  } finally {
    clock.followers.length = 0;
    for (const [name, was] of Object.entries(before)) was ? Object.defineProperty(globalThis, name, was) : delete globalThis[name];
  }
}
const cover = { src: "data:,", alt: "the machine" };
const called = (label) => (part) => part.attributes["aria-label"] === label;
const saying = (text) => (part) => part.name === "button" && part.textContent === text;

test("Space plays the motion where it is seen, and nothing where the machine is moved by hand", () => {
  withView((find) => {
    const canvas = find(({ name }) => name === "canvas"), play = find(saying("▶ Play"));
    canvas.tell("keydown", { key: " " });
    assert.equal(play.textContent, "❚❚ Pause");
    find(saying("By hand")).tell("click");
    assert.equal(play.textContent, "▶ Play");
    canvas.tell("keydown", { key: " " });
    assert.equal(play.textContent, "▶ Play");
  });
});

test("the platform is marked under the pointer, and no more once the pointer has left the picture", () => {
  withView((find) => {
    const canvas = find(({ name }) => name === "canvas");
    find(saying("By hand")).tell("click");
    const model = sample(), [x, y] = seen(framing(reachOf(model), standpoints.Isometric, 1.5), [0.5, 0.5, 1], 600, 400);
    canvas.tell("pointermove", { pointerType: "mouse", clientX: x, clientY: y });
    assert.ok(canvas.classList.contains("on-platform"));
    canvas.tell("pointerleave", { pointerType: "mouse" });
    assert.ok(!canvas.classList.contains("on-platform"));
  });
});

test("words typed in place of a number move nothing, and the number comes back", () => {
  withView((find, asked) => {
    find(saying("By hand")).tell("click");
    const number = find(called("l in m, as a number"));
    const type = (text) => {
      number.focus();
      number.value = text;
      number.tell("change");
    };
    const before = number.value;
    assert.equal(numberTyped(before), 1);
    type("a metre");
    assert.equal(number.value, before);
    assert.deepEqual(asked, []);
    type("1,5");
    assert.deepEqual(asked, [[1.5]]);
    assert.equal(numberTyped(number.value), 1.5);
  });
});

// Types into a field as a reader does, and answers with what stands beside it then.
function typing(find, label) {
  const number = find(called(label + ", as a number")), cell = find((part) => part.children.includes(number));
  const remark = cell.find(({ attributes }) => attributes.class === "remark");
  const type = (text) => {
    number.focus();
    number.value = text;
    number.tell("input");
    number.tell("change");
    return remark.textContent;
  };
  return { number, remark, type };
}

test("what a field does not take is told beside it until something else is asked for", () => {
  withView((find) => {
    find(saying("By hand")).tell("click");
    const { number, remark, type } = typing(find, "l in m"), other = typing(find, "x in m");
    assert.equal(type("a metre"), "“a metre”: no number");
    assert.equal(number.attributes["aria-invalid"], "true");
    number.tell("input");
    assert.equal(remark.textContent, "");
    assert.equal(number.attributes["aria-invalid"], "false");
    assert.equal(type("2,75"), "“2,75”: a singular pose is in the way");
    assert.equal(numberTyped(number.value), 1);
    assert.equal(other.type("8"), "“8”: out of reach");
    assert.equal(other.number.attributes["aria-invalid"], "true");
    assert.equal(type("1.5"), "");
    assert.equal(other.remark.textContent, "");
    assert.equal(other.number.attributes["aria-invalid"], "false");
  });
});

test("Escape takes back what was typed, and asks for nothing", () => {
  withView((find, asked) => {
    find(saying("By hand")).tell("click");
    const { number, remark } = typing(find, "l in m"), before = number.value;
    number.focus();
    number.value = "1.9";
    number.tell("input");
    number.tell("keydown", { key: "Escape" });
    assert.equal(number.value, before);
    assert.equal(remark.textContent, "");
    assert.equal(document.activeElement, null);
    assert.deepEqual(asked, []);
  });
});

test("an angle that loses whole turns says so, any other says nothing", () => {
  assert.equal(turnsTold(400, 40), "400\u202f° is 40\u202f° and a turn");
  assert.equal(turnsTold(-700, 20), "−700\u202f° is 20\u202f° less 2 turns");
  assert.equal(turnsTold(40, 40.000001), "");
  withView((find) => {
    find(saying("By hand")).tell("click");
    const { type } = typing(find, "l in °");
    assert.equal(type("370"), "370\u202f° is 10\u202f° and a turn");
    assert.equal(type("10"), "");
  }, { rotary: true, unit: "°", factor: 180 / Math.PI });
});

test("where the graphics card is lost the still picture stands in, until it is back", () => {
  withView((find) => {
    const canvas = find(({ name }) => name === "canvas"), lost = () => find(({ attributes }) => attributes.class === "view-lost");
    assert.equal(lost(), null);
    canvas.tell("webglcontextlost");
    assert.match(lost().find(({ name }) => name === "p").textContent, /lost its connection to the graphics card.* The picture shows the machine at home\.$/);
    assert.equal(lost().find(({ name }) => name === "img").attributes.src, cover.src);
    canvas.tell("webglcontextrestored");
    assert.equal(lost(), null);
  });
});
