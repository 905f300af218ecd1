// Colors as arrays of red, green and blue in [0, 1].
const Colors = {
  // The colors of numbers at equal distances in [0, 1], from the table of all pictures.
  nodes: [/*COLOR_MAP*/],

  parse(hex) { return [1, 3, 5].map((at) => parseInt(hex.slice(at, at + 2), 16) / 255); },

  // Returns the color of a number in [0, 1].
  map(t) {
    const place = Math.min(1, Math.max(0, t)) * (Colors.nodes.length - 1);
    const at = Math.min(Math.floor(place), Colors.nodes.length - 2);
    return Colors.nodes[at].map((x, i) => x + (place - at) * (Colors.nodes[at + 1][i] - x));
  },

  // Returns a color as one word of four bytes, opaque.
  pack(color) {
    const [r, g, b] = color.map((x) => Math.round(255 * x));
    return (r | g << 8 | b << 16 | 255 << 24) >>> 0;
  },

  css(color) { return `rgb(${color.map((x) => Math.round(255 * x)).join(',')})`; },

  // Returns the body of a GLSL function of t in [0, 1] that evaluates the map.
  shader() {
    const last = Colors.nodes.length - 1;
    const nodes = Colors.nodes.map((color) => `vec3(${color.map((x) => x.toFixed(4)).join()})`);
    return `vec3 nodes[${last + 1}] = vec3[](${nodes.join()});
  float place = t * ${last}.0;
  int i = min(int(place), ${last - 1});
  return mix(nodes[i], nodes[i + 1], place - float(i));`;
  },
};

const TRIANGLE_VERTEX = `#version 300 es
layout(location = 0) in vec3 position;
layout(location = 1) in float value;
layout(location = 2) in vec4 front;
layout(location = 3) in vec4 back;
layout(location = 4) in vec4 edge;
uniform mat4 view, projection;
out vec3 q, eye, edges;
out float t;
flat out vec3 front_color, back_color;
void main() {
  q = position;
  eye = (view * vec4(position, 1.0)).xyz;
  edges = edge.xyz;
  t = value;
  front_color = front.rgb;
  back_color = back.rgb;
  gl_Position = projection * vec4(eye, 1.0);
}`;

// The derivatives come before the discard, since they are undefined after it.
const TRIANGLE_FRAGMENT = `#version 300 es
precision highp float;
in vec3 q, eye, edges;
in float t;
flat in vec3 front_color, back_color;
uniform vec4 plane;
uniform bool by_value, lit;
uniform float wire_width, size;
out vec4 result;
vec3 color_map(float t) {
  ${Colors.shader()}
}
void main() {
  vec3 normal = normalize(cross(dFdx(eye) / size, dFdy(eye) / size));
  vec3 width = fwidth(edges);
  if (dot(plane.xyz, q) > plane.w) discard;
  vec3 color = gl_FrontFacing ? front_color : back_color;
  if (by_value) color = color_map(clamp(t, 0.0, 1.0));
  if (lit) {
    float key = max(dot(normal, normalize(vec3(-0.45, 0.65, 0.75))), 0.0);
    float fill = max(dot(normal, normalize(vec3(0.7, -0.2, 0.5))), 0.0);
    // A color map needs weaker shades than labels, so that its colors stay comparable.
    float ambient = by_value ? 0.62 : 0.44;
    color *= ambient + (1.0 - ambient) * key + 0.12 * fill;
  }
  if (wire_width > 0.0) {
    // An undrawn edge has a width of 0, for which the two limits must differ too.
    vec3 far = smoothstep(width * max(wire_width - 0.5, 0.0), width * (wire_width + 0.5) + 1e-6, edges);
    float line = 1.0 - min(far.x, min(far.y, far.z));
    float crowded = smoothstep(0.1, 0.6, max(width.x, max(width.y, width.z)));
    color *= 1.0 - line * mix(0.7, 0.2, crowded);
  }
  result = vec4(min(color, 1.0), 1.0);
}`;

