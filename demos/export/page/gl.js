// WebGL 2: programs, and batches of one solid in many places.

const canvas = byId("picture");
const gl = canvas.getContext("webgl2", { antialias: true, alpha: false, preserveDrawingBuffer: false });

/// A program and the locations of its uniforms.
function programOf(vertex, fragment) {
  const program = gl.createProgram();
  for (const [kind, text] of [[gl.VERTEX_SHADER, vertex], [gl.FRAGMENT_SHADER, fragment]]) {
    const shader = gl.createShader(kind);
    gl.shaderSource(shader, text);
    gl.compileShader(shader);
    gl.attachShader(program, shader);
  }
  gl.linkProgram(program);
  if (!gl.getProgramParameter(program, gl.LINK_STATUS) && !gl.isContextLost()) {
    const logs = gl.getAttachedShaders(program).map((shader) => gl.getShaderInfoLog(shader));
    throw new Error(`a shader does not compile: ${logs.join(" ")}`);
  }
  const places = {}, count = gl.getProgramParameter(program, gl.ACTIVE_UNIFORMS);
  for (let i = 0; i < count; ++i) {
    const { name } = gl.getActiveUniform(program, i);
    places[name] = gl.getUniformLocation(program, name);
  }
  return { program, places };
}

/// Sets numbers, vectors of two or three and matrices by uniform name; skips names that the program lacks.
function use({ program, places }, uniforms) {
  gl.useProgram(program);
  for (const [name, value] of Object.entries(uniforms)) {
    const place = places[name];
    if (place === undefined) continue;
    if (value.length === 16) gl.uniformMatrix4fv(place, false, value);
    else if (value.length === 2) gl.uniform2fv(place, value);
    else if (value.length === 3) gl.uniform3fv(place, value);
    else if (name === "shadowMap") gl.uniform1i(place, value);
    else gl.uniform1f(place, value);
  }
}

const kInstance = 16;  // floats: place 3, turn 4, scale 3, color 4, roughness, metallic
const kPieces = [3, 3, 4], kInstancePieces = [3, 4, 3, 4, 2];
const kPaint = [0.55, 0];

function setPieces(pieces, first, stride, divisor) {
  let offset = 0;
  pieces.forEach((size, i) => {
    gl.enableVertexAttribArray(first + i);
    gl.vertexAttribPointer(first + i, size, gl.FLOAT, false, 4 * stride, 4 * offset);
    gl.vertexAttribDivisor(first + i, divisor);
    offset += size;
  });
}

/// One solid's triangles, drawn wherever `add` says.
class Batch {
  constructor(numbers) {
    this.corners = numbers.length / kFloats;
    this.array = gl.createVertexArray();
    gl.bindVertexArray(this.array);
    gl.bindBuffer(gl.ARRAY_BUFFER, gl.createBuffer());
    gl.bufferData(gl.ARRAY_BUFFER, new Float32Array(numbers), gl.STATIC_DRAW);
    setPieces(kPieces, 0, kFloats, 0);
    this.buffer = gl.createBuffer();
    gl.bindBuffer(gl.ARRAY_BUFFER, this.buffer);
    setPieces(kInstancePieces, kPieces.length, kInstance, 1);
    this.instances = new Float32Array(16 * kInstance);
    this.count = 0;
  }
  clear() { this.count = 0; }
  add(place, turn, scale, color, material = kPaint) {
    const at = kInstance * this.count++;
    if (at + kInstance > this.instances.length) {
      const larger = new Float32Array(2 * this.instances.length);
      larger.set(this.instances);
      this.instances = larger;
    }
    this.instances.set(place, at);
    this.instances.set(turn, at + 3);
    this.instances.set(scale, at + 7);
    this.instances.set(color, at + 10);
    this.instances.set(material, at + 14);
  }
  upload() {
    gl.bindBuffer(gl.ARRAY_BUFFER, this.buffer);
    gl.bufferData(gl.ARRAY_BUFFER, this.instances.subarray(0, kInstance * this.count), gl.DYNAMIC_DRAW);
  }
  draw() {
    if (this.count === 0) return;
    gl.bindVertexArray(this.array);
    gl.drawArraysInstanced(gl.TRIANGLES, 0, this.corners, this.count);
  }
}

/// sRGB to linear.
const linear = (color) => color.slice(0, 3).map((s) => (s <= 0.04045 ? s / 12.92 : ((s + 0.055) / 1.055) ** 2.4));
