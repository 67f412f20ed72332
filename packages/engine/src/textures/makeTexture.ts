import {
  DataTexture,
  LinearFilter,
  LinearMipmapLinearFilter,
  NoColorSpace,
  RepeatWrapping,
  RGBAFormat,
  SRGBColorSpace,
  UnsignedByteType,
} from 'three';
import type { Pattern, Texel } from './patterns';

function finish(data: Uint8Array, size: number, isColour: boolean): DataTexture {
  const texture = new DataTexture(data, size, size, RGBAFormat, UnsignedByteType);
  texture.wrapS = texture.wrapT = RepeatWrapping;
  texture.magFilter = LinearFilter;
  texture.minFilter = LinearMipmapLinearFilter;
  texture.generateMipmaps = true;
  texture.anisotropy = 8;
  texture.colorSpace = isColour ? SRGBColorSpace : NoColorSpace;
  texture.needsUpdate = true;
  return texture;
}

const newTexel = (): Texel => ({ height: 0, red: 0, green: 0, blue: 0 });

/** A colour texture of a pattern, `size` × `size` texels, sRGB, repeating, with mipmaps. */
export function makeColourTexture(pattern: Pattern, size: number): DataTexture {
  const data = new Uint8Array(size * size * 4);
  const texel = newTexel();
  for (let y = 0, i = 0; y < size; y++) {
    for (let x = 0; x < size; x++, i += 4) {
      pattern((x + 0.5) / size, (y + 0.5) / size, texel);
      data[i] = Math.min(255, Math.max(0, texel.red));
      data[i + 1] = Math.min(255, Math.max(0, texel.green));
      data[i + 2] = Math.min(255, Math.max(0, texel.blue));
      data[i + 3] = 255;
    }
  }
  return finish(data, size, true);
}

/**
 * A normal map of a pattern's heights in tangent space (+y along +v), `size` × `size` texels.
 * @param depth - height of the pattern's bumps as a fraction of the texture's width
 */
export function makeNormalTexture(pattern: Pattern, size: number, depth: number): DataTexture {
  const heights = new Float32Array(size * size);
  const texel = newTexel();
  for (let y = 0, i = 0; y < size; y++) {
    for (let x = 0; x < size; x++, i++) {
      pattern((x + 0.5) / size, (y + 0.5) / size, texel);
      heights[i] = texel.height;
    }
  }
  const data = new Uint8Array(size * size * 4);
  const steep = (depth * size) / 2;
  for (let y = 0, i = 0; y < size; y++) {
    const above = ((y + 1) % size) * size;
    const below = ((y + size - 1) % size) * size;
    for (let x = 0; x < size; x++, i += 4) {
      const row = y * size;
      const dx = (heights[row + ((x + 1) % size)] - heights[row + ((x + size - 1) % size)]) * steep;
      const dy = (heights[above + x] - heights[below + x]) * steep;
      const scale = 127.5 / Math.sqrt(dx * dx + dy * dy + 1);
      data[i] = 127.5 - dx * scale;
      data[i + 1] = 127.5 - dy * scale;
      data[i + 2] = 127.5 + scale;
      data[i + 3] = 255;
    }
  }
  return finish(data, size, false);
}
