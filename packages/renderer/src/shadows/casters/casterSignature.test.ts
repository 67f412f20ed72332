import { Mesh, MeshBasicMaterial, Plane } from 'three';
import { expect, it } from 'vitest';
import { isAnimatedCaster } from './casterSignature';

it('a shadow that planes cut may change at any time, whichever of the materials they cut', () => {
  const whole = new MeshBasicMaterial();
  const cut = new MeshBasicMaterial({ clipShadows: true, clippingPlanes: [new Plane()] });
  const isAnimated = (...materials: MeshBasicMaterial[]): boolean => isAnimatedCaster(new Mesh(undefined, materials));
  expect(isAnimatedCaster(new Mesh(undefined, cut))).toBe(true);
  expect(isAnimated(whole, cut)).toBe(true);
  expect(isAnimated(cut, whole)).toBe(true);
  expect(isAnimated(whole, whole)).toBe(false);
  expect(isAnimatedCaster(new Mesh(undefined, whole))).toBe(false);
});
