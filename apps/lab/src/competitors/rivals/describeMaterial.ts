import {
  AdditiveBlending,
  BackSide,
  Color,
  DoubleSide,
  Material,
  type MeshBasicMaterial,
  type MeshPhysicalMaterial,
  type MeshStandardMaterial,
  type Texture,
} from 'three';
import type { Rgb, RivalMap, RivalMaterial } from './RivalScene';

/** Maps of three's materials that the Lab does not convert. */
const otherMaps = ['aoMap', 'alphaMap', 'bumpMap', 'displacementMap', 'envMap', 'lightMap', 'specularMap'] as const;

/** Properties that a physical material must not use, with their neutral values. */
const physicalDefaults = {
  clearcoat: 0,
  sheen: 0,
  transmission: 0,
  iridescence: 0,
  anisotropy: 0,
  dispersion: 0,
  ior: 1.5,
  specularIntensity: 1,
} as const;

const scaled = (colour: Color, factor: number): Rgb => [colour.r * factor, colour.g * factor, colour.b * factor];

/** Reason why a material cannot be converted, the end of a sentence; null if it can. */
function problemOf(material: Material): string | null {
  const of = material as MeshPhysicalMaterial;
  if (!['MeshStandardMaterial', 'MeshPhysicalMaterial', 'MeshBasicMaterial'].includes(material.type)) {
    return `is a ${material.type}`;
  }
  if (material.onBeforeCompile !== Material.prototype.onBeforeCompile) return 'changes three’s shaders';
  const map = otherMaps.find((name) => (of as unknown as Record<string, unknown>)[name]);
  if (map) return `has ${map === 'aoMap' || map === 'envMap' || map === 'alphaMap' ? 'an' : 'a'} ${map}`;
  if (material.side === BackSide) return 'shows its back sides alone';
  if (material.blending === AdditiveBlending) return 'is blended additively';
  if ((material as MeshBasicMaterial).wireframe) return 'is a wireframe';
  if (material.type === 'MeshPhysicalMaterial') {
    for (const [name, value] of Object.entries(physicalDefaults)) {
      if (of[name as keyof typeof physicalDefaults] !== value) return `has ${name}`;
    }
  }
  if (of.roughnessMap && of.metalnessMap && of.roughnessMap !== of.metalnessMap) {
    return 'has roughness and metalness in two textures';
  }
  // the engines have one map for roughness and metalness
  if (Boolean(of.roughnessMap) !== Boolean(of.metalnessMap) && (of.roughnessMap || of.metalness > 0)) {
    return 'has a texture for only one of roughness and metalness';
  }
  return null;
}

function describeMap(texture: Texture, name: string, textures: (texture: Texture) => number): RivalMap {
  if (texture.channel !== 0)
    throw new Error(`Material ${name} uses a second set of UVs: the Lab cannot give it to other engines.`);
  if (texture.matrixAutoUpdate) texture.updateMatrix();
  const [a, b, , c, d, , u, v] = texture.matrix.elements;
  if (Math.abs(b) > 1e-6 || Math.abs(c) > 1e-6)
    throw new Error(`Material ${name} rotates a texture: the Lab cannot give it to other engines.`);
  return { texture: textures(texture), scale: [a, d], offset: [u, v] };
}

/**
 * Converts three's material to plain data.
 * @param textures - returns a texture's index in `RivalScene.textures`
 * @throws Error that names a property that the Lab does not convert
 */
export function describeMaterial(material: Material, textures: (texture: Texture) => number): RivalMaterial {
  const name = material.name || 'without a name';
  const problem = problemOf(material);
  if (problem) throw new Error(`Material ${name} ${problem}: the Lab cannot give it to other engines.`);
  const of = material as MeshStandardMaterial;
  const isLit = material.type !== 'MeshBasicMaterial';
  const map = (texture: Texture | null | undefined): RivalMap | null =>
    texture ? describeMap(texture, name, textures) : null;
  return {
    name,
    isLit,
    colour: scaled(of.color, 1),
    map: map(of.map),
    normalMap: isLit ? map(of.normalMap) : null,
    normalScale: isLit ? [of.normalScale.x, of.normalScale.y] : [1, 1],
    roughness: isLit ? of.roughness : 1,
    metalness: isLit ? of.metalness : 0,
    roughnessMetalnessMap: isLit ? map(of.roughnessMap ?? of.metalnessMap) : null,
    emissive: isLit ? scaled(of.emissive, of.emissiveIntensity) : [0, 0, 0],
    emissiveMap: isLit ? map(of.emissiveMap) : null,
    isDoubleSided: material.side === DoubleSide,
    hasVertexColours: material.vertexColors,
    alphaTest: material.alphaTest,
    isTransparent: material.transparent,
    opacity: material.transparent ? material.opacity : 1,
  };
}
