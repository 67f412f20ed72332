import type { Texture } from 'three';
import { makeColourTexture, makeNormalTexture } from './makeTexture';
import { blocks, checker, cloth, grass, marble, type Pattern, plaster, sky, tiles, wood } from './patterns';

/** An asset of type 'texture', made on first use. */
export interface TextureSource {
  readonly type: 'texture';
  make(): Texture;
}

interface Look {
  readonly pattern: () => Pattern;
  /** Height of the bumps as a fraction of the texture's width; without it there is no normal map. */
  readonly depth?: number;
}

const patterns: Readonly<Record<string, Look>> = {
  checker: { pattern: () => checker([235, 235, 235], [40, 40, 44], 8) },
  sky: { pattern: sky },
  marble: { pattern: () => marble([232, 226, 214], 11), depth: 0.02 },
  stone: { pattern: () => blocks([206, 196, 178], 4, 8, 23), depth: 0.02 },
  brick: { pattern: () => blocks([178, 118, 92], 6, 12, 37), depth: 0.018 },
  tiles: { pattern: () => tiles([196, 186, 168], [128, 96, 84], 4, 41), depth: 0.012 },
  plaster: { pattern: () => plaster([214, 200, 176], 53), depth: 0.02 },
  wood: { pattern: () => wood([140, 98, 62], 6, 67), depth: 0.02 },
  grass: { pattern: () => grass([92, 150, 58], 71), depth: 0.03 },
  'cloth-red': { pattern: () => cloth([180, 42, 40], 6, 83), depth: 0.006 },
  'cloth-green': { pattern: () => cloth([48, 130, 70], 6, 89), depth: 0.006 },
  'cloth-blue': { pattern: () => cloth([52, 74, 172], 6, 97), depth: 0.006 },
};

/** Sizes (texels) of generated textures: the first is named 'stone', the others 'stone@512' and 'stone@128'. */
export const textureSizes = [256, 512, 128] as const;

/** Name of a generated texture at a size. */
export const textureName = (name: string, size: number): string =>
  size === textureSizes[0] ? name : `${name}@${size}`;

/** The generated textures: a colour map 'stone' and a normal map 'stone-normal' for each look, at each size. */
export const builtinTextures: Readonly<Record<string, TextureSource>> = Object.fromEntries(
  textureSizes.flatMap((size) =>
    Object.entries(patterns).flatMap(([name, { pattern, depth }]): [string, TextureSource][] => {
      const colour: TextureSource = { type: 'texture', make: () => makeColourTexture(pattern(), size) };
      if (depth === undefined) return [[textureName(name, size), colour]];
      const normal: TextureSource = { type: 'texture', make: () => makeNormalTexture(pattern(), size, depth) };
      return [
        [textureName(name, size), colour],
        [textureName(`${name}-normal`, size), normal],
      ];
    }),
  ),
);
