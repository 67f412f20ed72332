import type { InstancedMesh, Object3D, SkinnedMesh } from 'three';
import type { Model } from '../assets/Model';
import { commonAncestor, isWithin } from '../assets/modelNodes';

/** Why a part of a model stays one object. */
export type KeptFor = 'a skeleton' | 'morph targets' | 'instances of a mesh' | 'points or lines';

/** Nodes of a model that only a ModelRenderer draws, with all below them. */
export interface KeptPart {
  /** None is below another one. Several where a skeleton and its meshes stand beside each other. */
  readonly nodes: readonly Object3D[];
  readonly reason: KeptFor;
}

/** More instances of a mesh than this stay one object. */
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

/** Those of some nodes that are below none of the others. */
const topsOf = (nodes: Iterable<Object3D>): Object3D[] => {
  const all = [...new Set(nodes)];
  return all.filter((node) => !all.some((other) => other !== node && isWithin(node, other)));
};

const touch = (a: readonly Object3D[], b: readonly Object3D[]): boolean =>
  a.some((one) => b.some((other) => isWithin(one, other) || isWithin(other, one)));

const isSeen = (node: Flags): boolean =>
  Boolean(node.isMesh || node.isPoints || node.isLine || node.isSprite || node.isLight || node.isCamera);

/** Whether all that a node has below it, and is, belongs to some nodes. */
function holdsNothingElse(node: Object3D, nodes: readonly Object3D[]): boolean {
  let holds = true;
  node.traverse((each) => (holds &&= !isSeen(each) || nodes.some((kept) => isWithin(each, kept))));
  return holds;
}

/** The parts of a model that stay together: what a skeleton moves, meshes with morph targets, points and lines. */
export function keptTogether({ scene }: Model): KeptPart[] {
  let parts: KeptPart[] = [];
  scene.traverse((node) => {
    const reason = reasonOf(node);
    if (!reason) return;
    const bones = reason === 'a skeleton' ? ((node as SkinnedMesh).skeleton?.bones ?? []) : [];
    let added: KeptPart = { nodes: topsOf([node, ...bones.filter((bone) => isWithin(bone, scene))]), reason };
    for (const other of parts.filter((each) => touch(each.nodes, added.nodes))) {
      parts = parts.filter((each) => each !== other);
      added = { nodes: topsOf([...other.nodes, ...added.nodes]), reason: other.reason };
    }
    parts.push(added);
  });
  return parts.map(({ nodes, reason }) => {
    const above = commonAncestor(nodes);
    const isFree = parts.every((each) => each.nodes === nodes || !touch(each.nodes, [above]));
    return { nodes: above !== scene && isFree && holdsNothingElse(above, nodes) ? [above] : nodes, reason };
  });
}

/** Whether anything of a model can be an object beside its parts that stay together. */
export function isUnpackable(model: Model, kept = keptTogether(model)): boolean {
  if (kept.length !== 1) return true;
  return !holdsNothingElse(model.scene, kept[0].nodes);
}
