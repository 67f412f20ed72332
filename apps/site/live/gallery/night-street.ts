/**
 * The night street
 *
 * Shop windows, neon, wet asphalt and headlights: two hundred lights of every kind, twelve of them with shadows.
 *
 * @tags many lights, shadows, area light, scenes
 */
import { FarolRenderer } from '@farol/renderer';
import * as THREE from 'three';
import { OrbitControls } from 'three/addons/controls/OrbitControls.js';
import { RoundedBoxGeometry } from 'three/addons/geometries/RoundedBoxGeometry.js';

const canvas = document.querySelector('canvas')!;
const webgl = new THREE.WebGLRenderer({ canvas, antialias: true });
webgl.toneMapping = THREE.ACESFilmicToneMapping;
webgl.shadowMap.enabled = true;
const farol = new FarolRenderer(webgl, { technique: 'clustered-deferred' });

const scene = new THREE.Scene();
scene.background = new THREE.Color(0x05070f);
scene.fog = new THREE.Fog(0x05070f, 14, 60);
const camera = new THREE.PerspectiveCamera(52, 1, 0.1, 120);
camera.position.set(0.6, 1.9, 10);
const controls = new OrbitControls(camera, canvas);
controls.target.set(-0.3, 1.9, -6);
controls.update();

const road = new THREE.Mesh(
  new THREE.PlaneGeometry(120, 120),
  new THREE.MeshStandardMaterial({ color: 0x2e3238, roughness: 0.35 }),
);
road.rotation.x = -Math.PI / 2;
road.receiveShadow = true;
scene.add(road, new THREE.HemisphereLight(0x4a64b0, 0x0a0a0c, 0.35));

