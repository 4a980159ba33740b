// The machine in three dimensions: reads data/model.glb as it stands in the page, draws it with WebGL 2, plays its motion together with the
// time cursor of all plots, and lets the reader move it by hand where the page brings the machine's geometry (live.js). Nothing moves
// unless it is asked to, and nothing is drawn unless something changed.
//
// Lengths in metres, z up, as the machine's base has them. A body's pose is {origin: [3], rotation: [9]}, the rotation row by row.

const deg = Math.PI / 180;
const dot = (a, b) => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
const along = (p, ...steps) => p.map((value, k) => value + steps.reduce((sum, [length, v]) => sum + length * v[k], 0));
const less = (a, b) => a.map((value, k) => value - b[k]);
const clamped = (value, low, high) => Math.min(high, Math.max(low, value));

// ---- The model ----

async function unpacked(base64) {
  const bytes = Uint8Array.from(atob(base64), (c) => c.charCodeAt(0));
  return new Response(new Blob([bytes]).stream().pipeThrough(new DecompressionStream("gzip"))).arrayBuffer();
}

// Binary glTF 2.0 as we write it: one root that turns z up into y up, bodies below it in the machine's order, one animation or none.
// Bodies that look alike share a mesh. Throws where it is anything else.
function readModel(buffer) {
  const head = new DataView(buffer);
  if (buffer.byteLength < 20 || head.getUint32(0, true) !== 0x46546c67 || head.getUint32(4, true) !== 2) throw new Error("no binary glTF 2.0");
  const jsonSize = head.getUint32(12, true), binary = 20 + jsonSize + 8;
  const gltf = JSON.parse(new TextDecoder().decode(new Uint8Array(buffer, 20, jsonSize)));
  const list = (index) => {
    const accessor = gltf.accessors[index], place = binary + gltf.bufferViews[accessor.bufferView].byteOffset;
    const type = { 5123: Uint16Array, 5125: Uint32Array, 5126: Float32Array }[accessor.componentType];
    return new type(buffer, place, accessor.count * { SCALAR: 1, VEC3: 3, VEC4: 4 }[accessor.type]);
  };
  const part = ({ attributes, indices, material }) => ({
    positions: list(attributes.POSITION), normals: list(attributes.NORMAL), indices: list(indices),
    colour: gltf.materials[material].pbrMetallicRoughness.baseColorFactor,
  });
  const nodes = gltf.nodes[gltf.scenes[gltf.scene].nodes[0]].children ?? [], animation = gltf.animations?.[0];
  const track = (node, path) => {
    const channel = animation?.channels.find(({ target }) => target.node === node && target.path === path);
    return channel ? list(animation.samplers[channel.sampler].output) : null;
  };
  const meshes = (gltf.meshes ?? []).map(({ primitives }) => primitives.map(part));
  return {
    meshes, balls: meshes.map(ballOf),
    times: animation ? list(animation.samplers[0].input) : new Float32Array(0),
    begin: animation?.extras?.begin ?? 0,  // of the motion [s], where the keys count from later
    platform: nodes.findIndex((node) => gltf.nodes[node].extras?.platform === true),
    bodies: nodes.map((node) => {
      const { name, mesh, translation, rotation } = gltf.nodes[node];
      return { name, mesh: mesh ?? -1, translation, rotation, translations: track(node, "translation"), rotations: track(node, "rotation") };
    }),
  };
}

// Of a unit quaternion x y z w.
function rotationOf([x, y, z, w]) {
  return [
    1 - 2 * (y * y + z * z), 2 * (x * y - z * w), 2 * (x * z + y * w),
    2 * (x * y + z * w), 1 - 2 * (x * x + z * z), 2 * (y * z - x * w),
    2 * (x * z - y * w), 2 * (y * z + x * w), 1 - 2 * (x * x + y * y),
  ];
}

