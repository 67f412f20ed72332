import { Matrix4, Quaternion, Vector3 } from 'three';
import { counted } from '../../base/counted';
import { maximumDepth } from '../../base/maximumDepth';
import { absurdSize, LARGEST } from '../checkModel';
import type { GltfLists } from './GltfLists';

/** Greatest number of vertices drawn, with each mesh counted as often as it is drawn, and of primitives. */
const VERTICES = 100_000_000;
const DRAWS = 1_000_000;

const position = new Vector3();
const rotation = new Quaternion();
const scale = new Vector3();

function numbersOf(lists: GltfLists, value: unknown, length: number, what: string): number[] | null {
  if (value === undefined) return null;
  const list = lists.listOf(value, what);
  if (list.length !== length) lists.fail(`${what} must have ${length} numbers, not ${list.length}`);
  for (const each of list) {
    if (typeof each !== 'number' || !Number.isFinite(each))
      lists.fail(`${what} holds ${lists.show(each)}, which is not a number`);
    if (Math.abs(each as number) > LARGEST)
      lists.fail(`${what} holds ${lists.show(each)}, and ${LARGEST} is the limit`);
  }
  return list as number[];
}

function matrixOf(lists: GltfLists, node: Record<string, unknown>, what: string): Matrix4 {
  const matrix = numbersOf(lists, node.matrix, 16, `the matrix of ${what}`);
  if (matrix) return new Matrix4().fromArray(matrix);
  position.fromArray(numbersOf(lists, node.translation, 3, `the translation of ${what}`) ?? [0, 0, 0]);
  rotation.fromArray(numbersOf(lists, node.rotation, 4, `the rotation of ${what}`) ?? [0, 0, 0, 1]);
  scale.fromArray(numbersOf(lists, node.scale, 3, `the scale of ${what}`) ?? [1, 1, 1]);
  return new Matrix4().compose(position, rotation, scale);
}

/** Number of instances in which a node draws its mesh. */
function instancesOf(lists: GltfLists, node: Record<string, unknown>, what: string): number {
  const instancing = lists.record(node.extensions).EXT_mesh_gpu_instancing;
  if (instancing === undefined) return 1;
  const attributes = Object.values(lists.record(lists.record(instancing).attributes));
  const counts = attributes.map((each) => lists.all('accessors')[lists.index(each, 'accessors', what)].count as number);
  if (new Set(counts).size > 1) lists.fail(`the instances of ${what} have attributes of unequal counts`);
  return counts[0] ?? 1;
}

function primitivesOf(lists: GltfLists, mesh: unknown): Record<string, unknown>[] {
  const { primitives = [] } = lists.all('meshes')[mesh as number] as { primitives?: Record<string, unknown>[] };
  return primitives;
}

function verticesOf(lists: GltfLists, primitives: readonly Record<string, unknown>[]): number {
  return primitives.reduce((sum, { indices, attributes }) => {
    const accessor = (indices ?? lists.record(attributes).POSITION) as number | undefined;
    return sum + (accessor === undefined ? 0 : (lists.all('accessors')[accessor].count as number));
  }, 0);
}

/** Nodes in an order with parents before children, and the parent of each. */
function treeOf(lists: GltfLists): { order: number[]; parents: Map<number, number> } {
  const nodes = lists.all('nodes');
  const parents = new Map<number, number>();
  nodes.forEach(({ children = [] }, i) => {
    for (const each of lists.listOf(children, `the children of node ${i}`)) {
      const child = lists.index(each, 'nodes', `node ${i}`);
      if (parents.has(child)) lists.fail(`node ${child} is below two others, ${parents.get(child)} and ${i}`);
      parents.set(child, i);
    }
  });
  let level = nodes.flatMap((_, i) => (parents.has(i) ? [] : [i]));
  const order: number[] = [];
  for (let depth = 1; level.length > 0; depth++) {
    if (depth > maximumDepth) lists.fail(`its nodes are more than ${maximumDepth} deep`);
    order.push(...(level.length < 50_000 ? level : []));
    if (level.length >= 50_000) for (const each of level) order.push(each);
    level = level.flatMap((each) => (nodes[each].children as number[] | undefined) ?? []);
  }
  if (order.length < nodes.length) {
    const done = new Set(order);
    lists.fail(`node ${nodes.findIndex((_, i) => !done.has(i))} is below itself`);
  }
  return { order, parents };
}

/**
 * Checks the nodes: that they form a tree of limited depth, that no position is absurd, and that not too much is drawn.
 * @throws Error of one sentence
 */
export function checkGltfNodes(lists: GltfLists): void {
  const nodes = lists.all('nodes');
  const { order, parents } = treeOf(lists);
  const worlds = new Map<number, Matrix4>();
  const sizes = new Map<unknown, number>();
  let vertices = 0;
  let draws = 0;
  for (const i of order) {
    const node = nodes[i];
    const what = `node ${i}`;
    const world = matrixOf(lists, node, what);
    const parent = parents.get(i);
    if (parent !== undefined) world.premultiply(worlds.get(parent)!);
    if (absurdSize(world)) lists.fail(`${what} is scaled or moved beyond ${LARGEST} by the nodes above it`);
    worlds.set(i, world);
    if (node.camera !== undefined) lists.index(node.camera, 'cameras', what);
    if (node.skin !== undefined) lists.index(node.skin, 'skins', what);
    if (node.mesh === undefined) continue;
    lists.index(node.mesh, 'meshes', what);
    const primitives = primitivesOf(lists, node.mesh);
    const size = sizes.get(node.mesh) ?? verticesOf(lists, primitives);
    sizes.set(node.mesh, size);
    draws += primitives.length;
    vertices += size * instancesOf(lists, node, what);
  }
  if (draws > DRAWS) lists.fail(`it would take ${counted(draws)} draw calls, and ${counted(DRAWS)} is the limit`);
  if (vertices > VERTICES) {
    lists.fail(`it would draw ${counted(vertices)} vertices, and ${counted(VERTICES)} is the limit`);
  }
  lists.all('skins').forEach(({ joints, inverseBindMatrices, skeleton }, i) => {
    const list = lists.listOf(joints, `the joints of skin ${i}`);
    for (const each of list) lists.index(each, 'nodes', `skin ${i}`);
    if (skeleton !== undefined) lists.index(skeleton, 'nodes', `skin ${i}`);
    if (inverseBindMatrices === undefined) return;
    const { count } = lists.all('accessors')[lists.index(inverseBindMatrices, 'accessors', `skin ${i}`)];
    if ((count as number) < list.length) lists.fail(`skin ${i} has more joints than matrices`);
  });
  lists.all('scenes').forEach(({ nodes: roots = [] }, i) => {
    const list = lists.listOf(roots, `the nodes of scene ${i}`);
    for (const each of list) lists.index(each, 'nodes', `scene ${i}`);
    if (new Set(list).size < list.length) lists.fail(`scene ${i} names a node twice`);
  });
  if (lists.json.scene !== undefined) lists.index(lists.json.scene, 'scenes', 'the file');
}
