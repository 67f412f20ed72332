import type { Object3D } from 'three';

/** Some nodes of a model, each with all below it. */
export interface ModelSubtree {
  /** The node itself where there is one, else the nearest node above all of them. */
  readonly root: Object3D;
  /** The nodes; none is below another one. */
  readonly nodes: readonly Object3D[];
}

const nameOf = (node: Object3D): string => encode(node.name || node.type);

/** A name without what paths are made of. */
const encode = (name: string): string =>
  name.replaceAll(/[%/;#]/g, (letter) => `%${letter.charCodeAt(0).toString(16)}`);

/** A node of a model by names from the top down, 'Arm/Hand'; the second child of a name is 'Hand#2'. */
export function pathOfNode(scene: Object3D, node: Object3D): string {
  const names: string[] = [];
  for (let each = node; each !== scene && each.parent; each = each.parent) {
    const name = nameOf(each);
    const alike = each.parent.children.filter((other) => nameOf(other) === name);
    const place = alike.indexOf(each) + 1;
    names.unshift(place === 1 ? name : `${name}#${place}`);
  }
  return names.join('/');
}

function nodeAt(scene: Object3D, path: string): Object3D | null {
  let node: Object3D = scene;
  for (const step of path.split('/')) {
    const [name, place = '1'] = step.split('#');
    const found = node.children.filter((each) => nameOf(each) === name).at(Number(place) - 1);
    if (!found) return null;
    node = found;
  }
  return node;
}

export function isWithin(node: Object3D, above: Object3D): boolean {
  for (let each: Object3D | null = node; each; each = each.parent) if (each === above) return true;
  return false;
}

/** The nearest node that is, or is above, all of some. @param nodes - at least one, of one tree */
export function commonAncestor(nodes: readonly Object3D[]): Object3D {
  let above = nodes[0];
  while (!nodes.every((each) => isWithin(each, above))) above = above.parent!;
  return above;
}

/** Paths of nodes as one text, 'Arm/Hand;Head'. */
export const partsText = (scene: Object3D, nodes: readonly Object3D[]): string =>
  nodes.map((node) => pathOfNode(scene, node)).join(';');

/**
 * What a text of paths names in a model; names that are not there are passed over.
 * @returns null for a text without any node: the whole model
 */
export function subtreeOf(scene: Object3D, parts: string): ModelSubtree | null {
  const found = new Set<Object3D>();
  for (const path of parts.split(';')) {
    const node = path === '' ? null : nodeAt(scene, path);
    if (node && node !== scene) found.add(node);
  }
  const nodes = [...found].filter((node) => ![...found].some((other) => other !== node && isWithin(node, other)));
  return nodes.length === 0 ? null : { root: commonAncestor(nodes), nodes };
}

/** Whether a node is drawn with a subtree: it is below one of its nodes, or between them and its root. */
export const isOfSubtree = (node: Object3D, { root, nodes }: ModelSubtree): boolean =>
  isWithin(node, root) && nodes.some((each) => isWithin(node, each) || isWithin(each, node));