// The shorter way from one unit quaternion to another, evenly. Where they are close a straight line is as good, and divides by no zero.
function turned(a, b, share) {
  const cosine = a.reduce((sum, value, k) => sum + value * b[k], 0), angle = Math.acos(Math.min(1, Math.abs(cosine)));
  const straight = angle < 1e-4;
  const of = straight ? 1 - share : Math.sin((1 - share) * angle) / Math.sin(angle);
  const to = (straight ? share : Math.sin(share * angle) / Math.sin(angle)) * (cosine < 0 ? -1 : 1);
  const q = a.map((value, k) => of * value + to * b[k]), size = Math.hypot(...q);
  return q.map((value) => value / size);
}

// The last key that is not after `time`, and how far on to the next: [key, share], share 0 at the ends.
function keyAt(times, time) {
  let low = 0, high = times.length - 1;
  if (!(time > times[low])) return [low, 0];
  if (time >= times[high]) return [high, 0];
  while (high - low > 1) {
    const middle = (low + high) >> 1;
    if (times[middle] <= time) low = middle;
    else high = middle;
  }
  return [low, (time - times[low]) / (times[high] - times[low])];
}

// Where all bodies are at a time of the motion; outside it as at its ends, without one as they stand.
function posesAt(model, time) {
  const [key, share] = model.times.length > 0 ? keyAt(model.times, time - model.begin) : [0, 0];
  const row = (all, width, k) => Array.from(all.subarray(width * k, width * k + width));
  return model.bodies.map((body) => {
    const { translations: p, rotations: q } = body;
    if (!p || !q) return { origin: body.translation, rotation: rotationOf(body.rotation) };
    if (share === 0) return { origin: row(p, 3, key), rotation: rotationOf(row(q, 4, key)) };
    const from = row(p, 3, key), step = less(row(p, 3, key + 1), from);
    return { origin: along(from, [share, step]), rotation: rotationOf(turned(row(q, 4, key), row(q, 4, key + 1), share)) };
  });
}

const placed = ({ origin, rotation: r }, p) => [0, 1, 2].map((k) => origin[k] + r[3 * k] * p[0] + r[3 * k + 1] * p[1] + r[3 * k + 2] * p[2]);
const turnedBack = ({ rotation: r }, v) => [0, 1, 2].map((k) => r[k] * v[0] + r[3 + k] * v[1] + r[6 + k] * v[2]);

// Of a mesh the points that reach farthest in 26 directions: of a cube's corners, edges and faces.
function extremesOf(mesh) {
  const best = new Map();
  for (const { positions: p } of mesh)
    for (let i = 0; i < p.length; i += 3)
      for (let d = 0; d < 27; ++d) {
        const [x, y, z] = [(d % 3) - 1, (Math.floor(d / 3) % 3) - 1, Math.floor(d / 9) - 1], far = x * p[i] + y * p[i + 1] + z * p[i + 2];
        if (!(far <= best.get(d)?.far)) best.set(d, { far, point: [p[i], p[i + 1], p[i + 2]] });
      }
  return [...best.values()].map(({ point }) => point);
}

// Points that everything lies between, whatever the time.
function reachOf(model) {
  const extremes = model.meshes.map(extremesOf), end = model.times.length - 1, points = [];
  for (let i = 0; i <= 32; ++i) {
    const poses = posesAt(model, end < 0 ? 0 : model.begin + model.times[Math.round((i * end) / 32)]);
    model.bodies.forEach(({ mesh }, b) => mesh >= 0 && points.push(...extremes[mesh].map((p) => placed(poses[b], p))));
    if (end < 1) break;
  }
  return points.length > 0 ? points : [[-0.5, -0.5, 0], [0.5, 0.5, 1]];
}

// A ball around a mesh: {middle, radius}.
function ballOf(mesh) {
  const low = [Infinity, Infinity, Infinity], high = [-Infinity, -Infinity, -Infinity];
  for (const { positions: p } of mesh)
    for (let i = 0; i < p.length; ++i) {
      low[i % 3] = Math.min(low[i % 3], p[i]);
      high[i % 3] = Math.max(high[i % 3], p[i]);
    }
  const middle = low.map((value, k) => (value + high[k]) / 2);
  let radius = 0;
  for (const { positions: p } of mesh) for (let i = 0; i < p.length; i += 3) radius = Math.max(radius, Math.hypot(p[i] - middle[0], p[i + 1] - middle[1], p[i + 2] - middle[2]));
  return { middle, radius };
}

