import { BufferAttribute, BufferGeometry, InterleavedBufferAttribute } from 'three';
import type { UnwrappedMesh } from '../unwrap/UnwrapRequest';

type AnyAttribute = BufferAttribute | InterleavedBufferAttribute;

/** Cache of attributes reordered to a bake's vertices, shared by meshes of one geometry and order. */
export class GatheredAttributes {
  private readonly made = new Map<AnyAttribute, { order: Uint32Array; gathered: BufferAttribute }[]>();

  /** @param order - source vertex of each vertex of the result */
  of(attribute: AnyAttribute, order: Uint32Array): BufferAttribute {
    const all = this.made.get(attribute) ?? [];
    this.made.set(attribute, all);
    const known = all.find((each) => isEqual(each.order, order));
    if (known) return known.gathered;
    const gathered = gather(attribute, order);
    all.push({ order, gathered });
    return gathered;
  }
}

/** Index (`Texture.channel`) of the first UV set after set 0 that no geometry uses; the last one when all are used. */
export function freeChannel(geometries: readonly BufferGeometry[]): number {
  const isFree = (channel: number): boolean => geometries.every((each) => !each.hasAttribute(`uv${channel}`));
  return [1, 2, 3].find(isFree) ?? 3;
}

/**
 * A copy of a geometry with one more UV set, its vertices split at chart borders. Groups and bounds are the source's.
 */
export function litGeometry(
  source: BufferGeometry,
  { uv1, index, sourceVertex }: Pick<UnwrappedMesh, 'uv1' | 'index' | 'sourceVertex'>,
  channel: number,
  attributes: GatheredAttributes,
): BufferGeometry {
  const lit = new BufferGeometry();
  lit.name = source.name;
  lit.userData = source.userData;
  for (const [name, attribute] of Object.entries(source.attributes)) {
    lit.setAttribute(name, attributes.of(attribute, sourceVertex));
  }
  for (const [name, targets] of Object.entries(source.morphAttributes)) {
    lit.morphAttributes[name as keyof typeof source.morphAttributes] = targets!.map((target) =>
      attributes.of(target, sourceVertex),
    );
  }
  lit.morphTargetsRelative = source.morphTargetsRelative;
  lit.setAttribute(`uv${channel}`, new BufferAttribute(uv1, 2));
  lit.setIndex(new BufferAttribute(index, 1));
  lit.groups = source.groups.map((group) => ({ ...group }));
  lit.boundingBox = source.boundingBox?.clone() ?? null;
  lit.boundingSphere = source.boundingSphere?.clone() ?? null;
  lit.setDrawRange(source.drawRange.start, source.drawRange.count);
  return lit;
}

function isEqual(a: Uint32Array, b: Uint32Array): boolean {
  return a === b || (a.length === b.length && a.every((value, i) => value === b[i]));
}

function gather(attribute: AnyAttribute, order: Uint32Array): BufferAttribute {
  const { itemSize, normalized } = attribute;
  const isInterleaved = attribute instanceof InterleavedBufferAttribute;
  const from = isInterleaved ? attribute.data.array : attribute.array;
  const stride = isInterleaved ? attribute.data.stride : itemSize;
  const start = isInterleaved ? attribute.offset : 0;
  const array = new (from.constructor as Float32ArrayConstructor)(order.length * itemSize);
  order.forEach((vertex, i) => {
    for (let k = 0; k < itemSize; k++) array[itemSize * i + k] = from[stride * vertex + start + k];
  });
  const gathered = new BufferAttribute(array, itemSize, normalized);
  if (!isInterleaved) gathered.gpuType = attribute.gpuType;
  return gathered;
}
