/**
 * A transparent canvas over the page
 *
 * With `alpha: true` the page shows through: lit glass and metal float over its own text, in any technique.
 *
 * @tags canvas, transparency
 */
import { FarolRenderer } from '@farol/renderer';
import * as THREE from 'three';
import { OrbitControls } from 'three/addons/controls/OrbitControls.js';

const page = document.createElement('article');
page.innerHTML = '<h1>Light is paint</h1><p>This is text of the page, not of the scene. The canvas lies over it.</p>';
page.style.cssText =
  'position: fixed; inset: 0; z-index: -1; display: grid; place-content: center; text-align: center; color: #20242c;' +
  'background: linear-gradient(135deg, #ffe9c8, #c8dcff); font: 16px/1.5 Georgia, serif';
page.querySelector('h1')!.style.cssText = 'font-size: 12vw; margin: 0; line-height: 1';
document.body.append(page);

const canvas = document.querySelector('canvas')!;
const webgl = new THREE.WebGLRenderer({ canvas, antialias: true, alpha: true });
webgl.toneMapping = THREE.ACESFilmicToneMapping;
const farol = new FarolRenderer(webgl, { technique: 'clustered-deferred' });
const scene = new THREE.Scene(); // no background: what nothing covers stays transparent
const camera = new THREE.PerspectiveCamera(45, 1, 0.1, 60);
camera.position.set(0, 0, 7);
const controls = new OrbitControls(camera, canvas);

const rings = Array.from({ length: 6 }, (_, i) => {
  const isGlass = i % 2 === 0;
  const ring = new THREE.Mesh(
    isGlass ? new THREE.IcosahedronGeometry(0.7, 1) : new THREE.TorusGeometry(0.8, 0.26, 32, 96),
    new THREE.MeshStandardMaterial({
      color: new THREE.Color().setHSL(i / 6, 0.7, 0.55),
      roughness: 0.15,
      metalness: isGlass ? 0 : 0.8,
      transparent: isGlass,
      opacity: isGlass ? 0.6 : 1,
      flatShading: isGlass,
    }),
  );
  ring.position.set(2 * ((i % 3) - 1) * 1.3, i < 3 ? 1.2 : -1.2, 0);
  scene.add(ring);
  return ring;
});
const lights = Array.from({ length: 18 }, (_, i) => {
  const light = new THREE.PointLight(new THREE.Color().setHSL(i / 18, 0.6, 0.7), 14, 6);
  scene.add(light);
  return light;
});

function resize(): void {
  camera.aspect = innerWidth / innerHeight;
  camera.updateProjectionMatrix();
  farol.setPixelRatio(Math.min(devicePixelRatio, 2));
  farol.setSize(innerWidth, innerHeight);
}
addEventListener('resize', resize);
resize();

webgl.setAnimationLoop((milliseconds) => {
  const seconds = milliseconds / 1000;
  controls.update();
  for (const [i, ring] of rings.entries()) ring.rotation.set(0.4 * seconds + i, 0.3 * seconds, 0);
  for (const [i, light] of lights.entries()) {
    const angle = 0.5 * seconds + (i / 18) * 2 * Math.PI;
    light.position.set(3.6 * Math.cos(angle), 2 * Math.sin(2 * angle), 2.2);
  }
  farol.render(scene, camera);
});

export { camera, farol, scene, webgl };
