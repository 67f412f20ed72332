import { asset, type FieldTable, type FieldValue } from '@farol/editing/fields';
import { surfaceCode } from '../assets/surfaceCode';
import type { LayeredMaterial } from '../assets/LayeredMaterial';
import type { LayerUser } from '../assets/LayeredMaterials';
import type { SurfaceAsset } from '../assets/SurfaceAsset';
import { surfaceMaps, surfaceValueFields, UNIFORM } from '../assets/uniformFields';
import type { Component } from '../core/Component';
import type { Scene } from '../core/Scene';
import { StoredViews, type ViewSource } from '../fields/StoredViews';
import { type Material, type Mesh, Sphere } from 'three';

/** Fields of a component with a surface of its own. */
export const objectSurfaceFields = {
  surface: asset('surface', null, {
    help: 'Waves, rust, snow and the like for this object alone, over the effect of its material. It has values of its own.',
    label: 'Surface effect',
  }),
  ...surfaceValueFields,
};

type Bounded = Mesh & { boundingSphere?: Sphere | null };

/**
 * Surface that a component puts on top of its meshes' materials. Objects of one material, surface and values share a
 * material; while simulation changes a value, the object has a material of its own, so that only uniforms are written.
 */
export class ObjectSurface implements LayerUser {
  readonly views: StoredViews;
  private worn: LayeredMaterial[] = [];
  /** Whether simulation has changed the values, so that the object has a material of its own. */
  private isOwn = false;

  /**
   * @param owner - has `objectSurfaceFields`
   * @param declared - all fields of the owner
   * @param refresh - makes the owner apply materials again
   * @param reachChanged - called when the greatest displacement of vertices changed
   * @param views - returns the owner's field views other than those of uniforms
   */
  constructor(
    private readonly owner: Component,
    declared: FieldTable,
    private readonly refresh: () => void,
    private readonly reachChanged: () => void,
    views: readonly ViewSource[] = [],
  ) {
    this.views = new StoredViews(owner, declared, [() => this.asset?.uniformFields ?? null, ...views]);
  }

  get surfaceName(): string | null {
    return this.owner.getAuthored('surface') as string | null;
  }

  surfaceChanged(): void {
    this.refresh();
  }

  /**
   * Applies materials to meshes.
   * @param dress - called with `wear`, which returns the material to draw with: `source` itself where there is no
   *   surface
   */
  dress(scene: Scene, dress: (wear: (source: Material) => Material) => void): void {
    const { layered } = scene.assets;
    const before = this.worn;
    this.worn = [];
    const code = surfaceCode.code;
    const worn = this.surfaceName === null ? null : this.asset;
    if (this.surfaceName === null) layered.users.delete(this);
    else layered.users.add(this);
    dress((source) => {
      if (!code || !worn?.surface || !code.canWearSurface(source)) return source;
      const known = this.worn.find((each) => each.source === source);
      if (known) return known.material;
      const old = before.find((each) => each.source === source);
      const made = layered.acquire(source, worn, this.values(), this.isOwn, old);
      this.worn.push(made);
      if (this.isOwn) for (const name of Object.keys(worn.uniformFields)) made.write(name, this.owner.get(name));
      return made.material;
    });
    for (const each of before) layered.release(each);
  }

  /** Releases the layered materials. */
  end(scene: Scene): void {
    const { layered } = scene.assets;
    layered.users.delete(this);
    for (const each of this.worn) layered.release(each);
    this.worn = [];
    this.isOwn = false;
  }

  /** Applies a changed field of the component. @returns whether the field is a uniform's */
  fieldChanged(name: string): boolean {
    if (!name.startsWith(UNIFORM)) return false;
    const { owner, worn } = this;
    if (this.simulationChanged() || !this.views.has(name)) return true;
    const value = owner.get(name);
    for (let i = 0; i < worn.length; i++) worn[i].write(name, value);
    if (worn.length > 0 && worn[0].asset.surface!.displaces) this.reachChanged();
    return true;
  }

  /** Returns from materials of its own to shared ones, when the simulation has ended. */
  simulationEnded(): void {
    if (this.isOwn) this.simulationChanged();
  }

  /** Switches between shared and own materials as simulation begins or ends. @returns whether it switched */
  private simulationChanged(): boolean {
    if (this.isOwn === this.owner.isSimulated) return false;
    this.isOwn = this.owner.isSimulated;
    this.refresh();
    return true;
  }

  private get asset(): SurfaceAsset | null {
    const name = this.surfaceName;
    return name === null ? null : (this.owner.scene?.assets.surface(name) ?? null);
  }

  private values(): { text: string; maps: readonly (string | null)[] } {
    const get = (name: string): FieldValue => this.owner.getAuthored(name);
    return { text: get('surfaceValues') as string, maps: surfaceMaps.map((name) => get(name) as string | null) };
  }
}

/**
 * Sets a mesh's frustum culling and bounding sphere by how far its surfaces may displace vertices.
 * @param isCulled - whether a mesh without displacement is frustum culled
 */
export function fitBounds(mesh: Mesh, isCulled = true): void {
  const { material, geometry } = mesh;
  const bounded = mesh as Bounded;
  const code = surfaceCode.code;
  let reach = 0;
  if (!Array.isArray(material)) reach = code?.surfaceReach(material) ?? 0;
  else for (const each of material) reach = Math.max(reach, code?.surfaceReach(each) ?? 0);
  // the meshes whose own bounding sphere three computes, without displacement: they are never culled if displaced
  const hasOwn = 'isSkinnedMesh' in mesh || 'isInstancedMesh' in mesh || 'isBatchedMesh' in mesh;
  mesh.frustumCulled = isCulled && (hasOwn ? reach === 0 : reach !== Infinity);
  if (hasOwn) return;
  if (reach === 0 || reach === Infinity) {
    if (bounded.boundingSphere) bounded.boundingSphere = undefined;
    return;
  }
  if (geometry.boundingSphere === null) geometry.computeBoundingSphere();
  bounded.boundingSphere ??= new Sphere();
  bounded.boundingSphere.copy(geometry.boundingSphere!);
  bounded.boundingSphere.radius += reach;
}
