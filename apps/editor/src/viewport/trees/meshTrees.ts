import { attributeState } from '@farol/renderer/vertex-data';
import type { BufferGeometry } from 'three';
import type { MeshBVH } from 'three-mesh-bvh';

/** Meshes of more triangles than this have a tree. */
export const LARGE = 50_000;

/** A tree, and what of its geometry it was grown over. */
interface Grown {
  readonly state: string;
  tree: MeshBVH | null;
  readonly ready: Promise<void>;
}

const trees = new WeakMap<BufferGeometry, Grown>();

const trianglesOf = ({ index, attributes: { position } }: BufferGeometry): number =>
  ((index ?? position)?.count ?? 0) / 3;

const isCurrent = (grown: Grown, geometry: BufferGeometry): boolean => grown.state === stateOf(geometry);

const stateOf = ({ index, attributes: { position }, drawRange, groups }: BufferGeometry): string =>
  `${attributeState(position)} ${index ? attributeState(index) : 0} ${drawRange.start} ${drawRange.count} ${groups.length}`;

function begin(geometry: BufferGeometry): Grown {
  const grown: Grown = {
    state: stateOf(geometry),
    tree: null,
    ready: import('./loadTree')
      .then(({ loadTree }) => loadTree(geometry))
      .then(
        (tree) => {
          // edited meanwhile: the next ray begins again
          if (trees.get(geometry) === grown && isCurrent(grown, geometry)) grown.tree = tree;
        },
        // every triangle is looked at then
        (error: Error) => console.debug(`Farol: ${error.message}`),
      ),
  };
  trees.set(geometry, grown);
  return grown;
}

/** The tree of a large geometry, which begins to grow when it is first asked for; null until then, and for small ones. */
export function treeOf(geometry: BufferGeometry): MeshBVH | null {
  if (trianglesOf(geometry) <= LARGE) return null;
  const grown = trees.get(geometry);
  return (grown && isCurrent(grown, geometry) ? grown : begin(geometry)).tree;
}

/** Fulfilled once a geometry has the tree that it is to have. */
export async function treeReady(geometry: BufferGeometry): Promise<void> {
  if (treeOf(geometry) === null) await trees.get(geometry)?.ready;
}
