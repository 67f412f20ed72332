import type { FieldValue, Vector3Tuple } from '@farol/editing/fields';
import {
  BackSide,
  ClampToEdgeWrapping,
  DoubleSide,
  FrontSide,
  type Material,
  MirroredRepeatWrapping,
  type MeshPhysicalMaterial,
  RepeatWrapping,
  type Texture,
} from 'three';
import type { AssetNames, FieldViews } from '../fields/FieldOwner';
import { entryOf, readStored, storedValue } from '../fields/storedValues';
import { StoredViews } from '../fields/StoredViews';
import { FieldAsset, type FieldAssetHost } from './FieldAsset';
import { makeMaterial, writeMaterialValues } from './makeMaterial';
import { materialAssetFields } from './materialAssetFields';
import { materialFields, type MaterialValues } from './materialFields';
import { type MaterialMap, type MaterialMapName, materialMapNames, materialMaps } from './materialMaps';
import { MaterialTexture } from './MaterialTexture';
import type { SurfaceAsset } from './SurfaceAsset';
import { surfaceCode } from './surfaceCode';
import { surfaceMaps, uniformValues } from './uniformFields';
import { writeSurfaceMaps } from './writeSurfaceMaps';

/** Part of an AssetLibrary that MaterialAsset uses. */
export interface MaterialHost extends FieldAssetHost {
  isReady(type: 'texture', name: string): boolean;
  whenReady(type: 'texture', name: string, callback: () => void): void;
  texture(name: string): Texture;
  surface(name: string): SurfaceAsset | null;
  /** @internal Called when the surface (GLSL) of a material was replaced. */
  materialWears(material: Material): void;
  /** @internal */
  materialShapeChanged(name: string): void;
}

const wraps = { repeat: RepeatWrapping, mirror: MirroredRepeatWrapping, clamp: ClampToEdgeWrapping };

/** Property of three's MeshPhysicalMaterial for each field that is copied unchanged. */
const numbers: Readonly<Record<string, keyof MeshPhysicalMaterial>> = {
  sheen: 'sheen',
  sheenRoughness: 'sheenRoughness',
  iridescence: 'iridescence',
  iridescenceIor: 'iridescenceIOR',
  anisotropy: 'anisotropy',
  anisotropyRotation: 'anisotropyRotation',
  thickness: 'thickness',
  dispersion: 'dispersion',
  specularIntensity: 'specularIntensity',
  diffuseRoughness: 'diffuseRoughness' as keyof MeshPhysicalMaterial,
  retroreflectivity: 'retroreflectivity' as keyof MeshPhysicalMaterial,
};

/** Properties of MeshPhysicalMaterial for which three compiles another program when they are above 0. */
const lobes = [
  'clearcoat',
  'sheen',
  'iridescence',
  'anisotropy',
  'transmission',
  'dispersion',
  'diffuseRoughness',
  'retroreflectivity',
];

/**
 * A material of a library, made of field values, which any number of objects share: changing a field changes all of
 * them. Made by `AssetLibrary.addMaterial`; kept in files.
 */
export class MaterialAsset extends FieldAsset {
  static readonly fields = materialAssetFields;
  override readonly type = 'material';

  private material: Material | null = null;
  private readonly textures = new Map<MaterialMapName, MaterialTexture>();
  private host: MaterialHost | null = null;
  private readonly uniformViews = new StoredViews(this, materialAssetFields, [() => this.worn?.uniformFields ?? null]);

  /**
   * @param values - in place of the defaults; named textures need not exist yet
   * @throws FieldError for a value that is not allowed
   */
  constructor(host: MaterialHost, name: string, values: Readonly<Record<string, FieldValue>> = {}) {
    super(name);
    for (const field of Object.keys(values)) this.set(field, values[field]);
    this.host = host;
  }

  override get ownerName(): string {
    return this.name ?? 'Material';
  }

  /** Fields for the surface's uniforms, such as 'surface.height': views of parts of `surfaceValues`. */
  override get fieldViews(): FieldViews | undefined {
    return this.uniformViews;
  }

  /** three's material; replaced after a change of `kind`. */
  get three(): Material {
    if (!this.material) {
      this.material = makeMaterial(this.get('kind') as MaterialValues['kind']);
      this.material.name = this.name;
      this.write();
    }
    return this.material;
  }

  /** Frees the GPU memory; drawing again uploads again. */
  override dispose(): void {
    this.material?.dispose();
    for (const texture of this.textures.values()) texture.dispose();
  }

  /** @internal Called when the material's surface, or the surface's text, changed. */
  surfaceChanged(): void {
    if (this.material) this.writeSurface(this.material);
  }

  private get worn(): SurfaceAsset | null {
    // called from the constructor, before the fields have values
    const name = this.host ? (this.getAuthored('surface') as string | null) : null;
    return name === null ? null : this.host!.surface(name);
  }

  protected override get assetNames(): AssetNames | null {
    return this.host;
  }

  protected override fieldChanged(name: string, before: FieldValue): void {
    if (!this.host) return;
    const replaced = name === 'kind' ? this.material : null;
    if (replaced) {
      this.material = null;
      replaced.dispose();
    } else if (this.material) this.write();
    this.host.fieldAssetChanged(this, name, before, replaced !== null);
  }

