import {
  type Material,
  MeshBasicMaterial,
  MeshPhysicalMaterial,
  MeshStandardMaterial,
  Texture,
  type WebGLRenderer,
} from 'three';
import { expect, it, test } from 'vitest';
import { OpacityMasks } from './OpacityMasks';

/** A renderer that counts the layers drawn. */
function fakeRenderer() {
  const layers: number[] = [];
  const setRenderTarget = (_: object, layer: number) => void layers.push(layer);
  return { layers, renderer: { setRenderTarget, render: () => {} } as unknown as WebGLRenderer };
}

const opacityOf = (material: Material) => {
  const masks = new OpacityMasks(fakeRenderer().renderer, new Set([material]));
  return masks.of(material);
};

test.each<[string, Material, number, number]>([
  ['opaque', new MeshStandardMaterial(), 0, 1],
  ['opaque, its opacity unused', new MeshStandardMaterial({ opacity: 0.3 }), 0, 1],
  ['a cut-out', new MeshStandardMaterial({ alphaTest: 0.4 }), 0.4, 1],
  ['a transparent cut-out', new MeshStandardMaterial({ alphaTest: 0.4, transparent: true, opacity: 0.7 }), 0.4, 0.7],
  ['transparent', new MeshStandardMaterial({ transparent: true, opacity: 0.3 }), -1, 0.3],
  ['hashed', new MeshBasicMaterial({ alphaHash: true, opacity: 0.6 }), -1, 0.6],
  ['glass', new MeshPhysicalMaterial({ transmission: 0.75 }), -1, 0.25],
  [
    'half transparent glass',
    new MeshPhysicalMaterial({ transmission: 0.5, transparent: true, opacity: 0.5 }),
    -1,
    0.25,
  ],
])('%s', (_, material, seen, opacity) => {
  expect(opacityOf(material)).toEqual({ layer: -1, test: seen, opacity });
});

it('gives a layer to what has a map and is not opaque, and is opaque for what it does not know', () => {
  const map = new Texture();
  const materials = [
    new MeshStandardMaterial({ map }),
    new MeshStandardMaterial({ map, alphaTest: 0.5 }),
    new MeshStandardMaterial({ transparent: true }),
    new MeshStandardMaterial({ alphaMap: map, transparent: true }),
  ];
  const { layers, renderer } = fakeRenderer();
  const masks = new OpacityMasks(renderer, new Set(materials));
  expect(materials.map((each) => masks.of(each).layer)).toEqual([-1, 0, -1, 1]);
  expect(layers).toEqual([0, 1]);
  expect(masks.target.depth).toBe(2);
  expect(masks.of(new MeshStandardMaterial({ alphaTest: 0.5 }))).toEqual({ layer: -1, test: 0, opacity: 1 });
});
