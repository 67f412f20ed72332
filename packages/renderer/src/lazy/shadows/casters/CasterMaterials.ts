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

const SHADOW_SIDES: Record<Side, Side> = { [FrontSide]: BackSide, [BackSide]: FrontSide, [DoubleSide]: DoubleSide };

/** The sides of a material that cast its shadow; `bothSides` as for `CasterMaterials.get`. */
export function shadowSideOf({ side, shadowSide }: Material, bothSides: boolean): Side {
  return shadowSide ?? (bothSides ? side : SHADOW_SIDES[side]);
}

type AnyMaterial = MeshStandardMaterial & { isMeshDistanceMaterial?: boolean };
type CasterMaterial = MeshDepthMaterial | MeshDistanceMaterial;

/** Materials of one kind, by kind of mesh, and of those that need one of their own. */
interface Kinds {
  readonly shared: CasterMaterial[];
  readonly unique: Map<Material, CasterMaterial>;
}

type AnyMesh = Mesh & Partial<InstancedMesh> & { isSkinnedMesh?: boolean; isBatchedMesh?: boolean };

/**
 * The materials that casters are drawn with into a shadow map: the object's own depth material if it has one, else one
 * that takes from the caster's material what three's WebGLShadowMap takes. One program a kind of mesh, and one more for
 * each material that discards or displaces.
 */
export class CasterMaterials {
  private readonly depths: Kinds = { shared: [], unique: new Map() };
  /** Where depth is logarithmic, for point lights alone: these keep it as it is. */
  private readonly distances: Kinds = { shared: [], unique: new Map() };

  constructor(private readonly webgl: WebGLRenderer) {}

  /**
   * @param light whose shadow it is
   * @param bothSides as three has it for variance shadow maps: the sides that are seen cast the shadow
   */
  get(object: Object3D, source: Material, light: Light, bothSides: boolean): Material {
    const isPoint = (light as Light & { isPointLight?: boolean }).isPointLight === true;
    const own = isPoint ? object.customDistanceMaterial : object.customDepthMaterial;
    const kinds = isPoint && this.webgl.capabilities.logarithmicDepthBuffer ? this.distances : this.depths;
    const result = (own ?? this.materialOf(object, source, kinds)) as AnyMaterial;
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
    if (isPoint && result.isMeshDistanceMaterial === true) {
      (this.webgl.properties.get(result) as { light?: Light }).light = light;
    }
    return result;
  }

  dispose(): void {
    for (const { shared, unique } of [this.depths, this.distances]) {
      for (const material of shared) material?.dispose();
      for (const target of unique.keys()) this.forget({ target });
      shared.length = 0;
    }
  }

  private materialOf(object: Object3D, source: Material, kinds: Kinds): CasterMaterial {
    const needsOwn = this.needsOwn(source as AnyMaterial);
    return needsOwn ? this.uniqueFor(source, kinds) : this.sharedFor(object as AnyMesh, kinds);
  }

  /** True for what discards or displaces. */
  private needsOwn(m: AnyMaterial): boolean {
    return Boolean(
      (this.webgl.localClippingEnabled && m.clipShadows && m.clippingPlanes !== null && m.clippingPlanes.length > 0) ||
      (m.displacementMap && m.displacementScale !== 0) ||
      ((m.alphaMap || m.map) && m.alphaTest > 0) ||
      m.alphaToCoverage,
    );
  }

  /** Meshes whose programs differ have materials of their own, so that three need not look for the program each time. */
  private sharedFor(mesh: AnyMesh, { shared }: Kinds): CasterMaterial {
    const kind =
      (mesh.isInstancedMesh ? 1 : 0) +
      (mesh.isSkinnedMesh ? 2 : 0) +
      (mesh.isBatchedMesh ? 4 : 0) +
      (mesh.geometry.morphAttributes.position ? 8 : 0) +
      (mesh.isInstancedMesh && mesh.instanceColor ? 16 : 0);
    return (shared[kind] ??= this.make(shared));
  }

  private uniqueFor(source: Material, { shared, unique }: Kinds): CasterMaterial {
    let material = unique.get(source);
    if (material === undefined) {
      unique.set(source, (material = this.make(shared)));
      source.addEventListener('dispose', this.forget); // three adds a listener once
    }
    return material;
  }

  private readonly forget = ({ target }: { target: Material }) => {
    target.removeEventListener('dispose', this.forget);
    for (const { unique } of [this.depths, this.distances]) {
      unique.get(target)?.dispose();
      unique.delete(target);
    }
  };

  private make(shared: Kinds['shared']): CasterMaterial {
    const material = shared === this.distances.shared ? new MeshDistanceMaterial() : new MeshDepthMaterial();
    material.colorWrite = false;
    return material;
  }
}
