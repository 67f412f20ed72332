import { Color, Mesh, MeshStandardMaterial, type Object3D, Scene, ShaderMaterial, Texture } from 'three';
import { expect, it } from 'vitest';
import { LightField } from '../../light-fields/LightField';
import { RenderQueue } from '../../frame/RenderQueue';
import { looksOf, surroundingsOf } from './looksOf';

function queueOf(...meshes: Mesh[]): RenderQueue {
  const queue = new RenderQueue();
  queue.clear();
  for (const mesh of meshes) {
    queue.push(mesh as Object3D, mesh.geometry, mesh.material as MeshStandardMaterial, 0, 0, null, null);
  }
  queue.finish();
  return queue;
}

it('stays while nothing changes, and tells a change of any look', () => {
  const material = new MeshStandardMaterial({ color: 0x336699, transparent: true, opacity: 0.5 });
  const looks = () => looksOf(queueOf(new Mesh(undefined, material)));
  let before = looks();
  expect(looks()).toBe(before);
  const changes = [
    () => material.color.setRGB(0.1, 0.2, 0.3),
    () => (material.opacity = 0.6),
    () => (material.roughness = 0.2),
    () => (material.emissiveIntensity = 2),
    () => (material.needsUpdate = true),
  ];
  for (const change of changes) {
    change();
    expect(looks()).not.toBe(before);
    before = looks();
  }
});

it('takes a shader of the host for one that may change at any time', () => {
  const looks = looksOf(queueOf(new Mesh(undefined, new ShaderMaterial())));
  expect(looks === looks).toBe(false);
});

it('tells that a light has gone, that ambient light or the background has changed', () => {
  const field = new LightField(1);
  const lights = { visible: 2, ambient: new Float32Array(16).fill(0.25), fields: [field] };
  const scene = new Scene();
  scene.background = new Color(0x112233);
  const seen = new Set([surroundingsOf(lights, scene)]);
  expect(seen.has(surroundingsOf(lights, scene))).toBe(true);
  lights.visible = 1;
  seen.add(surroundingsOf(lights, scene));
  expect(seen.size).toBe(2);
  lights.ambient[3] = 0.5;
  seen.add(surroundingsOf(lights, scene));
  scene.background.g += 0.1;
  seen.add(surroundingsOf(lights, scene));
  scene.environmentIntensity = 0.5;
  seen.add(surroundingsOf(lights, scene));
  expect(seen.size).toBe(5);
  field.intensity = 2;
  seen.add(surroundingsOf(lights, scene));
  field.matrixWorld.setPosition(1, 0, 0);
  seen.add(surroundingsOf(lights, scene));
  expect(seen.size).toBe(7);
  field.textures = { sphere: new Texture(), emission: new Texture() };
  expect(surroundingsOf(lights, scene), 'the GPU may move them').toBeNaN();
});
