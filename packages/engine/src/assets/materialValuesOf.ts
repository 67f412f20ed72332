import { checkFieldValue, type FieldValue, sameValue, type Vector3Tuple } from '@farol/editing/fields';
import {
  BackSide,
  type Color,
  ClampToEdgeWrapping,
  DoubleSide,
  type Material,
  type MeshPhongMaterial,
  type MeshPhysicalMaterial,
  MirroredRepeatWrapping,
  type Texture,
  type Vector2,
} from 'three';
import { materialAssetFields } from './materialAssetFields';
import type { MaterialValues } from './materialFields';
import { materialMapNames, materialMaps } from './materialMaps';

type AnyMaterial = MeshPhysicalMaterial & {
  readonly isMeshPhongMaterial?: boolean;
  readonly isMeshLambertMaterial?: boolean;
  readonly isMeshBasicMaterial?: boolean;
};

function kindOf(material: AnyMaterial): MaterialValues['kind'] | null {
  if (material.isMeshPhysicalMaterial) return 'physical';
  if (material.isMeshStandardMaterial) return 'standard';
  if (material.isMeshPhongMaterial) return 'phong';
  if (material.isMeshLambertMaterial) return 'lambert';
  return material.isMeshBasicMaterial ? 'basic' : null;
}

/** Field for each three property that is copied unchanged: a number or a flag of equal meaning. */
const plain: Readonly<Record<string, string>> = {
  ...{ roughness: 'roughness', metalness: 'metalness', shininess: 'shininess', emissiveIntensity: 'emissiveIntensity' },
  ...{ bumpScale: 'bumpScale', displacementScale: 'displacementScale', displacementBias: 'displacementBias' },
  ...{ aoMapIntensity: 'aoIntensity', lightMapIntensity: 'lightMapIntensity', alphaTest: 'alphaTest' },
  ...{ transparent: 'transparent', opacity: 'opacity', depthWrite: 'depthWrite', wireframe: 'wireframe' },
  ...{ vertexColors: 'vertexColours', clearcoat: 'clearcoat', clearcoatRoughness: 'clearcoatRoughness' },
  ...{ sheen: 'sheen', sheenRoughness: 'sheenRoughness', iridescence: 'iridescence', iridescenceIOR: 'iridescenceIor' },
  ...{ anisotropy: 'anisotropy', anisotropyRotation: 'anisotropyRotation', transmission: 'transmission', ior: 'ior' },
  ...{ thickness: 'thickness', dispersion: 'dispersion', specularIntensity: 'specularIntensity' },
  ...{ diffuseRoughness: 'diffuseRoughness', retroreflectivity: 'retroreflectivity' },
};

const rgb = ({ r, g, b }: Color): Vector3Tuple => [r, g, b];

const wrapOf = (wrapping: number): string => {
  if (wrapping === ClampToEdgeWrapping) return 'clamp';
  return wrapping === MirroredRepeatWrapping ? 'mirror' : 'repeat';
};

/** Limits a value to the range of its field. */
function allowed(name: string, value: FieldValue): FieldValue {
  const field = materialAssetFields[name];
  if (typeof value !== 'number' || checkFieldValue(field, value) === null) return value;
  const { min = -Infinity, max = Infinity } = field as { min?: number; max?: number };
  return Number.isFinite(value) ? Math.min(max, Math.max(min, value)) : field.default;
}

/**
 * Field values for a MaterialAsset that looks like a material of three's; defaults are left out.
 * @param nameOf - returns a texture's name in the library; null leaves the map out
 * @returns null for a material that no fields can describe, such as a shader
 */
export function materialValuesOf(
  given: Material,
  nameOf: (texture: Texture) => string | null,
): Record<string, FieldValue> | null {
  const material = given as AnyMaterial;
  const kind = kindOf(material);
  if (!kind) return null;
  const all: Record<string, FieldValue> = { kind, colour: rgb(material.color) };
  const any = material as unknown as Record<string, FieldValue | undefined>;
  for (const [property, field] of Object.entries(plain)) {
    const value = any[property];
    if (value !== undefined) all[field] = value;
  }
  all.doubleSided = material.side === DoubleSide;
  all.side = material.side === BackSide ? 'back' : 'front';
  if (kind !== 'basic') {
    const { shading } = (material.userData.farol ?? {}) as { shading?: string };
    all.shading = material.flatShading ? 'flat' : shading === 'gouraud' ? shading : 'smooth';
    all.emissive = rgb(material.emissive);
    Object.assign(all, normalsOf('normal', material.normalScale));
  }
  if (kind === 'phong') all.specular = rgb((given as MeshPhongMaterial).specular);
  if (kind === 'physical') {
    all.sheenColour = rgb(material.sheenColor);
    all.specularColour = rgb(material.specularColor);
    all.attenuationColour = rgb(material.attenuationColor);
    all.attenuationDistance = Number.isFinite(material.attenuationDistance) ? material.attenuationDistance : 0;
    [all.iridescenceThicknessMin, all.iridescenceThicknessMax] = filmThickness(material);
    Object.assign(all, normalsOf('clearcoatNormal', material.clearcoatNormalScale));
  }
  Object.assign(all, mapsOf(material, nameOf));
  const values = Object.entries(all).map(([name, value]) => [name, allowed(name, value)] as const);
  return Object.fromEntries(values.filter(([name, value]) => !sameValue(value, materialAssetFields[name].default)));
}

/** Smallest and largest thickness of the film (nm), which versions of three before 0.187 have as a pair. */
function filmThickness(material: object): readonly [number, number] {
  const film = material as { iridescenceThicknessMinimum?: number; iridescenceThicknessMaximum?: number };
  if (film.iridescenceThicknessMinimum === undefined || film.iridescenceThicknessMaximum === undefined)
    return (material as MeshPhysicalMaterial).iridescenceThicknessRange as [number, number];
  return [film.iridescenceThicknessMinimum, film.iridescenceThicknessMaximum];
}

const normalsOf = (prefix: string, { x, y }: Vector2): Record<string, FieldValue> => ({
  [`${prefix}Scale`]: x,
  [`${prefix}Flip`]: Math.sign(x) !== Math.sign(y),
});

function mapsOf(material: Material, nameOf: (texture: Texture) => string | null): Record<string, FieldValue> {
  const values: Record<string, FieldValue> = {};
  for (const name of materialMapNames) {
    const texture = (material as unknown as Record<string, Texture | null | undefined>)[materialMaps[name].property];
    const asset = texture ? nameOf(texture) : null;
    if (!texture || asset === null) continue;
    values[name] = asset;
    values[`${name}OffsetX`] = texture.offset.x;
    values[`${name}OffsetY`] = texture.offset.y;
    values[`${name}RepeatX`] = texture.repeat.x;
    values[`${name}RepeatY`] = texture.repeat.y;
    values[`${name}Rotation`] = texture.rotation;
    values[`${name}WrapX`] = wrapOf(texture.wrapS);
    values[`${name}WrapY`] = wrapOf(texture.wrapT);
    values[`${name}Channel`] = texture.channel;
  }
  return values;
}
