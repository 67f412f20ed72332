import {
  AdditiveBlending,
  Mesh,
  MeshStandardMaterial,
  MultiplyBlending,
  NormalBlending,
  PlaneGeometry,
  SubtractiveBlending,
} from 'three';
import { expect, test } from 'vitest';
import { Decal } from './Decal';

test.each([
  [NormalBlending, false],
  [AdditiveBlending, false],
  [SubtractiveBlending, true],
  [MultiplyBlending, true],
])('its mesh blends as it does, with the alpha that three asks for: blending %i', (blending, premultipliedAlpha) => {
  const surface = new MeshStandardMaterial({ blending });
  const { material } = new Decal(surface).toMesh(new Mesh(new PlaneGeometry(2, 2)));
  expect(material).toMatchObject({ blending, premultipliedAlpha, transparent: true });
  expect(surface.premultipliedAlpha).toBe(false);
});
