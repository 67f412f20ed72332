import {
  Color,
  MeshBasicMaterial,
  MeshLambertMaterial,
  MeshPhongMaterial,
  MeshPhysicalMaterial,
  MeshStandardMaterial,
  MeshToonMaterial,
  ShaderMaterial,
  type Material,
} from 'three';
import { describe, expect, it } from 'vitest';
import { isLightBufferMaterial } from './isLightBufferMaterial';

const lit: Record<string, Material> = {
  Lambert: new MeshLambertMaterial(),
  'Blinn-Phong brighter than white': new MeshPhongMaterial({ color: new Color(4, 4, 4) }),
  standard: new MeshStandardMaterial(),
  'physical, of its defaults': new MeshPhysicalMaterial(),
  'physical, with a colour and intensity of its specular': new MeshPhysicalMaterial({
    specularColor: new Color(1, 0.5, 0),
    specularIntensity: 0.3,
  }),
  'physical, iridescent': new MeshPhysicalMaterial({ iridescence: 1 }),
};

const notLit: Record<string, Material> = {
  toon: new MeshToonMaterial(),
  unlit: new MeshBasicMaterial(),
  'a shader of the user': new ShaderMaterial({ lights: true }),
  'with clearcoat': new MeshPhysicalMaterial({ clearcoat: 0.5 }),
  'with sheen': new MeshPhysicalMaterial({ sheen: 0.5 }),
  anisotropic: new MeshPhysicalMaterial({ anisotropy: 0.5 }),
  transmissive: new MeshPhysicalMaterial({ transmission: 0.5 }),
};

describe('isLightBufferMaterial', () => {
  it.each(Object.keys(lit))('takes %s', (name) => expect(isLightBufferMaterial(lit[name])).toBe(true));
  it.each(Object.keys(notLit))('leaves %s to the forward draws', (name) =>
    expect(isLightBufferMaterial(notLit[name])).toBe(false),
  );

  const all = { hasAreas: true, hasImages: true };

  it('leaves what mirrors area lights sharply to the forward draws, where there are any', () => {
    const polished = new MeshStandardMaterial({ roughness: 0.1 });
    expect(
      [false, true].map((hasAreas) => isLightBufferMaterial(polished, true, { hasAreas, hasImages: false })),
    ).toEqual([true, false]);
    expect(isLightBufferMaterial(new MeshStandardMaterial({ roughness: 0.5 }), true, all)).toBe(true);
  });
});
