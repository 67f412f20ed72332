/**
 * Bloom by EffectComposer
 *
 * three's own composer: `FarolPass` in place of `RenderPass`, then UnrealBloomPass and OutputPass.
 *
 * @tags post-processing, effect
 */
import { FarolRenderer } from '@farol/renderer';
import { FarolPass } from '@farol/renderer/three-pass';
import {
  ACESFilmicToneMapping,
  Color,
  HemisphereLight,
  Mesh,
  MeshBasicMaterial,
  MeshStandardMaterial,
  PerspectiveCamera,
  PlaneGeometry,
  PointLight,
  Scene,
  TorusGeometry,
  Vector2,
  WebGLRenderer,
} from 'three';
import { OrbitControls } from 'three/addons/controls/OrbitControls.js';
import { EffectComposer } from 'three/addons/postprocessing/EffectComposer.js';
import { OutputPass } from 'three/addons/postprocessing/OutputPass.js';
import { UnrealBloomPass } from 'three/addons/postprocessing/UnrealBloomPass.js';

const canvas = document.querySelector('canvas')!;
const webgl = new WebGLRenderer({ canvas });
webgl.toneMapping = ACESFilmicToneMapping;
const farol = new FarolRenderer(webgl, { technique: 'clustered-forward' });

const scene = new Scene();
scene.background = new Color(0x04050a);
const camera = new PerspectiveCamera(45, 1, 0.1, 100);
camera.position.set(0, 2, 8);
const controls = new OrbitControls(camera, canvas);
controls.target.set(0, 1.5, 0);
controls.update();

const floor = new Mesh(new PlaneGeometry(40, 40), new MeshStandardMaterial({ color: 0x3c4048, roughness: 0.3 }));
floor.rotation.x = -Math.PI / 2;
scene.add(floor, new HemisphereLight(0x7080c0, 0x201820, 0.15));
const tube = new TorusGeometry(1.5, 0.035, 12, 96);
const rings = Array.from({ length: 7 }, (_, i) => {
  const color = new Color().setHSL((0.86 + 0.07 * i) % 1, 1, 0.55);
  const ring = new Mesh(tube, new MeshBasicMaterial({ color: color.clone().multiplyScalar(1.6) })); // brighter than white
  ring.position.y = 1.7;
  for (let k = 0; k < 6; k++) {
    const light = new PointLight(color, 1.6, 4); // six lamps along the tube
    light.position.set(1.5 * Math.cos((k * Math.PI) / 3), 1.5 * Math.sin((k * Math.PI) / 3), 0);
    ring.add(light);
  }
  scene.add(ring);
  return ring;
});

const composer = new EffectComposer(webgl);
composer.addPass(new FarolPass(farol, scene, camera)); // in place of: new RenderPass(scene, camera)
composer.addPass(new UnrealBloomPass(new Vector2(256, 256), 0.35, 0.4, 0.9));
composer.addPass(new OutputPass());

function resize(): void {
  camera.aspect = innerWidth / innerHeight;
  camera.updateProjectionMatrix();
  webgl.setSize(innerWidth, innerHeight);
  composer.setSize(innerWidth, innerHeight);
}
addEventListener('resize', resize);
resize();

webgl.setAnimationLoop((milliseconds) => {
  const seconds = milliseconds / 1000;
  for (const [i, ring] of rings.entries()) ring.rotation.set(0.3 * seconds + 0.45 * i, 0.4 * seconds + 0.9 * i, 0);
  composer.render();
});

export { camera, farol, scene, webgl };
