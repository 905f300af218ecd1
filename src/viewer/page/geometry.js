// A growing buffer of vertices or line segments, each of seven 32-bit words, in the layout of the shaders.
class WordBuffer {
  constructor(records) {
    this.reserve(Math.max(records, 64));
    this.count = 0;
  }

  reserve(records) {
    const old = this.words;
    this.words = new Uint32Array(7 * records);
    this.floats = new Float32Array(this.words.buffer);
    if (old) this.words.set(old);
  }

  // Adds a vertex of a triangle. The edge word has byte k set if the vertex is far from edge k.
  corner(x, y, z, value, front, back, edge) {
    if (7 * (this.count + 1) > this.words.length) this.reserve(2 * this.count);
    const at = 7 * this.count++;
    this.floats[at] = x; this.floats[at + 1] = y; this.floats[at + 2] = z; this.floats[at + 3] = value;
    this.words[at + 4] = front; this.words[at + 5] = back; this.words[at + 6] = edge;
  }

  // Adds a line segment between two points given by offsets into an array of coordinates.
  segment(points, p, q, color) {
    if (7 * (this.count + 1) > this.words.length) this.reserve(2 * this.count);
    const at = 7 * this.count++;
    for (let axis = 0; axis < 3; axis++) {
      this.floats[at + axis] = points[p + axis];
      this.floats[at + 3 + axis] = points[q + axis];
    }
    this.words[at + 6] = color;
  }
}

// The edge words of the three vertices of a triangle whose edges are all drawn.
const EDGE_WORDS = [0x0000ff, 0x00ff00, 0xff0000];

