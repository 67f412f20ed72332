import type { GraphicsDevice, StandardMaterial } from 'playcanvas';
import { describe, expect, test, vi } from 'vitest';
import type { RivalMaterial, RivalScene } from '../../../src/competitors/rivals/RivalScene';
import { encode, Materials } from './makeMaterials';

// PlayCanvas is installed on demand: a stub with its names, whose materials store what is assigned
vi.mock('playcanvas', () => {
  const constants = [
    ...['ADDRESS_REPEAT', 'ADDRESS_MIRRORED_REPEAT', 'ADDRESS_CLAMP_TO_EDGE', 'BLEND_NORMAL', 'CULLFACE_BACK'],
    ...['CULLFACE_NONE', 'FILTER_LINEAR', 'FILTER_LINEAR_MIPMAP_LINEAR', 'FILTER_LINEAR_MIPMAP_NEAREST'],
    ...['FILTER_NEAREST', 'FILTER_NEAREST_MIPMAP_LINEAR', 'FILTER_NEAREST_MIPMAP_NEAREST', 'SHADERLANGUAGE_GLSL'],
    ...['SEMANTIC_ATTR10', 'SEMANTIC_ATTR11', 'SEMANTIC_ATTR12', 'SEMANTIC_ATTR14', 'SEMANTIC_ATTR15'],
  ].map((name) => [name, name]);
  class Color {
    constructor(
      readonly r: number,
      readonly g: number,
      readonly b: number,
    ) {}
  }
  class StandardMaterial {
    readonly chunks = {};
    readonly diffuseVertexColor = false;
    readonly emissiveVertexColor = false;
    readonly useLighting = true;
    setParameter(): void {}
    update(): void {}
  }
  return { ...Object.fromEntries(constants), Color, StandardMaterial, ShaderChunks: {} };
});

const plain: RivalMaterial = {
  ...{ name: 'Plain', isLit: true, colour: [0.5, 0.25, 1], map: null, normalMap: null, normalScale: [1, 1] },
  ...{ roughness: 0.5, metalness: 0.25, roughnessMetalnessMap: null, emissive: [0, 0, 0], emissiveMap: null },
  ...{ isDoubleSided: false, hasVertexColours: false, alphaTest: 0, isTransparent: false, opacity: 1 },
};

/** PlayCanvas's material for a material of the scene. */
const made = (changes: Partial<RivalMaterial>): StandardMaterial => {
  const scene = { textures: [], materials: [{ ...plain, ...changes }] } as unknown as RivalScene;
  return new Materials(null as unknown as GraphicsDevice, scene, null).get(0, false);
};

describe.each([true, false])('a material with vertex colours: %s', (hasVertexColours) => {
  test('multiplies its colour by them where it is lit', () => {
    const material = made({ hasVertexColours });
    expect([material.diffuseVertexColor, material.emissiveVertexColor]).toEqual([hasVertexColours, false]);
    expect([material.diffuse, material.useLighting]).toEqual([encode(plain.colour), true]);
  });

  test('multiplies what it emits by them where it is not', () => {
    const material = made({ hasVertexColours, isLit: false });
    expect([material.diffuseVertexColor, material.emissiveVertexColor]).toEqual([false, hasVertexColours]);
    expect([material.emissive, material.useLighting]).toEqual([encode(plain.colour), false]);
  });
});

test('colours above 1 become an intensity', () => {
  const { emissive, emissiveIntensity } = made({ emissive: [4, 2, 0] });
  expect([emissive, emissiveIntensity]).toEqual([encode([1, 0.5, 0]), 4]);
});

test('both sides are drawn, and lit, where the scene draws both', () => {
  for (const isDoubleSided of [false, true]) {
    const { cull, twoSidedLighting } = made({ isDoubleSided });
    expect([cull, twoSidedLighting]).toEqual([isDoubleSided ? 'CULLFACE_NONE' : 'CULLFACE_BACK', isDoubleSided]);
  }
});