// Whether a line passes a ball by, but for rounding.
function passes(o, d, { middle: m, radius }) {
  const x = m[0] - o[0], y = m[1] - o[1], z = m[2] - o[2];
  const px = y * d[2] - z * d[1], py = z * d[0] - x * d[2], pz = x * d[1] - y * d[0];
  return Math.hypot(px, py, pz) > (1 + 1e-9) * radius * Math.hypot(d[0], d[1], d[2]);
}

// The first body that a ray meets, from far away along `direction`: {body, distance, point}; null where it meets none. `distance` counts
// from `origin`, and may be negative.
function pick(model, poses, origin, direction) {
  let body = -1, nearest = Infinity;
  model.bodies.forEach(({ mesh }, b) => {
    if (mesh < 0) return;
    const o = turnedBack(poses[b], less(origin, poses[b].origin)), d = turnedBack(poses[b], direction);
    if (passes(o, d, model.balls[mesh])) return;
    for (const { positions, indices } of model.meshes[mesh])
      for (let i = 0; i < indices.length; i += 3) {
        const distance = meets(o, d, positions, 3 * indices[i], 3 * indices[i + 1], 3 * indices[i + 2]);
        if (distance < nearest) [body, nearest] = [b, distance];
      }
  });
  return body < 0 ? null : { body, distance: nearest, point: along(origin, [nearest, direction]) };
}

// Möller and Trumbore: where a line meets from outside the triangle whose corners begin at a, b and c in a list of numbers; infinity where
// it does not. It runs for every triangle of a body at each move of a pointer, and makes nothing that would be collected.
function meets(o, d, p, a, b, c) {
  const ax = p[a], ay = p[a + 1], az = p[a + 2];
  const ux = p[b] - ax, uy = p[b + 1] - ay, uz = p[b + 2] - az, vx = p[c] - ax, vy = p[c + 1] - ay, vz = p[c + 2] - az;
  const px = d[1] * vz - d[2] * vy, py = d[2] * vx - d[0] * vz, pz = d[0] * vy - d[1] * vx;
  const volume = ux * px + uy * py + uz * pz;
  if (!(volume > 0)) return Infinity;
  const sx = o[0] - ax, sy = o[1] - ay, sz = o[2] - az, u = (sx * px + sy * py + sz * pz) / volume;
  if (u < 0 || u > 1) return Infinity;
  const qx = sy * uz - sz * uy, qy = sz * ux - sx * uz, qz = sx * uy - sy * ux, v = (d[0] * qx + d[1] * qy + d[2] * qz) / volume;
  return v < 0 || u + v > 1 ? Infinity : (vx * qx + vy * qy + vz * qz) / volume;
}

// ---- The camera, orthographic as in the pictures of the report ----

const standpoints = { Isometric: [45 * deg, Math.atan(Math.SQRT1_2)], Front: [0, 0], Right: [90 * deg, 0], Top: [0, 90 * deg] };

// Looks along +Y at azimuth 0, along -X at 90°, straight down at elevation 90°.
function axesOf({ azimuth, elevation }) {
  const sa = Math.sin(azimuth), ca = Math.cos(azimuth), se = Math.sin(elevation), ce = Math.cos(elevation);
  return { right: [ca, sa, 0], up: [-sa * se, ca * se, ce], towards: [sa * ce, -ca * ce, se] };
}