// Facets, interfaces and cuts of one frame. Positions are in units of the film's grid.
const Geometry = {
  // Returns the neighbor of each cell across the facet opposite to each of its corners, -1 at the domain's boundary.
  neighbors(simplices, corners) {
    const total = simplices.length;
    const keys = Geometry.facetKeys(simplices, corners);
    let size = 64;
    while (size < 1.5 * total) size *= 2;
    const table = new Int32Array(size);
    const result = new Int32Array(total).fill(-1);
    for (let facet = 0; facet < total; facet++) {
      const a = keys[3 * facet], b = keys[3 * facet + 1], c = keys[3 * facet + 2];
      let slot = Math.imul(a, 0x9e3779b1) ^ Math.imul(b, 0x85ebca77) ^ Math.imul(c, 0xc2b2ae3d);
      slot = (slot ^ (slot >>> 15)) & (size - 1);
      for (;;) {
        const other = table[slot] - 1;
        if (other < 0) {
          table[slot] = facet + 1;
          break;
        }
        if (keys[3 * other] === a && keys[3 * other + 1] === b && keys[3 * other + 2] === c) {
          result[facet] = other / corners | 0;
          result[other] = facet / corners | 0;
          break;
        }
        slot = (slot + 1) & (size - 1);
      }
    }
    return result;
  },

  // Returns the sorted vertices of the facet opposite to each corner, three numbers each; the last one is 0 in 2D.
  facetKeys(simplices, corners) {
    const keys = new Uint32Array(3 * simplices.length);
    for (let facet = 0; facet < simplices.length; facet++) {
      const opposite = facet % corners, first = facet - opposite;
      let a = simplices[first + (opposite + 1) % corners];
      let b = simplices[first + (opposite + 2) % corners];
      let c = corners === 4 ? simplices[first + (opposite + 3) % corners] : 0;
      let swap;
      if (a > b) { swap = a; a = b; b = swap; }
      if (corners === 4) {
        if (b > c) { swap = b; b = c; c = swap; }
        if (a > b) { swap = a; a = b; b = swap; }
      }
      keys[3 * facet] = a; keys[3 * facet + 1] = b; keys[3 * facet + 2] = c;
    }
    return keys;
  },

  // Returns the number of facets between cells of different labels.
  interfaceFacets(frame, corners) {
    let count = 0;
    for (let facet = 0; facet < frame.neighbors.length; facet++) {
      const cell = facet / corners | 0, other = frame.neighbors[facet];
      if (other > cell && frame.labels[other] !== frame.labels[cell]) count++;
    }
    return count;
  },

  // Returns 1 for each cell that is drawn: its label is shown, and its center is on the side that the cut keeps.
  visibleCells(frame, corners, shown, cut) {
    const visible = new Uint8Array(frame.simplexCount);
    const { simplices, positions } = frame;
    for (let cell = 0; cell < visible.length; cell++) {
      if (!shown[frame.labels[cell]]) continue;
      let sum = 0;
      if (cut) {
        for (let k = 0; k < corners; k++) sum += positions[3 * simplices[corners * cell + k] + cut.axis];
        if (cut.sign * (sum / corners - cut.position) > 0) continue;
      }
      visible[cell] = 1;
    }
    return visible;
  },

  // Returns the triangles between visible cells and their other neighbors. They are colored by the visible cell.
  // A facet between two visible cells is never seen, since both cells are drawn as solid.
  cellSurface(frame, visible, paint) {
    const buffer = new WordBuffer(16384);
    const { simplices, neighbors } = frame;
    for (let cell = 0; cell < visible.length; cell++) {
      if (!visible[cell]) continue;
      for (let opposite = 0; opposite < 4; opposite++) {
        const other = neighbors[4 * cell + opposite];
        if (other >= 0 && visible[other]) continue;
        const color = paint.colors[frame.labels[cell]];
        for (let k = 0; k < 3; k++) {
          const vertex = simplices[4 * cell + (opposite + 1 + k) % 4];
          Geometry.addCorner(buffer, frame, cell, vertex, color, color, EDGE_WORDS[k], paint);
        }
      }
    }
    return buffer;
  },

  // Returns the triangles of the visible cells of the plane.
  planeCells(frame, visible, paint) {
    const buffer = new WordBuffer(3 * frame.simplexCount);
    for (let cell = 0; cell < visible.length; cell++) {
      if (!visible[cell]) continue;
      const color = paint.colors[frame.labels[cell]];
      for (let k = 0; k < 3; k++) {
        Geometry.addCorner(buffer, frame, cell, frame.simplices[3 * cell + k], color, color, EDGE_WORDS[k], paint);
      }
    }
    return buffer;
  },

  // Returns the edges of visible cells of the plane at another label or at the domain's boundary.
  planeInterface(frame, visible, color) {
    const buffer = new WordBuffer(4096);
    const { simplices, neighbors } = frame;
    for (let cell = 0; cell < visible.length; cell++) {
      if (!visible[cell]) continue;
      for (let opposite = 0; opposite < 3; opposite++) {
        const other = neighbors[3 * cell + opposite];
        if (other >= 0 && (frame.labels[other] === frame.labels[cell] || (visible[other] && other < cell))) continue;
        const p = simplices[3 * cell + (opposite + 1) % 3], q = simplices[3 * cell + (opposite + 2) % 3];
        buffer.segment(frame.positions, 3 * p, 3 * q, color);
      }
    }
    return buffer;
  },

  // Returns the stored facets that bound a shown label. Each side has the color of the label behind it, so that a
  // region looks solid from outside; a hidden label behind a side leaves it the color of the label in front.
  storedSurface(frame, shown, paint) {
    const buffer = new WordBuffer(3 * frame.simplexCount);
    for (let facet = 0; facet < frame.simplexCount; facet++) {
      const front = frame.labels[facet], back = frame.backs[facet];
      if (!shown[front] && !shown[back]) continue;
      const seenFromFront = paint.colors[shown[back] ? back : front];
      const seenFromBack = paint.colors[shown[front] ? front : back];
      for (let k = 0; k < 3; k++) {
        const vertex = frame.simplices[3 * facet + k];
        Geometry.addCorner(buffer, frame, facet, vertex, seenFromFront, seenFromBack, EDGE_WORDS[k], paint);
      }
    }
    return buffer;
  },

  // Returns the stored edges of the plane that bound a shown label.
  storedEdges(frame, shown, paint) {
    const buffer = new WordBuffer(frame.simplexCount);
    for (let edge = 0; edge < frame.simplexCount; edge++) {
      const front = frame.labels[edge], back = frame.backs[edge];
      if (!shown[front] && !shown[back]) continue;
      const p = frame.simplices[2 * edge], q = frame.simplices[2 * edge + 1];
      let color = paint.colors[shown[back] ? back : front];
      if (paint.values) {
        const { values } = paint;
        color = Colors.pack(Colors.map(paint.ofVertices ? (values[p] + values[q]) / 2 : values[edge]));
      }
      buffer.segment(frame.positions, 3 * p, 3 * q, color);
    }
    return buffer;
  },

  addCorner(buffer, frame, simplex, vertex, front, back, edge, paint) {
    const { positions } = frame;
    const value = paint.values ? paint.values[paint.ofVertices ? vertex : simplex] : 0;
    buffer.corner(positions[3 * vertex], positions[3 * vertex + 1], positions[3 * vertex + 2], value, front, back, edge);
  },

  // Returns the polygons in which the plane of a cut meets the cells of shown labels.
  section(frame, shown, cut, paint) {
    const buffer = new WordBuffer(8192);
    const { simplices, positions } = frame;
    const above = [0, 0, 0, 0], below = [0, 0, 0, 0];
    for (let cell = 0; cell < frame.simplexCount; cell++) {
      if (!shown[frame.labels[cell]]) continue;
      let a = 0, b = 0;
      for (let k = 0; k < 4; k++) {
        const vertex = simplices[4 * cell + k];
        if (positions[3 * vertex + cut.axis] >= cut.position) above[a++] = vertex;
        else below[b++] = vertex;
      }
      if (a > 0 && b > 0) Geometry.addSection(buffer, frame, cell, cut, paint, above, a, below, b);
    }
    return buffer;
  },

  // Adds the section of one cell: a triangle, or a quadrangle as two triangles without their common edge.
  addSection(buffer, frame, cell, cut, paint, above, a, below, b) {
    const point = (p, q, edge) => Geometry.addCrossing(buffer, frame, cell, cut, paint, p, q, edge);
    if (a === 2) {
      const hidden = 0x00ff00, last = 0xff0000;
      point(above[0], below[0], EDGE_WORDS[0] | hidden);
      point(above[0], below[1], hidden);
      point(above[1], below[1], EDGE_WORDS[2] | hidden);
      point(above[0], below[0], EDGE_WORDS[0] | last);
      point(above[1], below[1], EDGE_WORDS[1] | last);
      point(above[1], below[0], last);
      return;
    }
    for (let k = 0; k < 3; k++) {
      if (a === 1) point(above[0], below[k], EDGE_WORDS[k]);
      else point(above[k], below[0], EDGE_WORDS[k]);
    }
  },

  // Adds the point where the plane of a cut crosses an edge.
  addCrossing(buffer, frame, cell, cut, paint, p, q, edge) {
    const { positions } = frame;
    const start = positions[3 * p + cut.axis];
    const share = (cut.position - start) / (positions[3 * q + cut.axis] - start);
    const blend = (from, to) => from + share * (to - from);
    let value = 0;
    if (paint.values) value = paint.ofVertices ? blend(paint.values[p], paint.values[q]) : paint.values[cell];
    const color = paint.colors[frame.labels[cell]];
    buffer.corner(blend(positions[3 * p], positions[3 * q]), blend(positions[3 * p + 1], positions[3 * q + 1]),
      blend(positions[3 * p + 2], positions[3 * q + 2]), value, color, color, edge);
  },

  // Enlarges a box (minimum of each axis, then maximum) to the vertices of the simplices with a shown label, or to all
  // vertices if shown is null.
  enlargeBox(box, frame, corners, shown) {
    const { simplices, positions } = frame;
    for (let i = 0; i < simplices.length; i++) {
      const simplex = i / corners | 0;
      if (shown && !shown[frame.labels[simplex]] && !(frame.backs && shown[frame.backs[simplex]])) continue;
      for (let axis = 0; axis < 3; axis++) {
        const x = positions[3 * simplices[i] + axis];
        if (x < box[axis]) box[axis] = x;
        if (x > box[3 + axis]) box[3 + axis] = x;
      }
    }
    return box;
  },

  emptyBox() { return [Infinity, Infinity, Infinity, -Infinity, -Infinity, -Infinity]; },

  // Returns the twelve edges of a box.
  boxEdges(box, color) {
    const buffer = new WordBuffer(12);
    const corners = [];
    for (let i = 0; i < 8; i++) corners.push(box[i & 1 ? 3 : 0], box[i & 2 ? 4 : 1], box[i & 4 ? 5 : 2]);
    for (let i = 0; i < 8; i++) {
      for (let bit = 1; bit < 8; bit *= 2) {
        if (!(i & bit)) buffer.segment(corners, 3 * i, 3 * (i | bit), color);
      }
    }
    return buffer;
  },
};

