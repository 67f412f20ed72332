import { Color, SRGBColorSpace } from 'three';
import type { MtlMap, MtlMaterial } from './parseMtl';
import type { ObjTextures, TextureInfo } from './ObjTextures';
import { normalsOfHeights, roughnessOfSpecular } from './pictures';

type Triple = readonly [number, number, number];

const linear = ([r, g, b]: Triple): [number, number, number] => {
  const colour = new Color().setRGB(r, g, b, SRGBColorSpace);
  return [colour.r, colour.g, colour.b];
};

/**
 * Roughness (0 to 1) of a surface with a Phong highlight: α² = 2 / (Ns + 2) gives GGX a highlight of the same width,
 * and α is roughness². A weaker Ks makes it rougher, down to 1 where there is no highlight.
 * @param shininess - Ns
 * @param strength - the largest channel of Ks
 * @see Walter et al. 2007, Microfacet Models for Refraction through Rough Surfaces, 5.2
 */
export function roughnessOf(shininess: number, strength: number): number {
  const roughness = (2 / (Math.max(0, shininess) + 2)) ** 0.25;
  return 1 + (roughness - 1) * Math.min(1, Math.max(0, strength));
}

/** glTF extensions that `gltfOfMtl` has used so far. */
export interface GltfNotes {
  usesEmissiveStrength: boolean;
}

/**
 * Converts a material of an MTL file to glTF, for a MeshStandardMaterial, which every technique supports:
 *
 * - `Kd` and `map_Kd` (or `map_Ka` alone): colour; a black Kd under a map counts as white
 * - `Ks`, `Ns`: roughness, see `roughnessOf`; `map_Ks`: its brightness is the strength of the highlight, as roughness.
 *   `Pr` and `Pm` are taken as they are; without `Pm` nothing is a metal
 * - `Ke`, `map_Ke`: emission
 * - `d`, or `Tr` = 1 − d: opacity, where that leaves anything to be seen; `map_d`: opacity, cut out at a half where it
 *   is nearly everywhere 0 or 1, else blended
 * - `norm`: map of normals; `bump`, `map_bump`: likewise where the picture holds normals, else the heights become
 *   normals; `disp`: only where it holds normals
 * - `-s`, `-o`, `-clamp`, `-bm` of textures
 * - see-through and cut-out surfaces have two sides, others one
 *
 * What is not there, or cannot be decoded, is left out, and noted by `textures`.
 * @param from - path of the MTL file
 */
export async function gltfOfMtl(
  material: MtlMaterial,
  from: string,
  textures: ObjTextures,
  notes: GltfNotes,
): Promise<object> {
  const colour = await colourOf(material, from, textures);
  const surface = await roughnessAndMetalness(material, from, textures);
  const normalTexture = await normalTextureOf(material, from, textures);
  const emission = await emissionOf(material, from, textures, notes);
  return {
    name: material.name,
    pbrMetallicRoughness: {
      baseColorFactor: [...colour.factor, material.opacity ?? 1],
      ...(colour.texture ? { baseColorTexture: colour.texture } : {}),
      ...surface,
    },
    ...(normalTexture ? { normalTexture } : {}),
    ...emission,
    ...(colour.alphaMode === 'OPAQUE' ? {} : { alphaMode: colour.alphaMode, doubleSided: true }),
  };
}

const white: Triple = [1, 1, 1];
const grey: Triple = [0.6, 0.6, 0.6];

/** Grey material for faces whose own material is unknown. */
export const greyMaterial = (name: string): object => ({
  name,
  pbrMetallicRoughness: { baseColorFactor: [...grey, 1], metallicFactor: 0, roughnessFactor: 0.8 },
});

interface Colour {
  factor: Triple;
  texture?: TextureInfo;
  alphaMode: 'OPAQUE' | 'MASK' | 'BLEND';
}