// The camera that holds all points, with a margin of 6 % on every side.
function framing(points, [azimuth, elevation], aspect) {
  const { right, up, towards } = axesOf({ azimuth, elevation });
  const [across, upwards, deep] = [right, up, towards].map((axis) => {
    const all = points.map((p) => dot(axis, p)), low = Math.min(...all), high = Math.max(...all);
    return { middle: (low + high) / 2, span: high - low };
  });
  const height = Math.max(upwards.span, across.span / aspect) / 0.88 || 1;
  return { azimuth, elevation, height, target: along([0, 0, 0], [across.middle, right], [upwards.middle, up], [deep.middle, towards]) };
}

// A point in a picture of this size, from its top left corner: [x, y].
function seen(camera, point, width, height) {
  const { right, up } = axesOf(camera), v = less(point, camera.target), scale = height / camera.height;
  return [width / 2 + scale * dot(right, v), height / 2 - scale * dot(up, v)];
}

// The point of a picture in the plane through the target that is parallel to it.
function pointed(camera, x, y, width, height) {
  const { right, up } = axesOf(camera), scale = camera.height / height;
  return along(camera.target, [scale * (x - width / 2), right], [scale * (height / 2 - y), up]);
}

// Moved parallel to the picture by so many of its pixels.
function shifted(camera, point, dx, dy, height) {
  const { right, up } = axesOf(camera), scale = camera.height / height;
  return along(point, [scale * dx, right], [-scale * dy, up]);
}

const orbited = (camera, turn, rise) => ({ ...camera, azimuth: camera.azimuth + turn, elevation: clamped(camera.elevation + rise, -90 * deg, 90 * deg) });

// What stands at this place of the picture stays there.
function zoomed(camera, factor, x, y, width, height, home) {
  const next = { ...camera, height: clamped(camera.height / factor, home.height / 40, home.height * 4) };
  return { ...next, target: along(next.target, [1, less(pointed(camera, x, y, width, height), pointed(next, x, y, width, height))]) };
}

// World to clip space as WebGL takes it, column by column; depth holds what is within `radius` of `middle`.
function clipMatrix(camera, aspect, middle, radius) {
  const { right, up, towards } = axesOf(camera), sx = 2 / (camera.height * aspect), sy = 2 / camera.height, sz = -1 / radius;
  return new Float32Array([
    sx * right[0], sy * up[0], sz * towards[0], 0, sx * right[1], sy * up[1], sz * towards[1], 0, sx * right[2], sy * up[2], sz * towards[2], 0,
    -sx * dot(right, camera.target), -sy * dot(up, camera.target), -sz * dot(towards, middle), 1,
  ]);
}

// 1, 2 or 5 times a power of ten, the next above.
function roundStep(length) {
  const decade = 10 ** Math.floor(Math.log10(length));
  return decade * [1, 2, 5, 10].find((m) => m * decade >= length * (1 - 1e-9));
}

// ---- What draws ----

