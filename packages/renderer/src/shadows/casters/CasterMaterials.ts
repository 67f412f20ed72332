import {
  BackSide,
  DoubleSide,
  FrontSide,
  type InstancedMesh,
  type Light,
  type Material,
  type Mesh,
  MeshDepthMaterial,
  MeshDistanceMaterial,
  type MeshStandardMaterial,
  type Object3D,
  type Side,
  type WebGLRenderer,
} from 'three';
import { surfacesOf, type WornSurfaces } from '../../materials/surfacesOf';
import type { MicroShaderRegistry } from '../../microshaders';
import { setLightOf } from '../../three/handles';

const SHADOW_SIDES: Record<Side, Side> = { [FrontSide]: BackSide, [BackSide]: FrontSide, [DoubleSide]: DoubleSide };

/** The side (three's `Side`) of a caster that is drawn into maps; `bothSides` as for `CasterMaterials.get`. */
export function shadowSideOf({ side, shadowSide }: Material, bothSides: boolean): Side {
  return shadowSide ?? (bothSides ? side : SHADOW_SIDES[side]);
}

type AnyMaterial = MeshStandardMaterial & { isMeshDistanceMaterial?: boolean };
type CasterMaterial = MeshDepthMaterial | MeshDistanceMaterial;

/** Materials for one kind of output: depths or distances. */
interface CasterMaterialSet {
  /** Materials shared by all casters that need the same program, see `sharedFor`. */
  readonly shared: CasterMaterial[];
  /** Materials of casters whose own material, the key, discards fragments or displaces vertices. */
  readonly unique: Map<Material, CasterMaterial>;
  /** Materials of casters whose own material, the key, has Farol surfaces that discard or displace. */
  readonly worn: Map<Material, CasterMaterial>;
}

type AnyMesh = Mesh & Partial<InstancedMesh> & { isSkinnedMesh?: boolean; isBatchedMesh?: boolean };

/**
 * The materials that casters are drawn with into a shadow map: the object's own depth material if it has one, else one that
 * copies the same properties of the caster's material as three's WebGLShadowMap. One program for each kind of mesh (instanced,
 * skinned…), and one more for each material that discards or displaces.
 */
export class CasterMaterials {
  private readonly depths: CasterMaterialSet = { shared: [], unique: new Map(), worn: new Map() };
  /** Materials that write linear distances instead of depths, for point lights when the depth buffer is logarithmic. */
  private readonly distances: CasterMaterialSet = { shared: [], unique: new Map(), worn: new Map() };

  constructor(
    private readonly webgl: WebGLRenderer,
    private readonly microshaders: MicroShaderRegistry,
  ) {}

  /**
   * @param light - light whose map is drawn
   * @param bothSides - whether to draw the sides that pictures show, as three does for variance shadow maps
   */
  get(object: Object3D, source: Material, light: Light, bothSides: boolean): Material {
    const isPoint = (light as Light & { isPointLight?: boolean }).isPointLight === true;
    const own = isPoint ? object.customDistanceMaterial : object.customDepthMaterial;
    const set = isPoint && this.webgl.capabilities.logarithmicDepthBuffer ? this.distances : this.depths;
    const result = (own ?? this.materialOf(object, source, set)) as AnyMaterial;
    const m = source as AnyMaterial;
    result.visible = m.visible;
    result.wireframe = m.wireframe;
    result.side = shadowSideOf(m, bothSides);
    result.alphaMap = m.alphaMap;
    result.alphaTest = m.alphaToCoverage ? 0.5 : m.alphaTest;
    result.map = m.map;
    result.clipShadows = m.clipShadows;
    result.clippingPlanes = m.clippingPlanes;
    result.clipIntersection = m.clipIntersection;
    result.displacementMap = m.displacementMap;
    result.displacementScale = m.displacementScale;
    result.displacementBias = m.displacementBias;
    result.wireframeLinewidth = m.wireframeLinewidth;
    (result as AnyMaterial & { linewidth: number }).linewidth = (m as AnyMaterial & { linewidth: number }).linewidth;
    if (isPoint && result.isMeshDistanceMaterial === true) setLightOf(this.webgl, result, light);
    return result;
  }

  dispose(): void {
    for (const { shared, unique, worn } of [this.depths, this.distances]) {
      for (const material of shared) material?.dispose();
      for (const target of [...unique.keys(), ...worn.keys()]) this.forget({ target });
      shared.length = 0;
    }
  }

  private materialOf(object: Object3D, source: Material, set: CasterMaterialSet): CasterMaterial {
    const surfaces = surfacesOf(source);
    if (surfaces !== undefined && (surfaces.displaces || surfaces.discards)) return this.wornBy(source, surfaces, set);
    const needsOwn = this.needsOwn(source as AnyMaterial);
    return needsOwn ? this.uniqueFor(source, set) : this.sharedFor(object as AnyMesh, set);
  }

  /** True for materials that need their own depth material, since they discard or displace. */
  private needsOwn(m: AnyMaterial): boolean {
    return Boolean(
      (this.webgl.localClippingEnabled && m.clipShadows && m.clippingPlanes !== null && m.clippingPlanes.length > 0) ||
      (m.displacementMap && m.displacementScale !== 0) ||
      ((m.alphaMap || m.map) && m.alphaTest > 0) ||
      m.alphaToCoverage,
    );
  }

  /**
   * Shared material for the mesh's kind (instanced, skinned…). Meshes that need different programs have different materials, so
   * that three does not look the program up at each draw.
   */
  private sharedFor(mesh: AnyMesh, { shared }: CasterMaterialSet): CasterMaterial {
    const program =
      (mesh.isInstancedMesh ? 1 : 0) +
      (mesh.isSkinnedMesh ? 2 : 0) +
      (mesh.isBatchedMesh ? 4 : 0) +
      (mesh.geometry.morphAttributes.position ? 8 : 0) +
      (mesh.isInstancedMesh && mesh.instanceColor ? 16 : 0);
    return (shared[program] ??= this.make(shared));
  }

  private uniqueFor(source: Material, { shared, unique }: CasterMaterialSet): CasterMaterial {
    let material = unique.get(source);
    if (material === undefined) {
      unique.set(source, (material = this.make(shared)));
      source.addEventListener('dispose', this.forget); // three ignores a second listener that is the same
    }
    return material;
  }

  private wornBy(source: Material, surfaces: WornSurfaces, { shared, worn }: CasterMaterialSet): CasterMaterial {
    let material = worn.get(source);
    if (material === undefined) {
      const { microshaders } = this;
      material = this.make(shared);
      material.name = source.name;
      material.onBeforeCompile = (shader, webgl) => surfaces.rewrite(shader, microshaders, webgl);
      material.customProgramCacheKey = () => `farol:caster:${surfaces.key(microshaders)}`;
      Object.defineProperty(material, 'version', { get: () => surfaces.version(microshaders), set() {} });
      worn.set(source, material);
      source.addEventListener('dispose', this.forget); // three ignores a second listener that is the same
    }
    return material;
  }

  private readonly forget = ({ target }: { target: Material }) => {
    target.removeEventListener('dispose', this.forget);
    for (const { unique, worn } of [this.depths, this.distances]) {
      unique.get(target)?.dispose();
      worn.get(target)?.dispose();
      unique.delete(target);
      worn.delete(target);
    }
  };

  private make(shared: CasterMaterial[]): CasterMaterial {
    const material = shared === this.distances.shared ? new MeshDistanceMaterial() : new MeshDepthMaterial();
    material.colorWrite = false;
    return material;
  }
}
