import * as THREE from 'three';
import { edgeScene } from '../edgeScene';
import type { TestScene } from '../materialScene';
import { shadowScene } from '../shadowScene';

/** The scenes that the soak goes through. Each call makes all of it anew. */
export const soakScenes: Readonly<Record<string, (width: number, height: number) => TestScene>> = {
  edges: edgeScene,
  spots: (width, height) => shadowScene(width, height, { caster: 'spot' }),
  mixed: (width, height) => shadowScene(width, height, { caster: 'mixed' }),
};

/** Frees what a scene holds on the GPU, as an application does that closes it. */
export function disposeScene(scene: THREE.Scene): void {
  scene.traverse((object) => {
    if (object instanceof THREE.Light) {
      if (object instanceof THREE.SpotLight) object.map?.dispose();
      object.dispose();
    }
    if (object instanceof THREE.InstancedMesh || object instanceof THREE.BatchedMesh) object.dispose();
    if (object instanceof THREE.SkinnedMesh) object.skeleton.dispose();
    const { geometry, material } = object as Partial<THREE.Mesh>;
    geometry?.dispose();
    for (const each of [material ?? []].flat()) {
      for (const value of Object.values(each)) if (value instanceof THREE.Texture) value.dispose();
      each.dispose();
    }
  });
  if (scene.background instanceof THREE.Texture) scene.background.dispose();
  scene.environment?.dispose();
}

/** Lights that can cast shadows. */
export type Caster = THREE.DirectionalLight | THREE.PointLight | THREE.SpotLight;

export function casters(scene: THREE.Scene): Caster[] {
  const list: Caster[] = [];
  scene.traverse((object) => {
    if (
      object instanceof THREE.DirectionalLight ||
      object instanceof THREE.PointLight ||
      object instanceof THREE.SpotLight
    )
      list.push(object);
  });
  return list;
}
