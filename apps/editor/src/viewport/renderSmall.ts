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

/** Draws a small scene by three; by Farol where a material wears a surface, of which three knows nothing. */
export function renderSmall(webgl: WebGLRenderer, scene: Scene, camera: Camera): void {
  if (!wearsSurface(scene)) return webgl.render(scene, camera);
  let farol = renderers.get(webgl);
  if (!farol) renderers.set(webgl, (farol = new FarolRenderer(webgl, { technique: 'forward-single-pass' })));
  farol.render(scene, camera);
}
