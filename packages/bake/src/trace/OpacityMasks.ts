import {
  LinearFilter,
  type Material,
  type MeshStandardMaterial,
  RedFormat,
  RepeatWrapping,
  type Texture,
  UnsignedByteType,
  WebGLArrayRenderTarget,
  type WebGLRenderer,
} from 'three';
import { FullscreenPass } from '../gpu/FullscreenPass';
import mask from './opacityMask.glsl?raw';

/** Texels along a side of a mask. */
const SIZE = 512;

/** Opacity of a material with cut-outs or glass, for the ray shader. */
export interface Opacity {
  /** Layer of the material's opacity in the array of masks; -1 for none. */
  readonly layer: number;
  /** 0: opaque; above 0: alphaTest threshold of the opacity; below 0: rays pass at random, by opacity. */
  readonly test: number;
  readonly opacity: number;
}

const opaque: Opacity = { layer: -1, test: 0, opacity: 1 };

/** Opacity of materials; opacity maps are layers of one array texture. */
export class OpacityMasks {
  readonly target: WebGLArrayRenderTarget;
  private readonly byMaterial = new Map<Material, Opacity>();

  constructor(renderer: WebGLRenderer, materials: ReadonlySet<Material>) {
    const masked: MeshStandardMaterial[] = [];
    for (const each of materials) {
      const material = each as MeshStandardMaterial;
      const opacity = readOpacity(material);
      const hasMask = opacity !== opaque && (material.map !== null || material.alphaMap !== null) && 'map' in material;
      this.byMaterial.set(each, hasMask ? { ...opacity, layer: masked.push(material) - 1 } : opacity);
    }
    const size = masked.length > 0 ? SIZE : 1;
    this.target = new WebGLArrayRenderTarget(size, size, Math.max(1, masked.length), {
      ...{ format: RedFormat, type: UnsignedByteType, depthBuffer: false, minFilter: LinearFilter },
      ...{ magFilter: LinearFilter, wrapS: RepeatWrapping, wrapT: RepeatWrapping },
    });
    const uniforms = {
      map: { value: null as Texture | null },
      alphaMap: { value: null as Texture | null },
      has: { value: [0, 0] },
    };
    const pass = new FullscreenPass('opacity', mask, uniforms);
    masked.forEach(({ map, alphaMap }, layer) => {
      uniforms.map.value = map;
      uniforms.alphaMap.value = alphaMap;
      uniforms.has.value = [map ? 1 : 0, alphaMap ? 1 : 0];
      pass.draw(renderer, this.target, layer);
    });
    pass.dispose();
  }

  of(material: Material): Opacity {
    return this.byMaterial.get(material) ?? opaque;
  }

  dispose(): void {
    this.target.dispose();
  }
}

function readOpacity(material: Material): Opacity {
  const { opacity, alphaTest, transparent, alphaHash } = material;
  if (alphaTest > 0) return { layer: -1, test: alphaTest, opacity };
  const transmission = (material as Material & { transmission?: number }).transmission ?? 0;
  if (!transparent && !alphaHash && transmission === 0) return opaque;
  return { layer: -1, test: -1, opacity: opacity * (1 - transmission) };
}
