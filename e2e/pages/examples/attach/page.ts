/** A page that knows nothing of Farol: three, its controls, a scene and a loop. */
import { WebGLRenderer } from 'three';
import { OrbitControls } from 'three/addons/controls/OrbitControls.js';
import { lanterns } from '../shared/lanterns';

export const renderer = new WebGLRenderer();
document.body.append(renderer.domElement);

const { scene, camera, update } = lanterns();
export { camera, scene };

export const controls = new OrbitControls(camera, renderer.domElement);
controls.target.set(0, 1.4, 0);
controls.update();

/** @param seconds - time on the page's clock */
export function drawFrame(seconds: number): void {
  update(seconds);
  renderer.render(scene, camera);
}

function resize(): void {
  camera.aspect = innerWidth / innerHeight;
  camera.updateProjectionMatrix();
  renderer.setSize(innerWidth, innerHeight);
}

addEventListener('resize', resize);
resize();
