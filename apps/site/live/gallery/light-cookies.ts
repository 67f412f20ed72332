/**
 * Images that lights throw
 *
 * A spot light's `map` throws a stained-glass rose; a lantern with a cube texture throws stars all round.
 *
 * @tags spot light, point light, textures
 */
import { FarolRenderer } from '@farol/renderer';
import { setLightOptions } from '@farol/renderer/light-options';
import * as THREE from 'three';
import { OrbitControls } from 'three/addons/controls/OrbitControls.js';

const canvas = document.querySelector('canvas')!;
const webgl = new THREE.WebGLRenderer({ canvas, antialias: true });
webgl.toneMapping = THREE.ACESFilmicToneMapping;
const farol = new FarolRenderer(webgl, { technique: 'deferred' });

const scene = new THREE.Scene();
scene.background = new THREE.Color(0x030407);
const camera = new THREE.PerspectiveCamera(46, 1, 0.1, 100);
camera.position.set(0, 2.6, 9.4);
const controls = new OrbitControls(camera, canvas);
controls.target.set(0, 2.2, -1);
controls.update();

const room = new THREE.Mesh(
  new THREE.BoxGeometry(12, 6, 10),
  new THREE.MeshStandardMaterial({ color: 0xb0a698, roughness: 0.85, side: THREE.BackSide }),
);
room.position.set(0, 3, 0);
scene.add(room, new THREE.HemisphereLight(0x8090d0, 0x604830, 0.5));
const column = new THREE.CylinderGeometry(0.35, 0.4, 6, 32);
for (const x of [-4.4, 4.4]) {
  const mesh = new THREE.Mesh(column, new THREE.MeshStandardMaterial({ color: 0xcfc6b6, roughness: 0.6 }));
  mesh.position.set(x, 3, -2.6);
  scene.add(mesh);
}

/** A square picture, drawn with the origin in its middle and a side of 2. */
function draw(paint: (context: CanvasRenderingContext2D) => void): HTMLCanvasElement {
  const picture = document.createElement('canvas');
  picture.width = picture.height = 512;
  const context = picture.getContext('2d')!;
  context.fillRect(0, 0, 512, 512);
  context.setTransform(256, 0, 0, 256, 256, 256);
  paint(context);
  return picture;
}
const rose = draw((context) => {
  for (let ring = 3; ring > 0; ring--) {
    for (let i = 0; i < 6 * ring; i++) {
      context.save();
      context.rotate((i / (6 * ring)) * 2 * Math.PI);
      context.fillStyle = `hsl(${(i * 360) / (6 * ring) + 60 * ring} 95% 58%)`;
      context.beginPath();
      context.ellipse(0, -0.29 * ring, 0.11, 0.13, 0, 0, 2 * Math.PI);
      context.fill();
      context.restore();
    }
  }
});
const window_ = new THREE.SpotLight(0xffffff, 520, 20, 0.5, 0.15);
window_.position.set(0, 3.2, 4.8);
window_.target.position.set(0, 3, -5);
window_.map = new THREE.CanvasTexture(rose);
window_.map.colorSpace = THREE.SRGBColorSpace;
scene.add(window_, window_.target);

const stars = draw((context) => {
  context.fillStyle = '#fff';
  for (let i = 0; i < 26; i++) {
    context.save();
    context.translate(1.7 * (THREE.MathUtils.seededRandom() - 0.5), 1.7 * (THREE.MathUtils.seededRandom() - 0.5));
    context.rotate(9 * i);
    context.beginPath();
    for (let k = 0; k < 10; k++) {
      const radius = (k % 2 ? 0.03 : 0.075) * (0.6 + (i % 3) / 3);
      context.lineTo(radius * Math.sin((k * Math.PI) / 5), radius * Math.cos((k * Math.PI) / 5));
    }
    context.fill();
    context.restore();
  }
});
const cookie = new THREE.CubeTexture([stars, stars, stars, stars, stars, stars]);
cookie.colorSpace = THREE.SRGBColorSpace;
cookie.needsUpdate = true;
for (const [x, color] of [
  [-3, 0xffb454],
  [3, 0x7ab8ff],
] as const) {
  const lantern = new THREE.PointLight(color, 50, 10);
  lantern.position.set(x, 1.6, 1.2);
  setLightOptions(lantern, { cookie });
  lantern.add(
    new THREE.Mesh(new THREE.OctahedronGeometry(0.2, 1), new THREE.MeshBasicMaterial({ color, wireframe: true })),
  );
  scene.add(lantern);
}

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
  window_.map!.center.set(0.5, 0.5);
  window_.map!.rotation = 0.1 * seconds;
  farol.render(scene, camera);
});

export { camera, farol, scene, webgl };