const shaders = {
  // The back faces of a solid that is grown by `outline` pixels stand out around it as its outline.
  solid: [`#version 300 es
    layout(location = 0) in vec3 position;
    layout(location = 1) in vec3 normal;
    uniform mat4 see, body;
    uniform mat3 turn;
    uniform vec2 size;
    uniform float outline;
    out vec3 n;
    void main() {
      n = turn * mat3(body) * normal;
      gl_Position = see * body * vec4(position, 1.0);
      float reach = length(n.xy);
      if (reach > 1e-3) gl_Position.xy += 2.0 * outline * n.xy / (reach * size);
    }`, `#version 300 es
    precision highp float;
    in vec3 n;
    uniform vec3 paint, up;
    uniform float lit;
    out vec4 colour;
    void main() {
      vec3 m = normalize(n);
      float key = max(0.0, dot(m, vec3(-0.485, 0.566, 0.667))), fill = max(0.0, dot(m, vec3(0.640, 0.105, 0.761)));
      float back = max(0.0, dot(m, vec3(0.30, 0.80, -0.52))), sky = 0.5 + 0.5 * dot(m, up);
      float shine = 0.16 * pow(max(0.0, dot(m, vec3(-0.266, 0.310, 0.913))), 32.0);
      vec3 light = paint * mix(1.0, 0.62 * key + mix(0.10, 0.34, sky) + 0.22 * fill + 0.12 * back, lit) + lit * shine;
      colour = vec4(pow(min(light, 1.0), vec3(1.0 / 2.2)), 1.0);
    }`],
  // What falls on the ground along `light`.
  shade: [`#version 300 es
    layout(location = 0) in vec3 position;
    uniform mat4 see, body;
    uniform vec3 light;
    uniform float ground;
    void main() {
      vec3 p = (body * vec4(position, 1.0)).xyz;
      gl_Position = see * vec4(p + light * max(0.0, p.z - ground), 1.0);
    }`, `#version 300 es
    precision highp float;
    uniform vec4 paint;
    out vec4 colour;
    void main() { colour = vec4(paint.rgb * paint.a, paint.a); }`],
  // Each line is a narrow rectangle, and fades out where it is `reach` away from the middle.
  line: [`#version 300 es
    layout(location = 0) in vec3 a;
    layout(location = 1) in vec3 b;
    uniform mat4 see;
    uniform vec2 size, middle;
    uniform float width, reach;
    out float fade;
    void main() {
      vec4 p = see * vec4(a, 1.0), q = see * vec4(b, 1.0);
      bool first = gl_VertexID < 2;
      vec2 run = (q.xy - p.xy) * size;
      run = length(run) > 1e-6 ? normalize(run) : vec2(1.0, 0.0);
      vec2 out2 = (gl_VertexID & 1) == 0 ? vec2(-run.y, run.x) : vec2(run.y, -run.x);
      gl_Position = first ? p : q;
      gl_Position.xy += width * (out2 + (first ? -0.5 : 0.5) * run) / size;
      fade = reach > 0.0 ? 1.0 - length((first ? a : b).xy - middle) / reach : 1.0;
    }`, `#version 300 es
    precision highp float;
    in float fade;
    uniform vec4 paint;
    out vec4 colour;
    void main() { float a = paint.a * clamp(1.6 * fade, 0.0, 1.0); colour = vec4(paint.rgb * a, a); }`],
};

function makeProgram(gl, [vertex, fragment]) {
  const program = gl.createProgram();
  for (const [kind, source] of [[gl.VERTEX_SHADER, vertex], [gl.FRAGMENT_SHADER, fragment]]) {
    const shader = gl.createShader(kind);
    gl.shaderSource(shader, source);
    gl.compileShader(shader);
    gl.attachShader(program, shader);
  }
  gl.linkProgram(program);
  if (!gl.getProgramParameter(program, gl.LINK_STATUS) && !gl.isContextLost()) throw new Error(gl.getProgramInfoLog(program));
  const at = {};
  for (let i = 0; i < (gl.getProgramParameter(program, gl.ACTIVE_UNIFORMS) ?? 0); ++i) {
    const { name } = gl.getActiveUniform(program, i);
    at[name] = gl.getUniformLocation(program, name);
  }
  return { program, at };
}

// Lists of three-vectors, each with its stride and offset in bytes, as the attributes 0, 1, ... of vertices, or of instances.
function makeArray(gl, lists, indices, perInstance) {
  const array = gl.createVertexArray();
  gl.bindVertexArray(array);
  lists.forEach(({ numbers, stride, offset }, location) => {
    gl.bindBuffer(gl.ARRAY_BUFFER, gl.createBuffer());
    gl.bufferData(gl.ARRAY_BUFFER, numbers, gl.STATIC_DRAW);
    gl.enableVertexAttribArray(location);
    gl.vertexAttribPointer(location, 3, gl.FLOAT, false, stride, offset);
    if (perInstance) gl.vertexAttribDivisor(location, 1);
  });
  if (indices) {
    gl.bindBuffer(gl.ELEMENT_ARRAY_BUFFER, gl.createBuffer());
    gl.bufferData(gl.ELEMENT_ARRAY_BUFFER, indices, gl.STATIC_DRAW);
  }
  gl.bindVertexArray(null);
  return array;
}

