import { t } from '@farol/editing';
import { sourceOfMaterial } from '@farol/engine';
import {
  type Color,
  type Material,
  MeshBasicMaterial,
  type MeshPhongMaterial,
  type MeshPhysicalMaterial,
  MeshStandardMaterial,
  type Texture,
  type Vector2,
  type WebGLRenderer,
} from 'three';
import { GltfTextures } from './GltfTextures';
import type { LeftOut } from './LeftOut';

/** Properties of a mesh that affect how its material is written. */
export interface MaterialUse {
  /** Names of an object and its material, for messages. */
  readonly user: string;
  readonly object: string;
  readonly hasUV: boolean;
  readonly hasTangents: boolean;
}

/** Maps of three's materials that glTF does not support. */
const unknownMaps = /^(env|light|bump|displacement|alpha|gradient|diffuseRoughness)Map$|^matcap$/;

/** Property with the scale of each normal map; a negative scale inverts a channel of the image. */
const normalScales: Readonly<Record<string, 'normalScale' | 'clearcoatNormalScale'>> = {
  normalMap: 'normalScale',
  clearcoatNormalMap: 'clearcoatNormalScale',
};

const isTexture = (value: unknown): value is Texture => value instanceof Object && 'isTexture' in value;

/** Limits a colour to 1 per channel, as glTF requires. @returns the factor removed */
function takeExcess(colour: Color): number {
  const largest = Math.max(colour.r, colour.g, colour.b);
  if (largest > 1) colour.multiplyScalar(1 / largest);
  return Math.max(1, largest);
}

/** Converts materials to glTF's model: metallic-roughness, or unlit. */
export class GltfMaterials {
  private readonly textures: GltfTextures;
  private readonly made = new Map<string, Promise<Material>>();

  constructor(
    webgl: WebGLRenderer,
    private readonly leftOut: LeftOut,
  ) {
    this.textures = new GltfTextures(webgl);
  }

  /** @throws Error naming the texture and the object when one of its textures cannot be read */
  convert(drawn: Material, use: MaterialUse): Promise<Material> {
    const { surface } = drawn.userData;
    if (typeof surface === 'string') for (const name of surface.split(', ')) this.leftOut.addSurface(name, use.object);
    // a material derived for an object's surface is converted as its original, which has the maps
    const source = sourceOfMaterial(drawn);
    const key = `${source.uuid} ${use.hasUV} ${use.hasTangents}`;
    let made = this.made.get(key);
    if (!made) this.made.set(key, (made = this.make(source, use)));
    return made;
  }

  dispose(): void {
    for (const made of this.made.values()) void made.then((material) => material.dispose()).catch(() => {});
  }

  private async make(source: Material, use: MaterialUse): Promise<Material> {
    const material = this.withoutTextures(source);
    material.name = source.name;
    // user data from Farol would be meaningless to other programs
    material.userData = {};
    if (takeExcess(material.color) > 1) this.leftOut.add(t('Materials brighter than white became white'), source);
    if (material instanceof MeshStandardMaterial) {
      material.emissiveIntensity *= takeExcess(material.emissive);
      const { r, g, b } = material.emissive;
      if (material.emissiveIntensity === 0) material.emissive.setRGB(0, 0, 0);
      if (r + g + b === 0) material.emissiveIntensity = 1;
    }
    for (const [field, value] of Object.entries(source)) {
      if (!isTexture(value) || (field === 'normalMap' && material.wireframe)) continue;
      if (unknownMaps.test(field) || !(field in material))
        this.leftOut.add(t('Maps that glTF does not have are left out'), value);
      else if (use.hasUV) Object.assign(material, { [field]: await this.texture(source, field, value, use) });
      else this.leftOut.add(t('Textures on meshes without texture coordinates are left out'), value);
    }
    if (material instanceof MeshStandardMaterial && use.hasUV) {
      // the signs of normal scales have been applied to the images, by inverting channels
      for (const name of Object.values(normalScales)) {
        const scale = (material as MeshPhysicalMaterial)[name] as Vector2 | undefined;
        scale?.setScalar(Math.abs(scale.x));
      }
    }
    return material;
  }

  private texture(source: Material, field: string, texture: Texture, use: MaterialUse): Promise<Texture> {
    if (!(field in normalScales)) return this.textures.convert(texture, use.user);
    const { x, y } = (source as MeshPhysicalMaterial)[normalScales[field]];
    // without tangents three expects green to point along v, and glTF opposite to v
    return this.textures.convertNormalMap(texture, x < 0, use.hasTangents ? y < 0 : y > 0, use.user);
  }

  private withoutTextures(source: Material): MeshStandardMaterial | MeshBasicMaterial {
    if ('isShaderMaterial' in source) {
      this.leftOut.add(t('Shaders became plain grey'), source);
      return new MeshBasicMaterial({ color: 0x808080 });
    }
    if (source instanceof MeshStandardMaterial || source instanceof MeshBasicMaterial) {
      const copy = source.clone();
      for (const [field, value] of Object.entries(copy)) if (isTexture(value)) Object.assign(copy, { [field]: null });
      return copy;
    }
    const { color, emissive, emissiveIntensity, shininess } = source as MeshPhongMaterial;
    const { transparent, opacity, alphaTest, side, vertexColors, wireframe } = source as MeshPhongMaterial;
    const shared = { transparent, opacity, alphaTest, side, vertexColors, ...(color ? { color } : {}) };
    if (!emissive) return new MeshBasicMaterial(shared);
    this.leftOut.add(t('Phong and Lambert materials became rough ones'), source);
    // Blinn-Phong exponent n to roughness: alpha = sqrt(2 / (n + 2)), roughness = sqrt(alpha) @see Walter 2007
    const roughness = shininess === undefined ? 1 : (2 / (shininess + 2)) ** 0.25;
    const values = { emissive, emissiveIntensity, roughness, metalness: 0, wireframe };
    const material = new MeshStandardMaterial({ ...shared, ...values });
    material.flatShading = (source as MeshPhongMaterial).flatShading;
    material.normalScale.copy((source as MeshPhongMaterial).normalScale);
    return material;
  }
}
