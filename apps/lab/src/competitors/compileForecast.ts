import { Mesh, MeshStandardMaterial, PerspectiveCamera, PlaneGeometry, PointLight, Scene, WebGLRenderer } from 'three';
import { loseContext } from '../stage/loseContext';
import { saltShaders } from '../measure/saltShaders';
import { waitForPixel } from '../measure/waitForPixel';

/** Numbers of lights that are tried. */
const TRIED = [16, 64] as const;
/** Growth by lights that is believed: compilers are no better than linear, hardly worse than cubic. */
const SLOPES = [1, 3] as const;

let tried: readonly number[] | null = null;

/**
 * Foretells how long three's shader takes to compile with that many lights (ms), by compiling it with few: on some devices
 * it is minutes, in which the page would hang.
 */
export function compileForecast(lights: number): number {
  tried ??= TRIED.map(compile);
  const slope = Math.log(tried[1] / tried[0]) / Math.log(TRIED[1] / TRIED[0]);
  return tried[1] * (lights / TRIED[1]) ** Math.min(SLOPES[1], Math.max(SLOPES[0], slope));
}

/** Time of a first frame of next to nothing with so many lights (ms). */
function compile(lights: number): number {
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
