import type { BufferGeometry, Light, Material, Mesh, Scene, Texture } from 'three';
import type { BakedMesh } from '../Bake';
import { takesLightmap } from '../scene/collectMeshes';
import { GatheredAttributes, litGeometry } from './litGeometry';
import { type LitMaterial, litMaterial } from './litMaterial';

interface Dressed {
  readonly baked: BakedMesh;
  readonly geometry: BufferGeometry;
  readonly material: Material | Material[];
  /** Geometry and material of the mesh before the bake; null once restored. */
  before: { geometry: BufferGeometry; material: Material | Material[] } | null;
}

/**
 * Gives meshes geometries and materials with lightmaps in place of their own, and switches off the lights that the
 * lightmaps contain.
 */
export class AppliedBake {
  private readonly dressed: Dressed[];
  private readonly hidden = new Map<Light, number>();
  private readonly lit: { lightmap: number; lit: LitMaterial }[] = [];
  private applied = false;

  /**
   * @param lights - lights that are switched off while the bake is applied
   * @param textures - one per lightmap; owned by the caller
   * @param channel - index of the textures' UV set
   * @param skyOf - see {@link litMaterial}
   */
  constructor(
    meshes: readonly BakedMesh[],
    private readonly lights: readonly Light[],
    textures: readonly Texture[],
    channel: number,
    skyOf: Scene | null,
  ) {
    const attributes = new GatheredAttributes();
    const materials = new Map<string, Material>();
    this.dressed = meshes.map((baked) => {
      const { geometry, material } = baked.mesh;
      const dress = (source: Material): Material => {
        if (!source || !takesLightmap(source)) return source;
        const key = `${source.id} ${baked.lightmap}`;
        const known = materials.get(key);
        if (known) return known;
        const lit = litMaterial(source, textures[baked.lightmap], skyOf);
        this.lit.push({ lightmap: baked.lightmap, lit });
        materials.set(key, lit.material);
        return lit.material;
      };
      return {
        baked,
        geometry: litGeometry(geometry, baked, channel, attributes),
        material: Array.isArray(material) ? material.map(dress) : dress(material),
        before: null,
      };
    });
  }

  get isApplied(): boolean {
    return this.applied;
  }

  apply(): void {
    if (this.applied) return;
    this.applied = true;
    for (const each of this.dressed) {
      const { mesh } = each.baked;
      each.before = { geometry: mesh.geometry, material: mesh.material };
      mesh.geometry = each.geometry;
      mesh.material = each.material;
    }
    // a light is moved to no layer rather than hidden, so that its children stay visible
    for (const light of this.lights) {
      this.hidden.set(light, light.layers.mask);
      light.layers.mask = 0;
    }
  }

  remove(): void {
    if (!this.applied) return;
    this.applied = false;
    for (const { baked, geometry, material, before } of this.dressed) {
      const mesh: Mesh = baked.mesh;
      // a geometry or material that other code has assigned since `apply` stays
      if (mesh.geometry === geometry) mesh.geometry = before!.geometry;
      if (mesh.material === material) mesh.material = before!.material;
    }
    for (const [light, mask] of this.hidden) if (light.layers.mask === 0) light.layers.mask = mask;
    this.hidden.clear();
  }

  /** Replaces the lightmaps, for instance by those of a later stage of the bake. */
  setTextures(textures: readonly Texture[]): void {
    for (const { lightmap, lit } of this.lit) lit.setLightmap(textures[lightmap]);
  }

  /** Restores the meshes and lights, and frees geometries and materials; the textures are freed by their owner. */
  dispose(): void {
    this.remove();
    for (const { geometry } of this.dressed) geometry.dispose();
    for (const { lit } of this.lit) lit.material.dispose();
  }
}
