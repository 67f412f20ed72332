/**
 * A microshader for toon shading
 *
 * One function of the deferred lighting shader is replaced while it runs: light falls into bands, by any number of lamps.
 *
 * @tags microshader, deferred
 */
import { FarolRenderer } from '@farol/renderer';
import * as THREE from 'three';
import { OrbitControls } from 'three/addons/controls/OrbitControls.js';

const canvas = document.querySelector('canvas')!;
const webgl = new THREE.WebGLRenderer({ canvas, antialias: true });
webgl.toneMapping = THREE.ACESFilmicToneMapping;
const farol = new FarolRenderer(webgl, { technique: 'deferred' });

const scene = new THREE.Scene();
scene.background = new THREE.Color(0x1a1c2c);
const camera = new THREE.PerspectiveCamera(40, 1, 0.1, 100);
camera.position.set(3.4, 2.2, 5);
const controls = new OrbitControls(camera, canvas);
controls.target.set(0, 1, 0);
controls.update();

// the chunk that ends the lighting of a G-buffer pixel; its diffuse light goes through steps. The packages' GLSL has no
// blanks round operators
const chunk = farol.microshaders.get('shadeSurface')!;
const bands = `vec3 example_bands(vec3 light) { return floor(light * 3.0 + 0.6) / 3.0; }\n`;
const toon = {
  ...chunk,
  header: chunk.header
    .replace('vec3 farol_endShading', `${bands}vec3 farol_endShading`)
    .replaceAll(/s\.diffuse ?\* ?albedo/g, 'example_bands(s.diffuse) * albedo'),
};
farol.microshaders.replace('shadeSurface', toon);

const matte = (color: number) => new THREE.MeshStandardMaterial({ color, roughness: 1 });
const floor = new THREE.Mesh(new THREE.PlaneGeometry(30, 30), matte(0x7a6f9a));
floor.rotation.x = -Math.PI / 2;
const bunny = new THREE.Group();
const part = (geometry: THREE.BufferGeometry, color: number, x: number, y: number, z: number) => {
  const mesh = new THREE.Mesh(geometry, matte(color));
  mesh.position.set(x, y, z);
  bunny.add(mesh);
  return mesh;
};
part(new THREE.SphereGeometry(0.75, 48, 32), 0xf4efe6, 0, 0.75, 0);
part(new THREE.SphereGeometry(0.5, 48, 32), 0xf4efe6, 0, 1.65, 0.15);
for (const x of [-0.22, 0.22]) {
  part(new THREE.CapsuleGeometry(0.12, 0.55, 12, 24), 0xf4efe6, x, 2.35, 0).rotation.z = -0.6 * x;
  part(new THREE.SphereGeometry(0.07, 24, 16), 0x222233, x, 1.72, 0.6);
  part(new THREE.SphereGeometry(0.26, 32, 20), 0xf4efe6, 2 * x, 0.2, 0.5);
}
part(new THREE.SphereGeometry(0.08, 24, 16), 0xff7a9a, 0, 1.58, 0.65);
part(new THREE.SphereGeometry(0.2, 24, 16), 0xffffff, 0, 0.5, -0.72);
scene.add(floor, bunny);
for (let i = 0; i < 14; i++) {
  const angle = (i / 14) * 2 * Math.PI;
  const tree = new THREE.Mesh(new THREE.ConeGeometry(0.5, 1.8, 24), matte(0x4f9a72));
  tree.position.set(6 * Math.cos(angle), 0.9, 6 * Math.sin(angle));
  scene.add(tree);
}
const lights = Array.from({ length: 10 }, (_, i) => {
  const light = new THREE.PointLight(new THREE.Color().setHSL(0.02 + 0.09 * i, 0.7, 0.7), 7, 6);
  scene.add(light);
  return light;
});
const box = document.createElement('label');
box.className = 'panel';
const check = Object.assign(document.createElement('input'), { type: 'checkbox', checked: true });
check.addEventListener('change', () => farol.microshaders.replace('shadeSurface', check.checked ? toon : chunk));
box.append(check, 'Toon');
document.body.append(box);

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
  bunny.rotation.y = 0.5 * Math.sin(seconds);
  for (const [i, light] of lights.entries()) {
    const angle = 0.5 * seconds + (i / 10) * 2 * Math.PI;
    light.position.set(2.8 * Math.cos(angle), 1 + 0.6 * (i % 3), 2.8 * Math.sin(angle));
  }
  farol.render(scene, camera);
});

export { camera, farol, scene, webgl };
