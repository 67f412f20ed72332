import * as pc from 'playcanvas';
import type {
  Rgb,
  RivalMap,
  RivalMaterial,
  RivalScene,
  RivalTexture,
} from '../../../src/competitors/rivals/RivalScene';
import { instanceAttributes, instanceColourChunks, multiplyByInstanceColour } from './chunks';

/** Inverse of the power 2.2 that PlayCanvas applies to colours. */
export const encode = ([r, g, b]: Rgb, scale = 1): pc.Color =>
  new pc.Color((r * scale) ** (1 / 2.2), (g * scale) ** (1 / 2.2), (b * scale) ** (1 / 2.2));

const addresses = { repeat: pc.ADDRESS_REPEAT, mirror: pc.ADDRESS_MIRRORED_REPEAT, clamp: pc.ADDRESS_CLAMP_TO_EDGE };

const minFilters = {
  none: [pc.FILTER_NEAREST, pc.FILTER_LINEAR],
  nearest: [pc.FILTER_NEAREST_MIPMAP_NEAREST, pc.FILTER_LINEAR_MIPMAP_NEAREST],
  linear: [pc.FILTER_NEAREST_MIPMAP_LINEAR, pc.FILTER_LINEAR_MIPMAP_LINEAR],
};

export const makeTexture = (device: pc.GraphicsDevice, from: RivalTexture): pc.Texture =>
  new pc.Texture(device, {
    width: from.width,
    height: from.height,
    format: from.isSrgb ? pc.PIXELFORMAT_SRGBA8 : pc.PIXELFORMAT_RGBA8,
    levels: [from.pixels],
    mipmaps: from.mipmaps !== 'none',
    minFilter: minFilters[from.mipmaps][from.isMinLinear ? 1 : 0],
    magFilter: from.isMagLinear ? pc.FILTER_LINEAR : pc.FILTER_NEAREST,
    addressU: addresses[from.wrapU],
    addressV: addresses[from.wrapV],
    anisotropy: from.anisotropy,
  });

type MapName = 'diffuseMap' | 'normalMap' | 'glossMap' | 'metalnessMap' | 'emissiveMap' | 'opacityMap';

/** PlayCanvas's materials: one per material of the scene for plain meshes, another for meshes with instance colours. */
export class Materials {
  private readonly made = new Map<string, pc.StandardMaterial>();
  private readonly textures: pc.Texture[];

  constructor(
    private readonly device: pc.GraphicsDevice,
    private readonly scene: RivalScene,
    private readonly ambientSH: Float32Array | null,
  ) {
    this.textures = scene.textures.map((texture) => makeTexture(device, texture));
  }

  get(index: number, hasInstanceColours: boolean): pc.StandardMaterial {
    const key = `${index} ${hasInstanceColours}`;
    let material = this.made.get(key);
    if (!material) this.made.set(key, (material = this.make(this.scene.materials[index], hasInstanceColours)));
    return material;
  }

  private make(from: RivalMaterial, hasInstanceColours: boolean): pc.StandardMaterial {
    const material = new pc.StandardMaterial();
    material.name = from.name;
    material.useSkybox = false;
    material.useFog = false;
    material.useTonemap = false;
    if (from.isLit) this.makeLit(material, from);
    else {
      material.useLighting = false;
      material.diffuse = new pc.Color(0, 0, 0);
      this.emit(material, from.colour);
      this.map(material, 'emissiveMap', from.map);
      material.emissiveVertexColor = from.hasVertexColours;
    }
    material.cull = from.isDoubleSided ? pc.CULLFACE_NONE : pc.CULLFACE_BACK;
    material.twoSidedLighting = from.isDoubleSided;
    if (from.isTransparent) {
      material.blendType = pc.BLEND_NORMAL;
      material.depthWrite = true;
      material.opacity = from.opacity;
      material.opacityFadesSpecular = true;
    }
    if (from.isTransparent || from.alphaTest > 0) {
      this.map(material, 'opacityMap', from.map);
      material.opacityMapChannel = 'a';
      material.alphaTest = from.alphaTest;
    }
    if (hasInstanceColours) {
      const { chunks } = material;
      Object.assign(chunks, instanceColourChunks);
      const chunk = from.isLit ? 'diffusePS' : 'emissivePS';
      chunks[chunk] = multiplyByInstanceColour(this.device, chunk);
      for (const [name, semantic] of Object.entries(instanceAttributes)) material.setAttribute(name, semantic);
    }
    material.update();
    return material;
  }

  private makeLit(material: pc.StandardMaterial, from: RivalMaterial): void {
    material.diffuse = encode(from.colour);
    material.useMetalness = true;
    material.metalness = from.metalness;
    material.enableGGXSpecular = true;
    if (from.roughnessMetalnessMap) {
      material.gloss = from.roughness;
      material.glossInvert = true;
      this.map(material, 'glossMap', from.roughnessMetalnessMap);
      this.map(material, 'metalnessMap', from.roughnessMetalnessMap);
      material.glossMapChannel = 'g';
      material.metalnessMapChannel = 'b';
    } else material.gloss = 1 - Math.max(from.roughness, 0.045);
    this.map(material, 'diffuseMap', from.map);
    this.map(material, 'normalMap', from.normalMap);
    material.setParameter('farol_normalScale', [from.normalScale[0], -from.normalScale[1]]);
    material.diffuseVertexColor = from.hasVertexColours;
    this.emit(material, from.emissive);
    this.map(material, 'emissiveMap', from.emissiveMap);
    // `ambientSH` is not declared in PlayCanvas's types
    if (this.ambientSH) Object.assign(material, { ambientSH: this.ambientSH });
  }

  private emit(material: pc.StandardMaterial, colour: Rgb): void {
    const most = Math.max(...colour, 1);
    material.emissive = encode(colour, 1 / most);
    material.emissiveIntensity = most;
  }

  private map(material: pc.StandardMaterial, name: MapName, map: RivalMap | null): void {
    if (!map) return;
    material[name] = this.textures[map.texture];
    material[`${name}Tiling`] = new pc.Vec2(...map.scale);
    // PlayCanvas's v runs from the top of the picture
    material[`${name}Offset`] = new pc.Vec2(map.offset[0], 1 - map.scale[1] - map.offset[1]);
  }
}
