import { Constants } from '@babylonjs/core/Engines/constants.js';
import { Material } from '@babylonjs/core/Materials/material.js';
import { PBRMaterial } from '@babylonjs/core/Materials/PBR/pbrMaterial.js';
import type { BaseTexture } from '@babylonjs/core/Materials/Textures/baseTexture.js';
import { RawTexture } from '@babylonjs/core/Materials/Textures/rawTexture.js';
import { Texture } from '@babylonjs/core/Materials/Textures/texture.js';
import { Color3 } from '@babylonjs/core/Maths/math.color.js';
import type { Scene } from '@babylonjs/core/scene.js';
import type { RivalMap, RivalMaterial, RivalScene, RivalTexture } from '../../../src/competitors/rivals/RivalScene';

const addresses = {
  repeat: Texture.WRAP_ADDRESSMODE,
  mirror: Texture.MIRROR_ADDRESSMODE,
  clamp: Texture.CLAMP_ADDRESSMODE,
};

const samplings = {
  none: [Texture.NEAREST_NEAREST, Texture.NEAREST_LINEAR, Texture.LINEAR_NEAREST, Texture.LINEAR_LINEAR],
  nearest: [
    Texture.NEAREST_NEAREST_MIPNEAREST,
    Texture.NEAREST_LINEAR_MIPNEAREST,
    Texture.LINEAR_NEAREST_MIPNEAREST,
    Texture.LINEAR_LINEAR_MIPNEAREST,
  ],
  linear: [
    Texture.NEAREST_NEAREST_MIPLINEAR,
    Texture.NEAREST_LINEAR_MIPLINEAR,
    Texture.LINEAR_NEAREST_MIPLINEAR,
    Texture.LINEAR_LINEAR_MIPLINEAR,
  ],
};

/** The scene's textures, with views of them for the offsets and scales of materials; texels are uploaded once. */
class Textures {
  private readonly sent: (RawTexture | undefined)[] = [];

  constructor(
    private readonly scene: Scene,
    private readonly from: readonly RivalTexture[],
  ) {}

  get({ texture, scale, offset }: RivalMap): Texture {
    const first = this.sent[texture];
    const made = first ? (first.clone() as RawTexture) : (this.sent[texture] = this.send(this.from[texture]));
    [made.uScale, made.vScale] = scale;
    [made.uOffset, made.vOffset] = offset;
    // Babylon scales about the centre by default, three about the origin
    made.uRotationCenter = made.vRotationCenter = 0;
    made.homogeneousRotationInUVTransform = true;
    return made;
  }

  private send(from: RivalTexture): RawTexture {
    const sampling = samplings[from.mipmaps][(from.isMagLinear ? 2 : 0) + (from.isMinLinear ? 1 : 0)];
    const texture = RawTexture.CreateRGBATexture(
      from.pixels,
      from.width,
      from.height,
      this.scene,
      from.mipmaps !== 'none',
      false,
      sampling,
      Constants.TEXTURETYPE_UNSIGNED_BYTE,
      0,
      from.isSrgb,
    );
    texture.wrapU = addresses[from.wrapU];
    texture.wrapV = addresses[from.wrapV];
    texture.anisotropicFilteringLevel = from.anisotropy;
    texture.gammaSpace = false;
    return texture;
  }
}

const setMap = (map: RivalMap | null, textures: Textures, set: (texture: BaseTexture) => void): void => {
  if (map) set(textures.get(map));
};

function makeMaterial(scene: Scene, from: RivalMaterial, textures: Textures, lights: number): PBRMaterial {
  const material = new PBRMaterial(from.name, scene);
  material.albedoColor = new Color3(...from.colour);
  material.ambientColor = new Color3(1, 1, 1);
  material.metallic = from.metalness;
  material.roughness = from.roughness;
  material.useGLTFLightFalloff = true;
  material.maxSimultaneousLights = lights;
  // triangles are counter-clockwise seen from their front, as in three
  material.sideOrientation = Material.CounterClockWiseSideOrientation;
  material.brdf.baseDiffuseModel = Constants.MATERIAL_DIFFUSE_MODEL_LAMBERT;
  material.unlit = !from.isLit;
  setMap(from.map, textures, (texture) => (material.albedoTexture = texture));
  setMap(from.roughnessMetalnessMap, textures, (texture) => {
    material.metallicTexture = texture;
    material.useRoughnessFromMetallicTextureAlpha = false;
    material.useRoughnessFromMetallicTextureGreen = true;
    material.useMetallnessFromMetallicTextureBlue = true;
  });
  const [x, y] = from.normalScale;
  setMap(from.normalMap, textures, (texture) => {
    if (Math.abs(x) !== Math.abs(y)) {
      throw new Error(`Material ${from.name}: Babylon.js scales both axes of a normal map alike.`);
    }
    material.bumpTexture = texture;
    texture.level = Math.abs(x);
    material.invertNormalMapX = x < 0;
    material.invertNormalMapY = y < 0;
  });
  material.emissiveColor = new Color3(...from.emissive);
  setMap(from.emissiveMap, textures, (texture) => (material.emissiveTexture = texture));
  material.backFaceCulling = !from.isDoubleSided;
  material.twoSidedLighting = from.isDoubleSided;
  if (from.isTransparent) {
    material.transparencyMode = PBRMaterial.PBRMATERIAL_ALPHABLEND;
    material.alpha = from.opacity;
    material.useRadianceOverAlpha = false;
    material.useSpecularOverAlpha = false;
    material.useAlphaFromAlbedoTexture = from.map !== null;
    material.forceDepthWrite = true;
  } else if (from.alphaTest > 0) {
    material.transparencyMode = PBRMaterial.PBRMATERIAL_ALPHATEST;
    material.alphaCutOff = from.alphaTest;
    material.useAlphaFromAlbedoTexture = true;
  }
  return material;
}

/** Babylon's materials, by index in the scene. @param lights - lights outside of the clusters, and the light container */
export function makeMaterials(scene: Scene, from: RivalScene, lights: number): PBRMaterial[] {
  const textures = new Textures(scene, from.textures);
  return from.materials.map((material) => makeMaterial(scene, material, textures, lights));
}
