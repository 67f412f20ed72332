import { shortText } from '@farol/editing';
import { SRGBColorSpace, Color } from 'three';
import { counted } from '../../base/counted';
import type { Steps } from '../../base/steps';
import { cutPolygon } from './cutPolygon';
import { LineReader } from './LineReader';
import { floatList, integerList, type NumberList } from './NumberList';

/** Consecutive corners with the same group and material. */
export interface ObjRun {
  /** Name of the group, or of the object where the group has none. */
  readonly name: string;
  /** Key of object and group, since two objects may have groups of one name. */
  readonly key: string;
  /** Name of the material; null before the first `usemtl`. */
  readonly material: string | null;
  /** Index of the first corner; `to` is one past the last. */
  readonly from: number;
  to: number;
}

/** Content of an OBJ file, its polygons cut into triangles. */
export interface ObjFile {
  /** x, y and z of each vertex. */
  readonly positions: Float32Array;
  /** Linear red, green and blue of each vertex; null when the file has none. */
  readonly colours: Float32Array | null;
  /** u and v, from the bottom up, of each pair of texture coordinates. */
  readonly uvs: Float32Array;
  /** x, y and z of each normal, not scaled to a length of 1. */
  readonly normals: Float32Array;
  /** Indices (from 0) of vertex, texture coordinates and normal of each corner; −1 for none. */
  readonly corners: Int32Array;
  readonly runs: readonly ObjRun[];
  /** MTL files, one for each `mtllib` line. */
  readonly materialFiles: readonly string[];
  /** Number of ignored lines, points, curves and surfaces. */
  readonly leftOut: number;
  /** Number of concave faces with too many corners, cut as if convex. */
  readonly coarse: number;
}

/** Lines that are read before the generator yields: about a millisecond of work. */
const STEP = 4096;

/** Greatest number of corners of a concave face cut by ear clipping, which takes quadratic time. */
const MOST_CORNERS = 4096;

const triangle = [0, 1, 2];
/** The two triangles of a quad, as indices of its corners. */
const halves = [0, 1, 2, 0, 2, 3];
const otherHalves = [1, 2, 3, 1, 3, 0];

/** Keywords of elements that are ignored. */
const notDrawn = new Set(['l', 'p', 'curv', 'curv2', 'surf']);

/**
 * Reads the text of an OBJ file: vertices with or without colours, faces of three or more corners with indices from the
 * start or, negative, from the end, groups, objects and materials. Vertices may follow the faces that use them. Unknown
 * keywords are ignored.
 * @throws Error of one sentence that names the line and what to do
 * @see Wavefront, Advanced Visualizer, Appendix B1: Object Files
 */
export function* parseObj(bytes: Uint8Array): Steps<ObjFile> {
  const parser = new ObjParser(bytes);
  while (parser.readLines(STEP)) yield;
  return parser.finish();
}

class ObjParser {
  private readonly reader: LineReader;
  private readonly positions = floatList();
  private readonly colours = floatList();
  private readonly uvs = floatList();
  private readonly normals = floatList();
  private readonly corners = integerList();
  private readonly runs: ObjRun[] = [];
  private readonly materialFiles: string[] = [];
  private leftOut = 0;
  private coarse = 0;
  private group = '';
  private material: string | null = null;
  /** Interned names of groups, objects and materials, so that equal names compare by identity. */
  private readonly names = new Map<string, string>();
  private readonly numbers = new Map<string, number>();
  private object = '';
  /** Key of the current object and group. */
  private key = '0 0';
  /** Work since the generator last yielded, in lines; cutting a polygon counts as several lines. */
  private work = 0;
  private hasColours = false;
  /** Highest vertex index referred to, and its line. */
  private highest = -1;
  private highestLine = 0;
  private readonly face: number[] = [];
  private readonly points: number[] = [];
  private readonly colour = new Color();

  constructor(bytes: Uint8Array) {
    this.reader = new LineReader(bytes);
  }

  /** @returns whether lines are left */
  readLines(count: number): boolean {
    const { reader } = this;
    for (this.work = 0; this.work < count && !reader.isAtEnd; this.work++) {
      this.readLine();
      reader.nextLine();
    }
    return !reader.isAtEnd;
  }

  finish(): ObjFile {
    const { positions, uvs, normals, corners, runs, materialFiles, leftOut, coarse } = this;
    const vertices = positions.length / 3;
    if (vertices === 0) {
      throw new Error('it has no vertices: it is empty, or not an OBJ file. Export it again.');
    }
    if (this.highest >= vertices) {
      throw new Error(
        `line ${this.highestLine}: a face names vertex ${this.highest + 1}, and the file has ${counted(vertices)}: export it again.`,
      );
    }
    if (runs.length === 0) throw new Error('it has no faces: export it again, with faces.');
    dropMissing(corners, 1, uvs.length / 2);
    dropMissing(corners, 2, normals.length / 3);
    return {
      positions: positions.values,
      colours: this.hasColours ? this.colours.values : null,
      uvs: uvs.values,
      normals: normals.values,
      corners: corners.values,
      runs,
      materialFiles,
      leftOut,
      coarse,
    };
  }

  private fail(problem: string): never {
    throw new Error(`line ${this.reader.line}: ${problem}: export it again.`);
  }

