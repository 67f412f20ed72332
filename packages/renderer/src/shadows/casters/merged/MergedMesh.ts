import { BufferAttribute, BufferGeometry, DynamicDrawUsage, type Material, Mesh, Sphere } from 'three';
import { casterProxy } from '../casterProxy';

/** Number of vertices, and of indices, in the first buffers. */
const SMALLEST = 4096;

/**
 * One mesh that holds the triangles of many casters. Triangles keep their place in the buffers; three binds the mesh, Farol
 * draws runs of it.
 */
export class MergedMesh {
  readonly mesh: Mesh;
  /** Mesh given to three's traversal, which uploads its buffers, see `casterProxy`. */
  readonly proxy: Mesh;
  vertices = 0;
  indices = 0;
  private geometry: BufferGeometry;

  constructor(material: Material) {
    this.geometry = makeGeometry(SMALLEST, SMALLEST);
    this.mesh = new Mesh(this.geometry, material);
    this.mesh.matrixAutoUpdate = this.mesh.matrixWorldAutoUpdate = false;
    this.proxy = casterProxy(this.mesh) as Mesh;
  }

  /**
   * Adds triangles.
   * @param positions - 3 numbers a vertex (own space of the object, m)
   * @param index - three vertices a triangle
   * @param object - number of the object, written with each vertex
   * @returns index of the first of the triangles' indices
   */
  add(positions: Float32Array, index: Uint32Array, object: number): number {
    const count = positions.length / 3;
    const first = this.indices;
    this.reserve(this.vertices + count, first + index.length);
    const position = this.geometry.attributes.position as BufferAttribute;
    const own = this.geometry.index!;
    const corners = position.array;
    for (let i = 0, at = this.vertices * 4; i < count; i++, at += 4) {
      corners[at] = positions[i * 3];
      corners[at + 1] = positions[i * 3 + 1];
      corners[at + 2] = positions[i * 3 + 2];
      corners[at + 3] = object;
    }
    for (let i = 0; i < index.length; i++) own.array[first + i] = index[i] + this.vertices;
    position.addUpdateRange(this.vertices * 4, count * 4);
    own.addUpdateRange(first, index.length);
    position.needsUpdate = own.needsUpdate = true;
    this.vertices += count;
    this.indices += index.length;
    return first;
  }

  /** Forgets all triangles; the buffers stay. */
  clear(): void {
    this.vertices = this.indices = 0;
  }

  dispose(): void {
    this.geometry.dispose();
  }

  private reserve(vertices: number, indices: number): void {
    const before = this.geometry;
    const position = before.attributes.position as BufferAttribute;
    const own = before.index!;
    if (vertices <= position.count && indices <= own.count) return;
    const made = makeGeometry(atLeast(position.count, vertices), atLeast(own.count, indices));
    (made.attributes.position as BufferAttribute).array.set(position.array);
    made.index!.array.set(own.array);
    before.dispose();
    this.geometry = this.mesh.geometry = made;
  }
}

function atLeast(size: number, wanted: number): number {
  while (size < wanted) size *= 2;
  return size;
}

function makeGeometry(vertices: number, indices: number): BufferGeometry {
  const geometry = new BufferGeometry();
  const position = new BufferAttribute(new Float32Array(vertices * 4), 4);
  const index = new BufferAttribute(new Uint32Array(indices), 1);
  position.usage = index.usage = DynamicDrawUsage;
  geometry.setAttribute('position', position);
  geometry.setIndex(index);
  geometry.boundingSphere = new Sphere(); // three sorts draws by the bounding sphere
  return geometry;
}
