import { isFieldVisible } from '@farol/editing/fields';
import {
  DoubleSide,
  FrontSide,
  type Material,
  MeshBasicMaterial,
  MeshLambertMaterial,
  MeshPhongMaterial,
  MeshPhysicalMaterial,
  MeshStandardMaterial,
  NormalBlending,
  type Texture,
} from 'three';
import { setShading } from '@farol/renderer';
import { hasAmbientReflection, setAmbientReflection } from './ambientReflection';
import type { MaterialValues } from './materialFields';
import { materialFields } from './materialFields';

const constructors = {
  standard: MeshStandardMaterial,
  phong: MeshPhongMaterial,
  lambert: MeshLambertMaterial,
  basic: MeshBasicMaterial,
  physical: MeshPhysicalMaterial,
};

type LitMaterial = MeshStandardMaterial | MeshPhongMaterial | MeshLambertMaterial;

/** Makes a material of three's class for the kind, with default values. */
export const makeMaterial = (kind: MaterialValues['kind']): Material => new constructors[kind]();

/** Values that matter for the kind of material, in the order of declaration, then the blending. */
export function materialSettings(values: MaterialValues): unknown[] {
  const get = (name: string): unknown => (name === 'material' ? null : values[name as keyof MaterialValues]);
  const settings = Object.keys(materialFields).map((name) =>
    isFieldVisible(materialFields, name, get) ? get(name) : null,
  );
  return [...settings, values.blending];
}

/**
 * Writes field values to a material of their kind.
 * @param texture - finds a texture by name, and by whether it holds data in place of colours; null while it is not
 * loaded
 */
export function writeMaterial(
  material: Material,
  values: MaterialValues,
  texture: (name: string, isData: boolean) => Texture | null,
): void {
  const find = (name: string | null, isData = false): Texture | null => (name === null ? null : texture(name, isData));
  const coloured = material as LitMaterial | MeshBasicMaterial;
  const before = programState(coloured);
  writeMaterialValues(material, values);
  coloured.map = find(values.map);
  if (values.kind !== 'basic') (material as LitMaterial).normalMap = find(values.normalMap, true);
  if (programState(coloured) !== before) material.needsUpdate = true;
}

/** Writes field values to a material of their kind, but for its textures. The material may need another program afterwards. */
export function writeMaterialValues(
  material: Material,
  values: Omit<MaterialValues, 'map' | 'normalMap' | 'repeat'>,
): void {
  const coloured = material as LitMaterial | MeshBasicMaterial;
  coloured.color.setRGB(...values.colour);
  coloured.wireframe = values.wireframe;
  material.transparent = values.transparent;
  material.opacity = values.transparent ? values.opacity : 1;
  material.blending = values.blending ?? NormalBlending;
  material.alphaTest = values.alphaTest;
  material.side = values.doubleSided ? DoubleSide : FrontSide;
  material.vertexColors = values.vertexColours;
  if (values.kind !== 'basic') writeLit(material as LitMaterial, values);
}

function writeLit(material: LitMaterial, values: Omit<MaterialValues, 'map' | 'normalMap' | 'repeat'>): void {
  material.normalScale.setScalar(values.normalScale);
  material.flatShading = values.shading === 'flat';
  setShading(material, values.shading === 'gouraud' ? 'gouraud' : null);
  material.emissive.setRGB(...values.emissive);
  material.emissiveIntensity = values.emissiveIntensity;
  if (material instanceof MeshPhongMaterial) {
    setAmbientReflection(material, values.ambient);
    material.specular.setRGB(...values.specular);
    material.shininess = Math.max(values.shininess, 1e-4);
  }
  if (material instanceof MeshStandardMaterial) {
    material.roughness = values.roughness;
    material.metalness = values.metalness;
  }
  if (material instanceof MeshPhysicalMaterial) {
    material.clearcoat = values.clearcoat;
    material.clearcoatRoughness = values.clearcoatRoughness;
    material.transmission = values.transmission;
    material.ior = values.ior;
  }
}

/** Key of the material's state that its program depends on; another key needs another program. */
function programState(material: LitMaterial | MeshBasicMaterial): string {
  const { map, side, transparent, alphaTest, vertexColors, wireframe } = material;
  const lit = material instanceof MeshBasicMaterial ? null : material;
  const physical = material instanceof MeshPhysicalMaterial ? material : null;
  return [
    Boolean(map),
    Boolean(lit?.normalMap),
    lit?.flatShading,
    side,
    transparent,
    alphaTest > 0,
    vertexColors,
    wireframe,
    hasAmbientReflection(material),
    (physical?.clearcoat ?? 0) > 0,
    (physical?.transmission ?? 0) > 0,
  ].join();
}
