import type { BufferGeometry, Material, Scene as ThreeScene } from 'three';
import type { Scene } from '../../core/Scene';
import { InstanceGroup, type InstanceMember } from './InstanceGroup';

/** The ObjectRenderers of a scene that are drawn as instances, grouped by geometry, material and shadows. */
export class InstanceGroups {
  private readonly groups = new Map<string, InstanceGroup>();
  private readonly keys = new Map<InstanceMember, string>();

  constructor(private readonly root: ThreeScene) {}

  add(renderer: InstanceMember, geometry: BufferGeometry, material: Material): void {
    const shadows = { cast: renderer.castShadow, receive: renderer.receiveShadow };
    const key = [geometry.id, material.id, shadows.cast, shadows.receive].join();
    let group = this.groups.get(key);
    if (!group) this.groups.set(key, (group = new InstanceGroup(geometry, material, shadows)));
    group.members.add(renderer);
    this.keys.set(renderer, key);
  }

  remove(renderer: InstanceMember): void {
    const key = this.keys.get(renderer);
    const group = key === undefined ? undefined : this.groups.get(key);
    if (key === undefined || !group) return;
    this.keys.delete(renderer);
    group.members.remove(renderer);
    if (group.members.array.length > 0) return;
    group.dispose();
    this.groups.delete(key);
  }

  /** Copies the world matrices, which must be up to date, to the instanced meshes. */
  update(): void {
    for (const group of this.groups.values()) {
      const mesh = group.update();
      if (mesh.parent !== this.root) this.root.add(mesh);
    }
  }
}

const known = new WeakMap<Scene, InstanceGroups>();

/** The instances of a scene, brought up to date whenever its world matrices are. */
export function instanceGroupsOf(scene: Scene): InstanceGroups {
  let groups = known.get(scene);
  if (!groups) {
    groups = new InstanceGroups(scene.three);
    known.set(scene, groups);
    scene.onMatricesUpdated(groups.update.bind(groups));
  }
  return groups;
}