async function colourOf(material: MtlMaterial, from: string, textures: ObjTextures): Promise<Colour> {
  const { diffuse = [0.8, 0.8, 0.8], opacity = 1, diffuseMap, opacityMap } = material;
  const colourPath = diffuseMap ? textures.find(from, diffuseMap) : null;
  const opacityPath = opacityMap ? textures.find(from, opacityMap) : null;
  const isBlack = diffuse.every((each) => each === 0);
  const alphaMode = opacity < 1 ? 'BLEND' : 'OPAQUE';
  if (opacityMap && opacityPath !== null) {
    const made = await textures.withOpacity(colourPath, opacityPath);
    if (made) {
      const factor = colourPath !== null && (isBlack || !material.diffuse) ? white : linear(diffuse);
      const texture = textures.texture(made.image, diffuseMap ?? opacityMap);
      return { factor, texture, alphaMode: opacity < 1 || !made.isCutOut ? 'BLEND' : 'MASK' };
    }
  }
  const image = colourPath === null ? null : await textures.plain(colourPath);
  if (image === null || !diffuseMap) {
    // a black factor of a texture that is missing is no colour: grey in its place
    return { factor: diffuseMap && isBlack ? grey : linear(diffuse), alphaMode };
  }
  const factor = isBlack || !material.diffuse ? white : linear(diffuse);
  return { factor, texture: textures.texture(image, diffuseMap), alphaMode };
}

async function roughnessAndMetalness(material: MtlMaterial, from: string, textures: ObjTextures): Promise<object> {
  const { specular, specularMap, shininess = 30, metalness = 0 } = material;
  const strength = specular ? Math.max(...specular) : 0.5;
  const roughness = material.roughness ?? roughnessOf(shininess, strength);
  const factors = { metallicFactor: clamp(metalness), roughnessFactor: clamp(roughness) };
  const path = specularMap && material.roughness === undefined ? textures.find(from, specularMap) : null;
  if (!specularMap || path === null || roughness === 1) return factors;
  const image = await textures.made(`${path} as roughness ${roughness}`, path, async () => {
    const picture = await textures.decode(path);
    return picture && roughnessOfSpecular(picture, roughness);
  });
  if (image === null) return factors;
  // without metalness, which the blue channel of the texture would set
  return { metallicFactor: 0, roughnessFactor: 1, metallicRoughnessTexture: textures.texture(image, specularMap) };
}

async function normalTextureOf(
  material: MtlMaterial,
  from: string,
  textures: ObjTextures,
): Promise<TextureInfo | undefined> {
  const { normalMap, bumpMap, displacementMap } = material;
  const normalPath = normalMap ? textures.find(from, normalMap) : null;
  if (normalMap && normalPath !== null) {
    const image = await textures.plain(normalPath);
    if (image !== null) return scaled(textures.texture(image, normalMap), normalMap);
  }
  for (const map of [bumpMap, displacementMap]) {
    const path = map ? textures.find(from, map) : null;
    if (!map || path === null) continue;
    if (await textures.holdsNormals(path)) {
      const image = await textures.plain(path);
      if (image !== null) return scaled(textures.texture(image, map), map);
    } else if (map === bumpMap) {
      const image = await textures.made(`${path} as normals ${map.bump}`, path, async () => {
        const picture = await textures.decode(path);
        return picture && normalsOfHeights(picture, map.bump);
      });
      if (image !== null) return textures.texture(image, map);
    }
  }
  return undefined;
}

const scaled = (texture: TextureInfo, { bump }: MtlMap): TextureInfo =>
  bump === 1 ? texture : { ...texture, scale: bump };

async function emissionOf(
  { emissive, emissiveMap }: MtlMaterial,
  from: string,
  textures: ObjTextures,
  notes: GltfNotes,
): Promise<object> {
  const path = emissiveMap ? textures.find(from, emissiveMap) : null;
  const image = path === null ? null : await textures.plain(path);
  const isBlack = !emissive || emissive.every((each) => each <= 0);
  if (isBlack && image === null) return {};
  const colour: Triple = isBlack
    ? [1, 1, 1]
    : linear([Math.max(0, emissive[0]), Math.max(0, emissive[1]), Math.max(0, emissive[2])]);
  const strength = Math.max(1, ...colour);
  if (strength > 1) notes.usesEmissiveStrength = true;
  return {
    emissiveFactor: colour.map((each) => each / strength),
    ...(strength > 1 ? { extensions: { KHR_materials_emissive_strength: { emissiveStrength: strength } } } : {}),
    ...(image !== null && emissiveMap ? { emissiveTexture: textures.texture(image, emissiveMap) } : {}),
  };
}

const clamp = (value: number): number => Math.min(1, Math.max(0, value));
