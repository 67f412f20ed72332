import type { InstancedMesh, Object3D, SkinnedMesh } from 'three';
import type { Model } from '../assets/Model';
import { commonAncestor, nearestOf, topsOf } from '../assets/modelNodes';

/** Reason why a part of a model cannot be split into GameObjects. */
export type KeptFor = 'a skeleton' | 'morph targets' | 'instances of a mesh' | 'points or lines';

/** Nodes of a model that only a ModelRenderer draws, with all below them. */
export interface KeptPart {
  /** Top nodes, none below another; several when a skeleton and its meshes are siblings. */
  readonly nodes: readonly Object3D[];
  readonly reason: KeptFor;
}

/** Number of instances above which an instanced mesh is kept as one object. */
const MOST_INSTANCES = 2000;

type Flags = Object3D & {
  readonly isMesh?: boolean;
  readonly isSkinnedMesh?: boolean;
  readonly isInstancedMesh?: boolean;
  readonly isPoints?: boolean;
  readonly isLine?: boolean;
  readonly isSprite?: boolean;
  readonly isLight?: boolean;
  readonly isCamera?: boolean;
  readonly morphTargetInfluences?: readonly number[];
};

function reasonOf(node: Flags): KeptFor | null {
  if (node.isSkinnedMesh) return 'a skeleton';
  if (node.isMesh && (node.morphTargetInfluences?.length ?? 0) > 0) return 'morph targets';
  if (node.isInstancedMesh) {
    const { count, instanceColor } = node as unknown as InstancedMesh;
    return count > MOST_INSTANCES || instanceColor ? 'instances of a mesh' : null;
  }
  return node.isPoints || node.isLine || node.isSprite ? 'points or lines' : null;
}

const isSeen = (node: Flags): boolean =>
  Boolean(node.isMesh || node.isPoints || node.isLine || node.isSprite || node.isLight || node.isCamera);

/** Nodes in traversal order: descendants directly follow their ancestor. */
class Order {
  readonly places = new Map<Object3D, number>();
  /** For each node's index, the index after its last descendant. */
  private readonly ends: number[] = [];
  /** Number of meshes, lights and cameras before each index. */
  private readonly countsBefore = [0];

  constructor(root: Object3D) {
    const visit = (node: Object3D): void => {
      const place = this.places.size;
      this.places.set(node, place);
      this.countsBefore.push(this.countsBefore[place] + Number(isSeen(node)));
      for (const child of node.children) visit(child);
      this.ends[place] = this.places.size;
    };
    visit(root);
  }

  endOf(node: Object3D): number {
    return this.ends[this.places.get(node)!];
  }

  /** Number of meshes, lights and cameras in a node's subtree. */
  seenIn(node: Object3D): number {
    return this.countsBefore[this.endOf(node)] - this.countsBefore[this.places.get(node)!];
  }

  /**
   * Whether all meshes, lights and cameras of a node's subtree are in the subtrees of `nodes`, none of which is below
   * another.
   */
  holdsNothingElse(node: Object3D, nodes: readonly Object3D[]): boolean {
    return this.seenIn(node) === nodes.reduce((sum, each) => sum + this.seenIn(each), 0);
  }
}

/**
 * Disjoint sets, merged two at a time (union-find).
 * @see Tarjan 1975, Efficiency of a good but not linear set union algorithm
 */
class Groups {
  private readonly parents: number[] = [];

  add(): number {
    return this.parents.push(this.parents.length) - 1;
  }

  of(one: number): number {
    while (this.parents[one] !== one) one = this.parents[one] = this.parents[this.parents[one]];
    return one;
  }

  join(one: number, other: number): void {
    this.parents[Math.max(this.of(one), this.of(other))] = Math.min(this.of(one), this.of(other));
  }
}

/** Parts of a model that cannot be split: skeletons with their meshes, meshes with morph targets, points and lines. */
export function keptTogether({ scene }: Model): KeptPart[] {
  const order = new Order(scene);
  const groups = new Groups();
  /** Reason that each group of nodes cannot be unpacked, by group index. */
  const reasons: KeptFor[] = [];
  const groupOf = new Map<Object3D, number>();
  for (const node of order.places.keys()) {
    const reason = reasonOf(node);
    if (!reason) continue;
    const group = groups.add();
    reasons.push(reason);
    const bones = reason === 'a skeleton' ? ((node as SkinnedMesh).skeleton?.bones ?? []) : [];
    for (const each of [node, ...bones]) {
      if (!order.places.has(each)) continue;
      const known = groupOf.get(each);
      if (known === undefined) groupOf.set(each, group);
      else groups.join(known, group);
    }
  }
  const kept = new Set(groupOf.keys());
  for (const node of kept) {
    const above = node.parent && nearestOf(node.parent, kept);
    if (above) groups.join(groupOf.get(node)!, groupOf.get(above)!);
  }
  const tops = topsOf(kept);
  const nodesOf = new Map<number, Object3D[]>();
  for (const node of tops) {
    const group = groups.of(groupOf.get(node)!);
    const nodes = nodesOf.get(group);
    if (nodes) nodes.push(node);
    else nodesOf.set(group, [node]);
  }
  /** Number of the kept nodes before each index. */
  const before = [0];
  const isTop = new Set(tops);
  for (const node of order.places.keys()) before.push(before.at(-1)! + Number(isTop.has(node)));
  return [...nodesOf].map(([group, nodes]) => {
    const above = commonAncestor(nodes);
    const topsIn = before[order.endOf(above)] - before[order.places.get(above)!];
    const isOne = above !== scene && topsIn === nodes.length && order.holdsNothingElse(above, nodes);
    return { nodes: isOne ? [above] : nodes, reason: reasons[group] };
  });
}

/** Whether a model has any part, besides those that cannot be split, that can become an object. */
export function isUnpackable(model: Model, kept = keptTogether(model)): boolean {
  if (kept.length !== 1) return true;
  return !new Order(model.scene).holdsNothingElse(model.scene, kept[0].nodes);
}
