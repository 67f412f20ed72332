import { PerspectiveCamera } from 'three';
import { expect, test } from 'vitest';
import { ShadowFace } from './ShadowFace';

test('runs of one side alone are cleared, though nothing was drawn of the others', () => {
  const face = new ShadowFace(new PerspectiveCamera());
  face.runs(1, 2).add(0, 3);
  face.clear();
  expect(face.runs(1, 2).count).toBe(0);
});