  /** Writes every field to three's material; textures are set once loaded. */
  private write(): void {
    const material = this.material as MeshPhysicalMaterial | null;
    if (!material) return;
    const before = this.programState(material);
    const get = <T extends FieldValue>(name: string): T => this.get(name) as T;
    writeMaterialValues(material, this.sharedValues());
    material.depthWrite = get('depthWrite');
    material.side = get('doubleSided') ? DoubleSide : get('side') === 'back' ? BackSide : FrontSide;
    for (const name of materialMapNames) {
      const map: MaterialMap = materialMaps[name];
      if (map.property in material) Object.assign(material, { [map.property]: this.textureOf(name, map) });
    }
    material.aoMapIntensity = get('aoIntensity');
    material.lightMapIntensity = get('lightMapIntensity');
    if ('normalScale' in material) {
      material.normalScale.set(1, get('normalFlip') ? -1 : 1).multiplyScalar(get('normalScale'));
      material.bumpScale = get('bumpScale');
      material.displacementScale = get('displacementScale');
      material.displacementBias = get('displacementBias');
    }
    if ('isMeshPhysicalMaterial' in material) {
      for (const field in numbers) Object.assign(material, { [numbers[field]]: this.get(field) });
      const flip = get('clearcoatNormalFlip') ? -1 : 1;
      material.clearcoatNormalScale.set(1, flip).multiplyScalar(get('clearcoatNormalScale'));
      material.sheenColor.setRGB(...get<Vector3Tuple>('sheenColour'));
      material.attenuationColor.setRGB(...get<Vector3Tuple>('attenuationColour'));
      material.specularColor.setRGB(...get<Vector3Tuple>('specularColour'));
      material.attenuationDistance = get<number>('attenuationDistance') || Infinity;
      setFilmThickness(material, get('iridescenceThicknessMin'), get('iridescenceThicknessMax'));
    }
    if (this.programState(material) !== before) material.needsUpdate = true;
    this.writeSurface(material);
  }

  /** Applies the surface to three's material, once the renderer's late code is loaded. */
  private writeSurface(material: Material): void {
    const code = surfaceCode.code;
    if (!code) return;
    const { host, worn } = this;
    const surface = worn?.surface ?? null;
    const stored = readStored(this.get('surfaceValues') as string);
    const before = code.getSurfaces(material)[0]?.surface ?? null;
    if (surface === null && before === null) return;
    const uniforms = surface?.uniforms ?? [];
    const values = code.setSurface(
      material,
      surface,
      uniformValues(uniforms, (name) => storedValue(worn!.surfaceFields[name], stored[entryOf(name)])),
    );
    writeSurfaceMaps(
      code,
      uniforms,
      values,
      surfaceMaps.map((name) => this.get(name) as string | null),
      host!,
      () => this.surfaceChanged(),
    );
    if (surface !== before) host?.materialWears(material);
    // lists the surface for readers of three's materials, such as an exporter
    material.userData.surface = surface?.name ?? null;
    const reach = code.surfaceReach(material);
    if (reach === (material.userData.reach ?? 0)) return;
    material.userData.reach = reach;
    host?.materialShapeChanged(this.name);
  }

  private sharedValues(): MaterialValues {
    const names = Object.keys(materialFields).filter((name) => name in this.fields);
    return Object.fromEntries(names.map((name) => [name, this.get(name)])) as unknown as MaterialValues;
  }

  private textureOf(name: MaterialMapName, map: MaterialMap): Texture | null {
    const texture = this.get(name) as string | null;
    const { host } = this;
    if (texture === null || !host) return this.drop(name);
    if (!host.isReady('texture', texture)) {
      host.whenReady('texture', texture, () => {
        if (this.get(name) === texture) this.write();
      });
      return this.drop(name);
    }
    const base = host.texture(texture);
    const wrapS = wraps[this.get(`${name}WrapX`) as keyof typeof wraps];
    const wrapT = wraps[this.get(`${name}WrapY`) as keyof typeof wraps];
    let used = this.textures.get(name);
    if (!used?.isOf(base, wrapS, wrapT)) {
      used?.dispose();
      used = new MaterialTexture(base, wrapS, wrapT, map.isColour ?? false);
      this.textures.set(name, used);
    }
    const value = (ending: string): number => this.get(`${name}${ending}`) as number;
    used.place(
      value('OffsetX'),
      value('OffsetY'),
      value('RepeatX'),
      value('RepeatY'),
      value('Rotation'),
      value('Channel'),
    );
    return used.three;
  }

  private drop(name: MaterialMapName): null {
    this.textures.get(name)?.dispose();
    this.textures.delete(name);
    return null;
  }

  /** Key of the material's state that its program depends on; another key needs another program. */
  private programState(material: MeshPhysicalMaterial): string {
    const any = material as unknown as Record<string, unknown>;
    const maps = materialMapNames.map((name) => {
      const texture = any[materialMaps[name].property] as Texture | null | undefined;
      return texture ? texture.channel : '';
    });
    const { flatShading, side, transparent, alphaTest, vertexColors, wireframe } = material;
    return [
      ...maps,
      ...lobes.map((name) => ((any[name] as number | undefined) ?? 0) > 0),
      flatShading,
      side,
      transparent,
      alphaTest > 0,
      vertexColors,
      wireframe,
      material.onBeforeCompile === undefined || Object.hasOwn(material, 'onBeforeCompile'),
    ].join();
  }
}

/** Sets the iridescence film thickness (nm), which three before 0.187 has as a pair. */
function setFilmThickness(material: MeshPhysicalMaterial, least: number, greatest: number): void {
  if ('iridescenceThicknessMinimum' in material) {
    Object.assign(material, { iridescenceThicknessMinimum: least, iridescenceThicknessMaximum: greatest });
  } else Object.assign(material, { iridescenceThicknessRange: [least, greatest] });
}