const random = () => THREE.MathUtils.seededRandom();
const pane = new THREE.PlaneGeometry(0.5, 0.7);
const lit = new THREE.InstancedMesh(pane, new THREE.MeshBasicMaterial(), 640);
const place = new THREE.Object3D();
const color = new THREE.Color();
let panes = 0;
const awning = new THREE.BoxGeometry(2.6, 0.1, 0.9);
const step = new THREE.BoxGeometry(1, 1, 1);
for (let i = 0; i < 20; i++) {
  const side = i % 2 ? 1 : -1;
  const z = 6 - 4 * Math.floor(i / 2);
  const height = 5 + 5 * random();
  const wall = new THREE.Mesh(
    step,
    new THREE.MeshStandardMaterial({ color: color.setHSL(0.04 + 0.08 * random(), 0.22, 0.3), roughness: 0.85 }),
  );
  wall.scale.set(4, height, 3.9);
  wall.position.set(side * 5.4, height / 2, z);
  wall.castShadow = wall.receiveShadow = true;
  scene.add(wall);
  for (let k = 0; k < 24 && panes < 640; k++) {
    if (random() < 0.55) continue;
    place.position.set(side * 3.39, 3.4 + 1.1 * Math.floor(k / 4), z + 0.85 * ((k % 4) - 1.5));
    place.rotation.y = (-side * Math.PI) / 2;
    if (place.position.y > height - 0.6) continue;
    place.updateMatrix();
    lit.setMatrixAt(panes, place.matrix);
    lit.setColorAt(panes++, color.setHSL(0.09 + 0.04 * random(), 0.7, 0.28 + 0.3 * random()));
  }
  // a shop: its window is an area light, its sign two points
  const hue = random();
  const window_ = new THREE.RectAreaLight(color.setHSL(0.09 + 0.05 * random(), 0.7, 0.55).getHex(), 3, 2.2, 1.5);
  window_.position.set(side * 3.37, 1.4, z);
  window_.rotation.y = side > 0 ? Math.PI / 2 : -Math.PI / 2;
  window_.add(
    new THREE.Mesh(
      new THREE.PlaneGeometry(2.2, 1.5).rotateY(Math.PI),
      new THREE.MeshBasicMaterial({ color: window_.color }),
    ),
  );
  const roof = new THREE.Mesh(
    awning,
    new THREE.MeshStandardMaterial({ color: new THREE.Color().setHSL(hue, 0.6, 0.4) }),
  );
  roof.position.set(side * 3, 2.4, z);
  roof.rotation.set(0, Math.PI / 2, side * 0.2, 'YXZ');
  roof.castShadow = roof.receiveShadow = true;
  scene.add(window_, roof);
  for (const dz of [-0.7, 0.7]) {
    const sign = new THREE.PointLight(new THREE.Color().setHSL(hue, 1, 0.55), 5, 4.5);
    sign.position.set(side * 3.15, 2.9, z + dz);
    const tube = new THREE.Mesh(
      new THREE.CapsuleGeometry(0.04, 0.9, 6, 12).rotateX(Math.PI / 2),
      new THREE.MeshBasicMaterial({ color: sign.color }),
    );
    sign.add(tube);
    scene.add(sign);
  }
}
lit.count = panes;
scene.add(lit);
const post = new THREE.CylinderGeometry(0.04, 0.07, 3.8, 12);
const iron = new THREE.MeshStandardMaterial({ color: 0x202226, roughness: 0.5, metalness: 0.5 });
for (let i = 0; i < 12; i++) {
  const side = i % 2 ? 1 : -1;
  const pole = new THREE.Mesh(post, iron);
  pole.position.set(side * 2.6, 1.9, 5 - 6 * Math.floor(i / 2));
  pole.castShadow = pole.receiveShadow = true;
  const lamp = new THREE.SpotLight(0xffc27a, 75, 10, 0.95, 0.7);
  lamp.position.set(pole.position.x - side * 0.4, 3.8, pole.position.z);
  lamp.target.position.set(lamp.position.x - side * 0.5, 0, pole.position.z);
  lamp.castShadow = true;
  lamp.shadow.normalBias = 0.03;
  lamp.add(new THREE.Mesh(new THREE.SphereGeometry(0.1, 16, 12), new THREE.MeshBasicMaterial({ color: 0xffe0b0 })));
  scene.add(pole, lamp, lamp.target);
}
const body = new RoundedBoxGeometry(1.3, 0.5, 2.8, 4, 0.2);
const cabin = new RoundedBoxGeometry(1.1, 0.45, 1.4, 4, 0.18);
const cars = Array.from({ length: 8 }, (_, i) => {
  const car = new THREE.Group();
  const paint = new THREE.MeshStandardMaterial({
    color: new THREE.Color().setHSL(random(), 0.5, 0.35),
    roughness: 0.35,
    metalness: 0.6,
  });
  const top = new THREE.Mesh(cabin, paint);
  top.position.set(0, 0.75, 0.2);
  const low = new THREE.Mesh(body, paint);
  low.position.y = 0.4;
  for (const part of [low, top]) part.castShadow = part.receiveShadow = true;
  car.add(low, top);
  for (const x of [-0.45, 0.45]) {
    const head = new THREE.SpotLight(0xfff2dc, 45, 12, 0.35, 0.8);
    head.position.set(x, 0.45, -1.4);
    head.target.position.set(x, 0, -6);
    const tail = new THREE.PointLight(0xff2010, 2.2, 3);
    tail.position.set(x, 0.45, 1.5);
    for (const light of [head, tail])
      light.add(
        new THREE.Mesh(new THREE.SphereGeometry(0.07, 12, 8), new THREE.MeshBasicMaterial({ color: light.color })),
      );
    car.add(head, head.target, tail);
  }
  car.rotation.y = i % 2 ? Math.PI : 0;
  car.position.x = i % 2 ? -1 : 1;
  scene.add(car);
  return car;
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
  for (const [i, car] of cars.entries()) {
    const along = (seconds * (3 + (i % 3)) + 11 * i) % 56;
    car.position.z = i % 2 ? along - 46 : 10 - along;
  }
  farol.render(scene, camera);
});

export { camera, farol, scene, webgl };
