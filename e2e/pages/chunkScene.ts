import * as THREE from 'three';
import type { TestScene } from './materialScene';
import { isSlice } from './techniquesInTurn';

/** A ball and a box over a floor in fog, under lights that cast shadows and others, for changes of three's shader chunks. */
export function chunkScene(width: number, height: number): TestScene {
  const scene = new THREE.Scene();
  scene.background = new THREE.Color(0x223344);
  scene.fog = new THREE.Fog(0x445566, 4, 18);
  const floor = new THREE.Mesh(new THREE.PlaneGeometry(12, 12), new THREE.MeshStandardMaterial({ roughness: 0.7 }));
  floor.rotation.x = -Math.PI / 2;
  const ball = new THREE.Mesh(new THREE.SphereGeometry(0.9, 32, 20), new THREE.MeshPhongMaterial({ color: 0xee9966 }));
  ball.position.set(-1.2, 1, 0);
  // in the slice the box is of the ball's kind: a program less
  const blue = { color: 0x66aaee };
  const matt = isSlice ? new THREE.MeshPhongMaterial(blue) : new THREE.MeshLambertMaterial(blue);
  const box = new THREE.Mesh(new THREE.BoxGeometry(1, 1.8, 1), matt);
  box.position.set(1.2, 0.9, -0.4);
  const pane = new THREE.Mesh(
    new THREE.PlaneGeometry(1, 1),
    new THREE.MeshStandardMaterial({ color: 0x99ff99, transparent: true, opacity: 0.5 }),
  );
  pane.position.set(0, 0.8, 1.2);
  for (const mesh of [floor, ball, box]) mesh.castShadow = mesh.receiveShadow = true;
  const sun = new THREE.DirectionalLight(0xfff0dd, 2);
  sun.position.set(3, 6, 4);
  const spot = new THREE.SpotLight(0xaaccff, 60, 14, 0.6, 0.4);
  spot.position.set(-3, 4, 2);
  for (const light of [sun, spot]) {
    light.castShadow = true;
    light.shadow.mapSize.set(128, 128);
    light.shadow.bias = -0.004;
  }
  const lamp = new THREE.PointLight(0xff8866, 6, 6);
  lamp.position.set(0, 1.5, 2);
  scene.add(floor, ball, box, pane, sun, spot, spot.target, lamp, new THREE.HemisphereLight(0x8899aa, 0x332211, 0.5));
  const camera = new THREE.PerspectiveCamera(45, width / height, 0.5, 40);
  camera.position.set(0, 3, 7);
  camera.lookAt(0, 0.6, 0);
  return { scene, camera, lights: [sun, spot, lamp] };
}
