import type { GameObject } from '@farol/engine';
import { BufferAttribute, BufferGeometry, type Matrix4, Mesh, Triangle, Vector3 } from 'three';
import { MeshSurfaceSampler } from 'three/addons/math/MeshSurfaceSampler.js';
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

/**
 * World positions of each triangle's corners (m).
 * @param upwards - whether only triangles that face up are used, if there are any
 */
function cornersOf(objects: readonly GameObject[], upwards: boolean): Float32Array {
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
  return Float32Array.from(up.length > 0 ? up : all);
}

/** Random points distributed evenly over the surface of objects, as of the last drawn frame. */
export class SurfaceSampler extends MeshSurfaceSampler {
  /** Sets the source of random numbers in [0, 1); missing in the types of three. */
  declare setRandomGenerator: (random: () => number) => this;

  /**
   * @param objects - sampled with their descendants
   * @param upwards - whether only triangles that face up are used, if there are any
   */
  constructor(objects: readonly GameObject[], upwards: boolean) {
    const positions = new BufferAttribute(cornersOf(objects, upwards), 3);
    super(new Mesh(new BufferGeometry().setAttribute('position', positions)));
    this.build();
  }

  /** Area of the whole surface (m²); 0 when there is none. */
  get area(): number {
    return this.distribution?.at(-1) ?? 0;
  }
}
