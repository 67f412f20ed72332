import { BufferAttribute, BufferGeometry, type DataTexture } from 'three';
import { MeshBVH, MeshBVHUniformStruct, SAH } from 'three-mesh-bvh';

/** A bounding volume hierarchy in the layout of the shader. */
export interface PackedBvh {
  /**
   * Inner nodes of 16 floats, the root first: for each of two children the minimum corner and a reference, the maximum
   * corner and a count. Count 0: the reference is the index of a node; else that of the first of `count` triangles.
   */
  readonly nodes: Float32Array;
  /** Indices of the given triangles in the order of the leaves. */
  readonly order: Uint32Array;
  /** Number of inner nodes from the root to the deepest leaf. */
  readonly depth: number;
}

const FLOATS = 16;

/**
 * Builds a hierarchy over triangles with three-mesh-bvh. A node stores the bounds of both children, so that the shader
 * reads four consecutive texels per step.
 *
 * @param positions - nine numbers per triangle
 * @see Aila and Laine 2009, Understanding the Efficiency of Ray Traversal on GPUs
 */
export function packBvh(positions: Float32Array): PackedBvh {
  const geometry = new BufferGeometry();
  geometry.setAttribute('position', new BufferAttribute(positions, 3));
  geometry.setIndex(
    new BufferAttribute(
      Uint32Array.from({ length: positions.length / 3 }, (_, i) => i),
      1,
    ),
  );
  const bvh = new MeshBVH(geometry, { strategy: SAH, targetLeafSize: 4, maxDepth: 40 });
  // the class's type declarations lack its textures
  const struct = new MeshBVHUniformStruct() as MeshBVHUniformStruct & Record<'bvhBounds' | 'bvhContents', DataTexture>;
  struct.updateFrom(bvh);
  const bounds = struct.bvhBounds.image.data as Float32Array;
  const contents = struct.bvhContents.image.data as Uint32Array;
  const index = geometry.index!.array;
  const order = Uint32Array.from({ length: index.length / 3 }, (_, i) => index[3 * i] / 3);
  struct.dispose();

  const isLeaf = (node: number): boolean => (contents[2 * node] & 0xffff0000) !== 0;
  const nodes: number[] = [];
  let depth = 0;
  const writeChild = (at: number, node: number, reference: number): void => {
    const count = isLeaf(node) ? contents[2 * node] & 0xffff : 0;
    for (let k = 0; k < 3; k++) {
      nodes[at + k] = bounds[8 * node + k];
      nodes[at + 4 + k] = bounds[8 * node + 4 + k];
    }
    nodes[at + 3] = count > 0 ? contents[2 * node + 1] : reference;
    nodes[at + 7] = count;
  };
  /** Inner nodes whose children are not written yet: node, its position in the output, depth. */
  const open: [number, number, number][] = [];
  let next = 1;
  nodes.length = FLOATS;
  if (isLeaf(0)) {
    writeChild(0, 0, 0);
    // the second child is an empty box, which no ray hits
    nodes.splice(8, 8, 1, 1, 1, 0, -1, -1, -1, 1);
    return { nodes: Float32Array.from(nodes), order, depth: 1 };
  }
  open.push([0, 0, 1]);
  for (let each = open.pop(); each; each = open.pop()) {
    const [node, place, level] = each;
    depth = Math.max(depth, level);
    [node + 1, node + contents[2 * node + 1]].forEach((child, side) => {
      const reference = isLeaf(child) ? 0 : next++;
      writeChild(FLOATS * place + 8 * side, child, reference);
      if (!isLeaf(child)) open.push([child, reference, level + 1]);
    });
  }
  return { nodes: Float32Array.from(nodes), order, depth };
}
