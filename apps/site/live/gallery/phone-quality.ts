/**
 * Lite, for phones
 *
 * `quality: 'lite'` takes G-buffers of 14 bytes a pixel and smaller shadow maps; `auto` does so on phones by itself.
 *
 * @tags phones, cost, shadows
 */
import { FarolRenderer } from '@farol/renderer';
import * as THREE from 'three';
import { OrbitControls } from 'three/addons/controls/OrbitControls.js';

const canvas = document.querySelector('canvas')!;
const webgl = new THREE.WebGLRenderer({ canvas, antialias: true });
webgl.toneMapping = THREE.ACESFilmicToneMapping;
webgl.shadowMap.enabled = true;
const farol = new FarolRenderer(webgl, { technique: 'clustered-deferred', quality: 'lite' });

const scene = new THREE.Scene();
scene.background = new THREE.Color(0x070812);
const camera = new THREE.PerspectiveCamera(42, 1, 0.1, 100);
camera.position.set(3.6, 2.6, 5.6);
const controls = new OrbitControls(camera, canvas);
controls.target.set(0, 0.8, 0);
controls.update();

const floor = new THREE.Mesh(
  new THREE.CylinderGeometry(3.2, 3.2, 0.2, 96),
  new THREE.MeshStandardMaterial({ color: 0x8a8fa0, roughness: 0.45 }),
);
floor.position.y = -0.1;
floor.receiveShadow = true;
scene.add(floor, new THREE.HemisphereLight(0x90a8e0, 0x302820, 0.25));
const gem = new THREE.OctahedronGeometry(0.34, 0);
const gems = Array.from({ length: 12 }, (_, i) => {
  const mesh = new THREE.Mesh(
    gem,
    new THREE.MeshStandardMaterial({
      color: new THREE.Color().setHSL(i / 12, 0.5, 0.65),
      roughness: 0.2,
      metalness: 0.3,
    }),
  );
  mesh.scale.y = 1.6;
  mesh.castShadow = mesh.receiveShadow = true;
  scene.add(mesh);
  return mesh;
});
const moon = new THREE.SpotLight(0xbcd0ff, 160, 16, 0.5, 0.6);
moon.position.set(-3, 7, 3);
moon.castShadow = true;
moon.shadow.normalBias = 0.03;
scene.add(moon);
const bulb = new THREE.SphereGeometry(0.05, 16, 12);
const lights = Array.from({ length: 30 }, (_, i) => {
  const light = new THREE.PointLight(new THREE.Color().setHSL((i * 0.618) % 1, 0.85, 0.6), 1.6, 2.4);
  light.add(new THREE.Mesh(bulb, new THREE.MeshBasicMaterial({ color: light.color })));
  scene.add(light);
  return light;
});
const select = document.createElement('select');
select.className = 'panel';
select.ariaLabel = 'Quality';
select.append(new Option('lite'), new Option('full'), new Option('auto'));
select.addEventListener('change', () => (farol.quality = select.value as typeof farol.quality));
document.body.append(select);

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
  for (const [i, mesh] of gems.entries()) {
    const angle = (i / 12) * 2 * Math.PI + 0.1 * seconds;
    mesh.position.set(2 * Math.cos(angle), 0.75 + 0.15 * Math.sin(seconds + i), 2 * Math.sin(angle));
    mesh.rotation.y = seconds + i;
  }
  for (const [i, light] of lights.entries()) {
    const angle = 0.4 * seconds * (i % 2 ? 1 : -1) + 2.4 * i;
    light.position.set(
      0.55 * Math.sqrt(i) * Math.cos(angle),
      0.3 + 0.3 * (i % 4),
      0.55 * Math.sqrt(i) * Math.sin(angle),
    );
  }
  farol.render(scene, camera);
});

export { camera, farol, scene, webgl };