// Segments one after the other, six numbers each.
function makeLines(gl, numbers) {
  const list = new Float32Array(numbers);
  return { count: list.length / 6, array: makeArray(gl, [0, 12].map((offset) => ({ numbers: list, stride: 24, offset })), null, true) };
}

function gridLines(ground, [x, y], reach, step, every) {
  const fine = [], strong = [], kind = (k) => (k % every === 0 ? strong : fine);
  // In short pieces, so that they fade.
  const pieces = 16;
  const add = (from, to, of) => {
    for (let i = 0; i < pieces; ++i) for (const end of [i, i + 1]) of.push(...from.map((value, k) => value + ((to[k] - value) * end) / pieces), ground);
  };
  const half = (offset) => Math.sqrt(Math.max(0, reach * reach - offset * offset));
  for (let k = Math.ceil((x - reach) / step); k * step <= x + reach; ++k) add([k * step, y - half(k * step - x)], [k * step, y + half(k * step - x)], kind(k));
  for (let k = Math.ceil((y - reach) / step); k * step <= y + reach; ++k) add([x - half(k * step - y), k * step], [x + half(k * step - y), k * step], kind(k));
  return { fine, strong };
}

// Everything that depends on a WebGL context; made anew when one is lost and comes back.
function makePainter(canvas, model, stage) {
  const gl = canvas.getContext("webgl2", { antialias: true, stencil: true, premultipliedAlpha: true });
  if (!gl) return null;
  const solid = makeProgram(gl, shaders.solid), shade = makeProgram(gl, shaders.shade), line = makeProgram(gl, shaders.line);
  const meshes = model.meshes.map((parts) =>
    parts.map(({ positions, normals, indices, colour }) => ({
      array: makeArray(gl, [positions, normals].map((numbers) => ({ numbers, stride: 0, offset: 0 })), indices, false),
      count: indices.length, colour, type: indices instanceof Uint16Array ? gl.UNSIGNED_SHORT : gl.UNSIGNED_INT,
    })));
  const grid = gridLines(stage.ground, stage.middle, stage.reach, stage.step, 5);
  const fine = makeLines(gl, grid.fine), strong = makeLines(gl, grid.strong), path = makeLines(gl, stage.path);
  const frame = [0, 1, 2].map((axis) => makeLines(gl, [0, 0, 0, ...[0, 1, 2].map((k) => (k === axis ? stage.frame : 0))]));
  let see;

  const drawMesh = (program, pose, parts, before) => {
    const { origin: o, rotation: r } = pose;
    gl.uniformMatrix4fv(program.at.body, false, [r[0], r[3], r[6], 0, r[1], r[4], r[7], 0, r[2], r[5], r[8], 0, o[0], o[1], o[2], 1]);
    for (const part of parts) {
      before?.(part);
      gl.bindVertexArray(part.array);
      gl.drawElements(gl.TRIANGLES, part.count, part.type, 0);
    }
  };
  const drawBodies = (program, poses, before) =>
    model.bodies.forEach(({ mesh }, b) => mesh >= 0 && drawMesh(program, poses[b], meshes[mesh], (part) => before?.(part, b)));
  const drawLines = (lines, width, paint, reach = 0) => {
    gl.useProgram(line.program);
    gl.uniformMatrix4fv(line.at.see, false, see);
    gl.uniform2f(line.at.size, canvas.width, canvas.height);
    gl.uniform2fv(line.at.middle, stage.middle);
    gl.uniform1f(line.at.width, width);
    gl.uniform1f(line.at.reach, reach);
    gl.uniform4fv(line.at.paint, paint);
    gl.bindVertexArray(lines.array);
    if (lines.count > 0) gl.drawArraysInstanced(gl.TRIANGLE_STRIP, 0, 4, lines.count);
  };

  // Suns close together, each with its part of the shade: a soft edge. What a sun shades already it shades no more.
  const drawShade = (poses, opacity, suns) => {
    gl.useProgram(shade.program);
    gl.uniformMatrix4fv(shade.at.see, false, see);
    gl.uniform1f(shade.at.ground, stage.ground);
    gl.uniform4f(shade.at.paint, 0, 0, 0, opacity / suns);
    gl.enable(gl.STENCIL_TEST);
    gl.stencilOp(gl.KEEP, gl.KEEP, gl.REPLACE);
    for (let k = 1; k <= suns; ++k) {
      const spread = suns > 1 ? 0.035 * Math.sqrt(k / suns) : 0;
      gl.uniform3f(shade.at.light, 0.22 + spread * Math.cos(2.4 * k), 0.3 + spread * Math.sin(2.4 * k), -1);
      gl.stencilFunc(gl.GREATER, k, 255);
      drawBodies(shade, poses);
    }
    gl.disable(gl.STENCIL_TEST);
  };

  return (poses, camera, { dark, marked, quick }) => {
    const width = canvas.width, height = canvas.height, pixel = Math.max(1, height / canvas.clientHeight), ink = dark ? 0.9 : 0.1;
    const axes = axesOf(camera), above = axes.towards[2] > 0.02;
    see = clipMatrix(camera, width / height, stage.centre, stage.depth);
    gl.viewport(0, 0, width, height);
    gl.clearColor(0, 0, 0, 0);
    gl.clear(gl.COLOR_BUFFER_BIT | gl.DEPTH_BUFFER_BIT | gl.STENCIL_BUFFER_BIT);
    gl.enable(gl.DEPTH_TEST);
    gl.enable(gl.CULL_FACE);
    gl.disable(gl.BLEND);
    gl.depthMask(true);

    gl.useProgram(solid.program);
    gl.uniformMatrix4fv(solid.at.see, false, see);
    gl.uniformMatrix3fv(solid.at.turn, false, [0, 1, 2].flatMap((k) => [axes.right[k], axes.up[k], axes.towards[k]]));
    gl.uniform2f(solid.at.size, width, height);
    gl.uniform3f(solid.at.up, axes.right[2], axes.up[2], axes.towards[2]);
    gl.uniform1f(solid.at.outline, 0);
    gl.uniform1f(solid.at.lit, 1);
    gl.cullFace(gl.BACK);
    drawBodies(solid, poses, ({ colour }, b) => gl.uniform3fv(solid.at.paint, b === marked ? colour.slice(0, 3).map((c) => 0.75 * c + 0.25) : colour.slice(0, 3)));
    gl.uniform1f(solid.at.outline, 1.1 * pixel);
    gl.uniform1f(solid.at.lit, 0);
    gl.cullFace(gl.FRONT);
    drawBodies(solid, poses, (_, b) => gl.uniform3fv(solid.at.paint, b === marked ? [0.6, 0.12, 0.01] : [0.01, 0.014, 0.018]));

    gl.disable(gl.CULL_FACE);
    gl.enable(gl.BLEND);
    gl.blendFunc(gl.ONE, gl.ONE_MINUS_SRC_ALPHA);
    gl.depthMask(false);
    if (above) drawShade(poses, dark ? 0.5 : 0.2, quick ? 1 : 8);
    drawLines(fine, pixel, [ink, ink, ink, dark ? 0.11 : 0.09], stage.reach);
    drawLines(strong, pixel, [ink, ink, ink, 0.24], stage.reach);
    const bright = dark ? [[1, 0.42, 0.38], [0.36, 0.8, 0.42], [0.45, 0.63, 1]] : [[0.78, 0.2, 0.17], [0.18, 0.56, 0.24], [0.16, 0.37, 0.77]];
    const orange = dark ? [1, 0.52, 0.2] : [0.82, 0.34, 0.04];
    const drawMarks = (opacity) => {
      frame.forEach((axis, k) => drawLines(axis, 2 * pixel, [...bright[k], opacity]));
      drawLines(path, 2.2 * pixel, [...orange, opacity]);
    };
    drawMarks(1);
    gl.disable(gl.DEPTH_TEST);
    drawMarks(0.3);
    gl.bindVertexArray(null);
  };
}
