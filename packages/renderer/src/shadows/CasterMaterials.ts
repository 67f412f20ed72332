import {
  BackSide,
  DoubleSide,
  FrontSide,
  type InstancedMesh,
  type Light,
  type Material,
  type Mesh,
  MeshDepthMaterial,
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
type AnyMesh = Mesh & Partial<InstancedMesh> & { isSkinnedMesh?: boolean; isBatchedMesh?: boolean };

/**
 * The materials that casters are drawn with into a shadow map: the object's own depth material if it has one, else one
 * that takes from the caster's material what three's WebGLShadowMap takes. One program a kind of mesh, and one more for
 * each material that discards or displaces.
 */
export class CasterMaterials {
  private readonly shared: MeshDepthMaterial[] = [];
  private readonly unique = new Map<Material, MeshDepthMaterial>();

  constructor(private readonly webgl: WebGLRenderer) {}

  /**
   * @param light whose shadow it is
   * @param bothSides as three has it for variance shadow maps: the sides that are seen cast the shadow
   */
  get(object: Object3D, source: Material, light: Light, bothSides: boolean): Material {
    const isPoint = (light as Light & { isPointLight?: boolean }).isPointLight === true;
    const own = isPoint ? object.customDistanceMaterial : object.customDepthMaterial;
    const result = (own ?? this.depthMaterial(object, source)) as AnyMaterial;
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
    for (const material of this.shared) material?.dispose();
    for (const material of this.unique.values()) material.dispose();
    this.shared.length = 0;
    this.unique.clear();
  }

  private depthMaterial(object: Object3D, source: Material): MeshDepthMaterial {
    return this.needsOwn(source as AnyMaterial) ? this.uniqueFor(source) : this.sharedFor(object as AnyMesh);
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
  private sharedFor(mesh: AnyMesh): MeshDepthMaterial {
    const kind =
      (mesh.isInstancedMesh ? 1 : 0) +
      (mesh.isSkinnedMesh ? 2 : 0) +
      (mesh.isBatchedMesh ? 4 : 0) +
      (mesh.geometry.morphAttributes.position ? 8 : 0) +
      (mesh.isInstancedMesh && mesh.instanceColor ? 16 : 0);
    return (this.shared[kind] ??= makeMaterial());
  }

  private uniqueFor(source: Material): MeshDepthMaterial {
    let material = this.unique.get(source);
    if (material === undefined) {
      material = makeMaterial();
      this.unique.set(source, material);
      const onDispose = () => {
        source.removeEventListener('dispose', onDispose);
        this.unique.get(source)?.dispose();
        this.unique.delete(source);
      };
      source.addEventListener('dispose', onDispose);
    }
    return material;
  }
}

function makeMaterial(): MeshDepthMaterial {
  const material = new MeshDepthMaterial();
  material.colorWrite = false;
  return material;
}
