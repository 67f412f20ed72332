/**
 * Decals
 *
 * Pictures thrown on whatever lies in their boxes: colour, normals and roughness, before any light is added.
 *
 * @tags effect, deferred, textures
 */
import { FarolRenderer } from '@farol/renderer';
import { Decal, Decals } from '@farol/renderer/decals';
import * as THREE from 'three';
import { OrbitControls } from 'three/addons/controls/OrbitControls.js';

const canvas = document.querySelector('canvas')!;
const webgl = new THREE.WebGLRenderer({ canvas, antialias: true });
webgl.toneMapping = THREE.ACESFilmicToneMapping;
const farol = new FarolRenderer(webgl, { technique: 'deferred', effects: [new Decals()] });

const scene = new THREE.Scene();
scene.background = new THREE.Color(0x07080b);
const camera = new THREE.PerspectiveCamera(45, 1, 0.1, 100);
camera.position.set(2.2, 1.9, 3.9);
const controls = new OrbitControls(camera, canvas);
controls.target.set(0, 0.9, 0);
controls.update();

const floor = new THREE.Mesh(
  new THREE.PlaneGeometry(30, 30),
  new THREE.MeshStandardMaterial({ color: 0x77726a, roughness: 0.9 }),
);
floor.rotation.x = -Math.PI / 2;
const pot = new THREE.Mesh(
  new THREE.SphereGeometry(1, 64, 48),
  new THREE.MeshStandardMaterial({ color: 0xe8ddcc, roughness: 0.6 }),
);
pot.position.y = 1;
const slab = new THREE.Mesh(
  new THREE.BoxGeometry(1.4, 2.4, 0.5),
  new THREE.MeshStandardMaterial({ color: 0xb9c2c4, roughness: 0.7 }),
);
slab.position.set(-2.2, 1.2, -0.8);
slab.rotation.y = 0.4;
scene.add(floor, pot, slab, new THREE.HemisphereLight(0xa0b0e0, 0x403830, 0.35));

/** A splash of paint: colour with an alpha of its own. */
function splash(hue: number): THREE.CanvasTexture {
  const picture = document.createElement('canvas');
  picture.width = picture.height = 256;
  const context = picture.getContext('2d')!;
  context.fillStyle = `hsl(${hue} 90% 52%)`;
  for (let i = 0; i < 46; i++) {
    const angle = 6.3 * THREE.MathUtils.seededRandom();
    const far = 100 * THREE.MathUtils.seededRandom() ** 1.4;
    context.beginPath();
    context.arc(128 + far * Math.cos(angle), 128 + far * Math.sin(angle), 30 - 0.26 * far, 0, 7);
    context.fill();
  }
  const texture = new THREE.CanvasTexture(picture);
  texture.colorSpace = THREE.SRGBColorSpace;
  return texture;
}
const paints = [4, 38, 165, 205, 285, 330].map(
  (hue) => new THREE.MeshStandardMaterial({ map: splash(hue), roughness: 0.12, transparent: true }),
);
for (let i = 0; i < 40; i++) {
  const decal = new Decal(paints[i % paints.length]);
  const angle = 2.4 * i;
  if (i < 16) {
    decal.position.setFromSphericalCoords(1, 0.5 + 0.09 * i, angle).add(pot.position);
    decal.lookAt(2 * decal.position.x, 2 * decal.position.y - 1, 2 * decal.position.z);
  } else if (i < 22) {
    decal.position.set(-2.2 + 0.5 * Math.cos(angle), 0.4 + 0.32 * (i - 16), -0.5);
    decal.rotation.y = 0.4;
  } else {
    decal.position.set((0.14 * i - 1.4) * Math.cos(angle), 0, (0.14 * i - 1.4) * Math.sin(angle));
    decal.rotation.x = -Math.PI / 2;
  }
  decal.scale.set(1, 1, 0.6);
  decal.rotateZ(i);
  scene.add(decal);
}
const bulb = new THREE.SphereGeometry(0.05, 16, 12);
const lamps = Array.from({ length: 10 }, () => {
  const lamp = new THREE.PointLight(0xffe2c0, 5.5, 6);
  lamp.add(new THREE.Mesh(bulb, new THREE.MeshBasicMaterial({ color: 0xffeed8 })));
  scene.add(lamp);
  return lamp;
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
  for (const [i, lamp] of lamps.entries()) {
    const angle = (i / 10) * 2 * Math.PI + 0.3 * seconds;
    lamp.position.set(2.6 * Math.cos(angle), 1 + 0.9 * ((i * 0.37) % 1), 2.6 * Math.sin(angle));
  }
  farol.render(scene, camera);
});

export { camera, farol, scene, webgl };
