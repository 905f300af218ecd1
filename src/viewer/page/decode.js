'use strict';

// Decodes blobs: base64, raw deflate, varint bytes in groups of 7 bits, zigzag signed integers.
const Blobs = {
  // Returns the bytes of a base64 text that holds a raw deflate stream.
  async inflate(text) {
    const packed = Uint8Array.from(atob(text), (character) => character.charCodeAt(0));
    const stream = new Blob([packed]).stream().pipeThrough(new DecompressionStream('deflate-raw'));
    return new Uint8Array(await new Response(stream).arrayBuffer());
  },

  // Returns the signed integers of varint bytes as numbers. Throws Error if the last one is cut off.
  integers(bytes) {
    let count = 0;
    for (let i = 0; i < bytes.length; i++) count += bytes[i] < 128 ? 1 : 0;
    if (bytes.length > 0 && bytes[bytes.length - 1] >= 128) throw new Error('a blob ends within a number');
    const values = new Float64Array(count);
    for (let i = 0, at = 0; i < count; i++) {
      let byte = bytes[at++];
      let value = byte & 127;
      // Multiplication instead of a shift: zigzag numbers exceed 31 bits.
      for (let scale = 128; byte >= 128; scale *= 128) {
        byte = bytes[at++];
        value += (byte & 127) * scale;
      }
      values[i] = value % 2 === 0 ? value / 2 : -(value + 1) / 2;
    }
    return values;
  },
};

// A film: a sequence of frames that share labels, fields and one grid of integer positions.
class Film {
  // Throws Error if the version is unknown or a required entry is missing.
  constructor(json) {
    if (json.version !== 1) throw new Error(`film version ${json.version} is unknown; this page reads version 1`);
    if (!Array.isArray(json.frames) || json.frames.length === 0) throw new Error('the film has no frames');
    this.title = json.title || 'Deformable simplicial complex';
    this.dimension = json.dimension;
    this.origin = json.origin;
    this.unit = json.unit;
    this.labels = json.labels;
    this.colors = json.colors;
    this.hidden = json.hidden || [];
    this.cells = json.cells;
    this.fields = json.fields || [];
    this.names = new Map(json.names || []);
    this.series = (json.series || []).map((series) => ({ ...series, name: this.withNames(series.name) }));
    this.events = (json.events || []).map((event) => ({ ...event, text: this.withNames(event.text) }));
    this.entries = json.frames;
    this.blobs = json.blobs;
    this.corners = this.dimension + (this.cells ? 1 : 0);
    this.frames = new Array(json.frames.length).fill(null);
    this.pending = [];
  }

  get count() { return this.entries.length; }

  // Returns a text with the names of the labels in it, such as "label 2 shell" for "label 2".
  withNames(text) {
    return text.replace(/label (-?\d+)/gi, (part, label) => {
      const name = this.names.get(Number(label));
      return name ? `${part} ${name}` : part;
    });
  }

  // Returns the integers of a blob. Throws Error if their number differs from the expected one.
  async read(index, expected, name) {
    const values = Blobs.integers(await Blobs.inflate(this.blobs[index]));
    if (expected !== null && values.length !== expected) {
      throw new Error(`${name}: ${values.length} numbers instead of ${expected}`);
    }
    return values;
  }

  // Returns the promise of a frame; decodes all frames before it that it depends on, each of them once.
  decode(index) {
    if (!this.pending[index]) this.pending[index] = this.decodeNow(index);
    return this.pending[index];
  }

  async decodeNow(index) {
    const entry = this.entries[index];
    const previous = entry.kept_vertices === undefined ? null : await this.decode(index - 1);
    const frame = {
      index, step: entry.step, time: entry.time,
      vertexCount: entry.vertices, simplexCount: entry.simplices,
      positions: null, simplices: null, labels: null, backs: null, fields: {},
    };
    const translation = await this.decodeVertices(frame, entry, previous);
    await this.decodeSimplices(frame, entry, previous, translation);
    for (const field of this.fields) {
      const blob = (entry.fields || {})[field.name];
      if (blob !== undefined && blob !== null) frame.fields[field.name] = await this.decodeField(frame, field, blob);
    }
    this.frames[index] = frame;
    return frame;
  }

