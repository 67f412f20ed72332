import { Mesh, MeshStandardMaterial, PerspectiveCamera, PlaneGeometry, PointLight, Scene, WebGLRenderer } from 'three';
import { saltShaders } from '../measure/saltShaders';
import { waitForPixel } from '../measure/waitForPixel';
import { loseContext } from '../stage/loseContext';

/** Measures the first frame of stock three with one plane and `lights` point lights (ms). */
export function smallFirstFrame(lights: number): number {
  const canvas = Object.assign(document.createElement('canvas'), { width: 1, height: 1 });
  saltShaders(canvas);
  const renderer = new WebGLRenderer({ canvas, antialias: false });
  const gl = renderer.getContext() as WebGL2RenderingContext;
  const scene = new Scene();
  const mesh = new Mesh(new PlaneGeometry(), new MeshStandardMaterial());
  mesh.position.z = -2;
  scene.add(mesh);
  for (let i = 0; i < lights; i++) scene.add(new PointLight());
  waitForPixel(gl);
  const begin = performance.now();
  renderer.render(scene, new PerspectiveCamera());
  waitForPixel(gl);
  const ms = performance.now() - begin;
  renderer.dispose();
  loseContext(gl);
  return ms;
}
