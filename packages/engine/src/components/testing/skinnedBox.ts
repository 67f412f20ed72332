import {
  Bone,
  BoxGeometry,
  BufferAttribute,
  Group,
  MeshStandardMaterial,
  type Object3D,
  Skeleton,
  SkinnedMesh,
} from 'three';

const named = <T extends Object3D>(object: T, name: string): T => Object.assign(object, { name });

const material = new MeshStandardMaterial({ name: 'Plain' });

/** A box whose upper vertices follow the second of two bones. */
export function skinnedBox(name: string, bones: Bone[]): SkinnedMesh {
  const geometry = new BoxGeometry();
  const { count } = geometry.getAttribute('position');
  const indices = Array.from({ length: count * 4 }, (_, i) => (i % 4 === 0 ? 1 : 0));
  const weights = Array.from({ length: count * 4 }, (_, i) => (i % 4 === 0 ? 1 : 0));
  geometry.setAttribute('skinIndex', new BufferAttribute(new Uint16Array(indices), 4));
  geometry.setAttribute('skinWeight', new BufferAttribute(new Float32Array(weights), 4));
  const mesh = named(new SkinnedMesh(geometry, material), name);
  mesh.bind(new Skeleton(bones));
  return mesh;
}

export function armature(name: string): { top: Group; bones: Bone[] } {
  const top = named(new Group(), name);
  const bones = [named(new Bone(), `${name}-hip`), named(new Bone(), `${name}-head`)];
  bones[1].position.set(0, 1, 0);
  bones[0].add(bones[1]);
  top.add(bones[0]);
  return { top, bones };
}