// One instance per segment. A segment is cut off at the near plane before the division by w.
const LINE_VERTEX = `#version 300 es
layout(location = 0) in vec3 start;
layout(location = 1) in vec3 end;
layout(location = 2) in vec4 color;
uniform mat4 view, projection;
uniform vec2 viewport;
uniform float line_width;
uniform vec4 plane;
out vec3 line_color;
out float height;
void main() {
  vec4 a = projection * view * vec4(start, 1.0), b = projection * view * vec4(end, 1.0);
  float da = a.z + a.w, db = b.z + b.w;
  if (da < 0.0 && db > 0.0) a = mix(a, b, da / (da - db));
  if (db < 0.0 && da > 0.0) b = mix(b, a, db / (db - da));
  bool at_end = gl_VertexID >= 2;
  vec2 along = (b.xy / b.w - a.xy / a.w) * viewport;
  along = length(along) > 0.0 ? normalize(along) : vec2(1.0, 0.0);
  vec2 side = vec2(-along.y, along.x) * (gl_VertexID % 2 == 0 ? -1.0 : 1.0);
  vec4 base = at_end ? b : a;
  vec2 shift = (side + (at_end ? along : -along)) * line_width / viewport;
  gl_Position = base + vec4(shift * base.w, 0.0, 0.0);
  line_color = color.rgb;
  height = dot(plane.xyz, at_end ? end : start) - plane.w;
}`;

const LINE_FRAGMENT = `#version 300 es
precision highp float;
in vec3 line_color;
in float height;
out vec4 result;
void main() {
  if (height > 0.0) discard;
  result = vec4(line_color, 1.0);
}`;

// A WebGL 2 renderer of named layers of triangles and line segments.
class Renderer {
  // Throws Error if the canvas has no WebGL 2 context.
  constructor(canvas) {
    this.canvas = canvas;
    this.gl = canvas.getContext('webgl2', { antialias: true, alpha: false });
    if (!this.gl) throw new Error('WebGL 2 is not available');
    this.restore();
  }

  // Creates all objects of the context; needed again after a lost context.
  restore() {
    this.triangles = this.program(TRIANGLE_VERTEX, TRIANGLE_FRAGMENT,
      ['view', 'projection', 'plane', 'by_value', 'lit', 'wire_width', 'size']);
    this.lines = this.program(LINE_VERTEX, LINE_FRAGMENT, ['view', 'projection', 'viewport', 'line_width', 'plane']);
    this.layers = {
      surface: this.triangleLayer(), section: this.triangleLayer(), edges: this.lineLayer(), box: this.lineLayer(),
    };
    this.uploads = 0;
  }

  program(vertex, fragment, uniforms) {
    const { gl } = this;
    const id = gl.createProgram();
    for (const [type, source] of [[gl.VERTEX_SHADER, vertex], [gl.FRAGMENT_SHADER, fragment]]) {
      const shader = gl.createShader(type);
      gl.shaderSource(shader, source);
      gl.compileShader(shader);
      gl.attachShader(id, shader);
      if (!gl.getShaderParameter(shader, gl.COMPILE_STATUS) && !gl.isContextLost()) {
        throw new Error(gl.getShaderInfoLog(shader));
      }
    }
    gl.linkProgram(id);
    if (!gl.getProgramParameter(id, gl.LINK_STATUS) && !gl.isContextLost()) throw new Error(gl.getProgramInfoLog(id));
    const result = { id };
    for (const name of uniforms) result[name] = gl.getUniformLocation(id, name);
    return result;
  }

  triangleLayer() {
    const { gl } = this;
    return this.layer([[3, gl.FLOAT, 0], [1, gl.FLOAT, 12], [4, gl.UNSIGNED_BYTE, 16], [4, gl.UNSIGNED_BYTE, 20],
      [4, gl.UNSIGNED_BYTE, 24]], 0);
  }

  lineLayer() {
    const { gl } = this;
    return this.layer([[3, gl.FLOAT, 0], [3, gl.FLOAT, 12], [4, gl.UNSIGNED_BYTE, 24]], 1);
  }

  // Returns a layer whose records of 28 bytes have the attributes (components, type, offset).
  layer(attributes, divisor) {
    const { gl } = this;
    const layer = { array: gl.createVertexArray(), buffer: gl.createBuffer(), count: 0 };
    gl.bindVertexArray(layer.array);
    gl.bindBuffer(gl.ARRAY_BUFFER, layer.buffer);
    attributes.forEach(([components, type, offset], location) => {
      gl.enableVertexAttribArray(location);
      gl.vertexAttribPointer(location, components, type, type !== gl.FLOAT, 28, offset);
      gl.vertexAttribDivisor(location, divisor);
    });
    gl.bindVertexArray(null);
    return layer;
  }

