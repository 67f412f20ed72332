import type { Object3D } from 'three';

/** Nodes of a model that are drawn together, and the node that gives their pose. */
export interface ModelSubtree {
  /** The chosen node itself if there is only one, else the nearest common ancestor of `nodes`. */
  readonly root: Object3D;
  /** Chosen nodes of a model; none is below another one. */
  readonly nodes: readonly Object3D[];
  /** Set of the chosen nodes. */
  readonly tops: ReadonlySet<Object3D>;
  /** Nodes on the paths from the root to `nodes`, each with those of its children that are on a path. */
  readonly between: ReadonlyMap<Object3D, readonly Object3D[]>;
}

const nameOf = (node: Object3D): string => encode(node.name || node.type);

/** Escapes the characters in a name that have a meaning in paths. */
const encode = (name: string): string =>
  name.replaceAll(/[%/;#]/g, (letter) => `%${letter.charCodeAt(0).toString(16)}`);

/** The children of a node by name, and the part of a path that leads to each: 'Hand' or 'Hand#2'. */
interface ChildIndex {
  readonly names: readonly string[];
  readonly byName: ReadonlyMap<string, readonly Object3D[]>;
  readonly steps: ReadonlyMap<Object3D, string>;
}

/** Cache of child indices by parent node: a loaded model never changes, and may have very many parts. */
const indices = new WeakMap<Object3D, ChildIndex>();

function indexOf(parent: Object3D): ChildIndex {
  const known = indices.get(parent);
  const { children } = parent;
  if (known?.names.length === children.length) return known;
  const names = children.map(nameOf);
  const byName = new Map<string, Object3D[]>();
  const steps = new Map<Object3D, string>();
  children.forEach((child, i) => {
    const alike = byName.get(names[i]) ?? [];
    byName.set(names[i], alike);
    alike.push(child);
    steps.set(child, alike.length === 1 ? names[i] : `${names[i]}#${alike.length}`);
  });
  const index = { names, byName, steps };
  indices.set(parent, index);
  return index;
}

/** Path of a node in a model: names from the top down, 'Arm/Hand'; the second child of a name is 'Hand#2'. */
export function pathOfNode(scene: Object3D, node: Object3D): string {
  const names: string[] = [];
  for (let each = node; each !== scene && each.parent; each = each.parent)
    names.push(indexOf(each.parent).steps.get(each)!);
  return names.toReversed().join('/');
}

function nodeAt(scene: Object3D, path: string): Object3D | null {
  let node: Object3D = scene;
  for (const step of path.split('/')) {
    const [name, place = '1'] = step.split('#');
    const found = indexOf(node)
      .byName.get(name)
      ?.at(Number(place) - 1);
    if (!found) return null;
    node = found;
  }
  return node;
}

/** The nearest of a node and its ancestors that is in a set; null when none is. */
export function nearestOf(node: Object3D, some: ReadonlySet<Object3D>): Object3D | null {
  for (let each: Object3D | null = node; each; each = each.parent) if (some.has(each)) return each;
  return null;
}

/** Nodes of a set that have no ancestor in the set. */
export function topsOf(nodes: ReadonlySet<Object3D>): Object3D[] {
  return [...nodes].filter((node) => !node.parent || nearestOf(node.parent, nodes) === null);
}

/**
 * The nearest common ancestor of nodes, or the node itself when there is only one.
 * @param nodes - at least one, of one tree
 */
export function commonAncestor(nodes: readonly Object3D[]): Object3D {
  const chain: Object3D[] = [];
  for (let each: Object3D | null = nodes[0]; each; each = each.parent) chain.push(each);
  const heights = new Map(chain.map((node, i) => [node, i]));
  let height = 0;
  for (const node of nodes) {
    let each = node;
    while (!heights.has(each)) each = each.parent!;
    height = Math.max(height, heights.get(each)!);
  }
  return chain[height];
}

/** Paths of nodes as one text, 'Arm/Hand;Head'. */
export const partsText = (scene: Object3D, nodes: readonly Object3D[]): string =>
  nodes.map((node) => pathOfNode(scene, node)).join(';');

/**
 * Subtree of a model that a text of paths names; unknown paths are ignored.
 * @returns null for a text without any node: the whole model
 */
export function subtreeOf(scene: Object3D, parts: string): ModelSubtree | null {
  const found = new Set<Object3D>();
  for (const path of parts.split(';')) {
    const node = path === '' ? null : nodeAt(scene, path);
    if (node && node !== scene) found.add(node);
  }
  const nodes = topsOf(found);
  if (nodes.length === 0) return null;
  const root = commonAncestor(nodes);
  const between = new Map<Object3D, Object3D[]>();
  for (const node of nodes) {
    for (let each = node; each !== root; each = each.parent!) {
      const known = between.get(each.parent!);
      if (known) {
        known.push(each);
        break;
      }
      between.set(each.parent!, [each]);
    }
  }
  return { root, nodes, tops: new Set(nodes), between };
}

/** Whether a node is one of the subtree's nodes, or a descendant of one. */
export const isDrawnBy = (node: Object3D, { tops }: ModelSubtree): boolean => nearestOf(node, tops) !== null;

/** Whether a node is drawn with a subtree: it is below one of its nodes, or between them and its root. */
export const isOfSubtree = (node: Object3D, subtree: ModelSubtree): boolean =>
  subtree.between.has(node) || isDrawnBy(node, subtree);
