import { FarolRenderer } from '@farol/renderer';
import { ACESFilmicToneMapping, AmbientLight, PerspectiveCamera, Scene, WebGLRenderer } from 'three';
import { OrbitControls } from 'three/addons/controls/OrbitControls.js';
import { lamps, moveLamps } from './lamps';
import { objects } from './objects';

const webgl = new WebGLRenderer();
webgl.toneMapping = ACESFilmicToneMapping;
document.body.append(webgl.domElement);
const farol = new FarolRenderer(webgl);

const scene = new Scene();
scene.add(new AmbientLight('white', 0.1), objects, lamps);
moveLamps(0);

const camera = new PerspectiveCamera(50, 1, 0.1, 100);
camera.position.set(0, 4, 12);
const controls = new OrbitControls(camera, webgl.domElement);

function resize() {
  camera.aspect = innerWidth / innerHeight;
  camera.updateProjectionMatrix();
  farol.setPixelRatio(Math.min(devicePixelRatio, 2));
  farol.setSize(innerWidth, innerHeight);
}
addEventListener('resize', resize);
resize();

await farol.compileAsync(scene, camera); // compiles all programs, so that the first frame is complete
webgl.setAnimationLoop((milliseconds) => {
  moveLamps(milliseconds / 1000);
  controls.update();
  farol.render(scene, camera);
});