  private readLine(): void {
    const { reader } = this;
    const word = reader.word();
    switch (word) {
      case 'v':
        return this.readVertex();
      case 'vt': {
        const u = reader.number();
        const v = reader.isLineOver ? 0 : reader.number();
        return this.uvs.push2(Number.isFinite(u) ? u : 0, Number.isFinite(v) ? v : 0);
      }
      case 'vn':
        return this.normals.push3(reader.number(), reader.number(), reader.number());
      case 'f':
      case 'fo':
        return this.readFace();
      case 'o':
        this.object = this.once(reader.rest());
        this.group = '';
        return this.groupChanged();
      case 'g':
        this.group = this.once(reader.rest());
        return this.groupChanged();
      case 'usemtl':
        this.material = this.once(reader.rest());
        return;
      case 'mtllib':
        this.materialFiles.push(reader.rest());
        return;
      default:
        if (notDrawn.has(word)) this.leftOut++;
    }
  }

  private readVertex(): void {
    const { reader } = this;
    const [x, y, z] = [reader.number(), reader.number(), reader.number()];
    if (!Number.isFinite(x) || !Number.isFinite(y) || !Number.isFinite(z)) {
      this.fail('the vertex does not have three numbers');
    }
    this.positions.push3(x, y, z);
    // one further number is a weight; three further numbers are a colour
    const rest: number[] = [];
    while (!reader.isLineOver && rest.length < 4) rest.push(reader.number());
    if (rest.length >= 3 && rest.every(Number.isFinite)) {
      this.hasColours = true;
      const [r, g, b] = rest.length > 3 ? rest.slice(1) : rest;
      this.colour.setRGB(r, g, b, SRGBColorSpace);
      this.colours.push3(this.colour.r, this.colour.g, this.colour.b);
    } else this.colours.push3(1, 1, 1);
  }

  private readFace(): void {
    const { reader, face } = this;
    face.length = 0;
    while (!reader.isLineOver) {
      const vertex = this.index(reader.integer(), this.positions.length / 3);
      let uv = -1;
      let normal = -1;
      if (reader.slash()) {
        uv = this.optional(this.uvs.length / 2);
        if (reader.slash()) normal = this.optional(this.normals.length / 3);
      }
      if (!reader.isWordOver) this.fail('a corner of the face is not of the form “vertex/texture/normal”');
      if (vertex > this.highest) {
        this.highest = vertex;
        this.highestLine = reader.line;
      }
      face.push(vertex, uv, normal);
    }
    const count = face.length / 3;
    if (count < 3) return;
    const run = this.currentRun();
    if (count === 3) this.pushCorners(triangle);
    else if (count === 4) this.pushCorners(this.isFolded(face) ? otherHalves : halves);
    else this.pushCorners(this.cut(face));
    run.to = this.corners.length / 3;
  }

  private cut(face: readonly number[]): readonly number[] {
    const count = face.length / 3;
    const { triangles, isCoarse } = cutPolygon(this.pointsOf(face), MOST_CORNERS);
    if (isCoarse) this.coarse++;
    this.work += Math.min(count, MOST_CORNERS) ** 2 / 64;
    return triangles;
  }

  private once(name: string): string {
    const known = this.names.get(name);
    if (known !== undefined) return known;
    this.names.set(name, name);
    this.numbers.set(name, this.names.size);
    return name;
  }

  private groupChanged(): void {
    const [object, group] = [this.object, this.group].map((name) => this.numbers.get(name) ?? 0);
    this.key = `${object} ${group}`;
  }

  /** Whether a quad is not convex: its two triangles have opposite normals. */
  private isFolded(face: readonly number[]): boolean {
    const p = this.pointsOf(face);
    let product = 0;
    for (let k = 0; k < 3; k++) {
      const [i, j] = [(k + 1) % 3, (k + 2) % 3];
      const across = [p[6 + i] - p[i], p[6 + j] - p[j]];
      const first = (p[3 + i] - p[i]) * across[1] - (p[3 + j] - p[j]) * across[0];
      const second = across[0] * (p[9 + j] - p[j]) - across[1] * (p[9 + i] - p[i]);
      product += first * second;
    }
    return product < 0;
  }

  /** Positions of a face's corners, three numbers each; 0 for vertices that the file defines later. */
  private pointsOf(face: readonly number[]): readonly number[] {
    const { points, positions } = this;
    points.length = 0;
    for (let i = 0; i < face.length; i += 3) {
      for (let k = 0; k < 3; k++) points.push(positions.at(face[i] * 3 + k) || 0);
    }
    return points;
  }

  private pushCorners(order: readonly number[]): void {
    const { face, corners } = this;
    for (const corner of order) corners.push3(face[corner * 3], face[corner * 3 + 1], face[corner * 3 + 2]);
  }

  private currentRun(): ObjRun {
    const { runs, object, group, material, key } = this;
    const last = runs.at(-1);
    if (last?.key === key && last.material === material) return last;
    const hasName = group !== '' && group !== 'default' && group !== 'off';
    const from = this.corners.length / 3;
    const run: ObjRun = { name: shortText(hasName ? group : object, 80), key, material, from, to: from };
    runs.push(run);
    return run;
  }

  /** Converts an index of a corner to one from 0. @param value - counted from 1, or, negative, from the end */
  private index(value: number, length: number): number {
    const index = value > 0 ? value - 1 : length + value;
    if (!(value !== 0 && index >= 0)) this.fail('a corner of the face names a vertex that does not exist');
    return index;
  }

  private optional(length: number): number {
    const value = this.reader.integer();
    if (Number.isNaN(value) || value === 0) return -1;
    return Math.max(-1, value > 0 ? value - 1 : length + value);
  }
}

/** Replaces indices of elements that the file does not have by -1, in the corners. */
function dropMissing(corners: NumberList<Int32Array>, offset: number, count: number): void {
  for (let i = offset; i < corners.length; i += 3) if (corners.at(i) >= count) corners.set(i, -1);
}