  // Replaces the content of a layer by a WordBuffer; null empties it.
  upload(name, content) {
    const { gl } = this;
    const layer = this.layers[name];
    layer.count = content ? content.count : 0;
    if (layer.count === 0) return;
    gl.bindBuffer(gl.ARRAY_BUFFER, layer.buffer);
    gl.bufferData(gl.ARRAY_BUFFER, content.words.subarray(0, 7 * content.count), gl.DYNAMIC_DRAW);
    this.uploads++;
  }

  // Fits the number of pixels to the size of the canvas on the page. Returns width / height.
  resize() {
    const ratio = Math.min(window.devicePixelRatio || 1, 2);
    const width = Math.max(1, Math.round(this.canvas.clientWidth * ratio));
    const height = Math.max(1, Math.round(this.canvas.clientHeight * ratio));
    if (this.canvas.width !== width || this.canvas.height !== height) {
      this.canvas.width = width;
      this.canvas.height = height;
    }
    this.ratio = ratio;
    return width / height;
  }

  // Draws all layers. The options are background, view, projection, plane (null without a flat cut),
  // byValue, lit, wire and size (a length that scales derivatives).
  draw(options) {
    const { gl } = this;
    gl.viewport(0, 0, this.canvas.width, this.canvas.height);
    gl.clearColor(...options.background, 1);
    gl.clear(gl.COLOR_BUFFER_BIT | gl.DEPTH_BUFFER_BIT);
    gl.enable(gl.DEPTH_TEST);
    gl.depthFunc(gl.LEQUAL);
    this.drawTriangles(options);
    this.drawLines(options);
    gl.bindVertexArray(null);
  }

  drawTriangles(options) {
    const { gl, triangles, layers } = this;
    gl.useProgram(triangles.id);
    gl.uniformMatrix4fv(triangles.view, false, options.view);
    gl.uniformMatrix4fv(triangles.projection, false, options.projection);
    gl.uniform1i(triangles.by_value, options.byValue ? 1 : 0);
    gl.uniform1f(triangles.wire_width, options.wire ? 0.45 * this.ratio : 0);
    gl.uniform1f(triangles.size, options.size);
    for (const [layer, plane, lit] of [[layers.surface, options.plane, options.lit], [layers.section, null, false]]) {
      if (layer.count === 0) continue;
      gl.uniform4fv(triangles.plane, plane || [0, 0, 0, 1]);
      gl.uniform1i(triangles.lit, lit ? 1 : 0);
      gl.bindVertexArray(layer.array);
      gl.drawArrays(gl.TRIANGLES, 0, layer.count);
    }
  }

  drawLines(options) {
    const { gl, lines, layers } = this;
    gl.useProgram(lines.id);
    gl.uniformMatrix4fv(lines.view, false, options.view);
    gl.uniformMatrix4fv(lines.projection, false, options.projection);
    gl.uniform2f(lines.viewport, this.canvas.width, this.canvas.height);
    for (const [layer, width] of [[layers.edges, 2.4], [layers.box, 1.2]]) {
      if (layer.count === 0) continue;
      gl.uniform4fv(lines.plane, layer === layers.edges && options.plane ? options.plane : [0, 0, 0, 1]);
      gl.uniform1f(lines.line_width, width * this.ratio);
      gl.bindVertexArray(layer.array);
      gl.drawArraysInstanced(gl.TRIANGLE_STRIP, 0, 4, layer.count);
    }
  }

  // Returns the drawn pixels, four bytes each, from the bottom row. Call it in the task that has drawn them.
  pixels() {
    const { gl } = this;
    const width = gl.drawingBufferWidth, height = gl.drawingBufferHeight;
    const data = new Uint8Array(4 * width * height);
    gl.readPixels(0, 0, width, height, gl.RGBA, gl.UNSIGNED_BYTE, data);
    return { width, height, data };
  }
}