// Shape measures of cells.
const Measures = {
  // Returns the quality of each cell in [0, 1]: the volume-length ratio in 3D, the area-length ratio in 2D.
  qualities(frame, corners) {
    const result = new Float32Array(frame.simplexCount);
    for (let cell = 0; cell < result.length; cell++) {
      const edges = Measures.edges(frame, corners, cell);
      result[cell] = corners === 4 ? Measures.tetrahedronQuality(edges) : Measures.triangleQuality(edges);
    }
    return result;
  },

  // Returns the vectors from the first corner of a cell to its other corners, in an array that each call reuses.
  edges(frame, corners, cell) {
    const e = Measures.scratch, { simplices, positions } = frame;
    const a = 3 * simplices[corners * cell];
    for (let k = 1; k < corners; k++) {
      const b = 3 * simplices[corners * cell + k];
      for (let axis = 0; axis < 3; axis++) e[3 * k - 3 + axis] = positions[b + axis] - positions[a + axis];
    }
    return e;
  },
  scratch: new Float64Array(9),
  normals: new Float64Array(12),

  tetrahedronQuality(e) {
    const volume = Math.abs(e[0] * (e[4] * e[8] - e[5] * e[7]) + e[1] * (e[5] * e[6] - e[3] * e[8])
      + e[2] * (e[3] * e[7] - e[4] * e[6])) / 6;
    let sum = 0;
    for (let axis = 0; axis < 3; axis++) {
      const u = e[axis], v = e[3 + axis], w = e[6 + axis];
      sum += u * u + v * v + w * w + (u - v) * (u - v) + (v - w) * (v - w) + (w - u) * (w - u);
    }
    return sum > 0 ? 6 * Math.SQRT2 * volume / Math.pow(sum / 6, 1.5) : 0;
  },

  triangleQuality(e) {
    const area = Math.abs(e[0] * e[4] - e[1] * e[3]) / 2;
    const sum = e[0] ** 2 + e[1] ** 2 + e[3] ** 2 + e[4] ** 2 + (e[0] - e[3]) ** 2 + (e[1] - e[4]) ** 2;
    return sum > 0 ? 4 * Math.sqrt(3) * area / sum : 0;
  },

  // Returns the histogram of dihedral angles (3D) or angles (2D) in 36 bins of 5 degrees, and the extreme angles.
  angles(frame, corners) {
    const result = { bins: new Uint32Array(36), smallest: 180, largest: 0 };
    const n = Measures.normals;
    const dimension = corners - 1;
    for (let cell = 0; cell < frame.simplexCount; cell++) {
      Measures.facetNormals(Measures.edges(frame, corners, cell), dimension);
      for (let i = 0; i < corners; i++) {
        for (let j = 0; j < i; j++) {
          const cosine = -(n[3 * i] * n[3 * j] + n[3 * i + 1] * n[3 * j + 1] + n[3 * i + 2] * n[3 * j + 2]);
          const angle = Math.acos(Math.min(1, Math.max(-1, cosine))) * 180 / Math.PI;
          if (angle < result.smallest) result.smallest = angle;
          if (angle > result.largest) result.largest = angle;
          result.bins[Math.min(35, angle / 5 | 0)]++;
        }
      }
    }
    return result;
  },

  // Sets the unit normals of the facets opposite to the corners, all inward or all outward.
  facetNormals(e, dimension) {
    const n = Measures.normals;
    n[0] = n[1] = n[2] = 0;
    for (let k = 1; k <= dimension; k++) {
      const v = 3 * (k % dimension), w = 3 * ((k + 1) % dimension);
      if (dimension === 3) {
        n[3 * k] = e[v + 1] * e[w + 2] - e[v + 2] * e[w + 1];
        n[3 * k + 1] = e[v + 2] * e[w] - e[v] * e[w + 2];
        n[3 * k + 2] = e[v] * e[w + 1] - e[v + 1] * e[w];
      } else {
        const sign = k === 1 ? 1 : -1;
        n[3 * k] = sign * e[v + 1];
        n[3 * k + 1] = -sign * e[v];
        n[3 * k + 2] = 0;
      }
      for (let axis = 0; axis < 3; axis++) n[axis] -= n[3 * k + axis];
    }
    for (let k = 0; k <= dimension; k++) {
      const length = Math.hypot(n[3 * k], n[3 * k + 1], n[3 * k + 2]) || 1;
      for (let axis = 0; axis < 3; axis++) n[3 * k + axis] /= length;
    }
  },
};
