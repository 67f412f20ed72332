import { LightProbes, ProbeGrid, setBakedSurroundings } from '@farol/renderer/light-probes';
import {
  type BufferGeometry,
  DataTexture,
  HalfFloatType,
  LinearFilter,
  type Material,
  type Mesh,
  type Object3D,
  RGBAFormat,
} from 'three';
import type { RequiredEffect } from '../RequiredEffect';
import type { Scene } from '../Scene';
import type { BakeData, LightmapData, LightmappedMesh } from '../../assets/bake/BakeData';
import { fitsGeometry, lightmappedGeometry } from './lightmappedGeometry';
import { lightmappedMaterial, takesLightmap } from './lightmappedMaterial';
import { MovedObjects } from './MovedObjects';

type Materials = Material | Material[];

/** A lightmapped mesh with its original material and geometry. */
interface Dressed {
  readonly baked: LightmappedMesh;
  geometry: BufferGeometry;
  material: Materials;
  ownGeometry: BufferGeometry;
  ownMaterial: Materials;
}

/** Effect by which light probes light meshes without a lightmap. */
const probesEffect: RequiredEffect = { effectClass: LightProbes, load: () => Promise.resolve() };

function textureOf({ width, height, data }: LightmapData, channel: number): DataTexture {
  const texture = new DataTexture(data, width, height, RGBAFormat, HalfFloatType);
  texture.name = 'Lightmap';
  texture.channel = channel;
  texture.minFilter = texture.magFilter = LinearFilter;
  texture.needsUpdate = true;
  return texture;
}

const listOf = (materials: Materials): readonly Material[] => (Array.isArray(materials) ? materials : [materials]);

/** Displays baked light in one scene. */
export class ShownBake {
  private readonly textures: readonly DataTexture[];
  private readonly meshes = new Map<string, LightmappedMesh[]>();
  private readonly lights: ReadonlySet<string>;
  private readonly grid: ProbeGrid | null;
  private readonly dressed = new Map<Mesh, Dressed>();
  /** Materials with a lightmap, by their source material, then by the lightmap's index. */
  private readonly materials = new Map<Material, (Material | undefined)[]>();
  private readonly moved: MovedObjects;

  constructor(
    private readonly scene: Scene,
    private readonly data: BakeData,
  ) {
    this.textures = data.lightmaps.map((lightmap) => textureOf(lightmap, data.channel));
    this.lights = new Set(data.lights);
    for (const mesh of data.meshes) {
      const list = this.meshes.get(mesh.component);
      if (list) list.push(mesh);
      else this.meshes.set(mesh.component, [mesh]);
    }
    const { probes, hasSky } = data;
    this.grid = probes && new ProbeGrid(probes.box, probes.coefficients);
    setBakedSurroundings(scene.three, { grid: this.grid, hasSky });
    scene.useEffect(probesEffect, true);
    this.moved = new MovedObjects(scene, this.dressed);
  }

  /** Whether all light of a Light component is baked. @param light - id of the component */
  hides(light: string): boolean {
    return this.lights.has(light);
  }

  /** Gives the meshes below `root`, which a component draws, their lightmaps. @param component - its id */
  dress(component: string, root: Object3D): void {
    const list = this.meshes.get(component);
    if (!list) return;
    let part = 0;
    root.traverse((object) => {
      if (!('isMesh' in object)) return;
      const baked = list.find((each) => each.part === part);
      part++;
      if (baked) this.dressMesh(object as Mesh, baked);
    });
  }

  /** Restores the original materials and geometries of the meshes below `root`. */
  undress(root: Object3D): void {
    root.traverse((object) => {
      const mesh = object as Mesh;
      const dressed = this.dressed.get(mesh);
      if (dressed) this.undressMesh(mesh, dressed);
    });
  }

  /** Removes the baked light from the scene. */
  end(): void {
    for (const [mesh, dressed] of [...this.dressed]) this.undressMesh(mesh, dressed);
    for (const [source, made] of [...this.materials]) this.forget(source, made);
    for (const texture of this.textures) texture.dispose();
    this.grid?.dispose();
    this.moved.end();
    setBakedSurroundings(this.scene.three, null);
    this.scene.useEffect(probesEffect, false);
  }

  private dressMesh(mesh: Mesh, baked: LightmappedMesh): void {
    const dressed = this.dressed.get(mesh);
    if (dressed && mesh.geometry === dressed.geometry && mesh.material === dressed.material) return;
    const own = dressed && mesh.geometry === dressed.geometry ? dressed.ownGeometry : mesh.geometry;
    const ownMaterial = dressed && mesh.material === dressed.material ? dressed.ownMaterial : mesh.material;
    if (!fitsGeometry(own, baked) || !listOf(ownMaterial).every(takesLightmap)) {
      if (dressed) this.undressMesh(mesh, dressed);
      return;
    }
    const geometry =
      dressed?.ownGeometry === own ? dressed.geometry : lightmappedGeometry(own, baked, this.data.channel);
    if (dressed && dressed.geometry !== geometry) dressed.geometry.dispose();
    const material = Array.isArray(ownMaterial)
      ? ownMaterial.map((each) => this.materialFor(each, baked.lightmap))
      : this.materialFor(ownMaterial, baked.lightmap);
    mesh.geometry = geometry;
    mesh.material = material;
    this.dressed.set(mesh, { baked, geometry, material, ownGeometry: own, ownMaterial });
    this.moved.changed();
  }

  private undressMesh(mesh: Mesh, dressed: Dressed): void {
    if (mesh.geometry === dressed.geometry) mesh.geometry = dressed.ownGeometry;
    if (mesh.material === dressed.material) mesh.material = dressed.ownMaterial;
    dressed.geometry.dispose();
    this.dressed.delete(mesh);
    this.moved.changed();
  }

  private materialFor(source: Material, lightmap: number): Material {
    let made = this.materials.get(source);
    if (!made) {
      this.materials.set(source, (made = []));
      source.addEventListener('dispose', this.sourceDisposed);
    }
    return (made[lightmap] ??= lightmappedMaterial(source, this.textures[lightmap]));
  }

  private readonly sourceDisposed = ({ target }: { target: Material }): void => {
    const made = this.materials.get(target);
    if (made) this.forget(target, made);
  };

  private forget(source: Material, made: readonly (Material | undefined)[]): void {
    source.removeEventListener('dispose', this.sourceDisposed);
    this.materials.delete(source);
    for (const material of made) material?.dispose();
  }
}
