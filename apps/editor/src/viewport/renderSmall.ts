import { FarolRenderer } from '@farol/renderer';
import type { Camera, Material, Mesh, Scene, WebGLRenderer } from 'three';

const renderers = new WeakMap<WebGLRenderer, FarolRenderer>();

function wearsSurface(scene: Scene): boolean {
  let wears = false;
  scene.traverse((object) => {
    const { material } = object as Partial<Mesh>;
    for (const each of ([] as Material[]).concat(material ?? [])) wears ||= typeof each.userData.surface === 'string';
  });
  return wears;
}

/** Renders a small scene with three, or with Farol when a material has a surface, which three cannot draw. */
export function renderSmall(webgl: WebGLRenderer, scene: Scene, camera: Camera): void {
  if (!wearsSurface(scene)) return webgl.render(scene, camera);
  let farol = renderers.get(webgl);
  if (!farol) renderers.set(webgl, (farol = new FarolRenderer(webgl, { technique: 'forward-single-pass' })));
  farol.render(scene, camera);
}
