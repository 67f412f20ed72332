/**
 * Bloom by EffectComposer
 *
 * three's own composer: `FarolPass` in place of `RenderPass`, then UnrealBloomPass and OutputPass.
 *
 * @tags post-processing, effect
 */
import { FarolRenderer } from '@farol/renderer';
import { FarolPass } from '@farol/renderer/three-pass';
import * as THREE from 'three';
import { OrbitControls } from 'three/addons/controls/OrbitControls.js';
import { EffectComposer } from 'three/addons/postprocessing/EffectComposer.js';
import { OutputPass } from 'three/addons/postprocessing/OutputPass.js';
import { UnrealBloomPass } from 'three/addons/postprocessing/UnrealBloomPass.js';

const canvas = document.querySelector('canvas')!;
const webgl = new THREE.WebGLRenderer({ canvas });
webgl.toneMapping = THREE.ACESFilmicToneMapping;
const farol = new FarolRenderer(webgl, { technique: 'clustered-forward' });

const scene = new THREE.Scene();
scene.background = new THREE.Color(0x04050a);
const camera = new THREE.PerspectiveCamera(45, 1, 0.1, 100);
camera.position.set(0, 2, 8);
const controls = new OrbitControls(camera, canvas);
controls.target.set(0, 1.5, 0);
controls.update();

const floor = new THREE.Mesh(
  new THREE.PlaneGeometry(40, 40),
  new THREE.MeshStandardMaterial({ color: 0x3c4048, roughness: 0.3 }),
);
floor.rotation.x = -Math.PI / 2;
scene.add(floor, new THREE.HemisphereLight(0x7080c0, 0x201820, 0.15));
const tube = new THREE.TorusGeometry(1.5, 0.035, 12, 96);
const rings = Array.from({ length: 7 }, (_, i) => {
  const color = new THREE.Color().setHSL((0.86 + 0.07 * i) % 1, 1, 0.55);
  const ring = new THREE.Mesh(tube, new THREE.MeshBasicMaterial({ color: color.clone().multiplyScalar(1.6) })); // brighter than white
  ring.position.y = 1.7;
  for (let k = 0; k < 6; k++) {
    const light = new THREE.PointLight(color, 1.6, 4); // six lamps along the tube
    light.position.set(1.5 * Math.cos((k * Math.PI) / 3), 1.5 * Math.sin((k * Math.PI) / 3), 0);
    ring.add(light);
  }
  scene.add(ring);
  return ring;
});

const composer = new EffectComposer(webgl);
composer.addPass(new FarolPass(farol, scene, camera)); // in place of: new RenderPass(scene, camera)
composer.addPass(new UnrealBloomPass(new THREE.Vector2(256, 256), 0.35, 0.4, 0.9));
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
