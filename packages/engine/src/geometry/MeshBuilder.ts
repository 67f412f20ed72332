import type { Vector3Tuple } from '@farol/editing/fields';
import { BufferGeometry, Float32BufferAttribute, Matrix4, Vector3 } from 'three';
import { computeCreaseNormals } from './computeCreaseNormals';

/** Returns a point of a surface, for u and v from 0 to 1. */
export type Surface = (u: number, v: number) => Vector3Tuple;

/** Returns a point of a profile, for v from 0 to 1: distance from the y axis, and height. */
export type Profile = (v: number) => readonly [radius: number, y: number];

const point = new Vector3();

/**
 * Builds a mesh from surfaces. Texture coordinates of flat surfaces are in metres, so that a texture's `repeat` is in
 * repeats per metre.
 */
export class MeshBuilder {
  private readonly positions: number[] = [];
  private readonly uvs: number[] = [];
  private readonly indices: number[] = [];
  private readonly matrix = new Matrix4();

  /** Sets the position and rotation of all parts added after this call. */
  at(x: number, y: number, z: number, turn = 0): this {
    this.matrix.makeRotationY(turn).setPosition(x, y, z);
    return this;
  }

  /**
   * Adds a grid of `columns` × `rows` cells over a surface, whose front faces towards (∂f/∂u) × (∂f/∂v).
   * @param size - texture coordinates at u = 1 and v = 1
   */
  surface(columns: number, rows: number, f: Surface, size: readonly [number, number] = [1, 1]): this {
    const base = this.positions.length / 3;
    for (let j = 0; j <= rows; j++) {
      for (let i = 0; i <= columns; i++) {
        const [u, v] = [i / columns, j / rows];
        point.set(...f(u, v)).applyMatrix4(this.matrix);
        this.positions.push(point.x, point.y, point.z);
        this.uvs.push(u * size[0], v * size[1]);
      }
    }
    for (let j = 0; j < rows; j++) {
      for (let i = 0; i < columns; i++) {
        const a = base + j * (columns + 1) + i;
        const c = a + columns + 1;
        this.indices.push(a, a + 1, c + 1, a, c + 1, c);
      }
    }
    return this;
  }

  /** Adds a flat patch from a corner along two edges, facing p × q. */
  patch(corner: Vector3Tuple, p: Vector3Tuple, q: Vector3Tuple, columns = 1, rows = 1): this {
    const size: [number, number] = [Math.hypot(...p), Math.hypot(...q)];
    const along = (u: number, v: number): Vector3Tuple => [
      corner[0] + p[0] * u + q[0] * v,
      corner[1] + p[1] * u + q[1] * v,
      corner[2] + p[2] * u + q[2] * v,
    ];
    return this.surface(columns, rows, along, size);
  }

  /** Adds a triangle, anticlockwise seen from its front; its texture coordinates are x + z and y. */
  triangle(a: Vector3Tuple, b: Vector3Tuple, c: Vector3Tuple): this {
    const base = this.positions.length / 3;
    for (const corner of [a, b, c]) {
      this.uvs.push(corner[0] + corner[2], corner[1]);
      point.set(...corner).applyMatrix4(this.matrix);
      this.positions.push(point.x, point.y, point.z);
    }
    this.indices.push(base, base + 1, base + 2);
    return this;
  }

  /** Adds a box between two corners, each face split into cells of about `cell` metres. */
  box(min: Vector3Tuple, max: Vector3Tuple, cell = Infinity): this {
    const [x, y, z] = [max[0] - min[0], max[1] - min[1], max[2] - min[2]];
    const cells = (length: number): number => Math.max(1, Math.round(length / cell));
    this.patch([min[0], min[1], max[2]], [x, 0, 0], [0, y, 0], cells(x), cells(y));
    this.patch([max[0], min[1], min[2]], [-x, 0, 0], [0, y, 0], cells(x), cells(y));
    this.patch([max[0], min[1], max[2]], [0, 0, -z], [0, y, 0], cells(z), cells(y));
    this.patch([min[0], min[1], min[2]], [0, 0, z], [0, y, 0], cells(z), cells(y));
    this.patch([min[0], max[1], max[2]], [x, 0, 0], [0, 0, -z], cells(x), cells(z));
    return this.patch(min, [x, 0, 0], [0, 0, z], cells(x), cells(z));
  }

  /** Adds a surface of revolution about the y axis, facing outwards where the profile rises. */
  lathe(segments: number, rings: number, profile: Profile, size: readonly [number, number] = [1, 1]): this {
    const turned: Surface = (u, v) => {
      const [radius, y] = profile(v);
      const angle = -u * 2 * Math.PI;
      return [radius * Math.cos(angle), y, radius * Math.sin(angle)];
    };
    return this.surface(segments, rings, turned, size);
  }

  /** Makes the mesh, with normals that are split at edges of more than `creaseAngle` radians. */
  build(creaseAngle = Math.PI / 5): BufferGeometry {
    const geometry = new BufferGeometry();
    geometry.setAttribute('position', new Float32BufferAttribute(this.positions, 3));
    geometry.setAttribute('uv', new Float32BufferAttribute(this.uvs, 2));
    geometry.setIndex(this.indices);
    const result = computeCreaseNormals(geometry, creaseAngle);
    result.computeBoundingBox();
    return result;
  }
}
