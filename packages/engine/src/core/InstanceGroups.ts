import { type BufferGeometry, type Material, Scene as ThreeScene } from 'three';
import type { ObjectRenderer } from '../components/ObjectRenderer';
import { InstanceGroup } from './InstanceGroup';

/** The three scene of a Scene: it brings its instances up to date after all world matrices. */
class SceneRoot extends ThreeScene {
  constructor(private readonly groups: InstanceGroups) {
    super();
  }

  override updateMatrixWorld(force?: boolean): void {
    super.updateMatrixWorld(force);
    this.groups.update();
  }
}

/** The ObjectRenderers of a scene that are drawn as instances, grouped by geometry, material and shadows. */
export class InstanceGroups {
  readonly root: ThreeScene = new SceneRoot(this);

  private readonly groups = new Map<string, InstanceGroup>();
  private readonly keys = new Map<ObjectRenderer, string>();

  /** How many groups, so how many draw calls, there are. */
  get size(): number {
    return this.groups.size;
  }

  add(renderer: ObjectRenderer, geometry: BufferGeometry, material: Material): void {
    const shadows = { cast: renderer.castShadow, receive: renderer.receiveShadow };
    const key = [geometry.id, material.id, shadows.cast, shadows.receive].join();
    let group = this.groups.get(key);
    if (!group) this.groups.set(key, (group = new InstanceGroup(geometry, material, shadows)));
    group.members.add(renderer);
    this.keys.set(renderer, key);
  }

  remove(renderer: ObjectRenderer): void {
    const key = this.keys.get(renderer);
    const group = key === undefined ? undefined : this.groups.get(key);
    if (key === undefined || !group) return;
    this.keys.delete(renderer);
    group.members.remove(renderer);
    if (group.members.array.length > 0) return;
    group.dispose();
    this.groups.delete(key);
  }

  /** Called when the world matrices are up to date. */
  update(): void {
    for (const group of this.groups.values()) {
      const mesh = group.update();
      if (mesh.parent !== this.root) this.root.add(mesh);
    }
  }
}
