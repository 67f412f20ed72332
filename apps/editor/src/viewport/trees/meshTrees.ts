import { attributeState } from '@farol/renderer/vertex-data';
import type { BufferGeometry } from 'three';
import type { MeshBVH } from 'three-mesh-bvh';

/** Number of triangles above which a geometry gets a bounding volume hierarchy ("tree"). */
export const LARGE = 50_000;

/** A tree, and the state of the geometry that it was built for. */
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
          // otherwise the geometry was edited meanwhile: the next ray starts building again
          if (trees.get(geometry) === grown && isCurrent(grown, geometry)) grown.tree = tree;
        },
        // a failed build is not fatal: without a tree, a ray is tested against every triangle
        (error: Error) => console.debug(`Farol: ${error.message}`),
      ),
  };
  trees.set(geometry, grown);
  return grown;
}

/** The tree of a large geometry; null for small ones, and until it is built. The first call starts building. */
export function treeOf(geometry: BufferGeometry): MeshBVH | null {
  if (trianglesOf(geometry) <= LARGE) return null;
  const grown = trees.get(geometry);
  return (grown && isCurrent(grown, geometry) ? grown : begin(geometry)).tree;
}

/** Fulfilled once a large geometry has its tree. */
export async function treeReady(geometry: BufferGeometry): Promise<void> {
  if (treeOf(geometry) === null) await trees.get(geometry)?.ready;
}
