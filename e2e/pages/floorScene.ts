import * as THREE from 'three';
import { Bench } from './Bench';

/** A floor that receives shadows, below a point light and a box that cast them; a bench that draws its shadow maps. */
export function floorScene() {
  const bench = new Bench(128, 96);
  bench.webgl.shadowMap.enabled = true;
  const floor = new THREE.Mesh(new THREE.PlaneGeometry(14, 14), new THREE.MeshStandardMaterial());
  floor.rotation.x = -Math.PI / 2;
  const box = new THREE.Mesh(new THREE.BoxGeometry(1.4, 1.4, 1.4), new THREE.MeshStandardMaterial());
  box.position.y = 1;
  const point = new THREE.PointLight(0xffffff, 60, 20);
  point.position.set(0, 4, 3);
  point.shadow.bias = -0.005;
  floor.receiveShadow = box.castShadow = point.castShadow = true;
  const camera = new THREE.PerspectiveCamera(50, 128 / 96, 0.1, 60);
  camera.position.set(0, 6, 8);
  camera.lookAt(0, 0, 0);
  return { bench, scene: new THREE.Scene().add(floor, box, point), floor, box, point, camera };
}
