/**
 * The G-buffer taken apart
 *
 * Albedo, normals, depth, roughness, light and the lights a pixel has, while the scene runs: `farol.view`.
 *
 * @tags views, deferred, technique
 */
import { FarolRenderer } from '@farol/renderer';
import * as THREE from 'three';
import { OrbitControls } from 'three/addons/controls/OrbitControls.js';
import { TeapotGeometry } from 'three/addons/geometries/TeapotGeometry.js';
import { type View, views } from '@farol/renderer';

const canvas = document.querySelector('canvas')!;
const webgl = new THREE.WebGLRenderer({ canvas, antialias: true });
webgl.toneMapping = THREE.ACESFilmicToneMapping;
const farol = new FarolRenderer(webgl, { technique: 'tiled-deferred', view: 'grid' });

const scene = new THREE.Scene();
scene.background = new THREE.Color(0x080a10);
const camera = new THREE.PerspectiveCamera(42, 1, 0.1, 100);
camera.position.set(4.6, 3, 6.4);
const controls = new OrbitControls(camera, canvas);
controls.target.set(0, 0.9, 0);
controls.update();

const checks = new THREE.DataTexture(
  new Uint8Array([214, 202, 184, 255, 92, 84, 78, 255, 92, 84, 78, 255, 214, 202, 184, 255]),
  2,
  2,
);
checks.colorSpace = THREE.SRGBColorSpace;
checks.wrapS = checks.wrapT = THREE.RepeatWrapping;
checks.repeat.set(10, 10);
checks.needsUpdate = true;
const floor = new THREE.Mesh(
  new THREE.PlaneGeometry(24, 24),
  new THREE.MeshStandardMaterial({ map: checks, roughness: 0.55 }),
);
floor.rotation.x = -Math.PI / 2;
scene.add(floor, new THREE.HemisphereLight(0x8fa8d8, 0x302820, 0.3));

const shapes = [
  new THREE.TorusKnotGeometry(0.55, 0.19, 160, 24),
  new TeapotGeometry(0.6, 14),
  new THREE.SphereGeometry(0.7, 48, 32),
  new THREE.IcosahedronGeometry(0.75, 1),
  new THREE.CapsuleGeometry(0.4, 0.8, 12, 32),
];
for (const [i, geometry] of shapes.entries()) {
  const angle = (i / shapes.length) * 2 * Math.PI;
  const color = new THREE.Color().setHSL(i / shapes.length, 0.55, 0.5);
  const material = new THREE.MeshStandardMaterial({ color, roughness: 0.15 + 0.16 * i, metalness: i % 2 });
  const mesh = new THREE.Mesh(geometry, material);
  mesh.position.set(2 * Math.cos(angle), 0.85, 2 * Math.sin(angle));
  scene.add(mesh);
}
const heart = new THREE.Mesh(
  new THREE.OctahedronGeometry(0.5, 2),
  new THREE.MeshStandardMaterial({ color: 0x222222, emissive: 0xff7a30, emissiveIntensity: 1.6 }),
);
heart.position.y = 1;
scene.add(heart);

const lights = Array.from({ length: 40 }, (_, i) => {
  const light = new THREE.PointLight(new THREE.Color().setHSL((i * 0.17) % 1, 0.8, 0.6), 3, 3.2);
  scene.add(light);
  return light;
});

const panel = document.createElement('label');
panel.className = 'panel';
panel.textContent = 'View ';
const select = document.createElement('select');
select.append(...views.map((view) => new Option(view)));
select.value = farol.view;
select.addEventListener('change', () => (farol.view = select.value as View));
panel.append(select);
// what a view shows is not in every frame: motion, for one, needs TAA
const lacking = document.createElement('p');
panel.append(lacking);
document.body.append(panel);

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
  for (const [i, light] of lights.entries()) {
    const angle = 0.3 * seconds * (i % 2 ? 1 : -1) + 0.9 * i;
    light.position.set((1 + (i % 4)) * Math.cos(angle), 0.4 + 0.4 * (i % 5), (1 + (i % 4)) * Math.sin(angle));
  }
  farol.render(scene, camera);
  lacking.textContent = farol.info.view?.problem ?? '';
});

export { camera, farol, scene, webgl };