  // Returns the increasing indices that a blob of gaps describes. Throws Error if one is not below the limit.
  async decodeKept(blob, limit, name) {
    const gaps = await this.read(blob, null, name);
    const kept = new Uint32Array(gaps.length);
    let last = -1;
    for (let i = 0; i < gaps.length; i++) {
      last += gaps[i] + 1;
      if (!(gaps[i] >= 0 && last < limit)) throw new Error(`${name}: index ${last} is out of range`);
      kept[i] = last;
    }
    return kept;
  }

  // Sets the positions, in units of the grid. Returns the new index of each vertex of the previous frame, -1 for
  // removed vertices; null if the frame is independent.
  async decodeVertices(frame, entry, previous) {
    const n = frame.vertexCount;
    const kept = previous ? await this.decodeKept(entry.kept_vertices, previous.vertexCount, 'kept vertices') : [];
    const stored = await this.read(entry.positions, n * this.dimension, 'positions');
    frame.positions = new Float32Array(3 * n);
    for (let axis = 0; axis < this.dimension; axis++) {
      let last = 0;
      for (let i = 0; i < n; i++) {
        last = stored[axis * n + i] + (i < kept.length ? previous.positions[3 * kept[i] + axis] : last);
        frame.positions[3 * i + axis] = last;
      }
    }
    if (!previous) return null;
    const translation = new Int32Array(previous.vertexCount).fill(-1);
    for (let i = 0; i < kept.length; i++) translation[kept[i]] = i;
    return translation;
  }

  // Sets the simplices and their labels (as indices into the film's labels).
  async decodeSimplices(frame, entry, previous, translation) {
    const corners = this.corners, m = frame.simplexCount;
    const hasKept = previous && entry.kept_simplices !== undefined;
    const kept = hasKept ? await this.decodeKept(entry.kept_simplices, previous.simplexCount, 'kept simplices') : [];
    const added = m - kept.length;
    const stored = await this.read(entry.new_simplices, added * corners, 'new simplices');
    const simplices = new Uint32Array(corners * m);
    for (let i = 0; i < kept.length; i++) {
      for (let k = 0; k < corners; k++) {
        const vertex = translation[previous.simplices[corners * kept[i] + k]];
        if (vertex < 0) throw new Error(`kept simplex ${kept[i]} has a removed vertex`);
        simplices[corners * i + k] = vertex;
      }
    }
    for (let k = 0; k < corners; k++) {
      let last = 0;
      for (let i = 0; i < added; i++) {
        last += stored[k * added + i];
        if (!(last >= 0 && last < frame.vertexCount)) throw new Error(`simplex with vertex ${last}: out of range`);
        simplices[corners * (kept.length + i) + k] = last;
      }
    }
    frame.simplices = simplices;
    const sides = this.cells ? 1 : 2;
    const labels = await this.read(entry.labels, added * sides, 'labels');
    frame.labels = this.decodeLabels(labels, 0, previous && previous.labels, kept, m);
    if (!this.cells) frame.backs = this.decodeLabels(labels, added, previous && previous.backs, kept, m);
  }

  // Returns the label indices of all simplices: kept ones from the previous frame, then those stored from an offset.
  decodeLabels(stored, offset, previous, kept, count) {
    const labels = new Uint16Array(count);
    for (let i = 0; i < kept.length; i++) labels[i] = previous[kept[i]];
    let last = 0;
    for (let i = kept.length; i < count; i++) {
      last += stored[offset + i - kept.length];
      if (!(last >= 0 && last < this.labels.length)) throw new Error(`label index ${last} is out of range`);
      labels[i] = last;
    }
    return labels;
  }

  // Returns one number per vertex or simplex: the value, or the length of the vector, mapped to [0, 1]
  // between the field's minimum and maximum.
  async decodeField(frame, field, blob) {
    const count = field.of === 'vertices' ? frame.vertexCount : frame.simplexCount;
    const stored = await this.read(blob, count * field.components, `field ${field.name}`);
    const range = field.maximum - field.minimum;
    const result = new Float32Array(count);
    for (let component = 0; component < field.components; component++) {
      let last = 0;
      for (let i = 0; i < count; i++) {
        last += stored[component * count + i];
        const share = last / field.steps;
        result[i] += field.components === 1 ? share : ((2 * share - 1) * field.maximum) ** 2;
      }
    }
    if (field.components === 1) return result;
    for (let i = 0; i < count; i++) {
      const share = range > 0 ? (Math.sqrt(result[i]) - field.minimum) / range : 0;
      result[i] = Math.min(1, Math.max(0, share));
    }
    return result;
  }
}
