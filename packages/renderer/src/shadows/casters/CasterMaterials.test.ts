import { Mesh, MeshStandardMaterial, PointLight, SpotLight, Texture, type WebGLRenderer } from 'three';
import { expect, test } from 'vitest';
import { MicroShaderRegistry } from '../../microshaders';
import { CasterMaterials } from './CasterMaterials';

test('materials of their own go with their source and with dispose, which leaves nothing behind on the sources', () => {
  const webgl = { capabilities: { logarithmicDepthBuffer: true }, properties: new WeakMap() };
  const materials = new CasterMaterials(webgl as unknown as WebGLRenderer, new MicroShaderRegistry());
  const sources = [0, 1].map(() => new MeshStandardMaterial({ map: new Texture(), alphaTest: 0.5 }));
  const listeners = (source: MeshStandardMaterial) =>
    ((source as { _listeners?: { dispose?: unknown[] } })._listeners?.dispose ?? []).length;
  // as depths, and as distances
  const lights = [new SpotLight(), new PointLight()];
  webgl.properties.get = () => ({});
  let disposed = 0;
  for (const source of sources) {
    for (const light of lights) {
      const material = materials.get(new Mesh(), source, light, false);
      expect(materials.get(new Mesh(), source, light, false)).toBe(material);
      material.addEventListener('dispose', () => disposed++);
    }
  }
  sources[0].dispose();
  expect(disposed).toBe(2);
  expect(listeners(sources[0])).toBe(0);
  materials.dispose();
  expect(disposed).toBe(4);
  expect(listeners(sources[1])).toBe(0);
});
