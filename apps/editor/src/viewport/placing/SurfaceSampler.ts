import type { GameObject } from '@farol/engine';
import { BufferAttribute, type Matrix4, type Mesh, Triangle, Vector3 } from 'three';
import { readableMeshes } from '../drawnMeshes';

/** Smallest y of the unit normal of a face that counts as facing up. */
const UPWARDS = 0.2;

const triangle = new Triangle();
const normal = new Vector3();

/** Position of a vertex, with bones and morph targets applied. */
function vertexAt(
  mesh: Mesh | null,
  positions: BufferAttribute,
  index: number,
  matrix: Matrix4,
  target: Vector3,
): void {
  if (mesh) mesh.getVertexPosition(index, target);
  else target.fromBufferAttribute(positions, index);
  target.applyMatrix4(matrix);
}

/** Random points distributed evenly over the surface of objects, as of the last drawn frame. */
export class SurfaceSampler {
  /** World positions of each triangle's corners (m): 9 numbers. */
  private readonly corners: Float32Array;
  /** Cumulative areas (m²): of each triangle and all previous ones. */
  private readonly areas: Float64Array;

  /**
   * @param objects - sampled with their descendants
   * @param upwards - whether only triangles that face up are used, if there are any
   */
  constructor(objects: readonly GameObject[], upwards: boolean) {
    const all: number[] = [];
    const up: number[] = [];
    for (const root of objects) {
      root.traverse((object) => {
        if (!object.activeInHierarchy) return;
        readableMeshes(object, (mesh, geometry, matrix) => {
          const positions = geometry.getAttribute('position') as BufferAttribute | undefined;
          if (!positions) return;
          const { index } = geometry;
          const count = index ? index.count : positions.count;
          for (let i = 0; i + 2 < count; i += 3) {
            const corner = (k: number): number => (index ? index.getX(i + k) : i + k);
            vertexAt(mesh, positions, corner(0), matrix, triangle.a);
            vertexAt(mesh, positions, corner(1), matrix, triangle.b);
            vertexAt(mesh, positions, corner(2), matrix, triangle.c);
            for (const { x, y, z } of [triangle.a, triangle.b, triangle.c]) all.push(x, y, z);
            if (!upwards || triangle.getNormal(normal).y < UPWARDS) continue;
            for (const { x, y, z } of [triangle.a, triangle.b, triangle.c]) up.push(x, y, z);
          }
        });
      });
    }
    this.corners = Float32Array.from(up.length > 0 ? up : all);
    this.areas = new Float64Array(this.corners.length / 9);
    let area = 0;
    for (let i = 0; i < this.areas.length; i++) {
      this.read(i);
      area += triangle.getArea();
      this.areas[i] = area;
    }
  }

  /** Area of the whole surface (m²); 0 when there is none. */
  get area(): number {
    return this.areas.at(-1) ?? 0;
  }

  /**
   * Samples a point.
   * @param random - returns numbers in [0, 1); called three times
   * @param point - receives the world position (m)
   * @param normalWS - receives the unit normal
   */
  sample(random: () => number, point: Vector3, normalWS: Vector3): void {
    const targetArea = random() * this.area;
    let [first, last] = [0, this.areas.length - 1];
    while (first < last) {
      const middle = (first + last) >> 1;
      if (this.areas[middle] > targetArea) last = middle;
      else first = middle + 1;
    }
    this.read(first);
    let [u, v] = [random(), random()];
    if (u + v > 1) [u, v] = [1 - u, 1 - v];
    point
      .copy(triangle.a)
      .multiplyScalar(1 - u - v)
      .addScaledVector(triangle.b, u)
      .addScaledVector(triangle.c, v);
    triangle.getNormal(normalWS);
  }

  private read(index: number): void {
    const { corners } = this;
    const at = 9 * index;
    triangle.a.fromArray(corners, at);
    triangle.b.fromArray(corners, at + 3);
    triangle.c.fromArray(corners, at + 6);
  }
}
